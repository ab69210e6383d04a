//! Where the nose points: where the hand left it, or along a heading.

use glam::{DMat3, DQuat, DVec3};
use lightfall_core::geometry::ship::Ship;
use lightfall_core::optics::ship::{Heading, star_ahead};
use lightfall_core::scene::mission::Start;

/// Number of headings of the key. After the last one the gyroscopes hold the nose.
const HEADINGS: usize = 5;
/// Which of them is the star's.
const STAR: usize = HEADINGS - 1;

/// Least speed of a turn to a heading, in radians per second.
const LEAST_TURN: f64 = 1.5;
/// A turn to a heading takes away what is left of it in this many seconds, but for one part in e.
const TURN_SECONDS: f64 = 0.15;
/// A nose this near to its heading follows it, in radians.
const ALIGNED: f64 = 1e-3;

/// What the nose follows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nose {
    /// The last heading, by its number.
    last: usize,
    /// The star of the last one of them, if one was chosen.
    star: Option<DVec3>,
    state: State,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    /// The gyroscopes hold it.
    Free,
    /// The ship turns to the last heading.
    Turns,
    /// The autopilot keeps it on the last heading.
    Follows,
}

impl Nose {
    /// A nose that the gyroscopes hold, and that is to turn to the hole first.
    pub const FREE: Self = Self {
        last: 0,
        star: None,
        state: State::Free,
    };

    /// A nose that the autopilot keeps where it points at the start of a mission.
    #[must_use]
    pub fn following(start: &Start) -> Self {
        let heading = Heading::at_start(start);
        let star = match heading {
            Heading::Star(star) => Some(star),
            _ => None,
        };
        let all = |number: usize| heading_of(number, star);
        Self {
            last: (0..HEADINGS)
                .find(|number| all(*number) == Some(heading))
                .unwrap_or(0),
            star,
            state: State::Follows,
        }
    }

    /// The same nose, held by the gyroscopes.
    #[must_use]
    pub fn released(self) -> Self {
        Self {
            state: State::Free,
            ..self
        }
    }

    /// Begins to turn to the last heading or, if the nose follows it, to the next one. The star is the one
    /// that the nose points to now; without one it is the last one. `None` if the gyroscopes hold the nose
    /// from now on.
    pub fn step(&mut self, ship: &Ship) -> Option<Heading> {
        if self.state != State::Free {
            self.last = (self.last + 1) % HEADINGS;
            if self.last == 0 {
                self.state = State::Free;
                return None;
            }
        }
        self.turn_to_last(ship)
    }

    /// As [`step`](Self::step), to the heading before: the way back through the same row.
    pub fn step_back(&mut self, ship: &Ship) -> Option<Heading> {
        if self.state != State::Free && self.last == 0 {
            self.state = State::Free;
            return None;
        }
        self.last = (self.last + HEADINGS - 1) % HEADINGS;
        self.turn_to_last(ship).or_else(|| {
            // There is no star ahead.
            self.last = STAR - 1;
            self.turn_to_last(ship)
        })
    }

    fn turn_to_last(&mut self, ship: &Ship) -> Option<Heading> {
        if self.last == STAR {
            self.star = star_ahead(ship).or(self.star);
        }
        let heading = self.last_heading();
        if heading.is_some() {
            self.state = State::Turns;
        } else {
            *self = Self::FREE;
        }
        heading
    }

    fn last_heading(&self) -> Option<Heading> {
        heading_of(self.last, self.star)
    }

    /// Leaves the nose to the gyroscopes.
    pub fn release(&mut self) {
        self.state = State::Free;
    }

    /// The heading that the nose turns to or follows.
    #[must_use]
    pub fn heading(&self) -> Option<Heading> {
        self.last_heading().filter(|_| self.state != State::Free)
    }

    /// The heading on which the autopilot keeps the nose.
    #[must_use]
    pub fn followed(&self) -> Option<Heading> {
        self.last_heading().filter(|_| self.state == State::Follows)
    }

    /// The turn to the heading for so many seconds, about an axis on the ship's axes, by its length in
    /// radians. With `at_once` it is the whole turn.
    pub fn turn(&mut self, ship: &Ship, seconds: f64, at_once: bool) -> DVec3 {
        if self.state != State::Turns {
            return DVec3::ZERO;
        }
        let heading = self.last_heading();
        let Some(direction) = heading.and_then(|heading| heading.direction(ship)) else {
            self.state = State::Follows;
            return DVec3::ZERO;
        };
        let whole = DQuat::from_mat3(&level(ship, direction)).to_scaled_axis();
        let angle = whole.length();
        let eased = angle * (1.0 - (-seconds / TURN_SECONDS).exp());
        let step = match at_once {
            true => angle,
            false => angle.min(eased.max(LEAST_TURN * seconds)),
        };
        if angle - step < ALIGNED {
            self.state = State::Follows;
        }
        whole.normalize_or_zero() * step
    }
}

/// The heading of a number. `None` for the star's if there is none.
fn heading_of(number: usize, star: Option<DVec3>) -> Option<Heading> {
    match number {
        0 => Some(Heading::Hole),
        1 => Some(Heading::Prograde),
        2 => Some(Heading::Retrograde),
        3 => Some(Heading::Outward),
        _ => star.map(Heading::Star),
    }
}

/// The ship's axes with the nose along `direction` and up as near to decreasing theta as that allows,
/// as columns on the present axes.
pub(super) fn level(ship: &Ship, direction: DVec3) -> DMat3 {
    let north = Heading::Observer(DVec3::NEG_Y).direction(ship);
    let up = [north, Some(DVec3::Z)]
        .into_iter()
        .flatten()
        .find_map(|up| up.reject_from_normalized(direction).try_normalize());
    let up = up.unwrap_or_else(|| direction.any_orthonormal_vector());
    DMat3::from_cols(direction, up.cross(direction), up)
}
