//! Special radii and circular orbits of Kerr against a table, expansions and the metric.

use crate::assert_close;
use lightfall_core::geometry::kerr::Kerr;

/// chi; then r_+, photon orbits (prograde, retrograde, polar), ISCO pro and
/// retro, in M. Computed with mpmath to 25 digits from Bardeen, Press & Teukolsky 1972.
const RADII: [[f64; 7]; 9] = [
    [0.0, 2.0, 3.0, 3.0, 3.0, 6.0, 6.0],
    [
        0.5,
        1.866025403784,
        2.347296355334,
        3.532088886238,
        2.883217741926,
        4.233002529531,
        7.554584714512,
    ],
    [
        0.7,
        1.714142842854,
        2.013334123597,
        3.725345250762,
        2.757906597637,
        3.393128470182,
        8.142965464834,
    ],
    [
        0.8,
        1.6,
        1.811085980236,
        3.818763716896,
        2.670621816075,
        2.906643854464,
        8.431757830806,
    ],
    [
        0.9,
        1.435889894354,
        1.557854627423,
        3.910267939103,
        2.559996869366,
        2.320883041762,
        8.717352279606,
    ],
    [
        0.94,
        1.341174442185,
        1.425244268703,
        3.946366077483,
        2.506945482174,
        2.0235931047,
        8.830752019186,
    ],
    [
        0.98,
        1.198997487421,
        1.239545082117,
        3.982189143377,
        2.447179035554,
        1.614029667635,
        8.943695231691,
    ],
    [
        0.998,
        1.063213922517,
        1.07390925768,
        3.998221892848,
        2.417615475358,
        1.236970655175,
        8.994374454804,
    ],
    [
        0.9999,
        1.014141782066,
        1.01637427063,
        3.999911110288,
        2.414384242149,
        1.078526434646,
        8.999718748638,
    ],
];

/// chi and 1 - E at the prograde ISCO, from the same table.
const EFFICIENCY: [[f64; 2]; 5] = [
    [0.0, 0.05719095841794],
    [0.5, 0.08211799333922],
    [0.9, 0.1557529919945],
    [0.998, 0.3209941656162],
    [0.9999, 0.3820415314851],
];

/// The table has twelve decimals, so a relative 1e-12 is its own rounding.
#[test]
fn special_radii_have_the_tabulated_values() {
    for [chi, horizon, pro, retro, polar, isco_pro, isco_retro] in RADII {
        let (kerr, mirrored) = (Kerr { spin: chi }, Kerr { spin: -chi });
        for (what, found, expected) in [
            ("horizon", kerr.horizon(), horizon),
            ("prograde photon orbit", kerr.photon_orbit_prograde(), pro),
            (
                "retrograde photon orbit",
                kerr.photon_orbit_retrograde(),
                retro,
            ),
            ("polar photon orbit", kerr.photon_orbit_polar(), polar),
            ("ISCO", kerr.isco(), isco_pro),
            ("ISCO against the spin", mirrored.isco(), isco_retro),
        ] {
            assert_close(
                format_args!("{what}, chi {chi}"),
                found,
                expected / 2.0,
                1e-12,
            );
        }
    }
}

/// Near |chi| = 1 the radii follow their expansions in delta = sqrt(1 - chi^2) or in the cube root
/// of 1 - chi. The next terms of the expansions set the tolerance. A formula with cancellation
/// would lose all digits here.
#[test]
fn near_extremal_spins_keep_their_digits() {
    let gap = 2.0_f64.powi(-46);
    let kerr = Kerr { spin: 1.0 - gap };
    let horizon = (kerr.horizon() / 0.5 - 1.0) / (2.0 * gap).sqrt();
    assert_close("r_+ - M in units of M sqrt(2 eps)", horizon, 1.0, 1e-8);
    // r_ISCO/M = 1 + (4 eps)^(1/3) + O(eps^(2/3)): Bardeen, Press & Teukolsky 1972 eq. 2.21
    // expanded.
    let isco = (kerr.isco() / 0.5 - 1.0) / (4.0 * gap).cbrt();
    assert_close("ISCO - M in units of M (4 eps)^(1/3)", isco, 1.0, 5e-5);
    // r_ph/M = 1 + 2 sqrt(2 eps / 3) + O(eps).
    let photon = (kerr.photon_orbit_prograde() / 0.5 - 1.0) / (2.0 * (2.0 * gap / 3.0).sqrt());
    assert_close("photon orbit - M", photon, 1.0, 1e-7);
}

/// For small spin the ISCO is 6 M (1 - 4 sqrt(2/3) chi / 6 ...), linear through zero. A relative
/// 1e-13 allows for rounding; the textbook form loses half of all digits here.
#[test]
fn the_isco_is_linear_in_small_spins() {
    for chi in [1e-7, -1e-7, 1e-10, 0.0] {
        let expected = 3.0 - 2.0 * (2.0_f64 / 3.0).sqrt() * chi;
        assert_close(
            format_args!("ISCO, chi {chi}"),
            Kerr { spin: chi }.isco(),
            expected,
            1e-13,
        );
    }
}

/// At the ISCO the energy of circular orbits has its minimum, so its tabulated value checks the
/// energy, and a central difference vanishes to second order.
#[test]
fn circular_orbits_have_the_published_efficiency_at_the_isco() {
    for [chi, efficiency] in EFFICIENCY {
        let kerr = Kerr { spin: chi };
        let energy = kerr.circular_orbit(kerr.isco()).unwrap().energy;
        assert_close(
            format_args!("efficiency, chi {chi}"),
            1.0 - energy,
            efficiency,
            1e-11,
        );
    }
}

/// u.u = -1 with u = u^t (1, 0, 0, Omega) in the metric's own components, and p_t = -E, p_phi = L
/// by lowering the index: the metric is written here from Bardeen, Press & Teukolsky 1972 eq. 2.1
/// and shares nothing with the orbit's formulas.
#[test]
fn circular_orbits_are_normalised_geodesics() {
    for chi in [-0.99, -0.3, 0.0, 0.5, 0.998] {
        let kerr = Kerr { spin: chi };
        for r in [1.05 * kerr.photon_orbit_prograde(), kerr.isco(), 7.0, 1e4] {
            let (a, orbit) = (chi / 2.0, kerr.circular_orbit(r).unwrap());
            let (g_tt, g_tphi, g_phiphi) = (-(1.0 - 1.0 / r), -a / r, r * r + a * a + a * a / r);
            let (u_t, u_phi) = (orbit.u_t, orbit.u_t * orbit.angular_velocity);
            let norm = g_tt * u_t * u_t + 2.0 * g_tphi * u_t * u_phi + g_phiphi * u_phi * u_phi;
            let scale = g_phiphi * u_phi * u_phi + u_t * u_t;
            assert!(
                (norm + 1.0).abs() < 1e-14 * scale,
                "chi {chi}, r {r}: u.u = {norm}"
            );
            assert!(
                (g_tt * u_t + g_tphi * u_phi + orbit.energy).abs() < 1e-13 * u_t,
                "energy, chi {chi}, r {r}"
            );
            let momentum = g_tphi * u_t + g_phiphi * u_phi;
            assert_close(
                format_args!("L, chi {chi}, r {r}"),
                orbit.angular_momentum,
                momentum,
                1e-12,
            );
            // A geodesic: d(g_tt + 2 Omega g_tphi + Omega^2 g_phiphi)/dr = 0 at fixed Omega.
            let omega = orbit.angular_velocity;
            let pull = -1.0 / (r * r)
                + 2.0 * omega * a / (r * r)
                + omega * omega * (2.0 * r - a * a / (r * r));
            assert!(
                pull.abs() < 1e-13 / (r * r),
                "chi {chi}, r {r}: force {pull:e}"
            );
        }
        assert_eq!(
            kerr.circular_orbit(kerr.photon_orbit_prograde()),
            None,
            "chi {chi}"
        );
    }
}
