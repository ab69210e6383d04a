//! The f64 truth: Kerr's geometry, observers, null geodesics, the disk and the spectrum, as pure
//! functions.
//!
//! Units are G = c = 1 and r_s = 1, so M = 1/2 and a = chi/2. Every photon is the physical,
//! future-directed one, with E = -p_t, L = p_phi and Carter's Q, per unit frequency for the camera;
//! rays are followed backward from the camera. Coordinates are Boyer-Lindquist, and a place on the
//! celestial sphere is the unit vector n = (sin theta cos phi, sin theta sin phi, cos theta).

pub mod disk;
pub mod elliptic;
pub mod exposure;
pub mod kerr;
pub mod mino;
pub mod observer;
pub mod path;
pub mod readout;
pub mod reference;
pub mod schwarzschild;
pub mod shift;
pub mod sight;
pub mod spectrum;
pub mod straight;
pub mod taylor;
pub mod timelike;
pub mod trace;
