//! Projections in shaders: against pairs of an independent program, and rays, footprints and point
//! stars of the whole sky against the formula in f64.

use crate::finite_light::{LIGHT, MAP};
use crate::light::light_from;
use crate::stars::light::flux_of_images;
use crate::stars::run::{StarLight, StarRun};
use crate::stars::{star_at, star_of};
use crate::{all_around, bare_hole, gpu, median, quantile};
use glam::swizzles::Vec3Swizzles;
use glam::{DMat3, DVec2, DVec3, UVec2, Vec2, Vec3, Vec4};
use lightfall_core::gpu::kernel::{ArrayKernel, uniform};
use lightfall_core::gpu::stars::{GpuStarImage, PackedStars};
use lightfall_core::gpu::{Entry, GpuScene, GpuStarlight, Inputs, Variant, bindings};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::stars::images::Inversion;
use lightfall_core::optics::stars::{Depth, Star};
use lightfall_core::scene::{Effects, Frame, Method, Projection, Scene, SkyMode};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const DEPTH: Depth = Depth {
    limit: 6.5,
    last: f64::INFINITY,
};

/// A depth at which half of the stars' light is that of points.
const DEEP: Depth = Depth {
    limit: 11.0,
    last: f64::INFINITY,
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

/// The place at which a direction is seen.
fn place_of(looking: DVec3, size: DVec2) -> DVec2 {
    let across = 0.5 + looking.x.atan2(looking.z) / TAU;
    let down = 0.5 - looking.y.asin() / PI;
    DVec2::new(across, down) * size
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

/// The pairs of crates/lightfall-core/tests/projections.csv, as the test of physics reads them:
/// projection, size, angle, place, direction.
fn pairs() -> Vec<(Projection, UVec2, f64, Vec2, Vec3)> {
    let text = include_str!("../projections.csv");
    let rows = text.lines().skip(1).filter_map(|line| {
        let (word, numbers) = line.split_once(',').unwrap();
        let numbers: Vec<f64> = numbers.split(',').filter_map(|n| n.parse().ok()).collect();
        let projection = Projection::from_word(word).unwrap();
        let size = DVec2::new(numbers[0], numbers[1]).as_uvec2();
        let place = DVec2::new(numbers[3], numbers[4]).as_vec2();
        // Places outside a circle have no direction, and a cube has no shader of its own.
        let is_drawn = numbers.len() == 9 && numbers[8] == 1.0 && projection != Projection::Cube;
        is_drawn.then(|| {
            let looking = DVec3::new(numbers[5], numbers[6], numbers[7]).as_vec3();
            (projection, size, numbers[2], place, looking)
        })
    });
    rows.collect()
}

/// Directions within 1e-6 and places within 2e-3 pixels: f32 gives 5e-7 radians, and a pixel of the
/// largest of these pictures is 7.7e-4. At the poles of the whole sky a place is compared by its row.
#[test]
#[ignore = "needs a graphics adapter"]
fn pixels_and_directions_are_those_of_an_independent_program() {
    let (mut worst, mut count) = ([0.0_f32; 2], 0);
    for (projection, size, angle_deg, place, looking) in pairs() {
        let mut scene = bare_hole(20.0);
        scene.camera.projection = projection;
        scene.camera.set_field_deg(angle_deg);
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
    scene.effects = Effects {
        lensing: false,
        doppler: false,
        beaming: false,
        gravitational_shift: false,
        aberration: false,
    };
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

/// Stars all around, and some whose images lie next to the seam behind the camera.
fn stars(scene: &Scene) -> Vec<Star> {
    let [outward, _, phi_hat] = scene.camera.tetrad().to_cols_array_2d().map(DVec3::from);
    let up = outward.cross(phi_hat);
    let beside = (-4..4).map(|i| {
        let turn = 0.2 * f64::from(i) + 0.1;
        outward + 0.7 * turn * up + 2e-3 * f64::from(i) * phi_hat
    });
    all_around(300)
        .into_iter()
        .chain(beside)
        .map(star_at)
        .collect()
}

/// An image in f64: the star's number, the order, and the place.
type Truth = (u32, u32, DVec2);

fn truths(scene: &Scene, stars: &[Star]) -> Vec<Truth> {
    let inversion = Inversion::new(scene).unwrap();
    let camera_from_tetrad = scene.camera.tetrad_from_camera().transpose();
    let size = scene.picture.size().as_dvec2();
    let mut truths = vec![];
    for (number, star) in stars.iter().enumerate() {
        for image in inversion.images(star.direction.as_dvec3().normalize()) {
            // Fainter by six magnitudes than the star is the limit of 6.5 but for rounding.
            if image.gain > 10_f64.powf(-0.4 * 6.0) {
                let place = place_of(camera_from_tetrad * image.direction, size);
                truths.push((number as u32, image.order, place));
            }
        }
    }
    truths
}

/// The way from one place to another, across the seam if that is shorter.
fn way(from: DVec2, to: DVec2, size: DVec2) -> DVec2 {
    let way = to - from;
    DVec2::new(way.x - size.x * (way.x / size.x).round(), way.y)
}

fn light_of(scene: &Scene, stars: &[Star]) -> StarLight {
    let list = PackedStars::new(stars);
    StarRun::new(gpu(), scene, &list, DMat3::IDENTITY, DEPTH).run()
}

/// The profile keeps the centre of an image's light, where a square of pixels holds it. The bars are a
/// fiftieth of a pixel for the place, a tenth for the centre, whose profile has its width on the sky
/// and not in pixels, and of the light a thousandth: what rounding to units and f32 leave.
fn check(scene: &Scene, name: &str, counts: impl Fn(&Truth) -> bool) {
    let size = scene.picture.size().as_dvec2();
    let stars = stars(scene);
    let truths = truths(scene, &stars);
    let light = light_of(scene, &stars);
    let list = PackedStars::new(&stars);
    let place = |direction: Vec3| place_of(direction.as_dvec3().normalize(), size);
    let (mut places, mut at_seam) = (vec![], 0);
    for truth in truths.iter().filter(|truth| counts(truth)) {
        let near = |image: &&GpuStarImage| {
            image.star == number_in(&list, &stars, truth.0)
                && way(truth.2, place(image.direction), size).length() < 1.0
        };
        let found: Vec<_> = light.images.iter().filter(near).collect();
        assert_eq!(found.len(), 1, "{name}: {truth:?} {found:?}");
        places.push(way(truth.2, place(found[0].direction), size).length());
        at_seam += usize::from(truth.2.x.min(size.x - truth.2.x) < 2.0);
    }
    let fluxes: Vec<f64> = middles(scene.picture.size())
        .zip(light.sums.chunks_exact(3))
        .map(|(middle, sums)| {
            let solid_angle =
                TAU * PI / size.element_product() * looking(middle, size).xz().length();
            f64::from(sums[1]) / light.unit * solid_angle
        })
        .collect();
    let mut centres = vec![];
    for truth in truths.iter().filter(|truth| counts(truth)) {
        let others = truths.iter().filter(|other| *other != truth);
        let alone = others
            .map(|other| way(truth.2, other.2, size).length())
            .fold(f64::INFINITY, f64::min);
        if alone < 12.0 || looking(truth.2, size).y.abs() > 0.8 {
            continue;
        }
        let (mut sum, mut moment) = (0.0, DVec2::ZERO);
        for (middle, flux) in middles(scene.picture.size()).zip(&fluxes) {
            let off = way(truth.2, middle, size);
            if off.abs().max_element() < 4.0 {
                (sum, moment) = (sum + flux, moment + *flux * off);
            }
        }
        assert!(sum > 0.0, "{name}: no light at {truth:?}");
        centres.push((moment / sum).length());
    }
    let in_picture: f64 = fluxes.iter().sum();
    let in_list = flux_of_images(&light.images) * scene.sky.brightness;
    let [place, centre] = [&places, &centres].map(|errors| quantile(errors, 1.0));
    println!(
        "{name}: {} images, {at_seam} at the seam: {place:.1e} px; {} centres: {centre:.1e} px; \
         light {:.1e}",
        places.len(),
        centres.len(),
        in_picture / in_list - 1.0
    );
    assert!(at_seam > 4 && centres.len() > 100);
    assert!(place < 0.02 && centre < 0.1, "{place} {centre}");
    assert!((in_picture / in_list - 1.0).abs() < 1e-3);
}

/// The number in the list, which is sorted by brightness, of a star.
fn number_in(list: &PackedStars, stars: &[Star], star: u32) -> u32 {
    let direction = stars[star as usize].direction;
    let distance = |number: &u32| {
        let other = star_of(list, *number).direction;
        (other.distance(direction) * 1e6) as u64
    };
    (0..list.len()).min_by_key(distance).unwrap()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn stars_by_inversion_land_where_another_projection_shows_them() {
    check(&whole_sky(960), "equirectangular-stars", |_| true);
}

/// At the edge of the shadow the meshes may miss images.
#[test]
#[ignore = "needs a graphics adapter"]
fn stars_by_a_mesh_land_where_another_projection_shows_them() {
    let mut scene = whole_sky(960);
    let size = scene.picture.size().as_dvec2();
    scene.method = Method::Mino;
    check(&scene, "equirectangular-mesh", |(_, order, place)| {
        *order == 0 && looking(*place, size).z < 0.9
    });
}

/// Stars along straight rays, one at each of several latitudes of the camera's sky: their light times
/// the solid angle of the pixels is their flux, whether a pixel is as wide as at the equator or 60
/// times as wide in columns. In a fisheye picture of 360 degrees the same angles lead to its edge.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_star_has_its_light_at_every_latitude() {
    for projection in [Projection::Equirectangular, Projection::Fisheye] {
        for latitude_deg in [0.0_f64, 60.0, 89.0, 89.9] {
            let mut scene = whole_sky(512);
            scene.camera.projection = projection;
            scene.camera.fisheye_deg = 360.0;
            scene.effects = Effects {
                lensing: false,
                doppler: false,
                beaming: false,
                gravitational_shift: false,
                aberration: false,
            };
            // Away from the hole, which hides what is straight ahead.
            scene.camera.yaw_deg = 90.0;
            let (sine, cosine) = latitude_deg.to_radians().sin_cos();
            let looking = DVec3::new(0.6 * cosine, sine, 0.8 * cosine);
            let axes = scene.camera.tetrad() * scene.camera.tetrad_from_camera();
            let stars = [star_at(axes * looking)];
            let light = light_of(&scene, &stars);
            let size = scene.picture.size().as_dvec2();
            let flux: f64 = middles(scene.picture.size())
                .zip(light.sums.chunks_exact(3))
                .map(|(middle, sums)| {
                    f64::from(sums[1]) / light.unit * scene.camera.solid_angle(middle, size)
                })
                .sum();
            let exact = flux_of_images(&light.images) * scene.sky.brightness;
            let name = format!("{} {latitude_deg}", projection.word());
            println!("{name}: {:.1e}", flux / exact - 1.0);
            assert!(exact > 0.0 && light.images.len() == 1, "{name}");
            assert!((flux / exact - 1.0).abs() < 0.01, "{name}: {flux} {exact}");
        }
    }
}
