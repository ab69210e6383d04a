//! The format of a journey's text: how many keyframes it has, and what a keyframe may name.

/// Most keyframes of a journey.
pub(super) const MAX_KEYFRAMES: usize = 1000;

/// What a keyframe may have: its name there, and the key of the field that says what it may be.
/// The angles without a key may be of any number of turns here.
pub(super) const NAMES: [(&str, &str); 9] = [
    ("r", "camera.r"),
    ("theta_deg", "camera.theta_deg"),
    ("phi_deg", ""),
    ("yaw_deg", ""),
    ("pitch_deg", ""),
    ("roll_deg", ""),
    ("fov_deg", "camera.fov_deg"),
    ("observer", "observer.kind"),
    ("velocity", "observer.velocity"),
];
