//! A ship with an engine: accelerated motion, gyroscopes and their error, in coordinates that are
//! regular on the axis and at both horizons.
//!
//! The coordinates are ingoing Kerr-Schild (T, x, y, z), with T = v - r and Kerr's ingoing azimuth
//! (Kerr & Schild 1965). Vectors have components on the frame e_b = d_b - H l_b l^mu d_mu, which is
//! orthonormal everywhere outside the ring, so that their products are Minkowski's. Of a [`DVec4`],
//! x is the component along e_T, and y, z, w are those along x, y and z.
//!
//! docs/FLIGHT.md explains the equations.
//!
//! [`DVec4`]: glam::DVec4

mod coast;
mod constants;
mod error;
mod extrapolation;
mod flight;
mod motion;
mod place;
mod rain_axes;
mod steps;
mod vectors;

pub use constants::VectorConstants;
pub use error::ShipError;
pub use flight::{Controls, DEFAULT_TOLERANCE, FlightError, Ship};
pub use place::Place;
pub use rain_axes::{rain_axes, zamo_axes};
pub use vectors::{boost, components, minkowski};
