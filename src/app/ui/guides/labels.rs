//! The labels of the guides: a column of names beside the hole, each joined to its line.

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
    /// The direction from the middle of the figure in which it is joined to its line.
    pub(super) toward: Vec2,
}

const SIZE: f32 = 13.0;
/// Room around a label's text, and between labels, in points.
const PADDING: Vec2 = vec2(6.0, 3.0);
const GAP: f32 = 5.0;
/// Distance of the column from the figure, and from the edge of the free part of the picture.
const DISTANCE: f32 = 34.0;
const MARGIN: f32 = 12.0;
/// Opacity of the box behind a text, which keeps it legible on any picture.
const BOX: Color32 = Color32::from_black_alpha(215);

/// A label with the place where it is joined to its line.
struct Anchored {
    galley: Arc<Galley>,
    colour: Color32,
    anchor: Pos2,
    top: f32,
}

impl Anchored {
    fn height(&self) -> f32 {
        self.galley.size().y + 2.0 * PADDING.y
    }
}

/// Draws the labels within `free`, beside the figure that their lines make. Those whose lines lie
/// outside `free` are left out.
pub(super) fn draw_labels(painter: &Painter, labels: Vec<Label>, free: Rect, taken: &[Rect]) {
    let mut figure = Rect::NOTHING;
    for point in labels.iter().flat_map(|label| &label.points) {
        if free.contains(*point) {
            figure.extend_with(*point);
        }
    }
    if !figure.is_positive() {
        return;
    }
    for right in [true, false] {
        let side = labels
            .iter()
            .filter(|label| (label.toward.x >= 0.0) == right);
        let anchored: Vec<_> = side
            .filter_map(|label| anchor(painter, label, figure, free))
            .collect();
        draw_column(painter, anchored, figure, free, right, taken);
    }
}

/// The point of a label's line that lies most nearly in the label's direction.
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
    Some(Anchored {
        top: anchor.y - 0.5 * galley.size().y - PADDING.y,
        galley,
        colour: label.colour,
        anchor: *anchor,
    })
}

fn draw_column(
    painter: &Painter,
    mut column: Vec<Anchored>,
    figure: Rect,
    free: Rect,
    right: bool,
    taken: &[Rect],
) {
    column.sort_by(|a, b| a.anchor.y.total_cmp(&b.anchor.y));
    let widths = column
        .iter()
        .map(|label| label.galley.size().x + 2.0 * PADDING.x);
    let width = widths.fold(0.0, f32::max);
    let left_edge = if right {
        (figure.right() + DISTANCE).min(free.right() - MARGIN - width)
    } else {
        (figure.left() - DISTANCE - width).max(free.left() + MARGIN)
    };
    // The column keeps clear of other boxes that reach into it.
    let span = Rect::from_x_y_ranges(left_edge..=left_edge + width, free.y_range());
    let mut lowest = free.top() + MARGIN;
    for other in taken.iter().filter(|other| other.intersects(span)) {
        lowest = lowest.max(other.bottom() + GAP);
    }
    let highest = free.bottom() - MARGIN;
    // Downward without overlap, then back up where the column leaves the picture.
    for label in &mut column {
        label.top = label.top.max(lowest);
        lowest = label.top + label.height() + GAP;
    }
    let mut bottom = highest;
    for label in column.iter_mut().rev() {
        label.top = label.top.min(bottom - label.height());
        bottom = label.top - GAP;
    }
    for label in &column {
        let size = label.galley.size() + 2.0 * PADDING;
        let x = if right {
            left_edge
        } else {
            left_edge + width - size.x
        };
        let area = Rect::from_min_size(pos2(x, label.top), size);
        let joint = pos2(
            if right { area.left() } else { area.right() },
            area.center().y,
        );
        for (extra, colour) in [(2.0, Color32::from_black_alpha(170)), (0.0, label.colour)] {
            painter.line_segment([label.anchor, joint], Stroke::new(1.0 + extra, colour));
            painter.circle_filled(label.anchor, 2.6 + 0.5 * extra, colour);
        }
    }
    for label in &column {
        let size = label.galley.size() + 2.0 * PADDING;
        let x = if right {
            left_edge
        } else {
            left_edge + width - size.x
        };
        let area = Rect::from_min_size(pos2(x, label.top), size);
        painter.rect(
            area,
            4.0,
            BOX,
            Stroke::new(1.0, label.colour.gamma_multiply(0.45)),
            egui::StrokeKind::Inside,
        );
        painter.galley(
            Align2::CENTER_CENTER
                .align_size_within_rect(label.galley.size(), area)
                .min,
            Arc::clone(&label.galley),
            label.colour,
        );
    }
}
