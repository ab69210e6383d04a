//! Point stars in projections of the whole sky, against the formula in f64.

use super::{STRAIGHT, looking, middles, whole_sky};
use crate::stars::light::flux_of_images;
use crate::stars::run::{StarLight, StarRun};
use crate::stars::{star_at, star_of};
use crate::{all_around, gpu, quantile};
use glam::swizzles::Vec3Swizzles;
use glam::{DMat3, DVec2, DVec3, Vec3};
use lightfall_core::gpu::stars::{GpuStarImage, PackedStars};
use lightfall_core::optics::stars::images::Inversion;
use lightfall_core::optics::stars::{Depth, Star};
use lightfall_core::scene::{Method, Projection, Scene};
use std::f64::consts::{PI, TAU};

const DEPTH: Depth = Depth {
    limit: 6.5,
    last: f64::INFINITY,
};

/// The place at which a direction is seen.
fn place_of(looking: DVec3, size: DVec2) -> DVec2 {
    let across = 0.5 + looking.x.atan2(looking.z) / TAU;
    let down = 0.5 - looking.y.asin() / PI;
    DVec2::new(across, down) * size
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
            scene.effects = STRAIGHT;
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
