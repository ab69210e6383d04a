//! The light of jets, against values of an independent formulation in other steps and with another
//! integrator.

use crate::assert_close;
use glam::{DVec2, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::mino::PhotonConstants;
use lightfall_core::optics::medium::jet::{Jet, JetPlace, Shape, Travel};
use lightfall_core::optics::medium::{Emission, Nodes, Tolerance};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::{spectrum, synchrotron};
use lightfall_core::scene::{ObserverKind, Scene};

/// The jets of the test values.
fn jet() -> Jet {
    let kerr = Kerr { spin: 0.9 };
    let shape = Shape {
        sheath: [0.84, 0.1],
        spine: [0.08, 0.25],
        rim: 8.0,
        fade: 0.6,
        decay: 1.3,
        ..Shape::new(kerr, [0.3, 1.5, 40.0, 0.8])
    };
    Jet { kerr, shape }
}

#[test]
fn smooth_jets_shine_as_an_independent_formulation_says() {
    let jet = jet();
    let mut scene = Scene::default();
    scene.hole.spin = jet.kerr.spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.fov_deg) = (30.0, 70.0, 66.0);
    scene.observer.kind = ObserverKind::Static;
    let size = DVec2::new(960.0, 540.0);
    let reference = Reference::new(&scene).unwrap();
    let (r, n) = reference.camera();
    let nodes = Nodes::new(12);
    // The sum of g^4 times the emission.
    for (pixel, expected) in [
        ([480.5, 40.5], 5.0615833e-2),
        ([440.5, 100.5], 2.6153441e-1),
        ([520.5, 140.5], 7.1399128e-4),
        ([480.5, 500.5], 1.9009789e-2),
        ([450.5, 430.5], 6.5184846e-2),
    ] {
        let looking = scene.camera.looking(DVec2::from_array(pixel), size);
        let direction = scene.camera.tetrad_from_camera() * looking;
        let photon = reference.photon(direction.normalize());
        let (constants, start) = PhotonConstants::of_photon(jet.kerr, &photon, r, n);
        let light = |place: &JetPlace, _: &Emission| DVec3::splat(place.g.powi(4));
        let seen = jet.passage(&constants, start, &nodes, Tolerance::TRUTH, light);
        // The values have eight digits.
        assert_close(format!("{pixel:?}"), seen.light.x, expected, 1e-7);
    }
}

#[test]
fn the_matter_of_jets_is_slower_than_light_and_leaves_the_hole() {
    let jet = jet();
    let shape = jet.shape;
    let mut last = 0.0;
    for i in 0..200 {
        let r = shape.base * (shape.length / shape.base).powf(f64::from(i) / 199.0);
        for x in [0.0, 0.3, 0.84, 1.0] {
            let cos = 1.0 - shape.width * x * x / r.powf(shape.kappa);
            let (lorentz, velocity) = jet.velocity(r, cos);
            let square: f64 = velocity.iter().map(|v| v * v).sum();
            // The Lorentz factor of this velocity.
            assert_close(r, (1.0 - square).powf(-0.5), lorentz, 1e-12);
            assert!(velocity[0] > 0.0 && velocity[1] <= 0.0 && velocity[2] >= 0.0);
            // Both jets move away from the hole, toward the axis and with the disk.
            let (_, below) = jet.velocity(r, -cos);
            assert_eq!(below, [velocity[0], -velocity[1], velocity[2]]);
        }
        let [time, turn] = Travel::of(&jet).at(r);
        assert!(time >= last && turn >= 0.0);
        last = time;
    }
}

#[test]
fn a_streamline_of_a_jet_is_where_its_matter_flows() {
    // Along psi = const, dtheta/dr = v_theta/(r v_r) of the coordinates, in which the observer with
    // zero angular momentum has dr/dl = sqrt(Delta/Sigma) and dtheta/dl = 1/sqrt(Sigma).
    let jet = jet();
    for (r, x) in [(1.2, 0.84), (3.0, 0.4), (25.0, 0.9)] {
        let cos = |r: f64| 1.0 - jet.shape.width * x * x / f64::powf(r, jet.shape.kappa);
        let h = 1e-5 * r;
        let slope = (cos(r + h).acos() - cos(r - h).acos()) / (2.0 * h);
        let (_, [outward, toward_axis, _]) = jet.velocity(r, cos(r));
        let flow = toward_axis / (outward * jet.kerr.delta(r).sqrt());
        // The difference quotient has an error of h^2.
        assert_close(r, flow, slope, 1e-8);
    }
}

#[test]
fn synchrotron_light_has_the_unit_of_thermal_light() {
    // A black body's spectrum as a sum over the frequencies at which the synchrotron spectrum falls
    // off has no closed form. But both tables are per unit of bolometric flux, so a band that holds
    // all of the flux and has a flat response would give the same luminance. Here the responses are
    // the observer's, and the sum is over wavelengths 1 nm apart instead of 10.
    let luminance = |of_wavelength: &dyn Fn(f64) -> f64| {
        let sum = |i: i32| {
            let nm = 380.0 + f64::from(i);
            of_wavelength(nm) * spectrum::line_xyz(nm).y
        };
        (0..=400).map(sum).sum::<f64>()
    };
    let thermal_flux: f64 = (1..400_000)
        .map(|i| spectrum::planck(0.1 * f64::from(i) + 0.05, 6500.0) * 0.1)
        .sum();
    let white = luminance(&|nm| spectrum::planck(nm, 6500.0)) / thermal_flux;
    for frequency in [0.3, 1.0, 5.0] {
        let of_frequency = |v: f64| v.powf(-0.6) * (-v).exp();
        // v = y^10 takes the pole out of the integrand, and the rest beyond y = 1.5 is 1e-25.
        let flux: f64 = (0..100_000)
            .map(|i| {
                let y = (f64::from(i) + 0.5) * 1.5e-5;
                of_frequency(y.powi(10)) * 10.0 * y.powi(9) * 1.5e-5
            })
            .sum();
        let seen = luminance(&|nm| {
            let nu = 555.0 / nm;
            of_frequency(nu / frequency) / (frequency * flux) * nu * nu / 555.0
        });
        let [r, g, b] = synchrotron::colour(frequency);
        let found = 0.212_639 * r + 0.715_169 * g + 0.072_192 * b;
        // Ten times fewer wavelengths, between which the responses are linear; the sum of a black
        // body's flux over steps of 0.1 nm from 0 to 40 micrometres is 1e-3 short of all of it.
        assert_close(frequency, found, seen / white, 3e-3);
    }
}

#[test]
fn light_beyond_the_table_of_colours_falls_by_its_power() {
    let brightest = |frequency: f64| DVec3::from(synchrotron::colour(frequency)).max_element();
    let [first, last] = synchrotron::TABLE_RANGE;
    for times in [3.0, 1e3, 1e6] {
        let expected = brightest(last) * f64::powf(times, -synchrotron::FALL_BEYOND_TABLE);
        assert_close(times, brightest(times * last), expected, 3e-4);
    }
    assert!(brightest(first) < 3e-7 * brightest(1.0));
}
