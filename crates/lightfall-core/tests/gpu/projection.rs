//! Projections in shaders: against pairs of an independent program, and rays and footprints of the whole
//! sky against the formula in f64.

mod stars;

use crate::finite_light::{LIGHT, MAP};
use crate::light::light_from;
use crate::projection_pairs::{Pair, pairs};
use crate::{bare_hole, gpu, median, quantile};
use glam::{DVec2, DVec3, UVec2, Vec2, Vec4};
use lightfall_core::gpu::kernel::{ArrayKernel, uniform};
use lightfall_core::gpu::{Entry, GpuScene, GpuStarlight, Inputs, Variant, bindings};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::stars::Depth;
use lightfall_core::scene::{Effects, Frame, Method, Projection, Scene, SkyMode};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A depth at which half of the stars' light is that of points.
const DEEP: Depth = Depth {
    limit: 11.0,
    last: f64::INFINITY,
};

/// Light goes straight, and its frequency stays as it is.
const STRAIGHT: Effects = Effects {
    lensing: false,
    doppler: false,
    beaming: false,
    gravitational_shift: false,
    aberration: false,
};

/// The direction (right, up, forward) that is seen at a place.
fn looking(place: DVec2, size: DVec2) -> DVec3 {
    let longitude = TAU * (place.x / size.x - 0.5);
    let latitude = PI * (0.5 - place.y / size.y);
    DVec3::new(
        latitude.cos() * longitude.sin(),
        latitude.sin(),
        latitude.cos() * longitude.cos(),
    )
}

/// The middles of a picture's pixels, row by row.
fn middles(size: UVec2) -> impl Iterator<Item = DVec2> {
    let pixels = (0..size.y).flat_map(move |y| (0..size.x).map(move |x| UVec2::new(x, y)));
    pixels.map(|pixel| pixel.as_dvec2() + 0.5)
}

/// A bare hole in a picture of the whole sky, whose middle has pixels as large as the scene's own
/// field of view gives them.
fn whole_sky(width: u32) -> Scene {
    let mut scene = bare_hole(20.0);
    scene.method = Method::Closed;
    (scene.picture.width, scene.picture.height) = (width, width / 2);
    scene.camera.projection = Projection::Equirectangular;
    scene
}

/// Directions within 1e-6 and places within 2e-3 pixels: f32 gives 5e-7 radians, and a pixel of the
/// largest of these pictures is 7.7e-4. At the poles of the whole sky a place is compared by its row.
#[test]
#[ignore = "needs a graphics adapter"]
fn pixels_and_directions_are_those_of_an_independent_program() {
    let (mut worst, mut count) = ([0.0_f32; 2], 0);
    // Places outside a circle have no direction, and a cube has no shader of its own.
    let is_drawn = |pair: &Pair| pair.is_inside && pair.projection != Projection::Cube;
    for pair in pairs().into_iter().filter(is_drawn) {
        let (projection, size) = (pair.projection, pair.size.as_uvec2());
        let (place, looking) = (pair.place.as_vec2(), pair.looking.as_vec3());
        let mut scene = bare_hole(20.0);
        scene.camera.projection = projection;
        scene.camera.set_field_deg(pair.angle_deg);
        (scene.picture.width, scene.picture.height) = size.into();
        let source = Variant::timed(&scene).source();
        let numbers = uniform(&GpuScene::new(&scene, &Frame::of(&scene)).unwrap());
        let values = |expression: &str, given: Vec4| {
            let uniforms = [(bindings::SCENE, numbers.clone())];
            light_from(gpu(), &source, expression, &uniforms, [given])[0]
        };
        let seen = values(
            "vec4<f32>(pixel_direction(given.xy), pixel_solid_angle(given.xy))",
            place.extend(0.0).extend(0.0),
        );
        let back = values(
            "vec4<f32>(project(given.xyz), coverage(project(given.xyz)), 0.0)",
            looking.extend(0.0),
        );
        let is_pole = projection == Projection::Equirectangular && looking.y.abs() > 0.999_999;
        let off = if is_pole {
            Vec2::new(0.0, back.y - place.y)
        } else {
            back.truncate().truncate() - place
        };
        let exact = scene.camera.solid_angle(place.as_dvec2(), size.as_dvec2());
        let name = format!("{} {place}", projection.word());
        worst = [
            worst[0].max(seen.truncate().distance(looking)),
            worst[1].max(off.length()),
        ];
        assert!(seen.truncate().distance(looking) < 1e-6, "{name}: {seen}");
        assert!(off.length() < 2e-3, "{name}: {back}");
        // Next to straight back the sine of the angle is a difference of large numbers.
        let largest = scene.pixel_angle().powi(2);
        assert!(
            (f64::from(seen.w) - exact).abs() < 1e-5 * largest,
            "{name}: {} {exact}",
            seen.w
        );
        count += 1;
    }
    println!("{count} pairs: {:.1e} {:.1e} px", worst[0], worst[1]);
    assert!(count > 35, "{count}");
}

/// Away from the shadow, where the lens enlarges errors, f32 gives 1e-6 and the bar is ten times that.
/// The sum of solid angles is that of the whole sphere but for the width of a row.
#[test]
#[ignore = "needs a graphics adapter"]
fn rays_go_where_another_projection_says() {
    let mut scene = whole_sky(64);
    (scene.camera.yaw_deg, scene.camera.pitch_deg) = (25.0, -10.0);
    let size = scene.picture.size();
    let answers = light_from(
        gpu(),
        &Variant::timed(&scene).source(),
        "vec4<f32>(trace(photon_from(pixel_direction(given.xy))).sky, pixel_solid_angle(given.xy))",
        &[(
            bindings::SCENE,
            uniform(&GpuScene::new(&scene, &Frame::of(&scene).with_whole(size)).unwrap()),
        )],
        middles(size).map(|place| place.as_vec2().extend(0.0).extend(0.0)),
    );
    let reference = Reference::new(&scene).unwrap();
    let axes = scene.camera.tetrad_from_camera();
    let (mut errors, mut sphere) = (vec![], 0.0);
    for (place, answer) in middles(size).zip(answers) {
        sphere += f64::from(answer.w);
        let direction = axes * looking(place, size.as_dvec2());
        if direction.dot(DVec3::NEG_X) < 0.9 {
            let sky = reference.trace(direction).sky.unwrap();
            errors.push(sky.distance(answer.truncate().as_dvec3()));
        }
    }
    let worst = quantile(&errors, 1.0);
    println!(
        "{} rays: {worst:.1e}; {:.1e}",
        errors.len(),
        sphere / (4.0 * PI) - 1.0
    );
    assert!(errors.len() > 1800 && worst < 1e-5, "{worst}");
    assert!((sphere / (4.0 * PI) - 1.0).abs() < 1e-3, "{sphere}");
}

/// Without lens and shifts an image covers as much of the sky as its pixel does, so that every pixel
/// shows stars of the same magnitudes as points, and the diffuse light of an even sky is the same
/// everywhere, in both projections. A solid angle that is wrong by a tenth changes it by 2 %; the bar
/// is less than a sixth of that.
#[test]
#[ignore = "needs a graphics adapter"]
fn the_diffuse_light_of_an_even_sky_is_even_in_another_projection() {
    let mut scene = whole_sky(96);
    (scene.sky.mode, scene.sky.reference_star) = (SkyMode::Stars, false);
    scene.effects = STRAIGHT;
    let size = scene.picture.size();
    // Four by four those of 2 x 2 squares, as LIGHT asks for.
    let squares = middles(size / 2).map(|place| (2.0 * (place - 0.5)).as_uvec2());
    let pixels: Vec<UVec2> = squares
        .flat_map(|corner| (0..4).map(move |i| corner + UVec2::new(i % 2, i / 2)))
        .collect();
    let given: Vec<Vec4> = pixels
        .iter()
        .map(|pixel| pixel.as_vec2().extend(0.0).extend(0.0))
        .collect();
    let light = |scene: &Scene| -> Vec<Vec4> {
        let variant = Variant {
            entry: Entry::Refine,
            antialias: false,
            ..Variant::picture(scene)
        };
        let starlight = GpuStarlight::new(scene, DEEP);
        let numbers = GpuScene::new(scene, &Frame::of(scene)).unwrap();
        let mut uniforms = Inputs::new(scene).declared_in(&variant.source());
        uniforms.push((bindings::SCENE, uniform(&numbers)));
        uniforms.push((bindings::STARLIGHT, uniform(&starlight)));
        let source = variant.source() + LIGHT;
        assert_eq!(source.matches(MAP).count(), 1);
        let source = source.replace(MAP, "vec3<f32>(1.0)");
        let kernel = ArrayKernel::new(gpu(), &source, "pixel_light", &uniforms).unwrap();
        kernel.run(gpu(), &given).unwrap()
    };
    let mut flat = scene.clone();
    flat.camera.projection = Projection::Perspective;
    flat.camera.fov_deg = 2.0 * FRAC_PI_2.atan().to_degrees();
    let perspective = light(&flat);
    let perspective = median(
        &perspective
            .iter()
            .map(|light| f64::from(light.y))
            .collect::<Vec<_>>(),
    );
    let lights = light(&scene);
    let mut differences = vec![];
    for (pixel, light) in pixels.iter().zip(lights) {
        // The hole's black ball lies straight ahead.
        if looking(pixel.as_dvec2() + 0.5, size.as_dvec2()).z < 0.9 {
            differences.push((f64::from(light.y) / perspective - 1.0).abs());
        }
    }
    let worst = quantile(&differences, 1.0);
    println!(
        "{} pixels of light {perspective}: {worst:.1e}",
        differences.len()
    );
    assert!(perspective > 0.0 && differences.len() > 4000);
    assert!(worst < 3e-3, "{worst}");
}
