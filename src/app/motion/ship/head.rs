//! Where the pilot looks: along the nose, or at the hole wherever the nose points. The ship, its turn and
//! its thrust are untouched.

use super::nose::level;
use crate::app::motion::facing::between_axes;
use lightfall_core::geometry::ship::Ship;
use lightfall_core::optics::ship::{Heading, Mount};
use lightfall_core::scene::mission::Look;

/// Seconds that a turn of the head takes.
const TURN_SECONDS: f64 = 0.4;

/// The pilot's head.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Head {
    look: Look,
    /// How far the head is turned from the nose to the hole, from 0 to 1.
    share: f64,
}

impl Head {
    /// A head that looks so, without a turn.
    pub(super) const fn looking(look: Look) -> Self {
        let share = match look {
            Look::Nose => 0.0,
            Look::Hole => 1.0,
        };
        Self { look, share }
    }

    /// What the pilot looks at, or turns the head to.
    pub(super) fn look(self) -> Look {
        self.look
    }

    /// Begins to turn to the other look.
    pub(super) fn switch(&mut self) {
        self.look = match self.look {
            Look::Nose => Look::Hole,
            Look::Hole => Look::Nose,
        };
    }

    /// Turns the head for so many seconds, or the whole way `at_once`.
    pub(super) fn turn(&mut self, seconds: f64, at_once: bool) {
        let end = Self::looking(self.look).share;
        let step = if at_once { 1.0 } else { seconds / TURN_SECONDS };
        self.share = end.clamp(self.share - step, self.share + step);
    }

    /// The camera that sees what the pilot sees. At the hole its up is as near to decreasing theta as the
    /// hole allows, so that the disk lies level.
    pub(super) fn mount(self, ship: &Ship) -> Mount {
        let ahead = Mount::NOSE;
        // Exactly the nose's, so that a look that was never changed does not round.
        if self.share == 0.0 {
            return ahead;
        }
        let Some(hole) = Heading::Hole.direction(ship) else {
            return ahead;
        };
        let at_hole = level(ship, hole) * ahead.0;
        Mount(between_axes(ahead.0, at_hole, self.share))
    }
}
