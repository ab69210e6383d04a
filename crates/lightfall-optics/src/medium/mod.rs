//! Matter with depth on the way of a ray: where it is, how much it absorbs, what it emits, and the
//! light that reaches the camera through it.
//!
//! Along a backward ray the optical depth grows by kappa rho ds, where ds = (1/g) Sigma dtau is the
//! length of the way in the matter's frame, tau is Mino time, and g is the observed over the emitted
//! frequency. The light of each place arrives weakened by what lies before it: the formal solution
//! of the equation of transfer (Rybicki & Lightman 1979, eq. 1.30), whose intensity over the cube of
//! the frequency is the same for all observers.

mod disk_matter;
mod emission;
pub mod jet;
mod light;
mod means;
mod nodes;
mod passage;
mod sheet;
mod source;
mod spans;
mod stretches;
mod thick_disk;
mod transfer;

pub use disk_matter::{Matter, Place};
pub use emission::Emission;
pub use light::Medium;
pub use means::Means;
pub use nodes::Nodes;
pub use passage::Passage;
pub use source::{emission_scale, scattering_source};
pub use spans::Span;
pub use stretches::{MatterKind, Stretch};
pub use thick_disk::{Shape, ThickDisk};
pub use transfer::Tolerance;
