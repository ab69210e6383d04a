//! The promises about rays, held in the scenes of `lightfall bench`. Each is an upper bound, and none
//! is ten times what is measured: a promise that says too little fails as well.

use crate::gpu;
use lightfall_core::accuracy::{
    ErrorSummary, Ray, Truth, rays_over_picture_and_near_edge, tolerance,
};
use lightfall_core::gpu::rays::RayKernel;
use lightfall_core::scene::promises::{
    CLOSED_MAX, CLOSED_P99, CLOSED_SPINNING_P99, MINO_MAX, MINO_P99,
};
use lightfall_core::scene::{Method, Scene};
use lightfall_lab::bench::scenes;

/// Rays of a scene: half over its picture, half next to the shadow's edge.
const RAYS: usize = 512;
/// The tightest value of `quality.max_error_px`.
const TIGHTEST: f64 = 1e-4;

/// The largest errors of a method in several scenes, in radians.
#[derive(Default)]
struct Worst {
    p99: f64,
    max: f64,
}

impl Worst {
    /// Traces a scene's rays, and takes its errors in. Every ray has an answer.
    fn add(&mut self, scene: &Scene, truth: &Truth, name: &str) {
        let rays: Vec<_> = truth.rays.iter().map(Ray::given).collect();
        let kernel = RayKernel::new(gpu(), scene).unwrap();
        let traces = kernel.trace_camera_rays(gpu(), scene, &rays).unwrap();
        let errors = ErrorSummary::of(truth, &traces);
        let method = scene.method.word();
        assert_eq!(
            (errors.unfinished(), errors.not_finite),
            (0, 0),
            "{name}, {method}"
        );
        let (p99, max) = (errors.backward.p99, errors.backward.max);
        println!(
            "{name}, {method}, {}: {p99:.1e} {max:.1e}",
            scene.quality.max_error_px
        );
        // `mino` may be as far off as its setting allows.
        assert!(max <= tolerance(scene), "{name}, {method}: {max:e}");
        self.p99 = self.p99.max(p99);
        self.max = self.max.max(max);
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_rays_of_every_scene_are_as_exact_as_promised() {
    let [mut closed, mut spinning, mut mino, mut tightest]: [Worst; 4] = Default::default();
    for bench_scene in scenes() {
        let (name, scene) = (&bench_scene.name, &bench_scene.scene);
        let truth = Truth::of(scene, rays_over_picture_and_near_edge(scene, RAYS)).unwrap();
        let by = |method| Scene {
            method,
            ..scene.clone()
        };
        let without_spin = scene.hole.spin == 0.0;
        let of_closed = if without_spin {
            &mut closed
        } else {
            &mut spinning
        };
        of_closed.add(&by(Method::Closed), &truth, name);
        let mut scene = by(Method::Mino);
        mino.add(&scene, &truth, name);
        scene.quality.max_error_px = TIGHTEST;
        tightest.add(&scene, &truth, name);
    }
    for (what, measured, promised) in [
        ("closed, 99 of 100", closed.p99, CLOSED_P99),
        ("closed, all", closed.max, CLOSED_MAX),
        (
            "closed with spin, 99 of 100",
            spinning.p99,
            CLOSED_SPINNING_P99,
        ),
        ("mino, 99 of 100", mino.p99, MINO_P99),
        ("mino at its tightest setting, all", tightest.max, MINO_MAX),
    ] {
        println!("{what}: {measured:e} of {promised:e}");
        assert!(measured <= promised, "{what}: {measured:e}");
        assert!(measured > 0.1 * promised, "{what}: {measured:e}");
    }
}
