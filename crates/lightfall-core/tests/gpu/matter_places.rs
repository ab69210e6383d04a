//! Where the light of matter with depth comes from: the GPU's means against the f64 twin's; and the views
//! of matter against the records of the same rays.

use crate::light::light_from;
use crate::{ALONG, gpu, pixel_directions, quantile};
use lightfall_core::accuracy::Ray;
use lightfall_core::gpu::kernel::uniform;
use lightfall_core::gpu::passages::{GpuPassage, PassageKernel};
use lightfall_core::gpu::{GpuScene, Inputs, Variant, bindings};
use lightfall_core::optics::medium::{Means, Medium, Tolerance};
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::{ObserverKind, Scene, SkyMode, View};

/// A camera beside matter of each kind: a disk with thickness, jets, both, and jets with a sheet.
fn scenes() -> [Scene; 4] {
    let mut base = Scene::default();
    base.hole.spin = 0.9;
    (base.camera.r, base.camera.theta_deg, base.camera.fov_deg) = (20.0, 75.0, 60.0);
    base.observer.kind = ObserverKind::Static;
    (base.disk.follow_isco, base.disk.outer, base.disk.edge_taper) = (true, 11.0, 0.2);
    base.disk.depth = 3.0;
    base.sky.mode = SkyMode::Off;
    base.jet.knots = 0.0;
    base.quality.max_error_light = 0.001;
    [
        (0.08, true, false),
        (0.0, false, true),
        (0.08, true, true),
        (0.0, true, true),
    ]
    .map(|(thickness, disk, jets)| {
        let mut scene = base.clone();
        (scene.disk.thickness, scene.disk.enabled) = (thickness, disk);
        scene.jet.enabled = jets;
        scene
    })
}

/// What the GPU finds along a picture's rays, as pixels do.
fn passages(scene: &Scene, rays: &[Ray]) -> Vec<GpuPassage> {
    let kernel = PassageKernel::of_pixels(gpu(), scene).unwrap();
    let given = rays.iter().map(Ray::given);
    kernel.passages(gpu(), scene, given).unwrap()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn light_comes_from_where_the_twin_says() {
    for scene in scenes() {
        let (camera, size) = (scene.camera.tetrad_from_camera(), [40, 30]);
        let directions = pixel_directions(&scene, size[0], size[1]);
        let rays: Vec<_> = directions
            .iter()
            .map(|direction| Ray::toward(camera.transpose() * *direction))
            .collect();
        let found = passages(&scene, &rays);
        let (medium, reference) = (
            Medium::of(&scene, 8).unwrap(),
            Reference::new(&scene).unwrap(),
        );
        let tolerance = Tolerance {
            relative: 1e-6,
            end_depth: 20.0,
        };
        let mut errors = Vec::new();
        for (ray, found) in rays.iter().zip(&found) {
            let direction = (camera * ray.direction()).normalize();
            let seen = medium.seen_with_means(&reference.photon(direction), tolerance);
            let Some(Means {
                r,
                height,
                g,
                delay,
            }) = seen.means()
            else {
                continue;
            };
            let means = found.means.as_dvec4();
            errors.push([
                (means.x - r).abs() / r,
                (means.y - height).abs() / r,
                (means.z - g).abs() / g,
                (means.w - delay).abs() / delay,
            ]);
        }
        assert!(errors.len() > 100, "{}", errors.len());
        for part in 0..4 {
            let of_part: Vec<f64> = errors.iter().map(|all| all[part]).collect();
            let most = quantile(&of_part, 0.95);
            println!(
                "{} {}: {part} {most:.1e}",
                scene.disk.thickness, scene.jet.enabled
            );
            // The promise for light is 0.001 of it. Light that goes astray by this share moves a mean by as
            // much as the places differ, which is at most ten times the radius or the shift.
            assert!(most < 0.01, "{part}: {most:e}");
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn views_of_matter_show_the_records_of_their_rays() {
    let mut scene = scenes()[0].clone();
    scene.quality.max_error_light = 0.1;
    let camera = scene.camera.tetrad_from_camera().transpose();
    let directions = pixel_directions(&scene, 48, 27);
    let rays: Vec<_> = directions
        .iter()
        .map(|d| Ray::toward(camera * *d))
        .collect();
    let found = passages(&scene, &rays);
    for (view, expression) in [
        (
            View::Depth,
            "select(depth_colour(given.x), vec3<f32>(0.0), given.x <= 0.0)",
        ),
        (
            View::Samples,
            "select(count_colour(given.x), vec3<f32>(0.0), given.x <= 0.0)",
        ),
        (
            View::LightError,
            "select(error_colour(given.x), vec3<f32>(0.0), given.y <= 0.0)",
        ),
    ] {
        scene.view = view;
        let source = Variant::picture(&scene).source();
        let numbers = GpuScene::for_rays(&scene).unwrap();
        let scene_alone = [(bindings::SCENE, uniform(&numbers))];
        let mut uniforms = Inputs::new(&scene).declared_in(&source);
        uniforms.push((bindings::SCENE, uniform(&numbers)));
        let given = directions.iter().map(|d| d.as_vec3().extend(0.0));
        let shown = light_from(gpu(), &source, ALONG, &uniforms, given);
        let of_record = found.iter().map(|seen| match view {
            View::Depth => glam::Vec4::new(-seen.transmission.ln(), 0.0, 0.0, 0.0),
            View::Samples => glam::Vec4::new(seen.samples as f32, 0.0, 0.0, 0.0),
            _ => glam::Vec4::new(seen.error, seen.samples as f32, 0.0, 0.0),
        });
        let expression = format!("mark({expression})");
        let wanted = light_from(gpu(), &source, &expression, &scene_alone, of_record);
        let lit = wanted
            .iter()
            .filter(|light| light.max_element() > 0.0 && light.x > 0.0)
            .count();
        assert!(lit > 100, "{view:?}: {lit}");
        let off = shown.iter().zip(&wanted).map(|(shown, wanted)| {
            f64::from(
                (*shown - *wanted).truncate().abs().max_element() / numbers.picture.mark_brightness,
            )
        });
        let off: Vec<f64> = off.collect();
        // Two compilations of the same sums differ by rounding, which an error at the edge of a disk
        // magnifies.
        let (most, share) = (quantile(&off, 0.99), quantile(&off, 0.9));
        assert!(most < 0.05 && share < 1e-3, "{view:?}: {most:e} {share:e}");
    }
}
