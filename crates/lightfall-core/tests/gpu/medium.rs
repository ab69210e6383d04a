//! Matter with depth on the GPU: its light against the converged f64 twin.

use crate::{gpu, pixel_directions, quantile};
use lightfall_core::accuracy::{Ray, true_passages};
use lightfall_core::gpu::passages::PassageKernel;
use lightfall_core::scene::promises::MEDIUM_LIGHT;
use lightfall_core::scene::{DiskStructure, Scene, SkyMode, presets};
use lightfall_lab::medium::thick_scene;

/// The light of the GPU and of the converged twin on a grid of pixels: the largest of red, green and
/// blue.
pub(crate) fn light(scene: &Scene, size: [u32; 2], relative: f64) -> Vec<[f64; 2]> {
    let camera_from_axes = scene.camera.tetrad_from_camera().transpose();
    let directions = pixel_directions(scene, size[0], size[1]).into_iter();
    let rays: Vec<_> = directions
        .map(|direction| Ray::toward(camera_from_axes * direction))
        .collect();
    let given = rays.iter().map(Ray::given);
    let kernel = PassageKernel::new(gpu(), scene).unwrap();
    let found = kernel.passages(gpu(), scene, given).unwrap();
    let truth = true_passages(scene, &rays, relative).unwrap();
    let pairs = found.iter().zip(&truth);
    let largest = pairs.map(|(found, truth)| {
        [
            f64::from(found.light.max_element()),
            truth.light.max_element(),
        ]
    });
    largest.collect()
}

/// The errors of lit pixels, relative to the larger of the pixel's light and 1 % of the picture's 95th
/// percentile.
pub(crate) fn errors(pairs: &[[f64; 2]]) -> Vec<f64> {
    let lit: Vec<_> = pairs
        .iter()
        .filter(|pair| pair[0] > 0.0 || pair[1] > 0.0)
        .collect();
    let truth: Vec<f64> = lit.iter().map(|[_, truth]| *truth).collect();
    let floor = 0.01 * quantile(&truth, 0.95);
    lit.into_iter()
        .map(|[found, truth]| (found - truth).abs() / truth.max(floor))
        .collect()
}

/// Edge-on, from above, from near by, and as opaque as a disk may be: spin, camera, thickness and depth.
const SCENES: [(f64, [f64; 2], f64, f64); 4] = [
    (0.9, [20.0, 83.0], 0.06, 12.0),
    (0.9, [20.0, 60.0], 0.1, 3.0),
    (0.9, [6.5, 80.0], 0.06, 12.0),
    (0.0, [20.0, 83.0], 0.05, 200.0),
];

#[test]
#[ignore = "needs a graphics adapter"]
fn light_holds_the_error_that_chooses_its_nodes() {
    for (spin, camera, thickness, depth) in SCENES {
        for max_error in [0.1, MEDIUM_LIGHT, 0.002] {
            let mut scene = thick_scene(spin, camera, thickness, depth);
            scene.quality.max_error_light = max_error;
            let errors = errors(&light(&scene, [48, 27], 1e-5));
            let [median, most] = [0.5, 0.95].map(|share| quantile(&errors, share));
            println!(
                "{spin} {camera:?} {thickness} {depth} {max_error}: {} lit, {median:.1e} {most:.1e}",
                errors.len()
            );
            assert!(errors.len() > 100, "{}", errors.len());
            assert!(
                most < max_error,
                "{spin} {camera:?}: {most:e}, not {max_error}"
            );
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn structure_in_depth_is_that_of_the_twin() {
    for (spin, camera, thickness, depth) in SCENES {
        let mut scene = thick_scene(spin, camera, thickness, depth);
        // Large lumps, which the nodes resolve.
        scene.disk.structure = DiskStructure::Turbulent;
        (scene.disk.scale, scene.disk.aspect) = (0.5, 1.0);
        (scene.disk.contrast, scene.disk.lumps) = (0.3, 0.3);
        scene.quality.max_error_light = 1e-4;
        let errors = errors(&light(&scene, [32, 18], 1e-4));
        let [median, most] = [0.5, 0.95].map(|share| quantile(&errors, share));
        println!(
            "{spin} {camera:?}: {} lit, {median:.1e} {most:.1e}",
            errors.len()
        );
        // With twelve nodes a chunk, what is left is f32's: phases of waves, and the search for the
        // boundary of an opaque disk.
        assert!(most < 3e-3, "{spin} {camera:?}: {most:e}");
    }
}

/// Rays that graze a disk and leave it far away: the last step ends at u = 0, where r has no end.
#[test]
#[ignore = "needs a graphics adapter"]
fn no_ray_between_lit_ones_is_dark() {
    let mut scene = presets::find("thick").unwrap().scene(&[]).unwrap();
    scene.sky.mode = SkyMode::Off;
    (scene.camera.fov_deg, scene.camera.yaw_deg) = (1.0, -1.15);
    let (width, height) = (480, 270);
    let camera_from_axes = scene.camera.tetrad_from_camera().transpose();
    let directions = pixel_directions(&scene, width, height).into_iter();
    let given: Vec<_> = directions
        .map(|direction| Ray::toward(camera_from_axes * direction).given())
        .collect();
    let kernel = PassageKernel::new(gpu(), &scene).unwrap();
    let found = kernel.passages(gpu(), &scene, given).unwrap();
    let light: Vec<f32> = found
        .iter()
        .map(|passage| passage.light.max_element())
        .collect();
    // A light that is no number is not lit.
    let is_lit = |light: f32| light > 0.0;
    let dark = |row: &[f32]| !is_lit(row[1]) && is_lit(row[0]) && is_lit(row[2]);
    let rows = light.chunks(width as usize);
    let count: usize = rows
        .map(|row| row.windows(3).filter(|three| dark(three)).count())
        .sum();
    assert_eq!(count, 0);
}
