//! The thin disk: edges, redshifts, hits and flux, against published formulas, tables and
//! integrals.

use crate::assert_close;
use crate::reference::directions;
use lightfall_core::geometry::kerr::{Kerr, MASS};
use lightfall_core::optics::disk;
use lightfall_core::optics::disk::{
    PageThorne, Profile, TABLE_LEN, lit, newtonian_flux, temperature,
};
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::{Disk, DiskModel, Scene};
use std::f64::consts::PI;

/// chi, r/M, then g of the most blue-shifted, the most red-shifted and the L = 0 ray to an observer
/// at infinity in the plane, computed with mpmath to 25 digits.
const REDSHIFT: [[f64; 5]; 5] = [
    [
        0.0,
        10.0,
        1.294_244_589_36,
        0.618_121_185_576,
        0.836_660_026_534,
    ],
    [
        0.0,
        20.0,
        1.206_276_556_84,
        0.746_097_563_53,
        0.921_954_445_729,
    ],
    [
        0.9,
        6.0,
        1.352_161_500_45,
        0.493_037_752_105,
        0.743_444_058_715,
    ],
    [
        0.9,
        10.0,
        1.278_983_979_38,
        0.625_496_497_924,
        0.845_936_298_536,
    ],
    [
        0.998,
        6.0,
        1.347_858_348_41,
        0.494_611_816_926,
        0.746_674_190_559,
    ],
];

#[test]
fn disk_edges_are_never_inside_the_innermost_stable_orbit_and_can_follow_it() {
    for spin in [-0.9, 0.0, 0.998] {
        let isco = Kerr { spin }.isco();
        let mut scene = Scene::default();
        scene.hole.spin = spin;
        for (inner, follow, edge) in [(0.1, false, isco), (8.0, false, 8.0), (8.0, true, isco)] {
            (scene.disk.inner, scene.disk.follow_isco) = (inner, follow);
            assert_eq!(scene.inner_edge(), edge);
        }
    }
}

/// The extreme rays leave along or against the motion: lambda = (r^2 + a^2 +- a sqrt(Delta)) / (a
/// +- sqrt(Delta)). The table carries twelve digits, so half a unit of the last is 5e-12.
#[test]
fn disk_redshifts_have_the_tabulated_values() {
    for [chi, r, bluest, reddest, middle] in REDSHIFT {
        let (kerr, r, a) = (Kerr { spin: chi }, r / 2.0, chi / 2.0);
        let (orbit, root) = (kerr.circular_orbit(r).unwrap(), (r * r - r + a * a).sqrt());
        let lambda = |root: f64| (r * r + a * a + a * root) / (a + root);
        for (lambda, expected) in [
            (lambda(root), bluest),
            (lambda(-root), reddest),
            (0.0, middle),
        ] {
            assert_close(
                format_args!("chi {chi}, r {r}"),
                disk::redshift(&orbit, 1.0, lambda),
                expected,
                5e-12,
            );
        }
    }
}

/// Seen along the axis every ray has L = 0, so g = sqrt(1 - 3/(2r)) / sqrt(1 - 1/r0) by the
/// article's formula, for every path of the ray. 1e-13 allows only for rounding.
#[test]
fn disk_seen_face_on_has_the_redshift_of_gravity_and_transverse_motion() {
    let mut scene = Scene::default();
    scene.camera.theta_deg = 0.0;
    let reference = Reference::new(&scene).unwrap();
    let mut seen = 0;
    for i in 0..40 {
        let angle = 0.01 * f64::from(i);
        for hit in reference
            .trace(glam::DVec3::new(
                -1.0,
                angle.cos() * angle,
                angle.sin() * angle,
            ))
            .hits
            .into_iter()
            .flatten()
        {
            let expected = (1.0 - 1.5 / hit.r).sqrt() / (1.0 - 1.0 / scene.camera.r).sqrt();
            assert_close(format_args!("r = {}", hit.r), hit.g, expected, 1e-13);
            seen += 1;
        }
    }
    assert!(seen > 20, "only {seen} hits");
}

/// The zero-torque profile peaks at (49/36) r_in with F = (36/49)^3 / 7, found by setting its
/// derivative to zero.
#[test]
fn disk_flux_peaks_where_the_zero_torque_profile_does() {
    let flux = |r: f64| newtonian_flux(r, 3.0);
    let peak = 3.0 * 49.0 / 36.0;
    assert_close("peak", flux(peak), (36.0_f64 / 49.0).powi(3) / 7.0, 1e-14);
    assert!(flux(peak * 1.001) < flux(peak) && flux(peak * 0.999) < flux(peak));
    assert_eq!([flux(3.0), flux(2.0)], [0.0, 0.0]);
    let temperature = temperature(&Disk::default(), flux(peak));
    assert_close(
        "temperature",
        temperature,
        18_000.0 * flux(peak).sqrt().sqrt(),
        1e-14,
    );
}

/// The two hits are the first two crossings of the annulus in the order of the backward ray, and a
/// third crossing does not replace them. An annulus that is cut off at the first hit's radius keeps
/// exactly the other hit.
#[test]
fn disk_hits_are_the_first_two_crossings_of_the_annulus() {
    let view = Scene::default();
    let reference = Reference::new(&view).unwrap();
    let mut double = 0;
    for d in directions(20_000).filter(|d| d.x < -0.8) {
        let [first, second] = reference.trace(d).hits;
        assert!(first.is_some() || second.is_none());
        for hit in [first, second].into_iter().flatten() {
            assert!(
                hit.r > 3.0 && hit.r < 11.0 && hit.phi > -PI && hit.phi <= PI,
                "{d}: {hit:?}"
            );
        }
        if let (Some(first), Some(second)) = (first, second) {
            double += 1;
            let mut narrow = view.clone();
            if first.r < second.r {
                narrow.disk.inner = 0.5 * (first.r + second.r);
            } else {
                narrow.disk.outer = 0.5 * (first.r + second.r);
            }
            assert_eq!(
                Reference::new(&narrow).unwrap().trace(d).hits[0],
                Some(second),
                "{d}"
            );
        }
    }
    assert!(double > 20, "only {double} rays hit twice");
}

/// chi, r/M, then 4 pi F / Mdot in 1/M^2, computed with mpmath to 25 digits. Radii with many digits
/// are peaks.
const PAGE_THORNE: [[f64; 3]; 10] = [
    [0.0, 8.0, 1.438_534_154_51e-4],
    [0.0, 9.550_928_08, 1.718_842_098_66e-4],
    [0.0, 10.0, 1.705_099_995_57e-4],
    [0.0, 20.0, 5.937_791_153_65e-5],
    [0.0, 50.0, 6.369_490_527_92e-6],
    [0.5, 6.615_087_61, 5.358_939_914_36e-4],
    [0.9, 3.441_843_36, 4.262_872_623_78e-3],
    [0.9, 10.0, 6.037_096_399_01e-4],
    [0.998, 1.581_184_58, 6.008_724_035_95e-2],
    [0.998, 10.0, 7.628_535_071_88e-4],
];

/// 4 pi F / Mdot at radius `r` of a disk with this inner edge, in 1/r_s^2.
fn flux_per_accretion_rate(disk: &PageThorne, inner: f64, r: f64) -> f64 {
    let x0 = (inner / MASS).sqrt();
    1.5 / (MASS * x0.powi(3)).powi(2) * disk.flux(r) / disk.scale()
}

/// The flux that the shader computes from a table for this inner edge, in f64.
pub fn sampled_flux(table: &[[f32; 4]; TABLE_LEN], inner: f64, r: f64) -> f64 {
    let depth = (1.0 - (inner / r).sqrt()).max(0.0);
    let position = depth.sqrt() * TABLE_LEN as f64;
    let entry = (position as usize).min(TABLE_LEN - 1);
    let t = position - entry as f64;
    let [a, b, c, d] = table[entry].map(f64::from);
    newtonian_flux(r, inner) * (a + t * (b + t * (c + t * d)))
}

/// The values carry twelve digits, so half a unit of the last is 5e-12.
#[test]
fn disk_page_thorne_has_the_tabulated_flux() {
    for [chi, r, expected] in PAGE_THORNE {
        let inner = Kerr { spin: chi }.isco();
        let flux = flux_per_accretion_rate(&at_the_isco(chi), inner, r / 2.0) / 4.0;
        assert_close(format_args!("chi {chi}, r {r}"), flux, expected, 5e-12);
    }
}

/// The table has eight digits after the point, so half a unit of the last is 5e-9 M. The scaled
/// peak equals the Newtonian one.
#[test]
fn disk_page_thorne_peaks_at_the_tabulated_radius_with_the_height_of_the_newtonian_profile() {
    for (chi, peak) in [
        (0.0, 9.550_928_08),
        (0.5, 6.615_087_61),
        (0.9, 3.441_843_36),
        (0.998, 1.581_184_58),
    ] {
        let disk = at_the_isco(chi);
        assert!(
            (disk.peak() * 2.0 - peak).abs() <= 5.1e-9,
            "chi {chi}: {}",
            disk.peak() * 2.0
        );
        assert_close(
            format_args!("chi {chi}"),
            disk.flux(disk.peak()),
            newtonian_flux(49.0, 36.0),
            1e-14,
        );
    }
}

fn at_the_isco(chi: f64) -> PageThorne {
    PageThorne::new(chi, Kerr { spin: chi }.isco())
}

/// By conservation of energy and angular momentum the flux is an integral over orbits (Page &
/// Thorne 1974 eq. 12):
///
/// 4 pi r F / Mdot = -Omega' / (E - Omega L)^2 times the integral of (E - Omega L) dL from the
/// edge,
///
/// It is computed here from the orbits of this crate, with a sum over small steps of dL and a
/// difference quotient for Omega', without the closed form. The error of the sum falls with the
/// square of the number of steps; with 4000 steps the largest measured error is 2.1e-8.
#[test]
fn disk_page_thorne_is_the_integral_of_the_energy_that_orbits_lose() {
    for chi in [-0.998, -0.5, 0.0, 1e-7, 0.3, 0.9, 0.998] {
        let kerr = Kerr { spin: chi };
        for beyond in [1.0, 1.2, 3.0] {
            let inner = beyond * kerr.isco();
            let disk = PageThorne::new(chi, inner);
            let orbit = |r: f64| kerr.circular_orbit(r).unwrap();
            let spare =
                |r: f64| orbit(r).energy - orbit(r).angular_velocity * orbit(r).angular_momentum;
            for r in [1.1, 1.5, 2.0, 5.0].map(|ratio| ratio * inner) {
                let pieces = 4000;
                let edge = |i: u32| inner + (r - inner) * f64::from(i) / f64::from(pieces);
                let sum: f64 = (0..pieces)
                    .map(|i| {
                        let (low, high) = (edge(i), edge(i + 1));
                        spare(0.5 * (low + high))
                            * (orbit(high).angular_momentum - orbit(low).angular_momentum)
                    })
                    .sum();
                let h = 1e-5 * r;
                let slope =
                    (orbit(r + h).angular_velocity - orbit(r - h).angular_velocity) / (2.0 * h);
                let expected = -slope / spare(r).powi(2) * sum / r;
                assert_close(
                    format_args!("chi {chi}, {beyond} x isco, r {r}"),
                    flux_per_accretion_rate(&disk, inner, r),
                    expected,
                    5e-8,
                );
            }
        }
    }
}

/// This includes edges beyond the innermost stable orbit, where the torque vanishes at the given
/// edge.
#[test]
fn disk_page_thorne_shines_everywhere_outside_its_edge_and_nowhere_inside() {
    for chi in [-0.999_999, -0.5, 0.0, 1e-12, 0.5, 0.998, 0.999_999] {
        for beyond in [1.0, 1.000_1, 1.1, 2.0, 100.0] {
            let inner = beyond * Kerr { spin: chi }.isco();
            let disk = PageThorne::new(chi, inner);
            for i in 1..2000 {
                let r = inner * (1.0 + 1e-3 * f64::from(i) + 1e-9 * f64::from(i).powi(4));
                let flux = disk.flux(r);
                assert!(
                    flux > 0.0 && flux < disk::NEWTONIAN_PEAK * (1.0 + 1e-14),
                    "chi {chi}, {beyond}, {r}: {flux}"
                );
            }
            assert_eq!([disk.flux(inner), disk.flux(0.9 * inner)], [0.0, 0.0]);
        }
    }
}

/// The shader's table against the closed form, relative to the peak. The measured errors are 2.0e-7
/// at spin 0.998, 1.0e-6 at 0.9999 and 1.6e-5 at 1 - 1e-6, where the flux rises within a hundredth
/// of the radius; elsewhere 6e-8, which is the rounding of f32. For the fastest hole that f64 can
/// represent the table must only be finite.
#[test]
fn disk_page_thorne_table_is_the_closed_form() {
    let spins = [
        (-0.998, 1e-7),
        (0.0, 1e-7),
        (0.9, 1e-7),
        (0.998, 3e-7),
        (0.9999, 1.5e-6),
        (0.999_999, 3e-5),
    ];
    for (chi, allowed) in spins {
        for beyond in [1.0, 1.01, 3.0] {
            let inner = beyond * Kerr { spin: chi }.isco();
            let disk = PageThorne::new(chi, inner);
            let table = disk.table();
            for i in 1..10_000 {
                let r = inner / (1.0 - (f64::from(i) / 1e4).powi(2)).powi(2);
                let error =
                    (sampled_flux(&table, inner, r) - disk.flux(r)).abs() / disk::NEWTONIAN_PEAK;
                assert!(
                    error < allowed,
                    "chi {chi}, {beyond} x isco, r {r}: {error:e}"
                );
            }
        }
    }
    assert!(
        at_the_isco(1.0 - f64::EPSILON)
            .table()
            .iter()
            .flatten()
            .all(|value| value.is_finite())
    );
}

#[test]
fn disk_model_of_the_scene_chooses_the_profile() {
    let mut scene = Scene::default();
    scene.hole.spin = 0.9;
    assert_eq!(Profile::new(&scene), Profile::Newtonian(3.0));
    scene.disk.model = DiskModel::PageThorne;
    assert_eq!(
        Profile::new(&scene),
        Profile::PageThorne(PageThorne::new(0.9, 3.0))
    );
}

#[test]
fn a_disk_that_keeps_its_accretion_rate_is_the_same_far_out_wherever_its_edge_is() {
    let far = 1e6;
    let light = |spin: f64, model: DiskModel| {
        let mut scene = Scene::default();
        (scene.hole.spin, scene.disk.follow_isco) = (spin, true);
        (scene.disk.model, scene.disk.keep_accretion) = (model, true);
        let (disk, flux) = (lit(&scene), Profile::new(&scene).flux(far));
        (temperature(&disk, flux), disk.brightness * flux)
    };
    // Without spin, the standard edge itself: the scene's own temperature and brightness.
    let standard = Scene::default();
    let flux = Profile::new(&standard).flux(far);
    let (hot, bright) = light(0.0, DiskModel::Newtonian);
    assert_close("temperature", hot, temperature(&standard.disk, flux), 1e-12);
    assert_close("brightness", bright, flux, 1e-12);
    for model in DiskModel::ALL {
        let (temperature, brightness) = light(0.0, model);
        for spin in [-0.9, 0.5, 0.9, 0.998] {
            let spinning = light(spin, model);
            // The edge counts by sqrt(r_in/r), a few thousandths here, and the relativistic
            // correction by sqrt(M/r) times a logarithm, a hundredth.
            assert_close("temperature", spinning.0, temperature, 0.005);
            assert_close("brightness", spinning.1, brightness, 0.02);
        }
    }
}
