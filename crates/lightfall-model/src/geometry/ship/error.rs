//! Why a ship cannot exist or move, each in one sentence.

use thiserror::Error;

/// Why there is no such ship, or no such motion.
#[derive(Clone, Debug, Error, PartialEq)]
#[expect(missing_docs, reason = "the messages say what the fields are")]
pub enum ShipError {
    /// The ship starts where no flight is followed.
    #[error("the ship is at r = {r}; it must be from {inner:.6} to {outer} r_s")]
    Place { r: f64, inner: f64, outer: f64 },
    /// The axes are not those of a body.
    #[error(
        "the ship's axes are not orthonormal, with its four-velocity first: two of them differ by {by:e} from that"
    )]
    Axes { by: f64 },
    /// The pilot asks for what is not a number.
    #[error("the ship's {what} is {given:?}; its three components must be finite numbers")]
    Controls { what: &'static str, given: [f64; 3] },
    /// Time does not run backward.
    #[error(
        "the ship was to move on by the proper time {0}; it must be a finite number, not negative"
    )]
    Duration(f64),
    /// The tolerance of a step is not one.
    #[error("the tolerance of a step is {0}; it must be from 1e-15 to 1e-3")]
    Tolerance(f64),
}
