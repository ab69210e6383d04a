//! How quantities go from one keyframe to the next.

crate::words! {
    /// How a quantity changes from a keyframe that names it to the next one that does.
    pub enum Ease {
        /// Through the keyframes without a jump of the speed, and at rest at both ends of the journey.
        Smooth = "smooth",
        /// At a constant speed.
        Linear = "linear",
        /// Not at all; at the next keyframe it changes at once.
        Hold = "hold",
        /// From rest, ever faster.
        In = "in",
        /// Quickly at first, and to rest.
        Out = "out",
    }
}

impl Ease {
    /// The slopes at both ends of a stretch with this mean slope; none where the neighbouring stretches
    /// decide them. A parabola from rest is the cubic with the slopes 0 and twice the mean.
    pub(super) fn slopes(self, mean: f64) -> Option<[f64; 2]> {
        match self {
            Self::Smooth => None,
            Self::Linear => Some([mean, mean]),
            Self::Hold => Some([0.0, 0.0]),
            Self::In => Some([0.0, 2.0 * mean]),
            Self::Out => Some([2.0 * mean, 0.0]),
        }
    }
}
