//! The labels of the guides: columns of names beside the hole, each joined to its line.

use crate::app::ui::layout::{GAP, Layout, Slide, Wish};
use crate::app::ui::screen::BOX;
use bevy_egui::egui::{
    self, Align2, Color32, FontId, Galley, Painter, Pos2, Rect, Stroke, Vec2, pos2, vec2,
};
use std::sync::Arc;

/// A label, before it has a place.
pub(super) struct Label {
    pub(super) text: String,
    pub(super) colour: Color32,
    /// The visible points of its line.
    pub(super) points: Vec<Pos2>,
    /// The direction from the figure's middle to the point of the line that it is joined to.
    pub(super) toward: Vec2,
}

const SIZE: f32 = 13.0;
/// Room around a label's text, in points.
const PADDING: Vec2 = vec2(6.0, 3.0);
/// Distance of the column from the figure, and from the edge of the free part of the picture.
const DISTANCE: f32 = 34.0;
const MARGIN: f32 = 12.0;

/// A label with the point of the line that it is joined to.
struct Anchored {
    galley: Arc<Galley>,
    colour: Color32,
    anchor: Pos2,
    /// The label's box.
    place: Rect,
}

/// Draws the labels within `free`, beside the figure that their lines make. A label whose line lies
/// outside `free`, or for which there is no room, is left out.
pub(super) fn draw_labels(
    painter: &Painter,
    mut labels: Vec<Label>,
    free: Rect,
    layout: &mut Layout,
) {
    let free = free.intersect(layout.bounds());
    let mut figure = Rect::NOTHING;
    for point in labels.iter().flat_map(|label| &label.points) {
        if free.contains(*point) {
            figure.extend_with(*point);
        }
    }
    if !figure.is_positive() {
        return;
    }
    let column_of = |labels: &[Label], right: bool| {
        let side = labels
            .iter()
            .filter(|label| (label.toward.x >= 0.0) == right);
        let anchored: Vec<_> = side
            .filter_map(|label| anchor(painter, label, figure, free))
            .collect();
        Column::new(anchored, figure, free, right)
    };
    // If a box covers a part of the right column's place, all labels go to the left.
    let column = column_of(&labels, true);
    if !column.is_free(layout) {
        for label in &mut labels {
            label.toward.x = -label.toward.x.abs();
        }
    }
    for right in [true, false] {
        let mut column = column_of(&labels, right);
        column.arrange(free, layout);
        column.draw(painter);
    }
}

/// The label joined to the point of its line that is nearest to the label's direction, and at the
/// height of this point. None if no point is within `free`.
fn anchor(painter: &Painter, label: &Label, figure: Rect, free: Rect) -> Option<Anchored> {
    let inner = free.shrink(MARGIN);
    let agreement = |point: &&Pos2| (**point - figure.center()).normalized().dot(label.toward);
    let anchor = label
        .points
        .iter()
        .filter(|point| inner.contains(**point))
        .max_by(|a, b| agreement(a).total_cmp(&agreement(b)))?;
    let galley =
        painter.layout_no_wrap(label.text.clone(), FontId::proportional(SIZE), label.colour);
    let size = galley.size() + 2.0 * PADDING;
    Some(Anchored {
        place: Rect::from_center_size(*anchor, size),
        galley,
        colour: label.colour,
        anchor: *anchor,
    })
}

/// The labels on one side of the figure, one below the other.
struct Column {
    labels: Vec<Anchored>,
    /// The edge of the labels toward the figure.
    inner: Align2,
}

impl Column {
    /// A column beside the figure. The edges of the labels toward the figure are aligned.
    fn new(mut labels: Vec<Anchored>, figure: Rect, free: Rect, right: bool) -> Self {
        labels.sort_by(|a, b| a.anchor.y.total_cmp(&b.anchor.y));
        let widths = labels.iter().map(|label| label.place.width());
        let width = widths.fold(0.0, f32::max);
        let (inner, x) = if right {
            let x = (figure.right() + DISTANCE).min(free.right() - MARGIN - width);
            (Align2::LEFT_CENTER, x)
        } else {
            let x = (figure.left() - DISTANCE).max(free.left() + MARGIN + width);
            (Align2::RIGHT_CENTER, x)
        };
        for label in &mut labels {
            label.place = inner.anchor_size(pos2(x, label.anchor.y), label.place.size());
        }
        Self { labels, inner }
    }

    /// Whether all labels have room before they make room for each other.
    fn is_free(&self, layout: &Layout) -> bool {
        self.labels.iter().all(|label| layout.is_free(label.place))
    }

    /// Gives the labels places one below the other, and leaves out those without room.
    fn arrange(&mut self, free: Rect, layout: &mut Layout) {
        let heights = self.labels.iter().map(|label| label.place.height() + GAP);
        // The labels below have room, too.
        let mut lowest = free.bottom() - MARGIN - heights.sum::<f32>();
        let mut highest = free.top();
        self.labels.retain_mut(|label| {
            let size = label.place.size();
            let top = label.place.top().min(lowest.max(free.top())).max(highest);
            lowest += size.y + GAP;
            let wish = Wish {
                anchor: Align2::LEFT_TOP,
                at: pos2(label.place.left(), top),
                slide: Slide::Upright,
                covers_hole: false,
            };
            let below = |place: &Rect| place.top() >= highest - GAP && free.contains_rect(*place);
            let place = layout.wished(size, wish).filter(below);
            if let Some(place) = place {
                layout.take("guide", place);
                label.place = place;
                highest = place.bottom() + GAP;
            }
            place.is_some()
        });
    }

    fn draw(&self, painter: &Painter) {
        for label in &self.labels {
            let joint = self.inner.pos_in_rect(&label.place);
            for (extra, colour) in [(2.0, Color32::from_black_alpha(170)), (0.0, label.colour)] {
                painter.line_segment([label.anchor, joint], Stroke::new(1.0 + extra, colour));
                painter.circle_filled(label.anchor, 2.6 + 0.5 * extra, colour);
            }
        }
        for label in &self.labels {
            let edge = Stroke::new(1.0, label.colour.gamma_multiply(0.45));
            painter.rect(label.place, 4.0, BOX, edge, egui::StrokeKind::Inside);
            let text = label.place.min + PADDING;
            painter.galley(text, Arc::clone(&label.galley), label.colour);
        }
    }
}
