//! The colours of the inspector's drawings.

use bevy_egui::egui::Color32;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::optics::trace::Outcome;

pub(super) const HORIZON: Color32 = Color32::from_gray(150);
pub(super) const ERGOSPHERE: Color32 = Color32::from_rgb(150, 90, 200);
pub(super) const PHOTON_ORBITS: Color32 = Color32::from_rgb(240, 200, 60);
pub(super) const ISCO: Color32 = Color32::from_rgb(90, 200, 130);
pub(super) const DISK: Color32 = Color32::from_rgb(215, 130, 70);
pub(super) const CAMERA: Color32 = Color32::WHITE;

/// The colour of a path.
pub(super) fn path_colour(inspected: &Inspected) -> Color32 {
    match (inspected.trace.hits[0], inspected.trace.outcome) {
        (Some(_), _) => Color32::from_rgb(255, 170, 90),
        (None, Outcome::Sky) => Color32::from_rgb(110, 180, 255),
        (None, Outcome::Captured) => Color32::from_rgb(235, 90, 90),
        (None, Outcome::Unfinished) => Color32::from_rgb(255, 0, 255),
    }
}
