//! The backward error next to the shadow's edge, where neighbouring rays differ in the number of
//! half-turns about the hole.

use glam::DVec3;
use lightfall_core::accuracy::{Ray, Truth};
use lightfall_core::optics::trace::{Hit, Outcome, Trace};
use lightfall_core::scene::Scene;

fn scene(spin: f64, r: f64, theta_deg: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    scene.disk.follow_isco = true;
    (scene.camera.r, scene.camera.theta_deg) = (r, theta_deg);
    scene
}

/// An answer of a graphics card. On the line through the ray toward the edge, at 0.05 of the ray's
/// distance to the edge, lies a ray with the answer's sky and hit radius, at the end of an image of
/// the disk. The ray's own hit is on another image.
#[test]
fn an_answer_with_other_half_turns_next_to_the_end_of_the_disks_image_is_explained() {
    let ray = Ray::toward(DVec3::new(-0.002_512_557_7, -0.001_986_405_3, 0.999_994_9));
    let truth = Truth::of(&scene(-0.9, 1000.0, 90.0), vec![ray]).expect("a static observer");
    let hit = Hit {
        r: 10.994_947_855_169_167,
        phi: -2.604_627_359_851_636_7,
        g: 0.976_445_436_477_681_1,
        delay: None,
    };
    let sky = DVec3::new(
        -0.938_218_817_544_848_1,
        -0.295_219_167_367_488_1,
        -0.180_530_035_239_552_1,
    );
    let given = Trace {
        outcome: Outcome::Sky,
        sky: Some(sky.normalize()),
        hits: [Some(hit), None],
        steps: 57,
        residual: 0.0,
    };
    let [error] = truth.judge(&[given])[..] else {
        panic!("one answer for one ray")
    };
    assert!(
        !error.misclassified && error.sky.is_some_and(|sky| sky > 2.0),
        "{error:?}"
    );
    // The ray is 6.6e-9 rad from the edge. The remainder is the rounding of the card's numbers,
    // whose spacing in f32 is 6e-8.
    assert!((1e-9..6e-8).contains(&error.backward), "{error:?}");
}
