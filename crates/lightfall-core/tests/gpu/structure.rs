//! The structure of the disk's light in WGSL against its twin in f64.

use crate::gpu;
use crate::structure_field::StructureField;
use encase::ShaderType;
use glam::{DVec2, Vec2};
use lightfall_core::gpu::kernel::{ArrayKernel, uniform};
use lightfall_core::gpu::{GpuScene, GpuStructure, Variant, bindings};
use lightfall_core::optics::structure::{Covariance, Structure};
use lightfall_core::scene::{DiskStructure, Scene};
use std::f64::consts::{PI, TAU};

/// A hit and its footprint.
#[derive(ShaderType, Clone, Copy, Debug)]
struct Place {
    position: Vec2,
    delay: f32,
    right: Vec2,
    down: Vec2,
}

impl Place {
    fn covariance(&self) -> Covariance {
        let p = self.position.as_dvec2();
        let change =
            |d: DVec2| [p.dot(d), p.perp_dot(d)].map(|product| product / p.length_squared());
        Covariance::of_pixel(change(self.right.as_dvec2()), change(self.down.as_dvec2()))
    }
}

/// The factors that the shader finds for the scene at these places. Compute shaders have no
/// differences between pixels, so the part that takes them is left out.
fn factors(scene: &Scene, limit: Option<u32>, places: &[Place]) -> Vec<f32> {
    let numbers = GpuStructure::new(scene, limit).expect("the scene has structure");
    let uniforms = [
        (
            bindings::SCENE,
            uniform(&GpuScene::for_rays(scene).unwrap()),
        ),
        (bindings::STRUCTURE, uniform(&numbers)),
    ];
    let source = Variant::picture(scene)
        .source()
        .replace("dpdx(value)", "value")
        .replace("dpdy(value)", "value")
        + "struct Place { position: vec2<f32>, delay: f32, right: vec2<f32>, down: vec2<f32> }
           @group(0) @binding(BINDING_INPUT) var<storage, read> places: array<Place>;
           @group(0) @binding(BINDING_OUTPUT) var<storage, read_write> factors: array<f32>;
           @compute @workgroup_size(WORKGROUP_SIZE) fn factors_at(@builtin(global_invocation_id) id: vec3<u32>) {
               if id.x < arrayLength(&places) {
                   let place = places[id.x];
                   let hit = Hit(vec3<f32>(place.position, 0.0), 1.0, place.delay);
                   let footprint = Footprint(vec3<f32>(place.right, 0.0), vec3<f32>(place.down, 0.0));
                   factors[id.x] = structure_factor(hit, footprint);
               }
           }";
    let kernel = ArrayKernel::new(gpu(), &source, "factors_at", &uniforms).unwrap();
    kernel.run(gpu(), places).unwrap()
}

/// Places all over the disk, with delays of several lives of waves, and footprints from points to
/// such that hide every wave.
fn places(scene: &Scene, inner: f64) -> Vec<Place> {
    let share = |i: u32, step: f64| (f64::from(i) * step).fract();
    (1..=20_000)
        .map(|i| {
            let r = inner * (scene.disk.outer / inner).powf(share(i, 0.618_033_988_75));
            let phi = TAU * share(i, 0.754_877_666_25) - PI;
            let side = if i % 4 == 0 {
                0.0
            } else {
                r * 10_f64.powf(3.8 * share(i, 0.569_840_290_998) - 4.0)
            };
            let turn = TAU * share(i, 0.324_717_957_24);
            let squeezed = share(i, 0.245_122_333_75);
            let direction = DVec2::from_angle(turn);
            Place {
                position: (r * DVec2::from_angle(phi)).as_vec2(),
                delay: (400.0 * share(i, 0.438_579_021_1) - 200.0) as f32,
                right: (side * direction).as_vec2(),
                down: (side * squeezed * direction.perp()).as_vec2(),
            }
        })
        .collect()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_shader_finds_the_structure_that_the_cpu_finds() {
    let (turbulent, streaks) = (DiskStructure::Turbulent, DiskStructure::Streaks);
    let scenes = [
        (turbulent, 0.0, 3.0, 11.0, 0.0, 0.0, None),
        (turbulent, 0.9, 1.1604, 11.0, 1e7, 0.0, None),
        (streaks, -0.5, 4.0, 2e4, -1e9, 0.0, Some(12)),
        (streaks, 0.998, 0.62, 30.0, 1e9, 0.0, None),
        // With a period: of one life, of several that are less than a delay, and of very many.
        (turbulent, 0.9, 1.1604, 11.0, 17.0, 24.0, None),
        (turbulent, 0.0, 3.0, 11.0, -1e7, 150.0, None),
        (streaks, 0.998, 0.62, 30.0, 1e9, 1e6, None),
    ];
    for (kind, spin, inner, outer, time, period, limit) in scenes {
        let mut scene = Scene::default();
        (scene.hole.spin, scene.disk.inner, scene.disk.outer) = (spin, inner, outer);
        (scene.disk.structure, scene.disk.time) = (kind, time);
        (scene.disk.waves, scene.disk.seed) = (48, 7);
        scene.disk.period = period;
        let structure = Structure::new(&scene, limit).unwrap();
        let lead = f64::from(GpuScene::for_rays(&scene).unwrap().observer.time_lead);
        let places = places(&scene, structure.places.start.exp());
        let found = factors(&scene, limit, &places);
        let (mut worst, mut widest) = (0.0_f64, 0.0_f64);
        for (place, found) in places.iter().zip(found) {
            let p = place.position.as_dvec2();
            // The scene's own lead in f64 differs from the uniform's by its rounding, which is far
            // less than a wave moves in.
            let emitted = time - lead - f64::from(place.delay);
            let truth =
                structure.factor_at(p.length(), p.y.atan2(p.x), emitted, place.covariance());
            let off = (f64::from(found) / truth).ln().abs();
            assert!(found.is_finite(), "{place:?}: {found}");
            worst = worst.max(off);
            widest = widest.max(truth.ln().abs());
        }
        eprintln!("{kind:?} {spin} {time:e}, period {period}: {worst:e} of {widest}");
        assert!(widest > 1.0, "the factors vary: {widest}");
        assert!(worst < 2e-3, "{kind:?} {spin}, period {period}: {worst:e}");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn neighbours_without_a_hit_or_in_another_image_change_nothing() {
    let mut scene = Scene::default();
    scene.disk.structure = DiskStructure::Turbulent;
    let here = Place {
        position: Vec2::new(6.9, 0.3),
        delay: 0.0,
        right: Vec2::ZERO,
        down: Vec2::new(0.01, 0.05),
    };
    // The position of a pixel without a hit is zero: the difference to its neighbour is the
    // neighbour's position. The other image at the border shows the far side of the disk.
    let beside_nothing = Place {
        right: here.position,
        ..here
    };
    let beside_the_far_side = Place {
        right: -2.3 * here.position,
        ..here
    };
    let nothing = Place {
        position: Vec2::ZERO,
        right: here.position,
        ..here
    };
    let places = [here, beside_nothing, beside_the_far_side, nothing];
    let found = factors(&scene, None, &places);
    assert_ne!(found[0], 1.0);
    assert_eq!(found[..3], [found[0]; 3]);
    assert!(found[3].is_finite(), "{found:?}");
}
