//! The field of a disk without thickness, by radius, azimuth and time.

use lightfall_core::optics::structure::{Covariance, Event, Field, Structure};

/// The field of a [`Structure`] in the disk's plane.
pub(crate) trait StructureField {
    /// The factor by which the structure multiplies the flux at the radius `r` and the azimuth
    /// `phi` for light that leaves at `time`, averaged over a footprint.
    fn factor_at(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> f64;

    /// The field there.
    fn field_at(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> Field;
}

/// An event in the disk's plane.
pub(crate) fn in_plane(r: f64, phi: f64, time: f64) -> Event {
    Event {
        r,
        phi,
        cos_theta: 0.0,
        time,
    }
}

impl StructureField for Structure {
    fn factor_at(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> f64 {
        self.field_at(r, phi, time, footprint)
            .factor(self.model.contrast)
    }

    fn field_at(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> Field {
        self.field(&in_plane(r, phi, time), footprint)
    }
}
