//! The geometry of a Kerr black hole: metric functions, observers and geodesics, as pure functions
//! in f64.
//!
//! Units are G = c = 1 and r_s = 1, so M = 1/2 and a = chi/2. Coordinates are Boyer-Lindquist, and
//! a place on the celestial sphere is the unit vector n = (sin theta cos phi, sin theta sin phi,
//! cos theta).

pub mod bisection;
pub mod chebyshev;
pub mod elliptic;
pub mod kerr;
pub mod mino;
pub mod observer;
pub mod quadrature;
pub mod schwarzschild;
pub mod ship;
pub mod sphere;
pub mod taylor;
pub mod tetrad;
pub mod timelike;
