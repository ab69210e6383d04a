//! The observer's matrix in the shader: every kind of observer sees what it sees in the reference.

use crate::{all_around, bare_hole, median, quantile, with_truths};
use glam::DVec3;
use lightfall_core::scene::{Method, ObserverKind};

#[test]
#[ignore = "needs a graphics adapter"]
fn every_observer_sees_the_sky_and_the_disk_where_the_reference_has_them() {
    for (kind, velocity, theta_deg) in [
        (ObserverKind::Static, [0.0; 3], 70.0),
        (ObserverKind::Static, [0.0; 3], 0.0),
        (ObserverKind::Static, [0.0; 3], 180.0),
        (ObserverKind::Zamo, [0.0; 3], 70.0),
        (ObserverKind::Orbit, [0.0; 3], 90.0),
        (ObserverKind::Rain, [0.0; 3], 70.0),
        (ObserverKind::Static, [0.3, -0.5, 0.6], 30.0),
        (ObserverKind::Rain, [-0.9, 0.1, 0.2], 110.0),
    ] {
        let mut scene = bare_hole(8.0);
        scene.disk.enabled = true;
        scene.camera.theta_deg = theta_deg;
        (scene.observer.kind, scene.observer.velocity) = (kind, velocity);
        let directions = all_around(2000);
        let (mut sky, mut g, mut differing) = (Vec::new(), Vec::new(), 0);
        for (trace, truth) in with_truths(&scene, &directions) {
            differing += u32::from(trace.outcome != truth.outcome);
            sky.extend(
                trace
                    .sky
                    .zip(truth.sky)
                    .map(|(sky, truth)| (sky - truth).length()),
            );
            let hits = trace
                .hits
                .into_iter()
                .zip(truth.hits)
                .filter_map(|(hit, truth)| hit.zip(truth));
            g.extend(hits.map(|(hit, truth)| (hit.g / truth.g - 1.0).abs()));
        }
        let seen = format!("{kind:?} {velocity:?} at {theta_deg} degrees");
        // The method's own error at 8 r_s is 1e-4 to 3e-4 rad in the median, for every observer.
        assert!(median(&sky) < 5e-4, "{seen}: sky {:e}", median(&sky));
        // Rays that circle the hole first make the tail long; there are few hits from within the
        // plane.
        assert!(
            median(&g) < 3e-4 && quantile(&g, 0.9) < 2e-3,
            "{seen}: g {:e} {:e}",
            median(&g),
            quantile(&g, 0.9)
        );
        assert!(differing <= 4, "{seen}: {differing} outcomes differ");
    }
}

/// Light from behind a fast observer is dim: the photon's numbers are 1e-4 of those ahead. Rounded
/// with those, they moved hits by 5e-5 of their radius, and one ray in ten ended wrongly. The bound
/// is that of observers at rest.
#[test]
#[ignore = "needs a graphics adapter"]
fn light_from_behind_a_fast_observer_keeps_its_digits() {
    for (method, velocity) in [
        (Method::Closed, DVec3::new(-0.9999, 0.0, 0.0)),
        (Method::Mino, DVec3::new(-0.9999, 0.0, 0.0)),
        (Method::Closed, DVec3::new(0.0, 0.9, 0.4)),
    ] {
        let mut scene = bare_hole(5.0);
        scene.method = method;
        scene.disk.enabled = true;
        scene.quality.max_error_px = 1e-4;
        (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Zamo, velocity.to_array());
        let behind = -velocity.normalize();
        let (across, along) = behind.any_orthonormal_pair();
        let directions: Vec<DVec3> = (0..2000)
            .map(|i| {
                let angle = 1e-5 * 1e5_f64.powf(f64::from(i) / 2000.0);
                let (sin, cos) = (2.399_963 * f64::from(i)).sin_cos();
                let direction = behind + angle * (cos * across + sin * along);
                direction.normalize().as_vec3().as_dvec3()
            })
            .collect();
        let (mut differing, mut r, mut g) = (0, vec![], vec![]);
        for (trace, truth) in with_truths(&scene, &directions) {
            differing += u32::from(trace.outcome != truth.outcome);
            for (hit, truth) in trace
                .hits
                .into_iter()
                .zip(truth.hits)
                .filter_map(|(hit, truth)| hit.zip(truth))
            {
                r.push((hit.r / truth.r - 1.0).abs());
                g.push((hit.g / truth.g - 1.0).abs());
            }
        }
        let seen = format!("{method:?} {velocity}: {differing} outcomes differ");
        assert_eq!(differing, 0, "{seen}");
        if r.len() > 20 {
            assert!(
                quantile(&r, 0.9) < 1e-5 && quantile(&g, 0.9) < 2e-6,
                "{seen}, r {:e}, g {:e}",
                median(&r),
                median(&g)
            );
        }
    }
}
