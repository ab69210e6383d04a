//! Null geodesics from infinity against tables, elliptic integrals and other codes.

use crate::light_without_spin::deflection;
use crate::schwarzschild::rounding_of_b;
use crate::{assert_close, bisect};
use glam::DVec3;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::mino::{PhotonConstants, PhotonState};
use lightfall_core::geometry::sphere::{celestial_frame, polar_sin_cos};
use lightfall_core::optics::reference::HoleAndDisk;
use lightfall_core::optics::trace::{Outcome, Trace};
use std::f64::consts::{FRAC_PI_2, PI};

/// The ray toward the hole at Bardeen's screen coordinates alpha, beta (r_s; alpha toward growing
/// phi, beta toward decreasing theta) of an observer at u and theta, phi = 0. p_phi / sin(theta) =
/// -alpha and p_theta = beta, so K = alpha^2 + beta^2 - a^2 cos^2(theta) (Bardeen 1973).
fn trace(
    spin: f64,
    [alpha, beta]: [f64; 2],
    u: f64,
    theta: f64,
    annulus: Option<[f64; 2]>,
) -> Trace {
    let kerr = Kerr { spin };
    let [n, theta_hat, phi_hat] = celestial_frame(theta, 0.0);
    let constants = PhotonConstants {
        a: kerr.a(),
        energy: 1.0,
        angular_momentum: -alpha * polar_sin_cos(theta).0,
        k: alpha * alpha + beta * beta - (kerr.a() * n.z).powi(2),
        ingoing: false,
    };
    let start = PhotonState {
        u,
        du: constants.potential(u).max(0.0).sqrt(),
        n,
        dn: alpha * phi_hat - beta * theta_hat,
        chi: 0.0,
    };
    HoleAndDisk { kerr, annulus }.trace(&constants, start)
}

/// The error of the deflection from infinity to infinity in the plane without spin: the ray's
/// azimuth changes by the deflection + pi, clockwise for positive L.
fn deflection_error(b: f64, bending: f64) -> f64 {
    let sky = trace(0.0, [-b, 0.0], 0.0, FRAC_PI_2, None).sky.unwrap();
    let turn = -(bending + PI);
    (sky - DVec3::new(turn.cos(), turn.sin(), 0.0)).length()
}

/// Thousands of impact parameters against the elliptic integral, over nine decades of distance to
/// the critical curve.
#[test]
fn light_from_infinity_has_the_deflection_of_the_closed_form() {
    let mut worst = 0.0_f64;
    for i in 0..2000 {
        let b = 2.598_076_211_353_316 * (1.0 + 10.0_f64.powf(-6.0 + 9.0 * f64::from(i) / 2000.0));
        let error = deflection_error(b, deflection(b).unwrap());
        assert!(
            error < 1e-13 + 2.0 * rounding_of_b(2.0 * b),
            "b = {b}: {error:e}"
        );
        worst = worst.max(error);
    }
    println!("worst difference from the closed form: {worst:e} rad");
}

/// chi, L/E in M, bending in the plane from infinity to infinity, by mpmath quadrature.
const KERR_BENDING: [[f64; 3]; 21] = [
    [0.5, 5.0, 1.885_834_349_170_52],
    [0.5, 6.0, 1.226_399_798_008_43],
    [0.5, 10.0, 0.538_977_894_197_951],
    [0.5, -7.0, 1.520_759_900_565_46],
    [0.5, -10.0, 0.654_972_355_737_293],
    [0.5, 100.0, 0.041_006_961_776_245_9],
    [0.5, -100.0, 0.041_440_425_288_942_6],
    [0.9, 3.0, 6.120_390_987_391_92],
    [0.9, 4.0, 2.178_290_448_907_08],
    [0.9, 6.0, 1.026_210_238_700_83],
    [0.9, 10.0, 0.504_632_984_000_672],
    [0.9, -7.0, 2.588_830_366_514_55],
    [0.9, -10.0, 0.720_503_613_953_961],
    [0.9, 100.0, 0.040_836_136_056_758_3],
    [0.998, 3.0, 3.880_588_450_508_33],
    [0.998, 4.0, 1.961_005_753_845_7],
    [0.998, 6.0, 0.988_740_335_636_821],
    [0.998, 10.0, 0.496_960_188_817_243],
    [0.998, -7.0, 5.524_226_483_629_73],
    [0.998, -7.5, 1.776_824_765_071_29],
    [0.998, -10.0, 0.739_104_522_448_639],
];

/// The table has fifteen digits. The ray at L = -7 M, 5e-4 from the critical one, amplifies
/// rounding errors by about a thousand.
#[test]
fn light_in_the_plane_of_a_spinning_hole_has_the_tabulated_deflection() {
    for [chi, lambda, bending] in KERR_BENDING {
        let sky = trace(chi, [-lambda / 2.0, 0.0], 0.0, FRAC_PI_2, None)
            .sky
            .unwrap();
        let turn = -lambda.signum() * (bending + PI);
        let error = (sky - DVec3::new(turn.cos(), turn.sin(), 0.0)).length();
        assert!(error < 2e-12, "chi {chi}, lambda {lambda} M: {error:e}");
    }
}

/// chi, inclination, alpha, beta, then x and y of the first crossing of the plane; lengths in M.
/// The observer is at r = 1000 M. The rows agree with the six digits of kgeo's table (which agrees
/// with ipole), and have ten digits here.
const CROSSINGS: [[f64; 6]; 8] = [
    [0.42, 60.0, -17.0, 0.0, -0.052_233_590_8, -16.034_233_4],
    [0.42, 60.0, -9.0, 0.0, -0.103_693_371_1, -8.097_835_112_7],
    [0.42, 60.0, -4.0, 0.0, -0.308_158_526_9, -3.204_448_796],
    [0.42, 60.0, 8.0, 0.0, 0.129_720_293_7, 6.948_290_943_2],
    [0.9, 10.0, -12.0, 0.0, -0.164_093_692_7, -11.008_196_085_7],
    [0.9, 10.0, -4.0, 0.0, -0.655_581_437_3, -2.995_575_589_3],
    [
        0.73,
        35.0,
        0.0001,
        -10.0,
        11.825_828_583_1,
        -0.085_877_521_9,
    ],
    [0.73, 35.0, 0.0001, 4.0, -2.112_207_118_2, 1.023_229_137],
];

/// The rows have eight or more digits after the point, hence 1e-9 of the radius (the first row's y
/// has nine digits in all).
#[test]
fn light_crosses_the_plane_where_other_codes_find_it() {
    for [chi, inclination, alpha, beta, x, y] in CROSSINGS {
        let inclination = inclination.to_radians();
        let screen = [alpha / 2.0, beta / 2.0];
        let hit = trace(chi, screen, 1.0 / 500.0, inclination, Some([0.9, 100.0])).hits[0].unwrap();
        let error = (hit.r * hit.phi.cos() - x / 2.0).hypot(hit.r * hit.phi.sin() - y / 2.0);
        assert!(
            error < 1e-9 * hit.r.max(1.0),
            "chi {chi}, alpha {alpha}, beta {beta}: {error:e}"
        );
    }
}

/// b (M) of the direct, second and third image of a ring of radius r seen along the axis, by
/// mpmath. The annulus is narrow, so that the crossing before it does not count.
#[test]
fn rings_seen_along_the_axis_appear_at_the_tabulated_impact_parameters() {
    let images = [
        (
            6.0,
            [
                6.932_148_479_189_5,
                5.478_913_722_083_8,
                5.207_989_587_554_5,
            ],
        ),
        (
            10.0,
            [10.956_115_049_792, 5.666_150_340_668_7, 5.214_490_199_24],
        ),
        (
            20.0,
            [20.976_651_135_838, 5.865_410_841_326_2, 5.220_484_439_229_3],
        ),
    ];
    for (r, impacts) in images {
        for b in impacts {
            let annulus = [0.4999 * r, 0.5001 * r];
            let hit = trace(0.0, [0.0, b / 2.0], 0.0, 0.0, Some(annulus)).hits[0].unwrap();
            // dr/db grows like exp(pi) per image, to 1.5e3 r at most, and b has thirteen digits.
            assert_close(format_args!("r = {r} M, b = {b} M"), hit.r, r / 2.0, 1e-9);
        }
    }
}

/// The edge of the shadow for an observer at infinity. With beta = 0 or alpha = 2a held, the
/// other is bisected to the last bit; the table's digits decide the tolerance.
#[test]
fn shadow_of_a_spinning_hole_has_the_tabulated_edge() {
    let captured = |chi: f64, i: f64, alpha: f64, beta: f64| {
        let theta = i.to_radians();
        let theta = if i == 90.0 { FRAC_PI_2 } else { theta };
        trace(chi, [alpha / 2.0, beta / 2.0], 0.0, theta, None).outcome == Outcome::Captured
    };
    for (chi, i, left, right) in [
        (0.5, 90.0, -4.096_266_658_71, 6.138_155_724_72),
        (0.9, 90.0, -2.844_421_403_48, 6.832_319_230_45),
        (0.998, 90.0, -2.110_887_794_55, 6.996_666_271_4),
        (0.9, 60.0, -3.095_907_971_15, 6.589_408_976_12),
        (0.998, 17.0, -4.092_204_303_65, 5.507_794_687_95),
        (0.94, 17.0, -4.225_863_114_68, 5.506_229_661_34),
    ] {
        for (edge, far) in [(left, -20.0), (right, 20.0)] {
            let found = bisect(0.5 * (left + right), far, |alpha| {
                captured(chi, i, alpha, 0.0)
            });
            assert_close(format_args!("chi {chi}, i {i}"), found, edge, 1e-11);
        }
    }
    for (chi, i, alpha, edge) in [
        (0.5, 90.0, 1.0, 5.196_152_422_71),
        (0.9, 90.0, 1.8, 5.196_152_422_71),
        (0.998, 90.0, 1.996, 5.196_152_422_71),
        (0.9, 60.0, 1.8 / 0.75_f64.sqrt(), 5.111_017_511_22),
    ] {
        let found = bisect(0.0, 20.0, |beta| captured(chi, i, alpha, beta));
        assert_close(format_args!("top, chi {chi}, i {i}"), found, edge, 1e-11);
    }
}

/// Seen along the axis the shadow is a circle of radius sqrt(eta + a^2), eta that of the polar
/// photon orbit: eta = r^3 (4 M a^2 - r (r - 3M)^2)/(a^2 (r - M)^2), with L = 0.
#[test]
fn shadow_seen_along_the_axis_is_that_of_the_polar_photon_orbit() {
    for chi in [0.3, 0.9, 0.9999] {
        let (r, a) = (2.0 * Kerr { spin: chi }.photon_orbit_polar(), chi);
        let eta = r.powi(3) * (4.0 * a * a - r * (r - 3.0).powi(2)) / (a * (r - 1.0)).powi(2);
        let found = bisect(0.0, 20.0, |radius| {
            trace(chi, [0.3 * radius, 0.4 * radius], 0.0, 0.0, None).outcome == Outcome::Captured
        });
        // eta has a cancellation at small spin: a few rounding errors over a^2.
        assert_close(
            format_args!("chi {chi}"),
            found,
            (eta + a * a).sqrt(),
            1e-13 / (a * a),
        );
    }
}
