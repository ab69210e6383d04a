//! Closed forms without spin against tables, series and the aberration of circles.

use crate::assert_close;
use crate::light_without_spin::deflection;
use lightfall_core::geometry::observer::observer_matrix;
use lightfall_core::geometry::schwarzschild::{
    CRITICAL_IMPACT, ShadowEdge, shadow_half_angle_rain, shadow_half_angle_static,
};
use lightfall_core::scene::ObserverKind;
use std::f64::consts::PI;

/// b in M and the deflection in radians, computed with mpmath to 25 digits.
const DEFLECTION: [[f64; 2]; 18] = [
    [5.1962, 11.200_883_845_258_15],
    [5.19616, 13.038_050_086_939_78],
    [5.197, 8.321_408_085_687_58],
    [5.2, 6.810_371_956_663_497],
    [5.22, 4.996_120_171_073_73],
    [5.3, 3.557_938_042_459_651_5],
    [5.4, 2.919_396_339_609_56],
    [5.5, 2.553_020_182_345_338_3],
    [6.0, 1.719_388_310_230_168_6],
    [7.0, 1.127_639_104_731_336_3],
    [8.0, 0.858_730_018_079_095_3],
    [10.0, 0.590_395_787_605_827_3],
    [20.0, 0.236_135_995_388_469_9],
    [40.0, 0.108_104_076_540_920_45],
    [60.0, 0.070_150_808_316_896_77],
    [100.0, 0.041_222_539_749_273_65],
    [200.0, 0.020_299_966_239_543_31],
    [2000.0, 0.002_002_950_587_099_01],
];

/// b in M at which light is bent by n pi, n = 1 to 5, computed with mpmath to 25 digits.
const RINGS: [f64; 5] = [
    5.356_958_630_741_789,
    5.202_680_402_810_456,
    5.196_433_501_105_725,
    5.196_164_566_759_376,
    5.196_152_947_493_144,
];

/// r; shadow half-angle in degrees for an observer at rest and one in free fall, computed with
/// mpmath to 25 digits.
pub const SHADOW: [[f64; 3]; 11] = [
    [1.02, 159.104_168_156, 41.770_444_165_7],
    [1.2, 117.885_566_836, 39.027_772_324_2],
    [1.5, 90.0, 35.264_389_682_7],
    [1.6, 83.916_719_658_6, 34.183_992_302],
    [2.0, 66.716_268_278_9, 30.506_205_755_2],
    [3.0, 45.0, 24.203_428_339_3],
    [5.0, 27.694_561_450_8, 17.324_198_656_6],
    [10.0, 14.269_027_327_9, 10.310_109_321_5],
    [20.0, 7.274_004_881_18, 5.797_044_970_76],
    [100.0, 1.481_291_386_65, 1.339_892_042_19],
    [1000.0, 0.148_784_520_962, 0.144_151_640_105],
];

/// The change of the deflection for an error in the last bit of b: d(deflection)/d(ln b) = b/(b -
/// b_c) near the critical curve.
pub fn rounding_of_b(b_over_m: f64) -> f64 {
    4.0 * f64::EPSILON * b_over_m / (b_over_m - 2.0 * CRITICAL_IMPACT)
}

/// A relative 1e-13 is some hundred rounding errors. Near the critical curve the rounding of b
/// dominates.
#[test]
fn the_deflection_has_the_tabulated_values() {
    for [b, expected] in DEFLECTION {
        let tolerance = 1e-13 + rounding_of_b(b) / expected;
        assert_close(
            format_args!("b = {b} M"),
            deflection(b / 2.0).unwrap(),
            expected,
            tolerance,
        );
    }
}

#[test]
fn the_deflection_is_whole_half_turns_at_the_tabulated_rings() {
    for (n, b) in (1..).zip(RINGS) {
        let expected = f64::from(n) * PI;
        let tolerance = 1e-13 + rounding_of_b(b) / expected;
        assert_close(
            format_args!("ring {n}"),
            deflection(b / 2.0).unwrap(),
            expected,
            tolerance,
        );
    }
    // The outer edges of the lensing ring and the photon ring, with deflections of pi/2 and 3 pi/2,
    // to the eleven digits of the source.
    for (b, expected) in [(6.167_566_764_77, 0.5 * PI), (5.227_938_608_53, 1.5 * PI)] {
        assert_close(
            format_args!("b = {b} M"),
            deflection(b / 2.0).unwrap(),
            expected,
            1e-9,
        );
    }
}

/// Bozza 2002: deflection -> -ln(b/b_c - 1) + ln(216 (7 - 4 sqrt 3)) - pi; the next term is of the
/// order x ln x.
#[test]
fn the_deflection_follows_the_strong_field_limit_next_to_the_critical_curve() {
    for x in [1e-4_f64, 1e-6, 1e-8] {
        let limit = -x.ln() + (216.0 * (7.0 - 4.0 * 3.0_f64.sqrt())).ln() - PI;
        let found = deflection(CRITICAL_IMPACT * (1.0 + x)).unwrap();
        assert!(
            (found - limit).abs() < 2.0 * x * x.ln().abs() + 4.0 * f64::EPSILON / x,
            "x = {x}: {found} and {limit}"
        );
    }
}

/// 2/b + (15 pi / 16)/b^2 + (16/3)/b^3 + O(b^-4), r_s = 1 (Keeton & Petters 2005, with their m =
/// 1/2).
#[test]
fn the_deflection_follows_the_weak_field_series_far_out() {
    for b in [1e2_f64, 1e3, 1e5] {
        let series = 2.0 / b + 15.0 * PI / (16.0 * b * b) + 16.0 / (3.0 * b.powi(3));
        let error = (deflection(b).unwrap() - series).abs();
        // The deflection is a difference from pi, hence an absolute tolerance.
        assert!(
            error < 15.0 / b.powi(4) + 8.0 * f64::EPSILON,
            "b = {b}: {error:e}"
        );
    }
}

#[test]
fn light_inside_the_critical_curve_is_captured() {
    assert_eq!(deflection(CRITICAL_IMPACT * (1.0 - 1e-15)), None);
    assert_eq!(deflection(0.0), None);
    assert!(deflection(CRITICAL_IMPACT * (1.0 + 1e-15)).is_some());
}

/// The table has twelve digits, so half a unit of the last is 5e-12.
#[test]
fn shadow_half_angles_have_the_tabulated_values() {
    for [r, at_rest, falling] in SHADOW {
        assert_close(
            format_args!("static, r = {r}"),
            shadow_half_angle_static(r).to_degrees(),
            at_rest,
            5e-12,
        );
        assert_close(
            format_args!("rain, r = {r}"),
            shadow_half_angle_rain(r).to_degrees(),
            falling,
            5e-12,
        );
    }
}

/// Aberration of the static angle by the speed of free fall, 1/sqrt(r): tan(alpha'/2) = sqrt((1 -
/// v)/(1 + v)) tan(alpha/2) outside; at the horizon 42.1034 degrees.
#[test]
fn the_falling_observers_shadow_is_the_static_one_aberrated() {
    for r in [1.02_f64, 1.3, 1.5, 4.0, 300.0] {
        let v = 1.0 / r.sqrt();
        let expected = 2.0
            * (((1.0 - v) / (1.0 + v)).sqrt() * (shadow_half_angle_static(r) / 2.0).tan()).atan();
        assert_close(
            format_args!("r = {r}"),
            shadow_half_angle_rain(r),
            expected,
            1e-13,
        );
    }
    assert_close(
        "at the horizon",
        shadow_half_angle_rain(1.0).to_degrees(),
        42.1034,
        2e-6,
    );
}

/// A boost maps circles on the sky to circles, so the edge is a circle for every observer. On the
/// edge b is b_c, which is not used to construct [`ShadowEdge`].
#[test]
fn the_edge_of_the_shadow_is_a_circle_on_every_observers_sky() {
    for r in [1.0001, 1.02, 1.5, 1.6, 4.0, 300.0, 1e7] {
        for kind in [ObserverKind::Static, ObserverKind::Rain] {
            for velocity in [[0.0; 3], [0.73, 0.37, 0.56], [-0.6, 0.79, 0.01]] {
                let matrix =
                    observer_matrix(0.0, kind, velocity, r, 1.1, 0.4).expect("outside the horizon");
                let [energy, radial, ..] = matrix.rows;
                let ShadowEdge {
                    critical_radial,
                    center,
                    margin_at_center,
                    curvature,
                } = ShadowEdge::new(energy, radial, r);
                let context = format!("{kind:?} at {r} with {velocity:?}");
                // |d - center| = 2 sin(angle/2) on the edge.
                let half = (-margin_at_center / (2.0 * curvature)).sqrt();
                assert!(
                    (1e-9..=0.5_f64.sqrt() + 1e-15).contains(&half),
                    "{context}: half chord {half}"
                );
                let angle = 2.0 * half.asin();
                let (u, v) = center.any_orthonormal_pair();
                for around in [0.1, 1.9, 4.0] {
                    let direction = |angle: f64| {
                        angle.cos() * center
                            + angle.sin() * (f64::sin(around) * u + f64::cos(around) * v)
                    };
                    let photon = matrix.photon(direction(angle));
                    // The angle of a small shadow far away has the relative precision of f64; gamma
                    // is 100 at most.
                    let b = r * photon.w.length() / photon.energy;
                    assert!(
                        (b / CRITICAL_IMPACT - 1.0).abs() < 1e-8 + 1e-14 / angle,
                        "{context}: b = {b}"
                    );
                    // On both sides of the edge the sign is that of the photon's own components.
                    for share in [0.5, 0.9, 1.1] {
                        let direction = direction(share * angle);
                        let photon = matrix.photon(direction);
                        let margin = margin_at_center
                            + 0.5 * curvature * (direction - center).length_squared();
                        let own = photon.radial - critical_radial * photon.energy;
                        let least = 1e-13 * photon.energy.abs().max(1.0) * 1e4;
                        assert!(
                            (margin - own).abs() < least.max(1e-9 * own.abs()),
                            "{context}: {margin:e} and {own:e}"
                        );
                    }
                }
            }
        }
    }
}
