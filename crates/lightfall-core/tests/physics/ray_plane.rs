//! A ray in its own plane, and the angle by which gravity turns its light, against closed forms.

use crate::light_without_spin;
use glam::{DVec2, DVec3};
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::optics::ray_plane::DiskSection;
use lightfall_core::scene::{ObserverKind, Scene};

/// A scene without a disk, with the camera at this radius.
fn without_disk(r: f64) -> Scene {
    let mut scene = Scene::default();
    scene.disk.enabled = false;
    scene.camera.r = r;
    scene
}

/// The ray with the impact parameter `b` that an observer at rest sees in front of the hole:
/// sin(angle) = b sqrt(1 - 1/r) / r from the inward direction.
fn ray(scene: &Scene, b: f64) -> Inspected {
    let r = scene.camera.r;
    let angle = (b * (1.0 - 1.0 / r).sqrt() / r).asin();
    let direction = DVec3::new(-angle.cos(), 0.6 * angle.sin(), 0.8 * angle.sin());
    Inspected::new(scene, direction, None, 3.0 * r + 60.0).unwrap()
}

/// Beyond a camera at 1e6 r_s light turns by less than b / r^2 < 1e-9 more.
#[test]
fn seen_from_far_away_the_deflection_is_that_of_the_elliptic_integral() {
    let scene = without_disk(1e6);
    for b in [2.6, 2.7, 3.0, 5.0, 20.0, 300.0] {
        let deflection = ray(&scene, b).numbers.deflection.unwrap();
        let exact = light_without_spin::deflection(b).unwrap();
        assert!(
            (deflection - exact).abs() < 1e-7,
            "b = {b}: {deflection} and not {exact}"
        );
    }
    // Einstein's 2 r_s / b, whose next term is (15 pi / 16) / b^2.
    let weak = ray(&scene, 300.0).numbers.deflection.unwrap();
    assert!((weak - 2.0 / 300.0).abs() < 3.0 / 300.0_f64.powi(2));
}

/// At first order the light that arrives at r has turned by (r_s / b) (1 + sqrt(1 - b^2/r^2))
/// (Ishihara et al. 2016): half of the whole angle where the camera is at the closest approach.
/// The second order is below 3 r_s^2 / b^2.
#[test]
fn a_camera_at_a_finite_distance_sees_the_part_of_the_deflection_up_to_it() {
    for (r, b) in [(1000.0, 100.0), (300.0, 200.0), (1000.0, 800.0)] {
        let deflection = ray(&without_disk(r), b).numbers.deflection.unwrap();
        let first_order = (1.0 + (1.0 - (b / r).powi(2)).sqrt()) / b;
        assert!(
            (deflection - first_order).abs() < 3.0 / (b * b),
            "r = {r}, b = {b}: {deflection} and not {first_order}"
        );
    }
}

/// The angle belongs to the observer at rest, whatever the camera's own motion.
#[test]
fn the_deflection_does_not_depend_on_how_the_camera_moves() {
    let scene = without_disk(8.0);
    let still = ray(&scene, 4.0);
    let mut falling = scene.clone();
    falling.observer.kind = ObserverKind::Rain;
    // The same photon for rain: boosted inward by beta = sqrt(1/r).
    let (beta, cosine) = (8.0_f64.sqrt().recip(), -still.numbers.er);
    let seen = (cosine + beta) / (1.0 + beta * cosine);
    let across = (1.0 - seen * seen).sqrt();
    let direction = DVec3::new(-seen, 0.6 * across, 0.8 * across);
    let moving = Inspected::new(&falling, direction, None, 84.0).unwrap();
    let b = |inspected: &Inspected| inspected.numbers.impact_parameter.unwrap();
    assert!((b(&moving) - 4.0).abs() < 1e-9 && (b(&still) - 4.0).abs() < 1e-9);
    let [one, two] = [&still, &moving].map(|ray| ray.numbers.deflection.unwrap());
    assert!((one - two).abs() < 1e-9, "{one} {two}");
}

/// With an ever smaller spin the angle between the directions becomes the same angle, within half a
/// turn: the spin changes it by about spin / b^2.
#[test]
fn with_spin_the_deflection_is_the_angle_between_the_directions_of_the_light() {
    for b in [3.5, 6.0, 12.0] {
        let mut scene = without_disk(40.0);
        let plain = ray(&scene, b).numbers.deflection.unwrap();
        scene.hole.spin = 1e-6;
        let spinning = ray(&scene, b).numbers.deflection.unwrap();
        assert!(
            (spinning.cos() - plain.cos()).abs() < 1e-5,
            "b = {b}: {spinning} {plain}"
        );
    }
}

#[test]
fn without_spin_the_plane_has_the_whole_path_and_its_asymptote_passes_at_b() {
    let scene = without_disk(20.0);
    for b in [2.65, 4.0, 9.0] {
        let inspected = ray(&scene, b);
        let plane = &inspected.plane;
        // The same points, in another frame: distances between them stay.
        for (flat, round) in plane
            .points
            .windows(2)
            .zip(inspected.path.points.windows(2))
        {
            let [flat, round] = [flat[0].distance(flat[1]), round[0].distance(round[1])];
            assert!((flat - round).abs() < 1e-9 * round.max(1.0));
        }
        assert!(plane.points[0].distance(DVec2::new(20.0, 0.0)) < 1e-9);
        assert!(plane.points[1].y > 0.0);
        let closest = plane.closest.unwrap().length();
        assert!((closest.powi(3) / (closest - 1.0) - b * b).abs() < 1e-8 * b * b);
        // Far out the ray runs along its asymptote, which passes the hole at the distance b. It
        // nears it as b / r^2.
        let source = DVec2::from_angle(plane.source.unwrap());
        let last = plane.points[plane.points.len() - 1];
        let distance = -source.perp_dot(last);
        assert!(
            (distance - b).abs() < b.powi(3) / last.length().powi(2),
            "b = {b}: {distance}"
        );
    }
}

#[test]
fn rays_that_show_no_sky_have_no_deflection_and_hits_lie_on_the_disks_line() {
    // b < 3 sqrt(3) / 2: captured.
    let captured = ray(&without_disk(20.0), 2.5);
    assert_eq!(captured.numbers.deflection, None);
    assert_eq!(
        (captured.plane.source, captured.plane.closest),
        (None, None)
    );
    assert!(captured.plane.looking.is_some());
    // No bending, no angle.
    let mut flat = without_disk(20.0);
    flat.effects.lensing = false;
    assert_eq!(ray(&flat, 5.0).numbers.deflection, None);
    // Inside the horizon no observer is at rest.
    let mut inside = without_disk(0.6);
    inside.observer.kind = ObserverKind::Rain;
    let out = Inspected::new(&inside, DVec3::new(0.9, 0.3, 0.1).normalize(), None, 60.0).unwrap();
    assert_eq!((out.plane.looking, out.numbers.deflection), (None, None));

    // Down onto the disk from above.
    let mut scene = Scene::default();
    (scene.camera.r, scene.camera.theta_deg) = (20.0, 60.0);
    let mut met = 0;
    for aside in [-0.3, -0.15, 0.15, 0.3, 0.4] {
        let direction = DVec3::new(-1.0, 0.1, aside).normalize();
        let inspected = Inspected::new(&scene, direction, None, 120.0).unwrap();
        let (Some(hit), Some((_, place))) = (inspected.trace.hits[0], inspected.plane.hits[0])
        else {
            continue;
        };
        let Some(DiskSection::Line(angle)) = inspected.plane.disk else {
            panic!("the ray's plane is not the disk's");
        };
        assert!((place.length() - hit.r).abs() < 1e-12);
        // The crossing is found between points of the path, a few hundredths of a radian apart.
        let off = DVec2::from_angle(angle).perp_dot(place) / place.length();
        assert!(off.abs() < 1e-2, "aside {aside}: {off}");
        assert_eq!(inspected.numbers.deflection, None);
        met += 1;
    }
    assert!(met >= 3, "only {met} rays met the disk");
}

#[test]
fn a_ray_in_the_disks_plane_and_a_radial_one_have_a_plane() {
    let mut scene = without_disk(20.0);
    scene.camera.theta_deg = 90.0;
    let across = DVec3::new(-0.9, 0.0, 0.435_889_894_354_067_4);
    let flat = Inspected::new(&scene, across, None, 120.0).unwrap();
    assert_eq!(flat.plane.disk, Some(DiskSection::Plane));
    scene.camera.theta_deg = 50.0;
    let radial = Inspected::new(&scene, DVec3::X, None, 120.0).unwrap();
    assert!(radial.plane.points.iter().all(|place| place.is_finite()));
    let Some(DiskSection::Line(angle)) = radial.plane.disk else {
        panic!("a radial ray is not in the disk's plane");
    };
    assert!(
        (angle.abs() - 40.0_f64.to_radians()).abs() < 1e-9,
        "{angle}"
    );
    assert!(radial.numbers.deflection.unwrap().abs() < 1e-9);
}
