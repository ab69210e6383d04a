//! The half-open rule of the disk's plane: a step that ends exactly on the plane crosses it, and the
//! step that starts there does not.

use crate::light::light_from;
use crate::{bare_hole, gpu};
use glam::{DVec3, Vec4};
use lightfall_core::gpu::kernel::uniform;
use lightfall_core::gpu::{GpuScene, Variant, bindings};
use lightfall_core::scene::{Method, Scene};

/// A length of steps by which a multiplication is exact, so that fused and separate operations round
/// alike.
const STEP: f64 = 0.125;

/// The rule of shaders/disk.wgsl.
const RULE: &str = "return z0 != 0.0 && (z1 == 0.0 || (z0 > 0.0) != (z1 > 0.0));";
/// Other rules, and the number of crossings that they give a ray whose step ends exactly on the plane:
/// only such rays count; they never count; they count twice.
const TELLING: [(&str, f32); 3] = [
    ("return z0 != 0.0 && z1 == 0.0;", 1.0),
    ("return z0 * z1 < 0.0;", 0.0),
    ("return z0 * z1 <= 0.0;", 2.0),
];

#[test]
#[ignore = "needs a graphics adapter"]
fn a_crossing_belongs_to_the_step_that_ends_on_the_plane() {
    let mut scene = bare_hole(6.0);
    scene.disk.enabled = true;
    // Three heights in a row, and how often the two steps between them cross.
    let cases = [
        ([1.0, 0.0, -1.0], 1.0),
        ([-1.0, 0.0, 1.0], 1.0),
        ([1.0, -0.0, -1.0], 1.0),
        ([-1.0, -0.0, 1.0], 1.0),
        ([1.0, 0.0, 0.0], 1.0),
        ([1.0, -1.0, -2.0], 1.0),
        ([2.0, 1.0, -1.0], 1.0),
        ([1.0, -1.0, 1.0], 2.0),
        // From the plane, as a camera in it looks, and along it.
        ([0.0, 1.0, 2.0], 0.0),
        ([-0.0, -1.0, -2.0], 0.0),
        ([0.0, 0.0, 0.0], 0.0),
        ([3.0, 2.0, 1.0], 0.0),
    ];
    let counts = light_from(
        gpu(),
        &Variant::picture(&scene).source(),
        "vec4<f32>(f32(crosses_plane(given.x, given.y)) + f32(crosses_plane(given.y, given.z)), 0.0, 0.0, 0.0)",
        &[],
        cases.map(|([a, b, c], _)| Vec4::new(a, b, c, 0.0)),
    );
    for ((heights, expected), count) in cases.into_iter().zip(counts) {
        assert_eq!(count.x, expected, "{heights:?}");
    }
}

/// How often each ray crosses the disk in steps of fixed length, by this rule: within four of them
/// or, with mino, until it ends.
fn crossings(scene: &Scene, directions: &[DVec3], rule: &str) -> Vec<f32> {
    let replaced = |text: &str, from: &str, to: &str| {
        assert_eq!(text.matches(from).count(), 1, "{from}");
        text.replace(from, to)
    };
    let step = match scene.method {
        Method::Verlet => "= step_length(r, v, impact.length);",
        Method::Mino => "= step_of(orbit);",
        _ => "= step_length(metric, state.x, v);",
    };
    let source = Variant::rays(scene).source();
    let source = replaced(&source, step, &format!("= {STEP};"));
    let counts = light_from(
        gpu(),
        &replaced(&source, RULE, rule),
        "vec4<f32>(f32(trace(photon_from(given.xyz)).hit_count), 0.0, 0.0, 0.0)",
        &[(
            bindings::SCENE,
            uniform(&GpuScene::for_rays(scene).unwrap()),
        )],
        directions
            .iter()
            .map(|direction| direction.as_vec3().extend(0.0)),
    );
    counts.into_iter().map(|count| count.x).collect()
}

/// The cosine of the angle between the direction straight to the plane and that of a ray that stays
/// at its radius and is on the plane after one step. With spin it is hardly another.
fn share_toward_plane(scene: &Scene) -> f64 {
    let (r, theta) = (scene.camera.r, scene.camera.theta_deg.to_radians());
    let lapse = (1.0 - 1.0 / r).sqrt();
    match scene.method {
        // In a step a ray turns about the hole by the length of the step times the root of K, which
        // is scaled so that K + 4 E^2 is one; K/E^2 is (r/lapse)^2.
        Method::Mino => (STEP * r / r.hypot(2.0 * lapse)).tan().recip() / theta.tan().abs(),
        // The speed along theta is one over the lapse.
        _ => (r * theta.cos() / STEP * lapse).abs(),
    }
}

/// The rays of a fan lie so close together that f32's velocities across the plane take all values of
/// an interval. One of them leads exactly to the plane in one step.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_ray_whose_step_ends_exactly_on_the_plane_meets_the_disk_once() {
    let near = [88.73, 88.77, 91.25, 91.29];
    // A step of mino is nearly an angle, which at 6 r_s is a longer way.
    let far = [83.17, 83.21, 96.77, 96.81];
    for (method, spin, thetas_deg) in [
        (Method::Verlet, 0.0, near),
        (Method::KerrSchild, 0.0, near),
        (Method::KerrSchild, 0.9, near),
        (Method::Mino, 0.0, far),
        (Method::Mino, 0.9, far),
    ] {
        let mut found = [0; 3];
        for theta_deg in thetas_deg {
            let mut scene = bare_hole(6.0);
            (scene.method, scene.hole.spin) = (method, spin);
            scene.camera.theta_deg = theta_deg;
            scene.disk.enabled = true;
            scene.quality.max_steps = 4;
            // Down to the plane, or up to it.
            let side = (90.0 - scene.camera.theta_deg).signum();
            let tilt = share_toward_plane(&scene).acos();
            let directions: Vec<DVec3> = (-100_000..100_000)
                .map(|i| {
                    let (sin, cos) = (tilt + 2e-7 * f64::from(i)).sin_cos();
                    DVec3::new(0.0, cos * side, sin)
                })
                .collect();
            let counts = crossings(&scene, &directions, RULE);
            assert!(
                counts.iter().all(|count| *count == 1.0),
                "{method:?}, spin {spin}, {theta_deg}"
            );
            for (rays, (rule, count)) in found.iter_mut().zip(TELLING) {
                let counts = crossings(&scene, &directions, rule);
                *rays += counts.iter().filter(|found| **found == count).count();
            }
        }
        println!("{method:?}, spin {spin}: {found:?}");
        // Without such rays the test would show nothing; the other two rules get them wrong.
        assert!(
            found.iter().all(|rays| *rays > 0),
            "{method:?}, spin {spin}: {found:?} rays end on the plane, are lost, count twice"
        );
    }
}
