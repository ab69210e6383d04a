//! The stretches of a ray's way on which there is matter with depth.

use glam::DVec2;
use lightfall_core::optics::medium::{MatterKind, Medium, Stretch, ThickDisk, Tolerance};
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::{ObserverKind, Scene};

const TOLERANCE: Tolerance = Tolerance {
    relative: 1e-9,
    end_depth: 60.0,
};

/// A camera above a disk with thickness that lets light through.
fn scene() -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = 0.9;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.fov_deg) = (20.0, 75.0, 40.0);
    scene.observer.kind = ObserverKind::Static;
    (
        scene.disk.follow_isco,
        scene.disk.outer,
        scene.disk.edge_taper,
    ) = (true, 11.0, 0.2);
    (scene.disk.thickness, scene.disk.depth) = (0.1, 1.0);
    scene
}

/// The stretches of the rays of a grid of pixels, and the optical depths and the means of their whole ways.
fn ways(scene: &Scene) -> Vec<(Vec<Stretch>, lightfall_core::optics::medium::Passage)> {
    let (medium, reference) = (
        Medium::of(scene, 8).unwrap(),
        Reference::new(scene).unwrap(),
    );
    let (columns, rows) = (16, 9);
    let pixels = (0..columns * rows)
        .map(|i| DVec2::new(f64::from(i % columns), f64::from(i / columns)) + 0.5);
    let size = DVec2::new(f64::from(columns), f64::from(rows));
    pixels
        .map(|pixel| {
            let looking = scene.camera.looking(pixel, size);
            let direction = scene.camera.tetrad_from_camera() * looking;
            let photon = reference.photon(direction.normalize());
            let (stretches, _) = medium.stretches(&photon, TOLERANCE);
            (stretches, medium.seen_with_means(&photon, TOLERANCE))
        })
        .collect()
}

#[test]
fn stretches_add_up_to_the_way() {
    let mut lit = 0;
    for (stretches, way) in ways(&scene()) {
        let depth: f64 = stretches.iter().map(|stretch| stretch.depth).sum();
        assert!(
            (depth - way.depth).abs() <= 1e-12 * (1.0 + depth),
            "{depth}"
        );
        let Some(means) = way.means() else {
            assert!(stretches.iter().all(|stretch| stretch.share == 0.0));
            continue;
        };
        lit += 1;
        let share: f64 = stretches.iter().map(|stretch| stretch.share).sum();
        assert!((share - 1.0).abs() < 1e-12, "{share}");
        let mean = |of: fn(&lightfall_core::optics::medium::Means) -> f64| -> f64 {
            let parts = stretches.iter();
            parts
                .filter_map(|part| Some(part.share * of(&part.means?)))
                .sum()
        };
        assert!((mean(|means| means.r) - means.r).abs() < 1e-9 * means.r);
        assert!((mean(|means| means.delay) - means.delay).abs() < 1e-9 * means.delay);
    }
    assert!(lit > 20, "{lit}");
}

#[test]
fn stretches_begin_and_end_at_the_surface_of_the_matter() {
    let scene = scene();
    let disk = ThickDisk::of(&scene).unwrap();
    let [inner, outer] = disk.shape.edges;
    let mut found = 0;
    for (stretches, _) in ways(&scene) {
        for stretch in &stretches {
            assert_eq!(stretch.kind, MatterKind::Disk);
            for (r, height) in stretch.r.into_iter().zip(stretch.height) {
                let cos_theta = (height / r).abs();
                let at_wall = (r - inner).abs() < 1e-6 * inner || (r - outer).abs() < 1e-6 * outer;
                let off = (cos_theta - disk.half_opening(r)).abs();
                // The surface is found by halving a step to its last digit, some 1e-15 of it.
                assert!(at_wall || off < 1e-9, "{r} {height}: {off:e}");
            }
            found += 1;
        }
        // From the camera on, each light is older than the one before.
        let delays = stretches.iter().filter_map(|stretch| stretch.means);
        let delays: Vec<f64> = delays.map(|means| means.delay).collect();
        assert!(delays.is_sorted(), "{delays:?}");
    }
    assert!(found > 30, "{found}");
}

#[test]
fn a_camera_inside_of_matter_begins_its_way_there() {
    let mut scene = scene();
    (scene.camera.r, scene.camera.theta_deg) = (6.0, 89.0);
    for (stretches, _) in ways(&scene) {
        let first = stretches.first().unwrap();
        assert!((first.r[0] - 6.0).abs() < 1e-12, "{first:?}");
    }
}

#[test]
fn jets_and_disks_have_stretches_of_their_own() {
    let mut scene = scene();
    scene.jet.enabled = true;
    let kinds = |scene: &Scene| -> Vec<MatterKind> {
        let ways = ways(scene).into_iter();
        ways.flat_map(|(stretches, _)| stretches)
            .map(|stretch| stretch.kind)
            .collect()
    };
    let both = kinds(&scene);
    assert!(both.contains(&MatterKind::Disk) && both.contains(&MatterKind::Jets));
    scene.disk.thickness = 0.0;
    let sheet = kinds(&scene);
    assert!(sheet.contains(&MatterKind::Sheet) && sheet.contains(&MatterKind::Jets));
    assert!(!sheet.contains(&MatterKind::Disk));
}
