//! What the header of an EXR file and docs/PICTURES.md say of the unit of its light.

use super::linear::{linear, small};
use lightfall_core::optics::spectrum;
use lightfall_core::scene::{DiskModel, DiskStructure, HotSpotKind, LimbDarkening, Scene, SkyMode};

/// A thin and smooth disk of the Newtonian model, whose pixels have one ray each.
fn scene() -> Scene {
    let mut scene = small(2);
    scene.disk.model = DiskModel::Newtonian;
    (scene.disk.follow_isco, scene.disk.keep_accretion) = (false, false);
    (scene.disk.inner, scene.disk.outer, scene.disk.edge_taper) = (5.0, 14.0, 0.05);
    (scene.disk.temperature_k, scene.disk.brightness) = (9000.0, 1.7);
    (scene.disk.structure, scene.disk.limb) = (DiskStructure::None, LimbDarkening::None);
    (scene.disk.transmission, scene.disk.returning) = (0.0, false);
    (scene.hot_spot.kind, scene.probe.enabled) = (HotSpotKind::None, false);
    (scene.sky.mode, scene.picture.antialias) = (SkyMode::Off, false);
    scene
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_light_of_a_thin_disk_is_that_which_the_header_states() {
    let scene = scene();
    let linear = linear(&scene, "--aov hit1_radius,hit1_shift");
    // The factor is read from the file, so that what it states is what is compared.
    let factor = |channel: &str| -> f64 {
        let stated = &linear.texts[&format!("lightfall.unit.{channel}")];
        let (before, _) = stated
            .split_once(" disk.brightness F g^4 C(gT)")
            .unwrap_or_else(|| panic!("{stated}"));
        before.rsplit(' ').next().unwrap().parse().unwrap()
    };
    let factors = ["R", "G", "B"].map(factor);
    assert_eq!(factors, [10.0; 3]);
    let (radii, shifts) = (
        linear.values("hit1_radius.Y"),
        linear.values("hit1_shift.Y"),
    );
    let light = linear.light();
    let mut compared = 0;
    for (i, (r, g)) in radii.into_iter().zip(shifts).enumerate() {
        // Between the edges, at which the light fades within a twentieth of the radius.
        if !(5.3..13.2).contains(&r) {
            continue;
        }
        let x = 5.0 / r;
        let flux = x.powi(3) * (1.0 - x.sqrt());
        let colour = spectrum::colour(g * 9000.0 * flux.powf(0.25));
        for (channel, (factor, colour)) in factors.into_iter().zip(colour).enumerate() {
            let stated = factor * 1.7 * flux * g.powi(4) * colour.max(0.0);
            let found = light[channel][i];
            // Half floats have 11 bits, and the table of colours is good to a thousandth of the
            // largest channel.
            let largest = [0, 1, 2]
                .map(|c| light[c][i])
                .into_iter()
                .fold(0.0, f64::max);
            assert!(
                (found - stated).abs() < 2e-3 * largest,
                "{found} and {stated} in channel {channel} at r = {r}, g = {g}"
            );
        }
        compared += 1;
    }
    assert!(compared > 3000, "only {compared} pixels of the disk");
}

/// The number of docs/PICTURES.md: lumens per watt of a black body of 6500 K, by Planck's law in SI units
/// (constants of CODATA 2018) and 683 lumens per watt at the peak of the eye's response.
#[test]
fn one_unit_of_light_is_as_bright_as_the_documents_state() {
    let (planck, speed, boltzmann): (f64, f64, f64) =
        (6.626_070_15e-34, 299_792_458.0, 1.380_649e-23);
    let stefan_boltzmann = 5.670_374_419e-8;
    let kelvin = 6500.0;
    let luminance: f64 = spectrum::colour_matching()
        .unwrap()
        .iter()
        .map(|(nm, response)| {
            let metres = nm * 1e-9;
            let heat = planck * speed / (metres * boltzmann * kelvin);
            let radiance = 2.0 * planck * speed * speed / metres.powi(5) / heat.exp_m1();
            683.0 * response.y * radiance * 10e-9
        })
        .sum();
    let per_watt = luminance / (stefan_boltzmann * kelvin.powi(4) / std::f64::consts::PI);
    assert!((per_watt - 95.4).abs() < 0.05, "{per_watt}");
    // A disk of brightness 1 with the usual 18 000 K.
    let unit = per_watt * stefan_boltzmann * 18_000_f64.powi(4) / (10.0 * std::f64::consts::PI);
    assert!((unit / 1.81e10 - 1.0).abs() < 5e-3, "{unit}");
    let documents = include_str!("../../docs/PICTURES.md");
    for number in ["95.4", "1.81e10", "10 B F g^4 C(gT)"] {
        assert!(documents.contains(number), "{number} is not stated");
    }
}
