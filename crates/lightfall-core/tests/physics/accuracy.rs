//! The backward error against known errors: for answers that belong to rays rotated by a known
//! angle, the measure must find this angle.

mod thorough_search;

use glam::{DQuat, DVec3};
use lightfall_core::accuracy::{
    ErrorSummary, Quantiles, Ray, Truth, rays_near_edge, rays_over_picture, rays_over_sky,
};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::{Hit, Outcome, Trace};
use lightfall_core::scene::{ObserverKind, Scene};

fn scene(spin: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg) = (12.0, 70.0);
    scene
}

/// The reference's answers for the rays of `truth` rotated by `angle`, each about another axis.
fn answers_to_turned_rays(scene: &Scene, truth: &Truth, angle: f64) -> Vec<Trace> {
    let reference = Reference::new(scene).expect("a static observer outside the horizon");
    let axes = scene.camera.tetrad_from_camera();
    let turned = |(i, direction): (usize, DVec3)| {
        let aside = direction.any_orthonormal_vector();
        let axis = DQuat::from_axis_angle(direction, i as f64) * aside;
        reference.trace(axes * (DQuat::from_axis_angle(axis, angle) * direction))
    };
    truth
        .rays
        .iter()
        .map(|ray| ray.direction())
        .enumerate()
        .map(turned)
        .collect()
}

#[test]
fn a_known_rotation_of_every_ray_is_found_within_the_factor_of_two_of_the_mixed_error() {
    for spin in [0.0, 0.9] {
        let scene = scene(spin);
        let mut rays = rays_over_picture(&scene, 200);
        rays.extend(rays_near_edge(&scene, 200, [1e-4, 0.3]));
        let truth = Truth::of(&scene, rays).expect("a static observer");
        for angle in [1e-9, 1e-7, 1e-6] {
            let errors = truth.judge(&answers_to_turned_rays(&scene, &truth, angle));
            let seen = truth
                .traces
                .iter()
                .zip(&errors)
                .filter(|(truth, _)| truth.sky.is_some());
            // A hundredth more for the remainder of Newton's method. Next to a caustic a smaller
            // rotation explains the same answer.
            let seen: Vec<f64> = seen
                .filter(|(_, error)| !error.misclassified)
                .map(|(_, error)| error.backward)
                .collect();
            assert!(seen.len() > 200, "{} rays see the sky", seen.len());
            let quantiles = Quantiles::of(seen.iter().copied());
            println!("chi {spin}, {angle:e}: {quantiles:?}");
            assert!(
                quantiles.p99 <= 1.01 * angle,
                "chi {spin}: a turn of {angle:e} was found to be {:e}",
                quantiles.p99
            );
            // Near an edge the search for the shortest rotation has steps in the logarithm of the
            // distance, and may miss it by this factor.
            assert!(
                quantiles.max <= 1.5 * angle,
                "chi {spin}: a turn of {angle:e} was found to be {:e}",
                quantiles.max
            );
            assert!(
                quantiles.p50 >= 0.5 * angle,
                "chi {spin}: a turn of {angle:e} was found to be {:e}",
                quantiles.p50
            );
        }
    }
}

/// Next to a fast hole a factor e of the distance to the edge is hundreds of radians of azimuth,
/// and an answer contains the azimuth only modulo whole revolutions.
#[test]
fn a_known_rotation_is_found_where_rays_wind_many_times() {
    for (spin, r) in [(0.999, 12.0), (0.99999, 30.0), (-0.999_999, 1000.0)] {
        let mut scene = scene(spin);
        scene.camera.r = r;
        scene.disk.enabled = false;
        let truth =
            Truth::of(&scene, rays_near_edge(&scene, 64, [1e-5, 0.1])).expect("a static observer");
        let reference = Reference::new(&scene).expect("a static observer");
        let axes = scene.camera.tetrad_from_camera();
        let turned = |(i, ray): (usize, &Ray)| {
            let (direction, edge) = (
                ray.direction(),
                ray.distance_to_edge()
                    .expect("critical rays know their edge"),
            );
            let axis =
                DQuat::from_axis_angle(direction, i as f64) * direction.any_orthonormal_vector();
            reference.trace(axes * (DQuat::from_axis_angle(axis, 0.3 * edge.abs()) * direction))
        };
        let given: Vec<Trace> = truth.rays.iter().enumerate().map(turned).collect();
        let errors = truth.judge(&given);
        let seen = truth
            .rays
            .iter()
            .zip(&errors)
            .filter(|(_, error)| error.sky.is_some() && !error.misclassified);
        let shares = seen.map(|(ray, error)| {
            error.backward / (0.3 * ray.distance_to_edge().unwrap_or(0.0).abs())
        });
        let quantiles = Quantiles::of(shares);
        println!("chi {spin}: {quantiles:?}");
        // The measure finds the rotation, or a shorter one that explains the same answer. At worst
        // it finds the distance to the edge, which is 1/0.3 of the rotation.
        assert!(
            quantiles.count > 20 && quantiles.p50 < 1.01,
            "chi {spin}: {quantiles:?}"
        );
        assert!(quantiles.max < 1.01 / 0.3, "chi {spin}: {quantiles:?}");
    }
}

#[test]
fn a_ray_on_the_wrong_side_of_the_edge_is_off_by_its_distance_from_it() {
    // Without a disk, because its edges are boundaries of classes, too.
    let mut scene = scene(0.5);
    scene.disk.enabled = false;
    let truth =
        Truth::of(&scene, rays_near_edge(&scene, 64, [1e-3, 1e-2])).expect("a static observer");
    // The nearest ray on the other side, which stands for a wrong answer of another method.
    let reference = Reference::new(&scene).expect("a static observer");
    let axes = scene.camera.tetrad_from_camera();
    let shadow_centre = DVec3::Z;
    let mut compared = 0;
    for (ray, trace) in truth.rays.iter().zip(&truth.traces) {
        let distance = ray
            .distance_to_edge()
            .expect("critical rays know their edge");
        assert_eq!(
            trace.outcome == Outcome::Sky,
            distance > 0.0,
            "beyond the edge, and only there, is the sky"
        );
        let axis = ray.direction().cross(shadow_centre).normalize();
        let across =
            DQuat::from_axis_angle(axis, distance + 0.2 * distance.abs() * distance.signum())
                * ray.direction();
        let given = reference.trace(axes * across);
        if given.outcome == trace.outcome {
            continue;
        }
        compared += 1;
        let one = Truth::of(&scene, vec![*ray]).expect("a static observer");
        let [error] = one.judge(&[given])[..] else {
            panic!("one answer for one ray")
        };
        assert!(error.misclassified);
        // Eight spokes exceed the shortest distance by 1/cos(22.5 deg) at most, and rings that
        // differ by a factor of three are bisected to 1 %.
        let ratio = error.backward / distance.abs();
        assert!(
            (0.9..1.3).contains(&ratio),
            "{ratio} times the distance {distance:e}"
        );
    }
    assert!(compared > 30, "{compared} rays were compared");
}

#[test]
fn perfect_answers_have_no_error_and_missing_ones_an_infinite_error() {
    let scene = scene(0.9);
    let truth = Truth::of(&scene, rays_over_sky(200)).expect("a static observer");
    let perfect = ErrorSummary::of(&truth, &truth.traces);
    assert_eq!((perfect.misclassified, perfect.unfinished()), (0, 0));
    // The rounding of a direction in f64.
    assert!(perfect.backward.max < 1e-15, "{:e}", perfect.backward.max);
    let mut given = truth.traces.clone();
    let given_up = Trace {
        outcome: Outcome::Unfinished,
        sky: None,
        hits: [None; 2],
        ..given[0]
    };
    given[..10].fill(given_up);
    let errors = ErrorSummary::of(&truth, &given);
    assert_eq!((errors.unfinished(), errors.misclassified), (10, 0));
    assert_eq!(errors.backward.max, f64::INFINITY);
    // Ten of at most 200 are more than one in a hundred.
    assert_eq!(errors.backward.p99, f64::INFINITY);
}

#[test]
fn quantiles_are_values_of_the_set_and_nan_is_the_worst() {
    let quantiles = Quantiles::of((1..=200).map(f64::from));
    assert_eq!(
        (quantiles.count, quantiles.p50, quantiles.p99, quantiles.max),
        (200, 100.0, 198.0, 200.0)
    );
    assert_eq!(
        Quantiles::of([1.0, f64::NAN].into_iter()).max,
        f64::INFINITY
    );
    assert!(Quantiles::of(std::iter::empty()).max.is_nan());
}

/// Next to an almost extremal hole a hundredth of the distance to the edge adds one orbit, so a
/// small rotation changes the number of orbits by many.
#[test]
fn a_known_rotation_is_found_where_it_changes_the_orbits_around_a_fast_hole() {
    let scene = scene(0.99999);
    let truth =
        Truth::of(&scene, rays_near_edge(&scene, 64, [1e-5, 1e-3])).expect("a static observer");
    let angle = 1e-7;
    let errors = truth.judge(&answers_to_turned_rays(&scene, &truth, angle));
    let seen = truth
        .traces
        .iter()
        .zip(&errors)
        .filter(|(truth, error)| truth.sky.is_some() && !error.misclassified);
    let (mut far, mut worst) = (0, 0.0);
    for (_, error) in seen {
        far += usize::from(error.sky.is_some_and(|sky| sky > 0.1));
        worst = f64::max(worst, error.backward);
    }
    assert!(far > 5, "{far} of the answers are far off");
    // Every rotation that is found explains the answer, but the shortest one may lie between two
    // orbits: it is exceeded by a factor of 7 at most.
    assert!(
        worst <= 10.0 * angle,
        "a turn of {angle:e} was found to be {worst:e}"
    );
}

/// At the top of its range of latitudes a critical orbit has the right height on a short stretch only.
/// The answer belongs to a ray between this one and the edge of the shadow, 2.3e-7 rad away.
#[test]
fn an_answer_at_the_end_of_the_orbits_latitudes_is_explained_next_to_the_edge() {
    let mut scene = scene(-0.999_939_806_753_672_2);
    (scene.camera.r, scene.camera.theta_deg) = (0.506_930_271_912_324, 74.446_850_303_743_94);
    scene.observer.kind = ObserverKind::Zamo;
    scene.disk.enabled = false;
    let direction = DVec3::new(-0.110_084_718_2, 0.024_988_283_94, 0.993_608_041_68);
    let ray = Ray::toward(scene.camera.tetrad_from_camera().transpose() * direction);
    let truth = Truth::of(&scene, vec![ray]).expect("a static observer");
    let given = Trace {
        sky: Some(DVec3::new(-0.837_505_84, -0.476_148_94, 0.268_078_61)),
        ..truth.traces[0]
    };
    let error = truth.judge(&[given])[0].backward;
    println!("{error:e}");
    assert!(error < 1e-6, "{error:e}");
}

/// The image of a ring next to the edge of the shadow is an arc a thousandth as wide as it is long. The
/// answer belongs to a ray 5e-7 rad away along the edge, where the reference has no hit in between.
#[test]
fn a_hit_on_a_narrow_ring_is_explained_along_the_edge_of_the_shadow() {
    let mut scene = scene(0.0);
    scene.camera.r = 934_098.941_358_315_4;
    scene.camera.theta_deg = 63.545_927_439_307_22;
    scene.camera.fov_deg = 0.001_840_140_598_910_195;
    scene.observer.kind = ObserverKind::Zamo;
    scene.observer.velocity = [
        0.454_582_558_167_330_3,
        -0.541_923_356_764_455_1,
        0.434_698_210_559_572_3,
    ];
    (scene.disk.inner, scene.disk.outer) = (5.057_770_067_556_813, 5.694_984_683_305_130_5);
    let direction = DVec3::new(
        -0.431_811_405_520_559_13,
        -0.703_578_851_294_586,
        0.564_371_960_743_4,
    );
    let ray = Ray::toward(scene.camera.tetrad_from_camera().transpose() * direction);
    let truth = Truth::of(&scene, vec![ray]).expect("a slower observer than light");
    let hit = Hit {
        r: 5.091_664,
        phi: 0.285_302_2,
        g: 0.761_248_2,
        delay: None,
    };
    let given = Trace {
        hits: [Some(hit), None],
        ..truth.traces[0]
    };
    assert_eq!(
        (truth.traces[0].outcome, truth.traces[0].hits),
        (Outcome::Captured, [None; 2])
    );
    let error = truth.judge(&[given])[0];
    println!("{error:?}");
    assert!(error.misclassified && error.backward < 1e-6, "{error:?}");
}

/// The tangent plane at a direction shows its opposite at the same place.
#[test]
fn the_opposite_of_the_sky_is_not_the_sky() {
    for spin in [0.0, 0.9] {
        let scene = scene(spin);
        let mut rays = rays_over_picture(&scene, 50);
        rays.extend(rays_near_edge(&scene, 50, [1e-2, 0.3]));
        let truth = Truth::of(&scene, rays).expect("a still observer");
        let opposite = |trace: &Trace| Trace {
            sky: trace.sky.map(|sky| -sky),
            ..*trace
        };
        let given: Vec<Trace> = truth.traces.iter().map(opposite).collect();
        let seen = truth.traces.iter().filter(|trace| trace.sky.is_some());
        assert!(seen.count() > 20);
        for (trace, error) in truth.traces.iter().zip(truth.judge(&given)) {
            // The nearest ray with that answer lies on the other side of the hole, or as near to the
            // edge as half an orbit more asks for: e^-pi of a hundredth of the shadow's radius.
            let least = if trace.sky.is_some() { 1e-5 } else { 0.0 };
            assert!(error.backward >= least, "{trace:?} {error:?}");
        }
    }
}

/// Where the disk reaches into the photon orbits, the first two crossings converge toward the edge: they
/// do not fill all azimuths, as the sky of rays next to a spinning hole's edge does.
#[test]
fn a_hit_at_another_azimuth_is_not_explained_by_the_nearness_of_the_edge() {
    let mut scene = scene(0.9);
    (scene.disk.inner, scene.disk.outer) = (1.2, 100.0);
    let truth =
        Truth::of(&scene, rays_near_edge(&scene, 100, [1e-7, 1e-6])).expect("a still observer");
    let turned = |trace: &Trace| {
        let mut given = *trace;
        for hit in given.hits.iter_mut().flatten() {
            // The radius is off by what next to the edge is small, to either side.
            hit.r *= if hit.phi > 0.0 {
                1.0 + 1e-9
            } else {
                1.0 - 1e-9
            };
            hit.phi = (hit.phi + 1.0).sin().atan2((hit.phi + 1.0).cos());
        }
        given
    };
    let given: Vec<Trace> = truth.traces.iter().map(turned).collect();
    let mut tested = 0;
    for (trace, error) in truth.traces.iter().zip(truth.judge(&given)) {
        if trace.hits[1].is_some() {
            tested += 1;
            assert!(error.backward > 1e-3, "{trace:?} {error:?}");
        }
    }
    assert!(tested > 25, "{tested} rays with two hits");
}

/// The edge of a round shadow is a circle, along which the search would go round and round.
#[test]
fn the_search_for_a_class_that_no_ray_has_ends() {
    let mut scene = scene(0.0);
    (scene.camera.r, scene.disk.enabled) = (1000.0, false);
    let truth =
        Truth::of(&scene, rays_near_edge(&scene, 16, [1e-4, 0.1])).expect("a still observer");
    let hit = Hit {
        r: 5.0,
        phi: 0.3,
        g: 0.8,
        delay: None,
    };
    let with_hits = |trace: &Trace| Trace {
        hits: [Some(hit); 2],
        ..*trace
    };
    let given: Vec<Trace> = truth.traces.iter().map(with_hits).collect();
    for error in truth.judge(&given) {
        assert!(
            error.misclassified && error.backward == f64::INFINITY,
            "{error:?}"
        );
    }
}
