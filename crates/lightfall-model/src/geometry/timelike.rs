//! Timelike geodesics of Kerr in Mino time, on the celestial sphere.
//!
//! The equations are those of light (`mino.rs`), but for unit rest mass and followed forward. In
//! Mino time lambda (dtau = Sigma dlambda), with u = 1/r, n the place on the celestial sphere
//! without the dragged part of the azimuth, E, L and Carter's Q per unit mass, 2 M = 1,
//! K = Q + L^2, K' = Q + (L - a E)^2, B = a (a E - L) and kappa = a^2 (1 - E^2),
//!
//! * u'^2 = U(u) = W^2 - D (1 + K' u^2), W = E + B u^2, D = 1 - u + a^2 u^2, and u'' = U'(u)/2;
//! * n'' = -kappa n_z e_z - (K - 2 kappa n_z^2) n, with |n'|^2 = K - kappa n_z^2 and (n x n')_z =
//!   L;
//! * tau' = r^2 + a^2 n_z^2;
//! * Kerr's ingoing azimuth grows by L/sin^2(theta), which is contained in n, and by a (F - E);
//! * the ingoing (advanced) time grows by v' = (r^2 + a^2) F + a (L - a E sin^2(theta)),
//!
//! where F = (W - u')/D. For infalling particles F = (1 + K' u^2)/(W + u'), which is regular at the
//! horizon. Derived from Carter's separated equations (1968; Bardeen, Press & Teukolsky 1972 eqs.
//! 2.9-2.10; Misner, Thorne & Wheeler 1973 box 33.2 for the ingoing coordinates).

mod geodesic;
mod motion;
mod series;

pub use geodesic::{Geodesic, Limit};
pub use motion::{ParticleConstants, ParticleState};
