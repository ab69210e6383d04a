//! Views that have nothing to show in a scene.

use lightfall_core::scene::{Scene, View};

/// Why a view of the scene would have nothing to show, in one sentence. `None` if it shows something.
#[must_use]
pub fn why_empty(view: View, scene: &Scene) -> Option<&'static str> {
    let method = scene.resolved_method().properties();
    let steps = scene.effects.lensing && method.steps;
    match view {
        View::Unfinished if !scene.effects.lensing || method.answers_every_ray => {
            Some("This method finishes every ray.")
        }
        View::Residual if !steps => {
            Some("This method solves for rays instead of stepping along them: it has no residual.")
        }
        View::Steps if !steps => {
            Some("This method solves for rays instead of stepping along them: no ray takes a step.")
        }
        View::Delay if !scene.disk.enabled => Some("The disk is off: no light to time."),
        _ if view.shows_matter() && !scene.has_medium() => {
            Some("No matter with depth: the disk has no thickness, and there are no jets.")
        }
        _ => None,
    }
}
