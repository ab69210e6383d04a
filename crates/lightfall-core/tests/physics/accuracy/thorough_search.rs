//! The thorough search around a ray next to the edge of the shadow: answers that are wrong by a known
//! turn, or of a known class, are explained by it.

use super::{answers_to_turned_rays, scene};
use glam::DVec3;
use lightfall_core::accuracy::{EDGE_DISTANCES, Ray, Truth, TurnBounds, rays_near_edge};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::{Outcome, Trace};
use lightfall_core::scene::{Method, ObserverKind, Scene};

#[test]
fn both_searches_find_known_rotations_across_a_tiny_shadow() {
    // The shadow's radius is 1.8e-6 rad, thirty times the spacing of directions in f32.
    let mut scene = Scene::default();
    (scene.camera.r, scene.camera.theta_deg) = (276_779.5, 129.8);
    scene.camera.fov_deg = 0.006;
    scene.observer.kind = ObserverKind::Zamo;
    scene.observer.velocity = [0.0665, -0.9834, -0.0181];
    (scene.disk.inner, scene.disk.outer) = (33.9, 35.2);
    let rays = rays_near_edge(&scene, 500, [1e-7, 0.3]);
    let truth = Truth::of(&scene, rays).expect("a slow observer");
    // Half of the tolerance of `closed`. The reference cannot tell less of the ray next to the edge: a
    // rounding of its f64 directions, 1e-16 rad, is magnified by the inverse of the distance to the
    // edge, down to 1e-10 rad.
    let limit = 5e-7;
    let bounds = TurnBounds {
        target: 0.5 * limit,
        upper_bound: f64::INFINITY,
    };
    for angle in [1e-8, 3e-8, 1e-7, 2e-7] {
        let given = answers_to_turned_rays(&scene, &truth, angle);
        for (i, error) in truth.judge(&given).iter().enumerate() {
            assert!(error.backward <= limit, "ray {i}, {angle:e}: {error:?}");
            // The thorough search is slow, and must not need the usual one's result.
            if i % 40 == 0 {
                let found = truth.thorough_search(i, bounds).judge(&given[i], bounds);
                assert!(found <= limit, "ray {i}, {angle:e}: {found:e}, {error:?}");
            }
        }
    }
}

#[test]
fn the_thorough_search_explains_an_answer_without_sky_and_hits() {
    let scene = scene(0.7);
    let rays = rays_near_edge(&scene, 200, EDGE_DISTANCES);
    let truth = Truth::of(&scene, rays).expect("a still observer");
    let is_wanted = |trace: &Trace| trace.outcome == Outcome::Captured && trace.hits[0].is_some();
    let hit: Vec<usize> = (0..truth.rays.len())
        .filter(|i| is_wanted(&truth.traces[*i]))
        .collect();
    let mut explained = 0;
    for i in hit {
        let given = Trace {
            hits: [None; 2],
            ..truth.traces[i]
        };
        let usual = truth.error_of(i, &given, 0.0);
        // The grid reaches a third of the shadow's radius, which is 0.2 rad.
        if usual > 0.06 {
            continue;
        }
        explained += 1;
        let bounds = TurnBounds {
            target: usual / 4.0,
            upper_bound: f64::INFINITY,
        };
        let found = truth.thorough_search(i, bounds).judge(&given, bounds);
        // The turns of the grid's rows lie a factor of two apart.
        let limit = 2.0 * usual;
        assert!(found <= limit, "ray {i}: {found:e}, usually {usual:e}");
    }
    assert!(explained > 10, "{explained} rays");
}

/// A ray next to the edge and another one that meets a ring, both seen by the camera of a scene.
struct Neighbours {
    scene: Scene,
    /// (right, up, forward) of the camera.
    ray: DVec3,
    turned: DVec3,
    /// The tolerance, in radians, of the answer.
    limit: f64,
}

/// Scenes in which a turn of 4e-9, 1e-7 and 6e-7 rad leads to a ring whose image is narrower than the
/// thorough search's grid. The usual search finds no turn in the last two.
/// In the last one the turned ray is so close to the edge that the reference is uncertain by 1e-4 rad in
/// its sky.
fn next_to_narrow_rings() -> [Neighbours; 3] {
    let mut fast = scene(0.0);
    (fast.camera.r, fast.camera.theta_deg) = (2.9254440876851753, 6.736336449275317e-5);
    fast.observer.kind = ObserverKind::Zamo;
    fast.observer.velocity = [
        -0.6793707725529271,
        -0.7168403256806894,
        0.15207495918428784,
    ];
    (fast.disk.inner, fast.disk.outer) = (102.28282381209449, 939.1297244455548);
    let mut near = scene(-0.2901403599431642);
    (near.camera.r, near.camera.theta_deg) = (1.0856077020580623, 0.0025225788177677183);
    near.observer.kind = ObserverKind::Static;
    (near.disk.inner, near.disk.outer) = (2169.55, 2169.57);
    let mut throat = scene(-0.9998751377932301);
    (throat.camera.r, throat.camera.theta_deg) = (0.5118494062805897, 86.16860095752736);
    throat.observer.kind = ObserverKind::Zamo;
    (throat.disk.inner, throat.disk.outer) = (43.871093357974715, 44.288237894969);
    let limit = Method::Closed.backward_max(throat.hole.spin);
    for scene in [&mut fast, &mut near, &mut throat] {
        scene.disk.follow_isco = false;
    }
    [
        Neighbours {
            scene: fast,
            ray: DVec3::new(0.1526112740903675, 0.7170238661357559, 0.680137173232171),
            turned: DVec3::new(0.152611273398547, 0.7170238634567344, 0.6801371762117201),
            limit: 1e-6,
        },
        Neighbours {
            scene: near,
            ray: DVec3::new(
                -0.6545152534679575,
                -0.31809159483945953,
                -0.6858771903703058,
            ),
            turned: DVec3::new(
                -0.6545153136633562,
                -0.3180916240953971,
                -0.6858771193592267,
            ),
            limit: 1e-6,
        },
        Neighbours {
            scene: throat,
            ray: DVec3::new(0.8572841221627557, 0.3407251510999502, 0.3859667152690105),
            turned: DVec3::new(0.8572839370060026, 0.34072499175293525, 0.38596726719561386),
            limit,
        },
    ]
}

#[test]
fn the_thorough_search_follows_the_sky_to_a_ring_too_narrow_for_its_grid() {
    for Neighbours {
        scene,
        ray,
        turned,
        limit,
    } in next_to_narrow_rings()
    {
        let reference = Reference::new(&scene).expect("an observer that exists");
        let mut given = reference.trace(scene.camera.tetrad_from_camera() * turned);
        let hit = given.hits[0].as_mut().expect("a hit on the ring");
        // Roundings of f32.
        hit.r *= 1.0 + 2e-7;
        hit.phi += 3e-7;
        let truth = Truth::of(&scene, vec![Ray::toward(ray)]).expect("an observer that exists");
        assert_eq!(truth.traces[0].hits, [None; 2], "the ray passes the ring");
        // The thorough search must not need the usual one's result.
        let bounds = TurnBounds::for_limit(limit, f64::INFINITY);
        let found = truth.thorough_search(0, bounds).judge(&given, bounds);
        assert!(found <= bounds.target, "{found}");
    }
}

/// A fast observer far away in the disk's plane: the shadow's radius is 3e-7 rad, and the photon of light
/// from the hole is 6000 times smaller than the entries of the observer's matrix. A hit behind the whole
/// way about the hole moves by its radius within 1e-9 rad, so the reference's own roundings decide how
/// well a turn can explain it.
#[test]
fn a_hit_behind_a_tiny_shadow_is_explained_to_more_digits_than_f32_has() {
    let mut scene = scene(0.0);
    (scene.camera.r, scene.camera.theta_deg) = (89366.75505480128, 90.0);
    scene.camera.fov_deg = 0.0192;
    scene.observer.kind = ObserverKind::Zamo;
    scene.observer.velocity = [-0.6289395047860017, 0.589880649063948, -0.5061654189981627];
    scene.disk.follow_isco = false;
    (scene.disk.inner, scene.disk.outer) = (25.2421107808497, 26.194719364756057);
    let from_camera = scene.camera.tetrad_from_camera();
    let on_axes = DVec3::new(-0.6351298297273263, 0.5861822554510557, -0.5029915136310459);
    let ray = from_camera.transpose() * on_axes;
    let truth = Truth::of(&scene, vec![Ray::toward(ray)]).expect("an observer that exists");
    assert_eq!(truth.traces[0].hits, [None; 2], "the ray passes the ring");

    let reference = Reference::new(&scene).expect("an observer that exists");
    let (across, along) = ray.any_orthonormal_pair();
    let turned = (0..2000_u32).map(|i| {
        let (sin, cos) = (f64::from(i) * 2.4).sin_cos();
        ray + (1.8e-9 + 1e-13 * f64::from(i)) * (cos * across + sin * along)
    });
    let mut explained = 0;
    for direction in turned {
        let mut given = reference.trace(from_camera * direction);
        let Some(hit) = given.hits[0].as_mut() else {
            continue;
        };
        // What f32's rounding of the whole angle leaves of the radius.
        hit.r *= 1.0 + 5e-6;
        let error = truth.error_of(0, &given, 0.0);
        assert!(error < 1.5e-7, "{direction}: {error:e}");
        explained += 1;
    }
    assert!(explained > 10, "{explained} rays meet the ring");
}
