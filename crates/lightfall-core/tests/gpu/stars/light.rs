//! The light that images of stars add to the picture.

use super::run::{StarLight, StarRun};
use super::{DEPTH, bright_stars, place_of, preset, star_light, truths};
use crate::gpu;
use crate::random::Random;
use crate::random_scene::random_scene;
use glam::{DVec2, DVec3};
use lightfall_core::gpu::stars::{GpuStarImage, PackedStars, sums_side};
use lightfall_core::optics::spectrum;
use lightfall_core::optics::stars::images::Inversion;
use lightfall_core::optics::stars::{Catalogue, Star};
use lightfall_core::scene::promises::STAR_FLICKER;
use lightfall_core::scene::{Scene, SkyMode};

/// The luminous fluxes of a picture's light, square by square: radiance times solid angle.
fn fluxes(scene: &Scene, light: &StarLight) -> Vec<f64> {
    let size = scene.picture.size().as_dvec2();
    let half = DVec2::new(size.x / size.y, 1.0) * (0.5 * scene.camera.fov_deg).to_radians().tan();
    let side = sums_side(scene.picture.size());
    let width = scene.picture.width.div_ceil(side) as usize;
    let side = f64::from(side);
    let green = light.sums.chunks_exact(3).enumerate();
    green
        .map(|(index, sums)| {
            let square = DVec2::new((index % width) as f64, (index / width) as f64) + 0.5;
            let tangents = (2.0 * side * square / size - 1.0) * half;
            let cosine = (1.0 + tangents.length_squared()).powf(-0.5);
            let pixel = 4.0 * half.element_product() / size.element_product();
            let solid_angle = side * side * pixel * cosine.powi(3);
            f64::from(sums[1]) / light.unit * solid_angle
        })
        .collect()
}

/// The same of images: their green light.
pub(crate) fn flux_of_images(images: &[GpuStarImage]) -> f64 {
    let table = spectrum::table();
    let green = |image: &GpuStarImage| {
        f64::from(image.flux) * spectrum::sample(&table, image.temperature.into())[1]
    };
    images.iter().map(green).sum()
}

/// The catalogue's stars of whose images none is cut by the picture's edge.
fn stars_within(scene: &Scene) -> Vec<Star> {
    let (list, turn) = bright_stars();
    let size = scene.picture.size().as_dvec2();
    let mut kept = vec![true; list.len() as usize];
    for ((number, _), truth) in truths(scene, &list, turn) {
        kept[number as usize] &= truth.place.min(size - truth.place).min_element() > 6.0;
    }
    let stars = Catalogue::built_in().stars().iter().zip(kept);
    stars
        .filter_map(|(star, kept)| kept.then_some(*star))
        .collect()
}

fn light_of(scene: &Scene, stars: &[Star]) -> StarLight {
    let (_, turn) = bright_stars();
    StarRun::new(gpu(), scene, &PackedStars::new(stars), turn, DEPTH).run()
}

fn relative(found: f64, expected: f64) -> f64 {
    (found / expected - 1.0).abs()
}

/// The sums are rounded to units, which is 1e-5 of the faintest star's light here. Without a disk,
/// whose samples would differ from size to size.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_picture_of_any_size_holds_the_light_of_all_images() {
    let mut scene = preset(2);
    scene.disk.enabled = false;
    (scene.picture.width, scene.picture.height) = (480, 270);
    let stars = stars_within(&scene);
    let mut totals = vec![];
    for (width, height) in [(480, 270), (960, 540), (3840, 2160), (5120, 2880)] {
        (scene.picture.width, scene.picture.height) = (width, height);
        let light = light_of(&scene, &stars);
        let in_picture: f64 = fluxes(&scene, &light).iter().sum();
        let in_list = flux_of_images(&light.images) * scene.sky.brightness;
        println!(
            "{width}x{height}: {} images, {in_picture:e} {in_list:e}",
            light.images.len()
        );
        assert!(light.images.len() > 500);
        assert!(
            relative(in_picture, in_list) < 1e-4,
            "{in_picture} {in_list}"
        );
        totals.push(in_picture);
    }
    assert!(relative(totals[0], totals[1]) < 1e-3 && relative(totals[2], totals[1]) < 1e-3);
}

/// The bar is a tenth of a percent; footprints that are no partition of unity change by ten percent.
/// Also at the picture's corner, where a pixel's solid angle is a third smaller.
#[test]
#[ignore = "needs a graphics adapter"]
fn stars_keep_their_light_while_the_camera_turns_by_tenths_of_a_pixel() {
    let mut scene = preset(2);
    scene.disk.enabled = false;
    let pixel = scene.pixel_angle().to_degrees();
    // Stars with one image each, far from all others'.
    let (list, turn) = bright_stars();
    let all: Vec<_> = truths(&scene, &list, turn).into_iter().collect();
    let size = scene.picture.size().as_dvec2();
    let apart = |star: u32, place: DVec2| {
        let others = all.iter().filter(|((other, _), _)| *other != star);
        let distances = others.map(|(_, truth)| truth.place.distance(place));
        distances.fold(f64::INFINITY, f64::min) > 9.0
    };
    let mut chosen: Vec<u32> = all
        .iter()
        .filter(|((star, order), truth)| {
            *order == 0
                && apart(*star, truth.place)
                && truth.place.min(size - truth.place).min_element() > 8.0
        })
        .map(|((star, _), _)| *star)
        .collect();
    chosen.sort_unstable();
    chosen.truncate(50);
    assert_eq!(chosen.len(), 50);
    let mut ranges = vec![[f64::INFINITY, 0.0]; chosen.len()];
    for tenths in 0..10 {
        scene.camera.yaw_deg = 0.1 * f64::from(tenths) * pixel;
        scene.camera.pitch_deg = 0.07 * f64::from(tenths) * pixel;
        let light = star_light(&scene);
        let fluxes = fluxes(&scene, &light);
        for (star, range) in chosen.iter().zip(&mut ranges) {
            let image = light
                .images
                .iter()
                .find(|i| i.star == *star && i.order == 0);
            let place = place_of(&scene, image.unwrap());
            let near = |index: usize| {
                let pixel = DVec2::new((index % 960) as f64, (index / 960) as f64) + 0.5;
                (pixel - place).abs().max_element() < 4.0
            };
            let of_star = (0..fluxes.len()).filter(|index| near(*index));
            let flux: f64 = of_star.map(|index| fluxes[index]).sum();
            *range = [range[0].min(flux), range[1].max(flux)];
        }
    }
    let worst = ranges.iter().map(|[low, high]| high / low - 1.0);
    let worst = worst.fold(0.0, f64::max);
    println!("peak to peak {worst:.1e}");
    assert!(worst < STAR_FLICKER, "{worst}");
}

/// Where images are drawn, their light is bounded, and what is not a number is left out. The list of
/// images still shows both, unless the magnification itself is not a number.
#[test]
#[ignore = "needs a graphics adapter"]
fn every_image_of_a_star_in_random_scenes_has_finite_light() {
    let mut random = Random::new();
    let mut found = 0;
    // Each with kernels of its own to compile.
    for number in 0..20 {
        let scene = random_scene(&mut random, &[SkyMode::Stars]);
        let images = star_light(&scene).images;
        for image in &images {
            // An opaque disk leaves none of the light.
            let is_light = image.flux.is_finite() && image.flux >= 0.0;
            let is_warm = image.temperature.is_finite() && image.temperature > 0.0;
            assert!(
                is_light && is_warm && image.direction.is_finite(),
                "scene {number}: {image:?}\n{}",
                scene.to_preset()
            );
        }
        found += images.len();
    }
    assert!(found > 200, "{found} images");
}

/// The same sums in spite of another order of threads, and the same images.
#[test]
#[ignore = "needs a graphics adapter"]
fn two_runs_give_the_same_bytes() {
    let scene = preset(4);
    let [first, second] = [star_light(&scene), star_light(&scene)];
    assert!(first.sums.iter().any(|sum| *sum > 0) && first.sums == second.sums);
    let sorted = |light: &StarLight| {
        let mut images = light.images.clone();
        images.sort_by_key(|image| (image.star, image.order));
        images
    };
    assert_eq!(sorted(&first), sorted(&second));
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_star_on_the_line_behind_the_hole_is_finite_and_no_brighter_than_its_disc_allows() {
    let mut scene = preset(2);
    scene.disk.enabled = false;
    let inversion = Inversion::new(&scene).unwrap();
    let (_, turn) = bright_stars();
    let [n, theta_hat, phi_hat] = scene.camera.tetrad().to_cols_array_2d().map(DVec3::from);
    for beta in [0.0, 3e-8, 1e-7, 4e-7, 2e-6] {
        let direction = -n + beta * (0.6 * theta_hat - 0.8 * phi_hat);
        let star = Star {
            direction: (turn.transpose() * direction).normalize().as_vec3(),
            magnitude: 8.0,
            temperature: 6500.0,
        };
        let light = light_of(&scene, &[star]);
        // The ring's two sides, or any two opposite places of it.
        assert_eq!(light.images.len(), 2, "{beta}");
        for image in &light.images {
            let own = star.flux();
            // 2/rho is the mean of 1/distance from the middle of a disc.
            let largest = inversion.image(-n, image.order).unwrap().gain;
            let gain = f64::from(image.flux) / own;
            assert!(
                gain.is_finite() && gain < 1.001 * largest,
                "{beta}: {gain} {largest}"
            );
            assert!(gain > 0.1 * largest, "{beta}: {gain} {largest}");
        }
        assert!(light.sums.iter().any(|sum| *sum > 0));
    }
}
