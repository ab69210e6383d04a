//! Flying a [`Ship`](lightfall_model::geometry::ship::Ship): from a scene and back to it, its clocks
//! and its rocket, what holds it in place, where it is headed, and its motion in frames of time.
//!
//! Everything but [`Flight`] is a pure function of the ship. Units are r_s and c, and directions are
//! on the ship's own axes.

mod aim;
mod apsides;
mod clocks;
mod flight;
mod heading;
mod holds;
mod life;
mod mission;
mod path;
mod pose;
mod quantities;
mod records;
mod rocket;
mod seen_path;
mod solution;
mod star;

pub use apsides::{Apsides, time_to_apsis};
pub use clocks::{Clocks, HOME_RADIUS, disk_clock};
pub use flight::{Event, Flight, Orders, TICK, Thrust};
pub use heading::{Heading, motion_rate, speed_for_zamo, turn_to};
pub use holds::{Hold, HoldRefusal, circular_velocity};
pub use life::{longest_life, radial_life};
pub use mission::{Attempt, Outcome, StartError};
pub use path::{Apsis, PathPoint, path_ahead};
pub use pose::{BoardError, Mount, board, write_scene};
pub use quantities::Voyage;
pub use records::{Records, tide_of};
pub use rocket::{Rocket, RocketError};
pub use seen_path::{SeenPath, seen_path, seen_wire};
pub use solution::{SolutionError, fly};
pub use star::star_ahead;
