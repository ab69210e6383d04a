//! Where the picture lies on the output.

use bevy::math::{URect, UVec2, Vec2};
use bevy::prelude::Resource;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::scene::Picture;

/// Where the picture is shown.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq, Eq, ExtractResource)]
pub struct PictureArea {
    /// The part of the output for it, in pixels. An empty one stands for the whole output.
    pub part: URect,
    /// Its sizes at rest. A picture that is drawn coarser for a moment lies where it lies at rest.
    pub at_rest: Option<RestingSizes>,
}

/// The sizes of a picture at rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RestingSizes {
    /// Its size in pixels.
    pub size: UVec2,
    /// Its grid of cells. A window keeps its cells while it draws fewer pixels than there are cells, and
    /// they then show the picture interpolated.
    pub grid: UVec2,
}

impl PictureArea {
    /// Centres the picture in this part of an output of the given size.
    #[must_use]
    pub fn letterbox(self, picture: &Picture, output: UVec2) -> Letterbox {
        let mut area = self
            .part
            .intersect(URect::from_corners(UVec2::ZERO, output));
        if area.is_empty() {
            area = URect::from_corners(UVec2::ZERO, output);
        }
        let at_rest = self.at_rest.filter(|at_rest| {
            if picture.bypass {
                have_same_shape(at_rest.size, picture.size())
            } else {
                have_same_shape(at_rest.grid, picture.grid())
            }
        });
        let shown = at_rest.map_or(*picture, |at_rest| Picture {
            width: at_rest.size.x,
            height: at_rest.size.y,
            grid_width: at_rest.grid.x,
            grid_height: at_rest.grid.y,
            ..*picture
        });
        let Letterbox { offset, extent } = letterbox(&shown, area.size());
        Letterbox {
            offset: offset + area.min.as_vec2(),
            extent,
        }
    }
}

/// The rectangle of the output that the picture fills. The outermost cells may reach beyond the
/// output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Letterbox {
    /// Upper left corner, in output pixels.
    pub offset: Vec2,
    /// Size, in output pixels.
    pub extent: Vec2,
}

/// Centres the picture on an output of the given size.
///
/// All cells have the same whole scale. A grid that was made for the output
/// ([`fit`](lightfall_core::scene::fit)) fills it, and the output's edge cuts through the outermost cells. Any
/// other grid has the largest whole scale that fits, with bars around it. Where there are no cells,
/// or the grid does not fit at scale one, the picture is as large as the output allows.
#[must_use]
pub fn letterbox(picture: &Picture, output: UVec2) -> Letterbox {
    let grid = picture.grid().max(UVec2::ONE);
    let scale = (output / grid).min_element();
    let extent = if picture.bypass {
        fitted(picture.size(), output)
    } else if let Some(scale) = filling_scale(grid, output) {
        (grid * scale).as_vec2()
    } else if scale > 0 {
        (grid * scale).as_vec2()
    } else {
        fitted(grid, output)
    };
    Letterbox {
        offset: ((output.as_vec2() - extent) / 2.0).floor(),
        extent,
    }
}

/// Whether two sizes have the same shape, where the smaller one's sides may be off by one: they are whole
/// numbers.
fn have_same_shape(a: UVec2, b: UVec2) -> bool {
    let (a, b) = (a.as_dvec2(), b.as_dvec2());
    let (small, large) = if a.x < b.x { (a, b) } else { (b, a) };
    let is_wider = |x: f64, y: f64| x * large.y >= y * large.x;
    is_wider(small.x + 1.0, small.y - 1.0) && !is_wider(small.x - 1.0, small.y + 1.0)
}

/// The scale at which the grid covers the output and no row or column of cells is out of view.
/// `None` if there is no such scale.
fn filling_scale(grid: UVec2, output: UVec2) -> Option<u32> {
    let scale = ((output + grid - 1) / grid).max_element();
    ((grid - 1) * scale).cmplt(output).all().then_some(scale)
}

/// The largest extent of this shape on the output. A bar that is thinner than a pixel of the
/// picture comes from rounding, and is left out.
fn fitted(shown: UVec2, output: UVec2) -> Vec2 {
    let (shown, output) = (shown.max(UVec2::ONE).as_vec2(), output.as_vec2());
    let scale = (output / shown).min_element();
    let extent = (shown * scale).round().max(Vec2::ONE);
    if (output - extent).max_element() <= scale.max(1.0) {
        output
    } else {
        extent
    }
}
