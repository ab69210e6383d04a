//! Null geodesics of Kerr in Mino time, on the celestial sphere. The twin in WGSL is
//! shaders/method/mino.wgsl and the files next to it.
//!
//! In Mino time tau (Mino 2003: dtau = d(affine)/Sigma) the radial and angular motions separate. In
//! u = 1/r and the unit vector n = (sin theta cos psi, sin theta sin psi, cos theta) their
//! equations are polynomial, without a singularity at the poles, the horizon or infinity. With K =
//! Q + L^2, K' = Q + (L - a E)^2 = K - 2 a E L + a^2 E^2, 2 M = 1, and tau growing along the
//! *backward* ray,
//!
//! * u'^2 = U(u) = E^2 + (a^2 E^2 - K) u^2 + K' u^3 - a^2 Q u^4, and u'' = U'(u)/2;
//! * n'' = a^2 E^2 n_z e_z - (K + 2 a^2 E^2 n_z^2) n, with |n'|^2 = K + a^2 E^2 n_z^2 and (n x
//!   n')_z = -L;
//! * phi = psi + chi, with chi' = -a u (E - a L u) / (1 - u + a^2 u^2).
//!
//! Derived from Carter's separated equations (1968; Bardeen, Press & Teukolsky 1972 eqs. 2.9-2.10)
//! by setting u = 1/r and by combining theta and the part L/sin^2(theta) of phi's equation into one
//! vector, whose motion is Neumann's problem on the sphere. The constants are not divided by E,
//! which may vanish or be negative in the ergosphere.
//!
//! A camera at or inside the horizon uses Kerr's ingoing azimuth, phi + integral of a dr / Delta,
//! for which chi' = a E - a K' u^2 / (E + (a^2 E - a L) u^2 - u'). It is regular for infalling
//! light, and has the same value at infinity. Backward rays that start very close to the horizon
//! use it too: the pole of Boyer-Lindquist's chi' leaves the series almost no radius of convergence
//! there.
//!
//! The motion is expanded in a Taylor series of high order about the start of every step, by
//! recurrences on these right-hand sides. A step is long (about one radian) and costs little, the
//! series itself is the dense output on which events are found to full precision, and there is no
//! error estimate to tune.

mod motion;
mod series;

pub use motion::{PhotonConstants, PhotonState};
pub use series::PhotonSeries;
