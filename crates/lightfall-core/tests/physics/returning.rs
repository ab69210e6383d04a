//! Light that returns to the disk: rays against published numbers, the flux against another tracer,
//! and the table against the rays.

use crate::assert_close;
use crate::disk::sampled_flux;
use lightfall_core::geometry::chebyshev::Chebyshev;
use lightfall_core::geometry::kerr::{Kerr, MASS};
use lightfall_core::geometry::quadrature::gauss_legendre;
use lightfall_core::optics::disk::returning::{Arrival, Return, Sampling, Source, upper_sky};
use lightfall_core::optics::disk::returning_table::{DEPTHS, MAX_SPIN, ReturningLight, spins};
use lightfall_core::optics::disk::{PageThorne, Profile};
use lightfall_core::optics::limb::electron_scattering;
use lightfall_core::scene::{DiskModel, LimbDarkening, Scene};
use std::f64::consts::TAU;

const SAMPLING: Sampling = Sampling {
    nodes: 20,
    azimuths: 64,
};

fn at_the_isco(spin: f64) -> PageThorne {
    PageThorne::new(spin, Kerr { spin }.isco())
}

fn sky_of_disk(spin: f64, r: f64) -> Vec<Arrival> {
    upper_sky(spin, Some(Kerr { spin }.isco()), r, SAMPLING).unwrap()
}

/// The sum over the arrivals from such sources.
fn total(
    sky: &[Arrival],
    is_meant: impl Fn(Source) -> bool,
    part: impl Fn(&Arrival) -> f64,
) -> f64 {
    sky.iter()
        .filter(|arrival| is_meant(arrival.source))
        .map(part)
        .sum()
}

/// The flux that falls down from such a sky, if the disk that shines in it has this limb law and flux.
fn fallen(sky: &[Arrival], law: LimbDarkening, disk: &PageThorne) -> f64 {
    sky.iter()
        .filter_map(|arrival| arrival.flux_from_disk(law))
        .map(|(r, share)| share * disk.flux(r))
        .sum()
}

/// The matter's half sky has 2 pi steradians, and a surface under a bright sky receives all of pi
/// F/pi, however fast it moves. The midpoint rule over 64 azimuths is off by pi^2/24/64^2 = 1e-4.
#[test]
fn returning_light_comes_from_half_a_sky() {
    for (spin, r) in [
        (-0.9, 5.0),
        (0.0, 3.0),
        (0.0, 300.0),
        (0.998, 0.62),
        (0.998, 8.0),
    ] {
        let sky = sky_of_disk(spin, r);
        let what = format_args!("spin {spin}, r {r}");
        assert_close(
            what,
            total(&sky, |_| true, |arrival| arrival.solid_angle),
            TAU,
            3e-4,
        );
        assert_close(what, total(&sky, |_| true, Arrival::share), 1.0, 3e-4);
    }
}

/// Igata, Nakashi & Ogasawara 2020: of the photons that matter at the innermost stable orbit emits
/// evenly in all directions around a hole of spin 0.998, 58.8 % escape. Light that arrives has the
/// same paths, in reverse. The tolerance is the rounding of their number and 1e-4 for the edge of the
/// hole's image: twice as many rays change the share by 5e-5.
#[test]
fn returning_rays_escape_as_often_as_published() {
    let spin = 0.998;
    let sampling = Sampling {
        nodes: 80,
        azimuths: 256,
    };
    let sky = upper_sky(spin, None, Kerr { spin }.isco(), sampling).unwrap();
    let escaped = total(
        &sky,
        |source| source == Source::Sky,
        |arrival| arrival.solid_angle,
    );
    assert!((escaped / TAU - 0.588).abs() < 6e-4, "{}", escaped / TAU);
}

/// At spin 0.998 and r = 0.973 another tracer, in Mino time with other integrators, finds 34 % of the
/// light on the disk and 22 % in the hole.
#[test]
fn returning_light_is_divided_between_disk_hole_and_sky_as_another_tracer_says() {
    let sky = sky_of_disk(0.998, 0.973);
    for (is_meant, expected) in [
        (
            (|source| matches!(source, Source::Disk { .. })) as fn(Source) -> bool,
            0.34,
        ),
        (|source| source == Source::Hole, 0.22),
        (|source| source == Source::Sky, 0.44),
    ] {
        let share = total(&sky, is_meant, Arrival::share);
        assert!((share - expected).abs() < 0.005, "{share}, not {expected}");
    }
}

/// What the hole gains from the disk per rest mass that it accretes: energy and angular momentum (in
/// r_s) of the matter at the inner edge and of the light that the hole swallows. As in Thorne 1974
/// the disk is no obstacle to its light.
fn gain(spin: f64, limb: fn(f64) -> f64) -> [f64; 2] {
    let (kerr, disk) = (Kerr { spin }, at_the_isco(spin));
    let inner = disk.inner();
    let orbit = kerr.circular_orbit(inner).unwrap();
    let mut gain = [orbit.energy, orbit.angular_momentum];
    for (p, weight) in gauss_legendre(20) {
        let x = 1.0 - p * p;
        let r = inner / (x * x);
        // 4 pi r F / Mdot dr: both faces of a ring, with r = r_in/x^2.
        let flux = 1.5 / (MASS * (inner / MASS).powf(1.5)).powi(2) * disk.flux(r) / disk.scale();
        let emitted = weight * 4.0 * p * inner / x.powi(3) * r * flux;
        let sampling = Sampling {
            nodes: 14,
            ..SAMPLING
        };
        for arrival in upper_sky(spin, None, r, sampling).unwrap() {
            // The reverse of a path on which light arrives leads light away at the same angle.
            if arrival.source == Source::Hole {
                let swallowed = emitted * arrival.share() * limb(arrival.cosine);
                gain[0] += swallowed * arrival.energy;
                gain[1] += swallowed * arrival.angular_momentum;
            }
        }
    }
    gain
}

/// Thorne 1974, as later works quote him; his paper was not at hand. The light that a hole swallows stops its accretion from spinning it up at 0.9978 if
/// the disk shines evenly in all directions, and at 0.9982 if it scatters on electrons. There 30.2 and
/// 30.8 % of the rest mass escape as light. His disk is transparent: with an opaque one the spins are about
/// 0.9984 and 0.9987. d(J/M^2) = 0 where L = 2 chi M E. The excess is nearly
/// linear between two spins about the limit, so the secant gives its root within 1e-5. The tolerances
/// are half a unit of his last digits, and a tenth of a unit for the rays.
#[test]
fn returning_rays_to_the_hole_give_thornes_limiting_spins() {
    let even: fn(f64) -> f64 = |_| 1.0;
    for (limb, limit, efficiency) in [(even, 0.9978, 0.302), (electron_scattering, 0.9982, 0.308)] {
        let ends = [limit - 0.0002, limit + 0.0002];
        let [low, high] = ends.map(|spin| {
            let [energy, angular_momentum] = gain(spin, limb);
            [angular_momentum - 2.0 * MASS * spin * energy, 1.0 - energy]
        });
        let share = low[0] / (low[0] - high[0]);
        let spin = ends[0] + (ends[1] - ends[0]) * share;
        assert!((spin - limit).abs() < 6e-5, "{spin}, not {limit}");
        let escaped = 0.5 * (low[1] + high[1]);
        assert!(
            (escaped - efficiency).abs() < 6e-4,
            "{escaped}, not {efficiency}"
        );
    }
}

/// chi, r/r_in, then the disk's own light that falls back over its flux, for electron scattering and
/// without limb darkening: from another tracer (quintic steps of Mino time, linear interpolation of
/// its own closed form of the flux), with 600 x 256 rays from each place.
const FALLEN: [[f64; 4]; 9] = [
    [0.0, 1.5, 0.018_352, 0.024_518],
    [0.0, 3.1, 0.010_606, 0.013_820],
    [0.0, 20.0, 0.013_575, 0.017_530],
    [0.9, 1.5, 0.077_807, 0.087_322],
    [0.9, 3.1, 0.048_722, 0.053_405],
    [0.9, 20.0, 0.060_920, 0.066_530],
    [0.998, 1.5, 0.205_633, 0.207_192],
    [0.998, 3.1, 0.173_688, 0.172_442],
    [0.998, 20.0, 0.187_922, 0.188_536],
];

/// Both sample the edges of images with few rays. With these the largest measured difference is 0.4
/// %, and 1.8 % at 1.5 r_in without spin, where the light is 2 % of the flux.
#[test]
fn returning_flux_is_that_of_another_tracer() {
    for [spin, ratio, scattered, even] in FALLEN {
        let disk = at_the_isco(spin);
        let r = ratio * disk.inner();
        let sky = sky_of_disk(spin, r);
        for (law, expected) in [
            (LimbDarkening::ElectronScattering, scattered),
            (LimbDarkening::None, even),
        ] {
            let found = fallen(&sky, law, &disk) / disk.flux(r);
            let allowed = 5e-4 * (1.0 + expected / 0.2);
            assert!(
                (found - expected).abs() < allowed,
                "{spin}, {ratio}: {found}, {expected}"
            );
        }
    }
}

/// A polynomial of as many coefficients as there are nodes is found again. 1e-13 allows for rounding.
#[test]
fn returning_table_is_interpolated_exactly_where_it_is_a_polynomial() {
    let chebyshev = Chebyshev::<5>::new();
    let polynomial = |x: f64| 1.0 + x * (2.0 + x * (-3.0 + x * (0.5 - 4.0 * x)));
    let values = chebyshev.nodes.map(polynomial);
    for place in [0.0, 0.3, chebyshev.nodes[2], 0.77, 1.0] {
        assert_close(
            place,
            chebyshev.value(&values, place),
            polynomial(place),
            1e-13,
        );
    }
}

/// The disk's own flux without returning light, in units of the flux without an edge.
fn own_flux(disk: &PageThorne, depth: f64) -> f64 {
    let x = 1.0 - depth;
    disk.flux(disk.inner() / (x * x)) / (disk.scale() * x.powi(6))
}

/// Between the table's spins, at one of them, and at the spin for which this light is best known. The
/// rays are a sixth of the table's, which shows where the light is faint: it may differ by 12 % of
/// itself (measured: 10 % at -0.7, 2 % from spin 0.9 on), and from 1.2 r_in on by 0.2 % of the flux
/// (measured: 0.13 %).
#[test]
fn returning_table_is_the_light_that_rays_find() {
    for spin in [-0.7, spins()[4], 0.998] {
        let disk = at_the_isco(spin);
        let returns = Return::on_disk(&disk, LimbDarkening::ALL, SAMPLING).unwrap();
        for (law, found) in LimbDarkening::ALL.into_iter().zip(returns) {
            let table = ReturningLight::new(spin, law);
            for (depth, light) in DEPTHS.nodes.into_iter().zip(found.light(60)) {
                let error = (table.at(depth) - light).abs();
                let flux = own_flux(&disk, depth) + light;
                assert!(
                    error < 0.12 * light && (depth < 0.087 || error < 2e-3 * flux),
                    "spin {spin}, {}, depth {depth}: {error:e}",
                    law.word()
                );
            }
        }
    }
}

/// Between the table's radii the light is found directly: the disk's own light that falls there, and
/// that of the table which has fallen before. At 1.03 r_in, where the light is faint without spin and
/// the flux nearly zero, they differ by 0.8 % of the flux; farther out by 0.12 % at most.
#[test]
fn returning_table_holds_between_its_radii() {
    let law = LimbDarkening::ElectronScattering;
    for spin in [0.0, 0.9, 0.998] {
        let disk = at_the_isco(spin);
        let lit = disk.with_returning(ReturningLight::new(spin, law));
        for ratio in [1.03, 1.25, 1.55, 2.1, 4.0, 10.0, 50.0] {
            let r = ratio * disk.inner();
            let sky = sky_of_disk(spin, r);
            let error =
                (fallen(&sky, law, &lit) - (lit.flux(r) - disk.flux(r))).abs() / lit.flux(r);
            let allowed = if ratio < 1.1 { 1e-2 } else { 1.5e-3 };
            assert!(error < allowed, "spin {spin}, {ratio} r_in: {error:e}");
        }
    }
}

/// A hole faster than any of the table has the light of the fastest.
#[test]
fn returning_table_ends_at_its_fastest_hole() {
    for law in LimbDarkening::ALL {
        assert_eq!(
            ReturningLight::new(1.0 - 1e-9, law),
            ReturningLight::new(MAX_SPIN, law)
        );
    }
}

fn relativistic(spin: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    scene.disk.model = DiskModel::PageThorne;
    scene.disk.follow_isco = true;
    scene.disk.limb = LimbDarkening::ElectronScattering;
    scene.disk.returning = true;
    scene
}

/// F_tot/F - 1 as docs/physics/disk.md has it, for electron scattering, rounded there to three
/// digits.
const ADDED: [(f64, [f64; 6]); 3] = [
    (0.0, [2.67, 0.0187, 0.0117, 0.0108, 0.0117, 0.0138]),
    (0.9, [10.2, 0.0853, 0.0565, 0.0532, 0.0576, 0.0657]),
    (0.998, [14.2, 0.297, 0.248, 0.242, 0.244, 0.245]),
];

#[test]
fn returning_light_adds_as_much_to_the_profile_as_documented() {
    for (spin, added) in ADDED {
        let (lit, disk) = (Profile::new(&relativistic(spin)), at_the_isco(spin));
        for (ratio, expected) in [1.02, 1.5, 2.2, 3.1, 6.6, 20.0].into_iter().zip(added) {
            let r = ratio * disk.inner();
            assert_close(
                format_args!("spin {spin}, {ratio} r_in"),
                lit.flux(r) / disk.flux(r) - 1.0,
                expected,
                5e-3,
            );
        }
        // The scale is that of the disk's own flux, so a disk that counts the light is brighter.
        let Profile::PageThorne(lit) = lit else {
            panic!("the profile is not the relativistic one");
        };
        assert_eq!(lit.scale(), disk.scale());
    }
}

/// Every change takes the returning light away; then the profile is the same, bit for bit, as without
/// the field.
#[test]
fn returning_light_exists_only_where_it_is_known() {
    let changes: [fn(&mut Scene); 5] = [
        |_| (),
        |scene| scene.disk.returning = false,
        |scene| scene.disk.model = DiskModel::Newtonian,
        |scene| scene.effects.lensing = false,
        |scene| (scene.disk.follow_isco, scene.disk.inner) = (false, 4.0),
    ];
    for (i, change) in changes.into_iter().enumerate() {
        let mut scene = relativistic(0.5);
        change(&mut scene);
        let mut without = scene.clone();
        without.disk.returning = false;
        let same = Profile::new(&scene) == Profile::new(&without);
        assert_eq!(same, i > 0, "change {i}");
    }
    // An edge inside the innermost stable orbit is that orbit.
    let mut scene = relativistic(0.5);
    (scene.disk.follow_isco, scene.disk.inner) = (false, 0.1);
    assert!(scene.has_returning_light());
}

/// The shader's table, in f64, against the profile. Its cubics hold 1/p^2 the better the farther out
/// they lie. So the error is stated as a share of the returning light at the edge, by radius; the disk
/// fades over the first hundredths of the radius in most scenes. Measured: 3 % and 1.8 %, then
/// 1.9e-3, 4.5e-4 and 3.4e-5.
#[test]
fn returning_light_is_in_the_shaders_table() {
    let bounds = [1.000_25, 1.0005, 1.002, 1.005, 1.02, 1e3];
    let allowed = [0.04, 0.02, 2.5e-3, 6e-4, 5e-5];
    for spin in [-0.9, 0.0, 0.9, 0.998, 0.999_99] {
        let Profile::PageThorne(disk) = Profile::new(&relativistic(spin)) else {
            panic!("the profile is not the relativistic one");
        };
        let (table, inner) = (disk.table(), disk.inner());
        let edge = disk.flux(inner * (1.0 + 1e-9));
        for (ends, allowed) in bounds.windows(2).zip(allowed) {
            for i in 0..=1000 {
                let share = f64::from(i) / 1000.0;
                let beyond = (ends[0] - 1.0_f64).powf(1.0 - share) * (ends[1] - 1.0).powf(share);
                let r = inner * (1.0 + beyond);
                let error = (sampled_flux(&table, inner, r) - disk.flux(r)).abs() / edge;
                assert!(error < allowed, "spin {spin}, r {r}: {error:e}");
            }
        }
    }
}
