//! The built-in catalogue, the light of its stars and the frames, against the catalogue's own
//! numbers, published ones and identities.

use crate::assert_close;
use crate::random::Random;
use crate::starlight::{fainter_share, total_light};
use glam::{DMat3, DVec3};
use lightfall_core::optics::spectrum;
use lightfall_core::optics::stars::{
    Catalogue, FAINTER_SHARE, SOLAR_B_V, Star, ZERO_MAGNITUDE_FLUX, angular_radius,
    celestial_direction, flux, galactic_from_celestial, hole_from_celestial, number_brighter,
    temperature_from_b_v,
};

fn named(name: &str) -> Star {
    let names = Catalogue::built_in().names();
    names.iter().find(|star| star.name == name).unwrap().star
}

#[test]
fn the_built_in_catalogue_has_the_stars_of_the_bright_star_catalogue() {
    let catalogue = Catalogue::built_in();
    assert_eq!(catalogue.stars().len(), 9096);
    // Counted in the catalogue; less one from V = 2 on, because the nova T CrB has V = 10 here.
    let counts = [
        (0.99, 15),
        (1.99, 48),
        (2.99, 169),
        (3.99, 512),
        (4.99, 1603),
        (5.99, 5022),
        (6.49, 8354),
    ];
    for (magnitude, count) in counts {
        assert_eq!(catalogue.count(magnitude), count, "V <= {magnitude}");
    }
    let magnitudes: Vec<f32> = catalogue
        .stars()
        .iter()
        .map(|star| star.magnitude)
        .collect();
    assert!(magnitudes.is_sorted());
    for star in catalogue.stars() {
        // Half a unit in the last place of three components.
        assert!((star.direction.length() - 1.0).abs() < 1e-7);
    }
    let names: Vec<&str> = catalogue.names().iter().map(|star| &*star.name).collect();
    assert_eq!(names.len(), 55);
    assert_eq!(
        names[..5],
        ["Sirius", "Canopus", "Arcturus", "Rigil Kentaurus", "Vega"]
    );
}

/// Galactic longitude and latitude that the Bright Star Catalogue itself lists, in degrees.
const GALACTIC: [(&str, f64, f64); 11] = [
    ("Sirius", 227.22, -8.88),
    ("Canopus", 261.21, -25.29),
    ("Arcturus", 15.14, 69.11),
    ("Vega", 67.44, 19.24),
    ("Achernar", 290.84, -58.79),
    ("Antares", 351.95, 15.06),
    ("Acrux", 300.13, -0.36),
    ("Fomalhaut", 20.49, -64.90),
    ("Aldebaran", 180.97, -20.25),
    ("Deneb", 84.28, 2.00),
    ("Polaris", 123.28, 26.46),
];

#[test]
fn galactic_places_of_stars_are_those_that_the_catalogue_lists() {
    for (name, l, b) in GALACTIC {
        let listed = celestial_direction(l, b);
        let found = galactic_from_celestial() * named(name).direction.as_dvec3();
        let off = found.angle_between(listed).to_degrees();
        // They are rounded to 0.01 and, it seems, for the epoch 1950: in half a century Arcturus has
        // moved by 0.032 degrees, and no other of these stars as far.
        assert!(off < 0.04, "{name} is {off} degrees off");
    }
    // The origin of the galactic frame of Hipparcos, 17h 45m 37.1991s, -28d 56' 10.2207" (Liu, Zhu &
    // Zhang 2011, A&A 526, A16). The pole's angles have five decimals.
    let centre = galactic_from_celestial() * celestial_direction(266.404_996, -28.936_172);
    let off = centre.angle_between(DVec3::X).to_degrees();
    assert!(off < 2e-5, "{off} degrees");
}

#[test]
fn the_place_behind_the_hole_is_at_minus_x_and_north_is_up_for_random_orientations() {
    let mut random = Random::new();
    for _ in 0..1000 {
        let (ra, dec) = (random.between(0.0, 360.0), random.between(-90.0, 90.0));
        let roll = random.between(-180.0, 180.0);
        let turn = hole_from_celestial(ra, dec, roll);
        // Rounding of a product of three rotations.
        let excess = turn * turn.transpose() - DMat3::IDENTITY;
        assert!(excess.to_cols_array().iter().all(|x| x.abs() < 1e-14));
        assert!((turn.determinant() - 1.0).abs() < 1e-14);
        let behind = turn * celestial_direction(ra, dec);
        assert!((behind - DVec3::NEG_X).length() < 1e-14);
        // The celestial pole seen from the camera at +x, which looks to -x with +z up and +y to the
        // right: a positive roll has turned it counterclockwise, from the top to the left.
        let pole = turn * DVec3::Z;
        let angle = (-pole.y).atan2(pole.z).to_degrees();
        let off = (angle - roll + 540.0).rem_euclid(360.0) - 180.0;
        // Close to a pole the angle is that of a short vector.
        assert!(
            off.abs() * dec.to_radians().cos() < 1e-11,
            "{angle} for {roll}"
        );
    }
    // East of the place is to the left, as the sky is seen from inside.
    let east = hole_from_celestial(80.0, 20.0, 0.0) * celestial_direction(81.0, 20.0);
    assert!(east.y < 0.0);
}

#[test]
fn colours_give_the_temperatures_of_ballesteros() {
    // From his formula, worked out by hand to the kelvin.
    for (b_v, kelvin) in [
        (-0.3, 16_602.0),
        (0.0, 10_125.0),
        (0.3, 7462.0),
        (SOLAR_B_V, 5778.0),
        (1.0, 4743.0),
        (1.5, 3794.0),
        (2.0, 3169.0),
    ] {
        let found = temperature_from_b_v(b_v);
        assert!((found - kelvin).abs() < 1.0, "B-V {b_v}: {found}");
    }
    assert_eq!(temperature_from_b_v(5.74), temperature_from_b_v(2.5));
    assert_eq!(temperature_from_b_v(-9.0), temperature_from_b_v(-0.4));
}

#[test]
fn a_star_of_a_magnitude_has_its_luminance_whatever_its_random_colour() {
    let mut random = Random::new();
    for _ in 0..1000 {
        let magnitude = random.between(-2.0, 12.0);
        let temperature = random.log_between(2700.0, 20_000.0);
        let [r, g, b] = spectrum::colour(temperature);
        // Luminance of linear sRGB, ITU-R BT.709-6.
        let luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
        let found = luminance * flux(magnitude, temperature);
        let expected = ZERO_MAGNITUDE_FLUX * 10_f64.powf(-0.4 * magnitude);
        // The shader's table is interpolated, and the weights have four digits.
        assert_close(
            format!("V {magnitude}, {temperature} K"),
            found,
            expected,
            3e-4,
        );
    }
}

#[test]
fn angular_radii_are_those_that_interferometers_measure() {
    // Angular diameters in milliarcseconds, limb-darkened: Kervella et al. 2003 (A&A 404, 1087, and
    // 408, 681), 2004 (A&A 413, 251); Lacour et al. 2008 (A&A 485, 561).
    for (name, diameter) in [
        ("Sirius", 6.039),
        ("Rigil Kentaurus", 8.511),
        ("Procyon", 5.448),
        ("Arcturus", 21.05),
    ] {
        let measured = (0.5e-3 * diameter / 3600.0_f64).to_radians();
        // A colour gives a temperature to about 5 %, and the radius goes with its square.
        assert_close(name, named(name).angular_radius(), measured, 0.12);
    }
    // The Sun's limb at 959.63 seconds of arc; the IAU's nominal radius is 0.04 % less.
    let sun = angular_radius(-26.74, 5772.0);
    assert_close("the Sun", sun, (959.63_f64 / 3600.0).to_radians(), 5e-4);
}

#[test]
fn the_counts_agree_with_catalogues() {
    let bright = Catalogue::built_in();
    for magnitude in [4.5, 5.0, 5.5, 6.0] {
        // Four standard errors of a Poisson number; the fit's own error is smaller.
        let count = bright.count(magnitude) as f64;
        let expected = number_brighter(magnitude);
        assert!(
            (count - expected).abs() < 4.0 * expected.sqrt(),
            "{magnitude}: {count}"
        );
    }
    // Tycho, complete to 10 (ESA 1997), and Tycho-2 with UCAC4, which have 14 % more at 10: the
    // fit lies between or within a tenth.
    for (magnitude, count) in [(7.5, 26_533.0), (8.5, 77_627.0), (9.5, 217_689.0)] {
        assert_close(
            format!("V {magnitude}"),
            number_brighter(magnitude),
            count,
            0.08,
        );
    }
}

#[test]
fn the_light_of_all_stars_is_what_is_known_of_it() {
    // About 100 stars of tenth magnitude per square degree (Leinert et al. 1998, A&AS 127, 1).
    let square_degrees = 4.0 * std::f64::consts::PI * 1_f64.to_degrees().powi(2);
    assert_close("S10", total_light() * 1e4 / square_degrees, 100.0, 0.05);
    // Another integral of the same counts, in steps of a hundredth.
    let light = |from: f64, to: f64| -> f64 {
        let steps = ((to - from) * 100.0).round() as usize;
        (0..steps)
            .map(|step| {
                let low = from + 0.01 * step as f64;
                let number = number_brighter(low + 0.01) - number_brighter(low);
                number * 10_f64.powf(-0.4 * (low + 0.005))
            })
            .sum()
    };
    for magnitude in [6.0, 7.0, 8.5, 10.0, 11.0, 14.0] {
        let expected = light(magnitude, 25.0) / total_light();
        // Midpoints of steps of a tenth: (0.1 x 0.5 ln 10)^2 / 24.
        assert_close(magnitude, fainter_share(magnitude), expected, 1e-3);
    }
    assert_eq!((fainter_share(-50.0), fainter_share(50.0)), (1.0, 0.0));
}

#[test]
fn the_shaders_share_of_fainter_stars_is_within_a_hundredth() {
    for step in -100..400 {
        let magnitude = 0.1 * f64::from(step);
        let x = magnitude - 11.0;
        let [a, b, c, d] = FAINTER_SHARE;
        let fitted = 1.0 / (1.0 + (a + x * (b + x * (c + x * d))).exp());
        let off = fitted - fainter_share(magnitude);
        assert!(off.abs() < 0.01, "V {magnitude}: off by {off}");
    }
}
