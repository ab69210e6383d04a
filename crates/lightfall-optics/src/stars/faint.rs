//! Stars fainter than the catalogue's: as many as there are on the whole sky, at places that a seed
//! decides.

use super::catalogue::Catalogue;
use super::counts::number_brighter;
use super::photometry::Star;
use crate::cube_map;
use crate::milky_way::MilkyWay;
use lightfall_model::random::Random;
use rayon::prelude::*;

/// Stars are added beyond this V, to which catalogues of bright stars are complete.
pub const FIRST_MAGNITUDE: f64 = 6.0;

/// Stars are drawn in classes of a tenth of a magnitude. Each class has a sequence of random
/// numbers of its own, so that a deeper list has the same bright stars.
const CLASSES_PER_MAGNITUDE: f64 = 10.0;

/// The stars' density over the sky is that of the diffuse light to this power at the first
/// magnitude. It makes the latitudes of the catalogue's stars.
const FIRST_CONCENTRATION: f64 = 0.4;

/// Faint stars are farther away on the average and so closer to the plane. This is a guess of how
/// much the power grows with each magnitude, up to 1.
const CONCENTRATION_PER_MAGNITUDE: f64 = 0.05;

/// The colours are those of the catalogue's stars fainter than this V.
const COLOURS_FROM: f64 = 5.0;

/// The stars beyond [`FIRST_MAGNITUDE`] and down to `faintest` V that `catalogue` lacks, brightest
/// first.
pub(super) fn fainter_stars(catalogue: &Catalogue, seed: u32, faintest: f64) -> Vec<Star> {
    let missing = missing(catalogue, faintest);
    let sky = MilkyWay::model();
    let bright = Catalogue::built_in();
    let colours: Vec<f32> = bright.stars()[bright.count(COLOURS_FROM)..]
        .iter()
        .map(|star| star.temperature)
        .collect();
    let classes: Vec<Vec<Star>> = missing
        .into_par_iter()
        .enumerate()
        .map(|(number, expected)| {
            let random = Random::of_purpose(u64::from(seed) << 32 | number as u64);
            Class::new(number, expected).draw(random, sky, &colours)
        })
        .collect();
    let mut stars = classes.concat();
    stars.truncate(stars.partition_point(|star| star.magnitude <= faintest as f32));
    stars
}

/// The numbers of stars to add in each class: the growth of [`number_brighter`] less that of the
/// catalogue. A surplus in one class, which is chance, is subtracted from the next ones.
fn missing(catalogue: &Catalogue, faintest: f64) -> Vec<f64> {
    let lack = |magnitude: f64| number_brighter(magnitude) - catalogue.count(magnitude) as f64;
    let classes = ((faintest - FIRST_MAGNITUDE) * CLASSES_PER_MAGNITUDE).ceil();
    let mut most = lack(FIRST_MAGNITUDE);
    (0..classes.max(0.0) as usize)
        .map(|number| {
            let before = most;
            most = most.max(lack(class_start(number + 1)));
            most - before
        })
        .collect()
}

fn class_start(number: usize) -> f64 {
    FIRST_MAGNITUDE + number as f64 / CLASSES_PER_MAGNITUDE
}

/// The stars of a tenth of a magnitude.
struct Class {
    start: f64,
    /// The stars' mean number.
    expected: f64,
    /// The number of all stars brighter than the class's end over that at its start.
    growth: f64,
}

impl Class {
    fn new(number: usize, expected: f64) -> Self {
        let start = class_start(number);
        Self {
            start,
            expected,
            growth: number_brighter(class_start(number + 1)) / number_brighter(start),
        }
    }

    /// Draws the stars. The cells of the sky lie one after the other on a line, each as long as its
    /// share of the stars, and the gaps from star to star are exponential: so the number in each
    /// cell is Poisson's.
    fn draw(&self, mut random: Random, sky: &MilkyWay, colours: &[f32]) -> Vec<Star> {
        let power =
            FIRST_CONCENTRATION + CONCENTRATION_PER_MAGNITUDE * (self.start - FIRST_MAGNITUDE);
        let weights = sky.cell_light_to_power(power.min(1.0));
        let per_star = weights.iter().sum::<f64>() / self.expected;
        let mut stars = Vec::with_capacity((1.1 * self.expected) as usize);
        let gap = |random: &mut Random| -(1.0 - random.unit()).ln() * per_star;
        // The distance of the next star from the start of the cell.
        let mut ahead = gap(&mut random);
        for (cell, weight) in weights.into_iter().enumerate() {
            while ahead < weight {
                stars.push(self.star(cell, &mut random, colours));
                ahead += gap(&mut random);
            }
            ahead -= weight;
        }
        stars.sort_by(|a, b| a.magnitude.total_cmp(&b.magnitude));
        stars
    }

    /// A star in a cell: anywhere with equal chance, of a magnitude after the growth of their
    /// number, and of the colour of any.
    fn star(&self, cell: usize, random: &mut Random, colours: &[f32]) -> Star {
        let rise = (1.0 + random.unit() * (self.growth - 1.0)).ln() / self.growth.ln();
        let colour = (random.unit() * colours.len() as f64) as usize;
        let size = MilkyWay::CELLS;
        let (face, column, row) = cube_map::face_column_row(size, cell);
        let direction = loop {
            let place = cube_map::place(
                face,
                (column as f64 + random.unit()) / size as f64,
                (row as f64 + random.unit()) / size as f64,
            );
            // Toward the corners of a face, equal areas have less solid angle.
            let length = place.length();
            if random.unit() * length.powi(3) <= 1.0 {
                break place / length;
            }
        };
        let magnitude = (self.start + rise / CLASSES_PER_MAGNITUDE) as f32;
        Star {
            direction: direction.as_vec3(),
            // The start itself belongs to the class before.
            magnitude: magnitude.max((self.start as f32).next_up()),
            temperature: colours[colour],
        }
    }
}
