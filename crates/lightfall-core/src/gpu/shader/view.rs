//! The views: what each of them adds to a picture's shader.

use super::text::{Part, part};
use crate::scene::View;

/// What the shaders need to know of a view, besides its
/// [properties](crate::scene::View::properties).
pub(super) struct ViewShader {
    /// The file that colours a ray: with `light_along`, if the view traces rays, else with
    /// `light_at`.
    pub part: Part,
    /// Whether it shows what a ray's record contains only with the flag DIAGNOSTICS.
    pub diagnostics: bool,
}

/// The row of a view: a new view is a new row.
pub(super) fn view_shader(view: View) -> ViewShader {
    let (part, diagnostics) = match view {
        View::Colour | View::Unfinished => (part!("view/colour.wgsl"), false),
        View::Classes => (part!("view/classes.wgsl"), false),
        View::Residual => (part!("view/residual.wgsl"), true),
        View::Order => (part!("view/order.wgsl"), true),
        View::Redshift => (part!("view/redshift.wgsl"), false),
        View::Error => (part!("view/error.wgsl"), false),
    };
    ViewShader { part, diagnostics }
}
