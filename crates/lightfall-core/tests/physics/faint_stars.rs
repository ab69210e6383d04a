//! The stars that are added to a catalogue: their number, places, colours and order, against the
//! counts and the statistics of chance.

use crate::random::Random;
use crate::sky_texel::texel;
use lightfall_core::optics::cube_map;
use lightfall_core::optics::stars::{
    Catalogue, FIRST_MAGNITUDE, MAX_MAGNITUDE, Star, StarList, galactic_from_celestial,
    number_brighter,
};

fn list(seed: u32, faintest: f64) -> StarList {
    StarList::new(Catalogue::built_in(), seed, faintest)
}

fn seed() -> u32 {
    Random::new().integer(0, u32::MAX - 1)
}

#[test]
fn a_random_list_has_as_many_stars_as_the_sky() {
    let seed = seed();
    for faintest in [7.0, 8.5, 10.0, MAX_MAGNITUDE] {
        let count = list(seed, faintest).stars().len() as f64;
        let expected = number_brighter(faintest);
        // Five standard errors, and the catalogue's own deviation at the first magnitude.
        let own =
            number_brighter(FIRST_MAGNITUDE) - Catalogue::built_in().count(FIRST_MAGNITUDE) as f64;
        let allowed = 5.0 * expected.sqrt() + own.abs();
        assert!(
            (count - expected).abs() < allowed,
            "{count} to V = {faintest}"
        );
    }
    let bright = list(seed, 5.5);
    assert_eq!(bright.stars().len(), Catalogue::built_in().count(5.5));
}

#[test]
fn a_deeper_random_list_begins_with_the_stars_of_a_shallower_one() {
    let seed = seed();
    let deep = list(seed, 9.0);
    for faintest in [-5.0, 3.0, 6.0, 6.05, 7.33, 8.0] {
        let shallow = list(seed, faintest);
        let (shallow, deep) = (shallow.stars(), deep.stars());
        assert_eq!(shallow, &deep[..shallow.len()], "V {faintest}");
        let next = deep[shallow.len()].magnitude;
        assert!(next > faintest as f32, "V {faintest}: {next} is missing");
    }
    assert!(deep.stars().is_sorted_by_key(|star| star.magnitude));
    assert_eq!(deep, list(seed, 9.0));
    assert_ne!(deep, list(seed.wrapping_add(1), 9.0));
}

#[test]
fn a_list_stops_at_the_limit_whatever_is_asked() {
    let deepest = list(1, 1e9);
    assert_eq!(deepest.faintest(), MAX_MAGNITUDE);
    assert_eq!(deepest.stars().len(), list(1, MAX_MAGNITUDE).stars().len());
    assert!(list(1, -100.0).stars().is_empty());
    assert_eq!(list(1, f64::NAN).faintest(), MAX_MAGNITUDE);
}

#[test]
fn a_catalogue_that_goes_deeper_is_not_doubled() {
    // As many stars as the sky has, evenly spread in log N between V = 6 and 8, and none brighter.
    let text: String = (0..40_000)
        .map(|i| {
            let magnitude = 6.001 + 2.0 * (1.0 + f64::from(i) / 40_000.0).log2().powf(0.7);
            format!("{},{},{magnitude}\n", i % 360, i % 90)
        })
        .collect();
    let catalogue = Catalogue::from_csv("test", &text).unwrap();
    let list = StarList::new(&catalogue, 1, 9.0);
    let own = catalogue.stars().len() as f64;
    let all = number_brighter(9.0) - number_brighter(6.0);
    let count = list.stars().len() as f64;
    // It has at most what it lacks in one class and has too much in an earlier one.
    assert!(
        (count - all).abs() < 0.05 * all + 5.0 * all.sqrt(),
        "{count} of {all}, {own} own"
    );
}

/// The number of stars in each of the cells that they are drawn in, of those in a range of V.
fn counts(stars: &[Star], from: f32, to: f32, size: usize) -> Vec<f64> {
    let mut counts = vec![0.0; 6 * size * size];
    for star in stars
        .iter()
        .filter(|star| (from..to).contains(&star.magnitude))
    {
        counts[texel(size, star.direction.as_dvec3())] += 1.0;
    }
    counts
}

#[test]
fn the_numbers_of_random_stars_in_cells_are_poissons() {
    // Two lists of other seeds have the same mean in each cell: for Poisson numbers a and b,
    // (a - b)^2 / (a + b) has mean 1 where a + b > 0.
    let seed = seed();
    let [a, b] =
        [seed, seed.wrapping_add(7)].map(|seed| counts(list(seed, 9.0).stars(), 7.0, 9.0, 64));
    let ratios: Vec<f64> = a
        .iter()
        .zip(&b)
        .filter(|(a, b)| *a + *b > 0.0)
        .map(|(a, b)| (a - b).powi(2) / (a + b))
        .collect();
    let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
    // Its variance is at most 2, so five standard errors of some 23 000 cells are 0.047.
    assert!(ratios.len() > 20_000);
    assert!((mean - 1.0).abs() < 0.047, "{mean} of {}", ratios.len());
}

#[test]
fn random_stars_lie_evenly_within_their_cells() {
    // Halves of cells along either side; even number of sub-cells.
    let fine = counts(list(seed(), 9.0).stars(), 6.5, 9.0, 128);
    let mut halves = [0.0; 4];
    for (texel, count) in fine.iter().enumerate() {
        let (_, column, row) = cube_map::face_column_row(128, texel);
        halves[column % 2 + 2 * (row % 2)] += count;
    }
    let total: f64 = halves.iter().sum();
    for half in halves {
        // Five standard errors.
        assert!(
            (half - 0.25 * total).abs() < 5.0 * (0.1875 * total).sqrt(),
            "{halves:?}"
        );
    }
}

#[test]
fn random_faint_stars_are_dense_where_bright_ones_are() {
    // Density over galactic latitude as a multiple of the mean, counted in the Bright Star
    // Catalogue for V < 6.
    let bands = [0.0_f64, 10.0, 20.0, 30.0, 45.0, 60.0, 90.0];
    let counted = [1.52, 1.21, 1.00, 0.78, 0.73, 0.72];
    let list = list(seed(), 8.0);
    let turn = galactic_from_celestial();
    let latitudes: Vec<f64> = list
        .stars()
        .iter()
        .filter(|star| star.magnitude > 6.0 && star.magnitude < 7.0)
        .map(|star| {
            (turn * star.direction.as_dvec3())
                .z
                .asin()
                .abs()
                .to_degrees()
        })
        .collect();
    for (band, expected) in bands.windows(2).zip(counted) {
        let share = band[1].to_radians().sin() - band[0].to_radians().sin();
        let inside = latitudes
            .iter()
            .filter(|b| (band[0]..band[1]).contains(*b))
            .count() as f64;
        let density = inside / latitudes.len() as f64 / share;
        println!("{band:?}: {density}, catalogue {expected}");
        // The catalogue's own standard errors are 0.03 to 0.06, and the model is fitted by one
        // power: 0.15.
        assert!(
            (density - expected).abs() < 0.15,
            "{band:?}: {density}, not {expected}"
        );
    }
}

#[test]
fn random_faint_stars_have_the_colours_of_the_catalogues_faint_stars() {
    let mean = |stars: &mut dyn Iterator<Item = &Star>| {
        let (sum, count) = stars.fold((0.0, 0.0), |(sum, count), star| {
            (sum + f64::from(star.temperature).ln(), count + 1.0)
        });
        sum / count
    };
    let list = list(seed(), 9.0);
    let added = mean(&mut list.stars().iter().filter(|star| star.magnitude > 8.0));
    let own = mean(
        &mut Catalogue::built_in()
            .stars()
            .iter()
            .filter(|star| star.magnitude > 5.0),
    );
    // The standard deviation of ln T is 0.35, and there are 80 000.
    assert!((added - own).abs() < 0.007, "{added}, {own}");
}
