//! The map as photographs of the Milky Way show it. This is art: a choice of contrast and of colour.
//!
//! Starlight from the poles of the galaxy is a fifth of that from its plane, and the eye sees a grey
//! sky. Photographers subtract the light of the empty sky and raise the saturation, until the night
//! is black and the bulge is warm.

/// Half of the light of this brightness is subtracted, in stars of V = 0 per steradian: 22.1
/// magnitudes per square second of arc, between the poles' 24 and the plane's 21.
const SUBTRACTED: f64 = 60.0;
/// How quickly the subtracted share falls with brightness.
const STEEPNESS: i32 = 2;

/// The bluer light's share of white starlight, and how many times a share's difference from it is
/// shown.
const WHITE_SHARE: f64 = 0.47;
const SATURATION: f64 = 3.5;

/// How much of the light of nebulae is shown.
const NEBULAR_SHARE: f64 = 0.3;

/// The lights of a texel as a photograph shows them: those of the bluer and of the redder stars, and
/// that of nebulae. Light in V, in stars of V = 0 per steradian.
pub(super) fn photographed([blue, red, nebular]: [f64; 3]) -> [f64; 3] {
    let light = blue + red;
    let nebular = NEBULAR_SHARE * nebular;
    if light <= 0.0 {
        return [0.0, 0.0, nebular];
    }
    let kept = light / (1.0 + (SUBTRACTED / light).powi(STEEPNESS));
    let share = WHITE_SHARE + SATURATION * (blue / light - WHITE_SHARE);
    let blue = kept * share.clamp(0.0, 1.0);
    [blue, kept - blue, nebular]
}
