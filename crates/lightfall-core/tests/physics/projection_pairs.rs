//! Pairs of pixels and directions that an independent program computed.

use glam::{DVec2, DVec3};
use lightfall_core::scene::Projection;

/// A pixel of a picture and the direction that is seen there: projection,width,height,angle_deg,
/// pixel_x,pixel_y,right,up,forward,inside.
pub struct Pair {
    pub projection: Projection,
    pub size: DVec2,
    pub angle_deg: f64,
    pub place: DVec2,
    pub looking: DVec3,
    pub is_inside: bool,
}

/// All pairs of the file.
pub fn pairs() -> Vec<Pair> {
    let text = include_str!("../projections.csv");
    let rows = text.lines().skip(1).map(|line| {
        let (word, numbers) = line.split_once(',').unwrap();
        let numbers: Vec<f64> = numbers
            .split(',')
            .map(|number| number.parse().unwrap_or(f64::NAN))
            .collect();
        Pair {
            projection: Projection::from_word(word).unwrap(),
            size: DVec2::new(numbers[0], numbers[1]),
            angle_deg: numbers[2],
            place: DVec2::new(numbers[3], numbers[4]),
            looking: DVec3::new(numbers[5], numbers[6], numbers[7]),
            is_inside: numbers[8] == 1.0,
        }
    });
    rows.collect()
}
