//! The view `error` against the numbers that it shows, and those numbers against known errors.

use crate::light::light_from;
use crate::{edge_on, gpu, median};
use glam::{UVec2, Vec3};
use lightfall_core::accuracy::picture_errors;
use lightfall_core::gpu::kernel::uniform;
use lightfall_core::gpu::{ERROR_MAP_SIZE, ErrorMap, Gpu, GpuScene, Variant, bindings};
use lightfall_core::scene::{Frame, Method, Scene, View};

/// The light that the view shows in the middle of each cell, and at its upper left and lower right
/// corner, just inside.
fn shown(gpu: &Gpu, scene: &Scene, errors: &[Option<f64>]) -> Vec<[Vec3; 3]> {
    let scene = Scene {
        view: View::Error,
        ..scene.clone()
    };
    let size = scene.picture.size();
    let uniforms = [
        (
            bindings::SCENE,
            uniform(&GpuScene::new(&scene, &Frame::of(&scene).with_whole(size)).unwrap()),
        ),
        (bindings::ERROR_MAP, ErrorMap::new(errors).bytes()),
    ];
    let cell = size.as_vec2() / UVec2::from(ERROR_MAP_SIZE).as_vec2();
    let cells = (0..ERROR_MAP_SIZE[1])
        .flat_map(|y| (0..ERROR_MAP_SIZE[0]).map(move |x| UVec2::new(x, y).as_vec2()));
    let places = cells.flat_map(|at| {
        [0.5, 0.01, 0.99].map(|inside| ((at + inside) * cell).extend(0.0).extend(0.0))
    });
    let source = Variant::picture(&scene).source();
    let lights = light_from(gpu, &source, "light_at(given.xy)", &uniforms, places);
    lights
        .chunks_exact(3)
        .map(|cell| [0, 1, 2].map(|i| cell[i].truncate()))
        .collect()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn every_cell_has_the_colour_of_its_error_everywhere() {
    let gpu = gpu();
    // With so few steps some rays get no answer.
    let mut scene = Scene {
        method: Method::Verlet,
        ..edge_on()
    };
    scene.quality.max_steps = 60;
    let errors = picture_errors(gpu, &scene, ERROR_MAP_SIZE).unwrap();
    let lights = shown(gpu, &scene, &errors);
    assert_eq!(lights.len(), errors.len());
    let mut known = Vec::new();
    let (mut unseen, mut unexplained) = (0, 0);
    for (error, light) in errors.iter().zip(&lights) {
        assert!(
            light.iter().all(|corner| corner == &light[0]),
            "a cell of several colours: {light:?}"
        );
        let luminance = light[0].dot(Vec3::new(0.2126, 0.7152, 0.0722));
        match *error {
            None => {
                assert_eq!(light[0], Vec3::ZERO);
                unseen += 1;
            }
            Some(error) if error.is_infinite() => {
                assert!(
                    light[0].x > 0.0 && light[0].y == 0.0 && light[0].z == light[0].x,
                    "{light:?}"
                );
                unexplained += 1;
            }
            Some(error) => known.push((error, luminance)),
        }
    }
    // A cell is lighter for a greater error, up to f32's rounding of both.
    known.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert!(
        known.windows(2).all(|pair| pair[1].1 > pair[0].1 - 1e-5),
        "{known:?}"
    );
    assert!(
        known.first().unwrap().1 > 0.0 && known.last().unwrap().1 > 10.0 * known.first().unwrap().1
    );
    assert!(
        unseen > 10 && unexplained > 10 && known.len() > 1000,
        "{unseen}, {unexplained}, {}",
        known.len()
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn cells_whose_error_is_not_known_yet_are_grey() {
    let gpu = gpu();
    for cell in shown(gpu, &edge_on(), &[]) {
        assert!(
            cell.iter()
                .all(|light| light.x > 0.0 && *light == Vec3::splat(light.x)),
            "{cell:?}"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_grid_shows_the_different_errors_of_the_methods() {
    let gpu = gpu();
    let of = |method: Method| {
        let errors = picture_errors(
            gpu,
            &Scene {
                method,
                ..edge_on()
            },
            ERROR_MAP_SIZE,
        )
        .unwrap();
        errors.into_iter().flatten().collect::<Vec<f64>>()
    };
    let (closed, mino, verlet) = (of(Method::Closed), of(Method::Mino), of(Method::Verlet));
    // The bound of closed is 1e-6 rad; that of mino is its setting, by default 0.05 pixel.
    let scene = edge_on();
    let pixel = scene.pixel_angle();
    assert!(
        closed.iter().all(|error| *error < 1e-6 / pixel),
        "{closed:?}"
    );
    assert!(
        mino.iter().all(|error| *error < scene.quality.max_error_px),
        "{mino:?}"
    );
    assert!(
        median(&verlet) > 30.0 * median(&mino).max(median(&closed)),
        "{}",
        median(&verlet)
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn only_rays_that_rightly_end_at_the_horizon_without_a_crossing_have_no_error() {
    let gpu = gpu();
    // Without a disk the shadow is unseen: a cone about the line of sight, of the half-angle that
    // theory gives.
    let mut scene = Scene {
        method: Method::Closed,
        ..edge_on()
    };
    scene.disk.enabled = false;
    scene.camera.fov_deg = 30.0;
    let unseen = picture_errors(gpu, &scene, ERROR_MAP_SIZE)
        .unwrap()
        .iter()
        .filter(|error| error.is_none())
        .count();
    let alpha = lightfall_core::geometry::schwarzschild::shadow_half_angle_static(scene.camera.r);
    let radius = alpha.tan() / (scene.camera.fov_deg.to_radians() / 2.0).tan()
        * f64::from(ERROR_MAP_SIZE[1])
        / 2.0;
    let expected = std::f64::consts::PI * radius * radius;
    // Each cell counts as a whole, so in sum at most every second cell on the edge is misplaced.
    assert!(
        (unseen as f64 - expected).abs() < std::f64::consts::PI * radius,
        "{unseen} cells, theory {expected}"
    );
}
