//! The views: what each of them adds to a picture's shader.

use super::text::{Part, part};
use crate::scene::View;

/// What the shaders need to know of a view, in addition to its
/// [properties](crate::scene::View::properties).
pub(super) struct ViewShader {
    /// The files that colour a ray. If the view traces rays, the last one defines
    /// `fn light_along(photon: Photon) -> vec4<f32>`, and `view/traced.wgsl` calls it. Otherwise it
    /// defines `fn light_at(place: vec2<f32>) -> vec4<f32>`, where `place` is in pixels from the
    /// upper left corner. Both return linear sRGB before exposure, and 1, or less in the shadow,
    /// where bloom must add nothing.
    pub parts: &'static [Part],
    /// Whether it shows what a ray's record contains only with the flag DIAGNOSTICS.
    pub diagnostics: bool,
}

/// The row of a view: a new view is a new row.
pub(super) fn view_shader(view: View) -> ViewShader {
    let (parts, diagnostics): (&[Part], bool) = match view {
        View::Colour | View::Unfinished => (&[part!("view/colour.wgsl")], false),
        View::Classes => (&[part!("view/classes.wgsl")], false),
        View::Residual => (&[part!("view/residual.wgsl")], true),
        View::Order => (&[part!("view/order.wgsl")], true),
        View::Delay => (&[part!("view/oklab.wgsl"), part!("view/delay.wgsl")], false),
        View::Redshift => (&[part!("view/redshift.wgsl")], false),
        View::Steps => (&[part!("view/oklab.wgsl"), part!("view/steps.wgsl")], false),
        View::Error => (&[part!("view/oklab.wgsl"), part!("view/error.wgsl")], false),
    };
    ViewShader { parts, diagnostics }
}
