//! Rings so narrow that f32 cannot tell whether a ray meets them.

use lightfall_accuracy::{Truth, is_same_class};
use lightfall_model::scene::Scene;
use lightfall_optics::trace::Trace;

/// The spacing of f32's numbers, relative to them.
const SPACING: f64 = 1.0 / (1_u32 << 23) as f64;

/// A ring narrower than this many spacings is too narrow: each of its edges may be rounded by half
/// of one, and the place of a hit by one.
const SPACINGS: f64 = 2.0;

/// Whether the scene's disk is a ring too narrow for f32: its edges differ by no more than
/// roundings of its radius, or from the camera it is no wider than roundings of a direction.
pub(super) fn is_narrow(scene: &Scene) -> bool {
    let (inner, outer) = (scene.inner_edge(), scene.disk.outer);
    let width = outer - inner;
    let farthest = f64::max(outer, scene.camera.r);
    scene.disk.enabled && width < SPACINGS * SPACING * farthest
}

/// Number of rays that f32 cannot answer: they meet a ring that is too narrow by the method or by
/// the reference alone, and end alike.
pub(super) fn count_unanswerable(scene: &Scene, truth: &Truth, given: &[Trace]) -> usize {
    if !is_narrow(scene) {
        return 0;
    }
    let differs = |(truth, given): &(&Trace, &Trace)| {
        truth.outcome == given.outcome && !is_same_class(truth, given)
    };
    truth.traces.iter().zip(given).filter(differs).count()
}
