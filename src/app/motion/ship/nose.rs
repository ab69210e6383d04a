//! Where the nose points: where the hand left it, or along a heading.

use glam::{DMat3, DQuat, DVec3};
use lightfall_core::geometry::ship::Ship;
use lightfall_core::optics::ship::Heading;

/// The headings of the key, in its order. After the last one the gyroscopes hold the nose.
pub const HEADINGS: [Heading; 4] = [
    Heading::Hole,
    Heading::Prograde,
    Heading::Retrograde,
    Heading::Outward,
];

/// Least speed of a turn to a heading, in radians per second.
const LEAST_TURN: f64 = 1.5;
/// A turn to a heading takes away what is left of it in this many seconds, but for one part in e.
const TURN_SECONDS: f64 = 0.15;
/// A nose this near to its heading follows it, in radians.
const ALIGNED: f64 = 1e-3;

/// What the nose follows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nose {
    /// The last heading, as a place in [`HEADINGS`].
    last: usize,
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
    /// A nose that the gyroscopes hold, and that was last on this heading.
    #[must_use]
    pub fn on(heading: Heading) -> Self {
        let last = HEADINGS.iter().position(|known| *known == heading);
        Self {
            last: last.unwrap_or(0),
            state: State::Free,
        }
    }

    /// A nose that the autopilot keeps on this heading.
    #[must_use]
    pub fn following(heading: Heading) -> Self {
        Self {
            state: State::Follows,
            ..Self::on(heading)
        }
    }

    /// Begins to turn to the last heading or, if the nose follows it, to the next one. `None` if the
    /// gyroscopes hold the nose from now on.
    pub fn step(&mut self) -> Option<Heading> {
        if self.state == State::Free {
            self.state = State::Turns;
            return Some(HEADINGS[self.last]);
        }
        self.last = (self.last + 1) % HEADINGS.len();
        if self.last == 0 {
            self.state = State::Free;
            return None;
        }
        self.state = State::Turns;
        Some(HEADINGS[self.last])
    }

    /// Leaves the nose to the gyroscopes.
    pub fn release(&mut self) {
        self.state = State::Free;
    }

    /// The heading that the nose turns to or follows.
    #[must_use]
    pub fn heading(&self) -> Option<Heading> {
        (self.state != State::Free).then_some(HEADINGS[self.last])
    }

    /// The heading on which the autopilot keeps the nose.
    #[must_use]
    pub fn followed(&self) -> Option<Heading> {
        (self.state == State::Follows).then_some(HEADINGS[self.last])
    }

    /// The turn to the heading for so many seconds, about an axis on the ship's axes, by its length in
    /// radians. With `at_once` it is the whole turn.
    pub fn turn(&mut self, ship: &Ship, seconds: f64, at_once: bool) -> DVec3 {
        if self.state != State::Turns {
            return DVec3::ZERO;
        }
        let Some(direction) = HEADINGS[self.last].direction(ship) else {
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

/// The ship's axes with the nose along `direction` and up as near to decreasing theta as that allows,
/// as columns on the present axes.
fn level(ship: &Ship, direction: DVec3) -> DMat3 {
    let north = Heading::Observer(DVec3::NEG_Y).direction(ship);
    let up = [north, Some(DVec3::Z)]
        .into_iter()
        .flatten()
        .find_map(|up| up.reject_from_normalized(direction).try_normalize());
    let up = up.unwrap_or_else(|| direction.any_orthonormal_vector());
    DMat3::from_cols(direction, up.cross(direction), up)
}
