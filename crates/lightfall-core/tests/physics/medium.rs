//! The light of matter with depth, against values of an independent formulation in other steps and
//! with another integrator.

use crate::assert_close;
use glam::{DVec2, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::mino::PhotonConstants;
use lightfall_core::optics::disk::newtonian_flux;
use lightfall_core::optics::medium::{
    Emission, Matter, Nodes, Passage, Place, Shape, ThickDisk, Tolerance, emission_scale,
};
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::{LimbDarkening, ObserverKind, Scene};

/// The camera of the test values: static, at r = 20 and 83 degrees, 960x540, 50 degrees.
fn scene(spin: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.fov_deg) = (20.0, 83.0, 50.0);
    scene.observer.kind = ObserverKind::Static;
    scene.disk.follow_isco = true;
    scene.disk.outer = 11.0;
    scene
}

fn disk(spin: f64, thickness: f64, depth: f64, limb: LimbDarkening) -> ThickDisk {
    let kerr = Kerr { spin };
    let shape = Shape {
        edges: [kerr.isco(), 11.0],
        tapers: [0.2, 0.45],
        thickness,
        flare: 0.0,
        depth,
    };
    ThickDisk::new(kerr, shape, limb)
}

/// What a pixel sees through the disk.
fn passage(
    disk: &ThickDisk,
    pixel: [f64; 2],
    nodes: usize,
    light: impl Fn(&Place) -> f64,
) -> Passage {
    let scene = scene(disk.kerr.spin);
    let size = DVec2::new(960.0, 540.0);
    let looking = scene.camera.looking(DVec2::from_array(pixel), size);
    let direction = scene.camera.tetrad_from_camera() * looking;
    let reference = Reference::new(&scene).unwrap();
    let photon = reference.photon(direction.normalize());
    let (r, n) = reference.camera();
    let (constants, start) = PhotonConstants::of_photon(disk.kerr, &photon, r, n);
    let nodes = Nodes::new(nodes);
    disk.passage(&constants, start, &nodes, Tolerance::TRUTH, |place, _| {
        Matter::smooth(DVec3::splat(light(place)))
    })
}

/// g^4 F of the Newtonian disk.
fn beamed_flux(disk: &ThickDisk) -> impl Fn(&Place) -> f64 {
    let inner = disk.shape.edges[0];
    move |place| place.g.powi(4) * newtonian_flux(place.r, inner)
}

#[test]
fn the_smooth_thick_disk_shines_as_an_independent_formulation_says() {
    // Columns: h = 0.05 and depth 20, isothermal and scattering; h = 0.1 and depth 3, isothermal,
    // and the optical depth of its whole way.
    let rows = [
        (
            0.0,
            [200.5, 300.5],
            [2.5913869e-2, 1.8346390e-2, 3.1168909e-2, 4.8675026],
        ),
        (
            0.0,
            [760.5, 300.5],
            [4.8258017e-3, 3.0231933e-3, 4.9867442e-3, 7.8509687],
        ),
        (
            0.0,
            [480.5, 150.5],
            [2.3706265e-2, 2.3303577e-2, 2.3458180e-2, 4.8554812],
        ),
        (
            0.0,
            [430.5, 190.5],
            [1.2447736e-2, 1.0021737e-2, 7.2517780e-3, 0.50405645],
        ),
        (
            0.9,
            [480.5, 150.5],
            [2.8023913e-3, 2.7028433e-3, 2.8120927e-3, 4.7115465],
        ),
        (
            0.9,
            [430.5, 190.5],
            [1.2012230e-2, 1.2364659e-2, 1.1918175e-2, 4.6423200],
        ),
        (
            0.9,
            [600.5, 215.5],
            [1.5317896e-3, 1.0762691e-3, 1.5306092e-3, 11.306377],
        ),
    ];
    for (spin, pixel, [opaque, scattering, thin, depth]) in rows {
        let seen = |thickness, depth, limb| {
            let disk = disk(spin, thickness, depth, limb);
            passage(&disk, pixel, 12, beamed_flux(&disk))
        };
        let found = [
            seen(0.05, 20.0, LimbDarkening::None).light.x,
            seen(0.05, 20.0, LimbDarkening::ElectronScattering).light.x,
            seen(0.1, 3.0, LimbDarkening::None).light.x,
            seen(0.1, 3.0, LimbDarkening::None).depth,
        ];
        // The values have eight digits. Their scale of emission is a sum over 4000 slices of the disk,
        // which is 1.6e-7 too low.
        let scale = emission_scale(20.0) / 1.014_893_528_9;
        let scattering = scattering * scale;
        for (found, expected) in found.into_iter().zip([opaque, scattering, thin, depth]) {
            assert_close(format!("{spin} {pixel:?}"), found, expected, 1e-7);
        }
    }
}

#[test]
fn each_face_of_a_scattering_disk_emits_its_flux() {
    // The same integral as a sum over 16000 slices of the disk and 64 angles.
    for (depth, scale) in [
        (3.0, 1.103_654_158_9),
        (10.0, 1.030_395_756_7),
        (20.0, 1.014_893_684_7),
        (50.0, 1.005_891_525_0),
    ] {
        assert_close(depth, emission_scale(depth), scale, 3e-8);
    }
    assert_close("opaque", emission_scale(1e4), 1.0, 1e-3);
    // A layer of no depth is seen through: its two faces together emit what its matter does.
    assert_close("thin", emission_scale(1e-6), 1.0, 1e-3);
}

#[test]
fn the_thin_limit_is_the_sheet() {
    // Isothermal and opaque, 5 % away from the edges: the error is the parallax of a surface above
    // the plane, which is proportional to the thickness.
    for (spin, theta_deg) in [(0.0, 60.0), (0.9, 60.0), (0.0, 83.0)] {
        let mut scene = scene(spin);
        scene.camera.theta_deg = theta_deg;
        let reference = Reference::new(&scene).unwrap();
        let axes = scene.camera.tetrad_from_camera();
        let size = DVec2::new(960.0, 540.0);
        let kerr = Kerr { spin };
        let [inner, outer] = [kerr.isco(), 11.0];
        let (r, n) = reference.camera();
        let nodes = Nodes::new(12);
        let mut errors = Vec::new();
        for i in 0..600 {
            let place = DVec2::new(0.754_877_67, 0.569_840_29) * f64::from(i) + 0.5;
            let looking = scene.camera.looking(place.fract() * size, size);
            let direction = (axes * looking).normalize();
            let Some(hit) = reference.trace(direction).hits[0] else {
                continue;
            };
            if hit.r < 1.3 * inner || hit.r > 0.5 * outer {
                continue;
            }
            let sheet = hit.g.powi(4) * newtonian_flux(hit.r, inner);
            let (constants, start) =
                PhotonConstants::of_photon(kerr, &reference.photon(direction), r, n);
            let thick = |thickness| {
                let disk = disk(spin, thickness, 50.0, LimbDarkening::None);
                let flux = beamed_flux(&disk);
                let matter =
                    |place: &Place, _: &Emission| Matter::smooth(DVec3::splat(flux(place)));
                let seen = disk.passage(&constants, start, &nodes, Tolerance::TRUTH, matter);
                seen.light.x
            };
            let extrapolated = 2.0 * thick(0.0005) - thick(0.001);
            errors.push((extrapolated / sheet - 1.0).abs());
        }
        errors.sort_by(f64::total_cmp);
        assert!(errors.len() > 10, "{}", errors.len());
        let worst = errors[errors.len() * 95 / 100];
        assert!(worst < 1e-3, "{spin} {theta_deg}: {worst:e}");
    }
}
