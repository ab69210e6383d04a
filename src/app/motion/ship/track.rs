//! The path that a ship has flown, as points.

use glam::DVec3;
use lightfall_core::geometry::ship::Ship;

/// Largest number of points. Where they are full, every second one goes.
const MAX_POINTS: usize = 1024;
/// Distance of two points at first, as a share of the radius.
const SPACING: f64 = 0.05;

/// Points of the path so far, in r_s, with the ship's own time at each.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    points: Vec<(f64, DVec3)>,
    /// The least distance of two points, as a share of the radius.
    spacing: f64,
}

impl Track {
    /// A path that begins where the ship is.
    #[must_use]
    pub fn new(ship: &Ship) -> Self {
        let mut track = Self {
            points: Vec::new(),
            spacing: SPACING,
        };
        track.note(ship);
        track
    }

    /// Adds the ship's place, unless it is near the last one.
    pub fn note(&mut self, ship: &Ship) {
        let place = ship.place();
        let at = place.r * place.n;
        let is_near = |(_, last): &(f64, DVec3)| (*last - at).length() < self.spacing * place.r;
        if self.points.last().is_some_and(is_near) {
            return;
        }
        if self.points.len() == MAX_POINTS {
            self.thin();
        }
        self.points.push((ship.proper_time(), at));
    }

    /// Leaves every second point out.
    fn thin(&mut self) {
        let mut index = 0;
        self.points.retain(|_| {
            index += 1;
            index % 2 == 1
        });
        self.spacing *= 2.0;
    }

    /// Forgets what came after an own time.
    pub fn cut(&mut self, proper_time: f64) {
        self.points.retain(|(time, _)| *time <= proper_time);
    }

    /// The places, in r_s.
    pub fn places(&self) -> impl Iterator<Item = DVec3> {
        self.points.iter().map(|(_, place)| *place)
    }
}
