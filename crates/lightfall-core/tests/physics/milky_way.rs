//! The diffuse light against what is known of the Milky Way's brightness, the places of things in
//! it, and the light of the stars; and the cube map against the solid angles of its texels.

use crate::assert_close;
use crate::random::Random;
use crate::sky_texel::{face_and_place, texel};
use crate::starlight::{fainter_share, total_light};
use glam::DVec3;
use half::f16;
use lightfall_core::optics::cube_map::{FACES, face_column_row, place, solid_angle};
use lightfall_core::optics::milky_way::{MilkyWay, nebular};
use lightfall_core::optics::stars::{
    Catalogue, StarList, ZERO_MAGNITUDE_FLUX, celestial_direction, flux, galactic_from_celestial,
};
use lightfall_galaxy::light_from;
use std::f64::consts::PI;

/// Stars of V = 0 per steradian as magnitudes V per square second of arc.
fn magnitude(brightness: f64) -> f64 {
    -2.5 * (brightness / 3600_f64.to_degrees().powi(2)).log10()
}

/// The radiances from a J2000 direction, linear between the four texels around it on its
/// face.
fn radiance(sky: &MilkyWay, direction: DVec3) -> [f64; 3] {
    let (face, u, v) = face_and_place(direction);
    let size = MilkyWay::SIZE as f64;
    let split = |place: f64| {
        let place = (place * size - 0.5).clamp(0.0, size - 1.0);
        let low = (place as usize).min(MilkyWay::SIZE - 2);
        (low, place - low as f64)
    };
    let ((column, right), (row, down)) = (split(u), split(v));
    let texel = |column: usize, row: usize| -> [f64; 3] {
        sky.texels(0)[(face * MilkyWay::SIZE + row) * MilkyWay::SIZE + column].map(f64::from)
    };
    std::array::from_fn(|i| {
        let along = |row| (1.0 - right) * texel(column, row)[i] + right * texel(column + 1, row)[i];
        (1.0 - down) * along(row) + down * along(row + 1)
    })
}

/// The brightness in V of the stars of a texel, in stars of V = 0 per steradian.
fn brightness_of(radiance: [f64; 3]) -> f64 {
    let [blue, red] = MilkyWay::temperatures().map(|temperature| flux(0.0, temperature));
    radiance[0] / blue + radiance[1] / red
}

/// The brightness in V from a galactic longitude and latitude in degrees, in stars of V = 0 per
/// steradian.
fn brightness(longitude: f64, latitude: f64) -> f64 {
    let galactic = celestial_direction(longitude, latitude);
    let direction = galactic_from_celestial().transpose() * galactic;
    brightness_of(radiance(MilkyWay::model(), direction))
}

/// Mean brightness over a box of longitudes and latitudes in degrees, every degree.
fn mean(longitudes: std::ops::Range<i32>, latitudes: std::ops::Range<i32>) -> f64 {
    let (mut sum, mut all) = (0.0, 0.0);
    for b in latitudes.map(|b| f64::from(b) + 0.5) {
        let weight = b.to_radians().cos();
        for l in longitudes.clone() {
            sum += weight * brightness(f64::from(l) + 0.5, b);
            all += weight;
        }
    }
    sum / all
}

#[test]
fn the_sky_is_as_bright_as_the_milky_way() {
    // Starlight alone is 33 to 40 stars of tenth magnitude per square degree at the poles, 23.8 to
    // 24.0 magnitudes, and 100 to 300 in the plane away from the centre, 21.6 to 22.8 (Leinert et
    // al. 1998, A&AS 127, 1). The brightest fields are 20.7. The model has few free numbers and is
    // fitted to the mean of the whole sky: 0.3 magnitudes.
    let brightest = {
        let level = MilkyWay::SIZE.ilog2() - 5;
        let texels = MilkyWay::model().texels(level as usize);
        let lights = texels.iter().map(|light| light.map(f64::from));
        lights.map(brightness_of).fold(0.0, f64::max)
    };
    let fields = [
        ("north pole", mean(0..360, 75..90), 23.8, 24.0),
        ("south pole", mean(0..360, -90..-75), 23.8, 24.0),
        ("Cygnus", mean(60..120, -5..5), 21.6, 22.8),
        ("Carina", mean(250..310, -5..5), 21.6, 22.8),
        ("Auriga", mean(150..210, -5..5), 21.6, 22.8),
        ("brightest field of 8 square degrees", brightest, 20.7, 20.7),
    ];
    for (place, brightness, ..) in fields {
        println!("{place}: {:.2}", magnitude(brightness));
    }
    for (place, brightness, low, high) in fields {
        let found = magnitude(brightness);
        assert!(found > low - 0.3 && found < high + 0.3, "{place}: {found}");
    }
}

#[test]
fn things_are_at_their_places() {
    // The bulge is on the side of the centre, and the plane is bright all around.
    let bulge = mean(-8..8, -8..-2) / mean(172..188, -8..-2);
    println!("bulge: {bulge:.2}");
    assert!(bulge > 2.0);
    for longitude in (0..360).step_by(20) {
        let plane = mean(longitude..longitude + 20, -8..8);
        assert!(
            plane > 2.0 * mean(longitude..longitude + 20, 50..60),
            "{longitude}"
        );
    }
    // The Great Rift is north of the plane, from Aquila to Ophiuchus.
    assert!(mean(15..35, 1..7) < 0.7 * mean(15..35, -7..-1));
    // The Coalsack beside the Southern Cross, and the Magellanic Clouds, by right ascension and
    // declination: against a ring around each.
    for (name, ra, dec, radius, low, high) in [
        ("Coalsack", 189.0, -62.5, 2.0, 0.3, 0.85),
        ("Large Magellanic Cloud", 80.9, -69.8, 1.5, 3.0, 9.0),
        ("Small Magellanic Cloud", 13.2, -72.8, 0.7, 2.0, 7.0),
        ("Andromeda Galaxy", 10.7, 41.3, 0.3, 2.0, 9.0),
    ] {
        let sky = MilkyWay::model();
        let middle = celestial_direction(ra, dec);
        let around = |angle: f64| -> f64 {
            let side = middle.any_orthonormal_vector();
            let directions = (0..24).map(|i| {
                let turned = side.rotate_axis(middle, f64::from(i) * PI / 12.0);
                middle * angle.to_radians().cos() + turned * angle.to_radians().sin()
            });
            directions
                .map(|to| brightness_of(radiance(sky, to)))
                .sum::<f64>()
                / 24.0
        };
        let ratio = around(0.5 * radius) / around(5.0 * radius.max(1.0));
        println!("{name}: {ratio:.2}");
        assert!((low..high).contains(&ratio), "{name}: {ratio}");
    }
}

#[test]
fn the_centre_is_redder_than_the_rest_of_the_plane() {
    // Stars have B-V from 0.5 to 1.0 in the mean, and dust makes them redder: 0.3 where it takes a
    // magnitude. The bulge's stars are old, and it is behind more dust.
    let b_v = |longitude: f64, latitude: f64| {
        let [v, b] = light_from(celestial_direction(longitude, latitude));
        -2.5 * (b / v).log10()
    };
    let mean = |middle: f64| -> f64 {
        (0..400)
            .map(|i| {
                b_v(
                    middle - 10.0 + f64::from(i % 20),
                    -6.0 + 0.6 * f64::from(i / 20),
                )
            })
            .sum::<f64>()
            / 400.0
    };
    let (bulge, plane, pole) = (mean(0.0), mean(180.0), b_v(0.0, 90.0));
    println!("B-V {bulge:.2} {plane:.2} {pole:.2}");
    assert!((0.8..1.3).contains(&bulge) && (0.5..0.85).contains(&plane));
    assert!(bulge > plane + 0.1 && (0.55..0.75).contains(&pole));
}

#[test]
fn a_photograph_has_a_black_night_and_more_colour() {
    let ends = |sky: &MilkyWay| {
        let mut lights: Vec<f64> = sky
            .texels(2)
            .iter()
            .map(|light| brightness_of(light.map(f64::from)))
            .collect();
        lights.sort_unstable_by(f64::total_cmp);
        [lights[lights.len() / 10], lights[lights.len() * 99 / 100]]
    };
    let [model, photograph] = [MilkyWay::model(), MilkyWay::photograph()].map(ends);
    println!("darkest tenth and brightest hundredth: {model:.1?}, {photograph:.1?}");
    // Photographs lose the sky's background and keep what is bright.
    assert!(photograph[1] / photograph[0] > 5.0 * model[1] / model[0]);
    assert!(photograph[1] > 0.6 * model[1] && photograph[1] < model[1]);
    let blue_over_red = |sky: &MilkyWay, longitude: f64, latitude: f64| {
        let galactic = celestial_direction(longitude, latitude);
        let light = radiance(sky, galactic_from_celestial().transpose() * galactic);
        light[0] / light[1]
    };
    let difference =
        |sky: &MilkyWay| blue_over_red(sky, 180.0, 0.0) / blue_over_red(sky, 0.0, -4.0);
    assert!(difference(MilkyWay::photograph()) > 1.5 * difference(MilkyWay::model()));
}

#[test]
fn nebulae_are_pink_and_change_colour_with_the_shift() {
    let at = |g: f64| nebular::colour(g);
    let home = at(1.0);
    assert!(home.x > home.z && home.z > home.y, "{home}");
    assert_close(
        "luminance",
        home.dot(DVec3::new(0.2126, 0.7152, 0.0722)),
        1.0,
        1e-12,
    );
    // A blueshift makes H-alpha green at 546 nm. Where it has left the visible range, H-beta is yellow
    // at 570 nm. At the table's ends no line is visible.
    let green = at(656.3 / 546.0);
    assert!(
        green.y > 2.0 * green.x && green.y > 2.0 * green.z,
        "{green}"
    );
    let yellow = at(486.1 / 570.0);
    assert!(
        yellow.y > 0.4 * yellow.x && yellow.z < 0.1 * yellow.x,
        "{yellow}"
    );
    let table = nebular::table();
    assert!(table[0].length() < 1e-3 && table[nebular::TABLE_LEN - 1].length() < 1e-2);
}

#[test]
fn all_light_is_that_of_all_stars() {
    let sky = MilkyWay::model();
    for level in 0..MilkyWay::LEVELS {
        let size = MilkyWay::SIZE >> level;
        let total: f64 = sky
            .texels(level)
            .iter()
            .enumerate()
            .map(|(texel, light)| {
                let (_, column, row) = face_column_row(size, texel);
                solid_angle(size, column, row) * brightness_of(light.map(f64::from))
            })
            .sum();
        // The asset has steps of 2 %, whose errors cancel; the model was scaled to half a percent.
        assert_close(format!("level {level}"), total, total_light(), 0.01);
    }
}

#[test]
fn the_light_of_a_random_list_and_of_the_rest_is_that_of_all_stars() {
    let seed = Random::new().integer(0, 1 << 30);
    for faintest in [4.0, 6.0, 7.5, 9.0, 11.0] {
        let list = StarList::new(Catalogue::built_in(), seed, faintest);
        let drawn: f64 = list
            .stars()
            .iter()
            .map(|star| 10_f64.powf(-0.4 * f64::from(star.magnitude)))
            .sum();
        let rest = fainter_share(faintest) * total_light();
        // The catalogue lacks a part of what the counts have from V = 6 on: half a percent.
        assert_close(format!("V {faintest}"), drawn + rest, total_light(), 0.01);
    }
}

#[test]
fn random_texels_of_the_asset_are_what_the_program_computes() {
    let mut random = Random::new();
    let sky = MilkyWay::model();
    for _ in 0..40 {
        let number = random.integer(0, (FACES * MilkyWay::SIZE * MilkyWay::SIZE) as u32 - 1);
        let [brightness, share, nebular] = lightfall_galaxy::texel(number as usize).map(f64::from);
        let texel = sky.texels(0)[number as usize].map(f64::from);
        // The steps of the two bytes, and one more for other mathematical libraries.
        let found = (brightness_of(texel) / 6.0).ln() / 0.02;
        assert!(
            (found - brightness).abs() < 1.01,
            "texel {number}: {found}, {brightness}"
        );
        let blue = brightness_of([texel[0], 0.0, 0.0]) / brightness_of(texel);
        assert!(
            (255.0 * blue - share).abs() < 1.01,
            "texel {number}: {blue}, {share}"
        );
        let found = 1.0 + (texel[2] / ZERO_MAGNITUDE_FLUX).ln() / 0.03;
        assert!(
            (found.max(0.0) - nebular).abs() < 1.01,
            "texel {number}: {found}, {nebular}"
        );
    }
}

#[test]
fn twenty_two_magnitudes_are_the_light_of_sixty_seven_stars_per_steradian() {
    assert_close("22 mag", magnitude(67.4), 22.0, 1e-4);
    // A texel's luminance is its brightness times the flux of a star of V = 0.
    let colours = lightfall_core::optics::spectrum::table();
    let light = radiance(MilkyWay::model(), DVec3::Z);
    let luminance: f64 = light
        .iter()
        .zip(MilkyWay::temperatures())
        .map(|(light, temperature)| {
            let [r, g, b] = lightfall_core::optics::spectrum::sample(&colours, temperature);
            light * (0.2126 * r + 0.7152 * g + 0.0722 * b)
        })
        .sum();
    let expected = ZERO_MAGNITUDE_FLUX * brightness_of(light);
    // Rec. 709's weights have four digits.
    assert_close("luminance", luminance, expected, 3e-4);
}

#[test]
fn half_floats_are_the_texels_face_by_face_and_level_by_level() {
    let sky = MilkyWay::photograph();
    let halves = sky.half_floats();
    assert_eq!(
        halves.len(),
        FACES * ((4 * MilkyWay::SIZE * MilkyWay::SIZE - 1) / 3)
    );
    let mut at = 0;
    for face in 0..FACES {
        for level in 0..MilkyWay::LEVELS {
            let size = MilkyWay::SIZE >> level;
            for texel in &sky.texels(level)[face * size * size..(face + 1) * size * size] {
                for (half, light) in halves[at].iter().zip(texel) {
                    let half = f16::from_bits(*half).to_f32();
                    // Half a unit in the last place, of normal and of subnormal numbers.
                    let allowed = light * 4.9e-4 + 3e-8;
                    assert!((half - light).abs() <= allowed, "{half}, {light}");
                }
                at += 1;
            }
        }
    }
}

/// Selection of faces and coordinates as graphics interfaces define it (Vulkan 1.3 specification,
/// table "Cube map face selection"): the largest component, and for each of its signs the components
/// that run along the face.
fn specified(direction: DVec3) -> (usize, f64, f64) {
    let DVec3 { x, y, z } = direction;
    let faces = [
        (x, -z, -y),
        (-x, z, -y),
        (y, x, z),
        (-y, x, -z),
        (z, x, -y),
        (-z, -x, -y),
    ];
    let largest = |face: &usize| faces[*face].0;
    let face = (0..6)
        .max_by(|a, b| largest(a).total_cmp(&largest(b)))
        .unwrap();
    let (along, s, t) = faces[face];
    (face, 0.5 * (s / along + 1.0), 0.5 * (t / along + 1.0))
}

#[test]
fn faces_and_texels_of_random_directions_are_those_of_graphics_interfaces() {
    let mut random = Random::new();
    for _ in 0..10_000 {
        let direction = random.direction();
        let (face, u, v) = face_and_place(direction);
        assert_eq!((face, u, v), specified(direction));
        assert!((place(face, u, v).normalize() - direction).length() < 1e-15);
        let (of_texel, column, row) = face_column_row(64, texel(64, direction));
        assert_eq!(of_texel, face);
        assert!((u * 64.0 - column as f64 - 0.5).abs() <= 0.5);
        assert!((v * 64.0 - row as f64 - 0.5).abs() <= 0.5);
    }
}

#[test]
fn the_texels_of_a_cube_cover_the_sphere() {
    for size in [1, 2, 64, 256] {
        let sum: f64 = (0..size * size)
            .map(|texel| solid_angle(size, texel % size, texel / size))
            .sum();
        // Rounding of a sum of many differences.
        assert_close(format!("size {size}"), 6.0 * sum, 4.0 * PI, 1e-11);
    }
    // A small texel is its area times (1 + s^2 + t^2)^(-3/2).
    let (s, t): (f64, f64) = (2.0 * 200.5 / 256.0 - 1.0, 2.0 * 30.5 / 256.0 - 1.0);
    let area = (2.0_f64 / 256.0).powi(2);
    let expected = area * (1.0 + s * s + t * t).powf(-1.5);
    assert_close("texel", solid_angle(256, 200, 30), expected, 1e-4);
}
