//! A board: texts in a dark box, in which they are legible over any picture.

use crate::app::ui::layout::{Layout, Wish};
use crate::app::ui::screen::BOX;
use bevy_egui::egui;
use egui::text::{LayoutJob, TextWrapping};
use egui::{Color32, FontId, Galley, LayerId, Order, Painter, Rect, Vec2};
use std::sync::Arc;

/// Size of the text, in points.
pub(super) const TEXT: f32 = 13.5;

/// Colour of the most important texts.
pub(super) const BRIGHT: Color32 = Color32::from_gray(238);
/// Colour of labels and key hints.
pub(super) const QUIET: Color32 = Color32::from_gray(198);
/// Colour of warnings.
pub(super) const WARNING: Color32 = Color32::from_rgb(255, 190, 90);

/// Room between a board's texts and its edge, in points.
pub(super) const PADDING: Vec2 = Vec2::new(10.0, 6.0);
const CORNER_RADIUS: f32 = 5.0;

/// The width, the size and the most rows of a text.
type Shape = (f32, f32, usize);
/// Widths, as shares of the largest one, sizes, as shares of the usual one, and numbers of rows in which
/// a text is tried: those of the usual size first, then smaller ones.
const SHAPES: [Shape; 5] = [
    (1.0, 1.0, usize::MAX),
    (0.6, 1.0, usize::MAX),
    (0.4, 1.0, usize::MAX),
    (1.0, 0.75, usize::MAX),
    (1.0, 0.55, usize::MAX),
];
const USUAL: usize = 3;
/// The same where there is no room for all of it, and it ends in an ellipsis.
const CUT: [Shape; 2] = [(1.0, 0.75, 2), (1.0, 0.75, 1)];

/// Texts with their places, to be painted in a box.
pub(super) struct Board {
    name: &'static str,
    painter: Painter,
    texts: Vec<(Vec2, Arc<Galley>)>,
    size: Vec2,
}

impl Board {
    /// An empty board. `strength` is its opacity, from 0 to 1.
    pub(super) fn new(context: &egui::Context, name: &'static str, strength: f32) -> Self {
        if strength > 0.0 && strength < 1.0 {
            // It needs another frame, so that it does not fade in steps.
            context.request_repaint();
        }
        let layer = LayerId::new(Order::Background, name.into());
        let mut painter = context.layer_painter(layer);
        painter.set_opacity(strength);
        Self {
            name,
            painter,
            texts: Vec::new(),
            size: Vec2::ZERO,
        }
    }

    /// Lays a text out in lines of at most `width` points.
    pub(super) fn text(&self, text: &str, size: f32, colour: Color32, width: f32) -> Arc<Galley> {
        let font = FontId::proportional(size);
        self.painter.layout(text.to_owned(), font, colour, width)
    }

    /// Lays a text out in one line of at most `width` points. A longer one ends in an ellipsis.
    pub(super) fn line(&self, text: &str, size: f32, colour: Color32, width: f32) -> Arc<Galley> {
        let font = FontId::proportional(size);
        let mut job = LayoutJob::simple_singleline(text.to_owned(), font, colour);
        job.wrap = TextWrapping::truncate_at_width(width);
        self.painter.layout_job(job)
    }

    /// Width of a text in one line, in points.
    pub(super) fn width_of(&self, text: &str, size: f32) -> f32 {
        self.text(text, size, BRIGHT, f32::INFINITY).size().x
    }

    /// Puts a text at a place of the board, from its upper left corner.
    pub(super) fn put(&mut self, place: Vec2, text: Arc<Galley>) {
        self.size = self.size.max(place + text.size());
        self.texts.push((place, text));
    }

    /// Puts a text below the others.
    pub(super) fn add_line(&mut self, text: Arc<Galley>, gap: f32) {
        let gap = if self.texts.is_empty() { 0.0 } else { gap };
        self.put(Vec2::new(0.0, self.size.y + gap), text);
    }

    /// Makes the board at least this wide, so that it keeps its width while its texts change.
    pub(super) fn widen(&mut self, width: f32) {
        self.size.x = self.size.x.max(width);
    }

    /// The board's size with its box, in points.
    pub(super) fn size(&self) -> Vec2 {
        self.size + 2.0 * PADDING
    }

    /// What the board is painted with, for drawings over its box.
    pub(super) fn painter(&self) -> Painter {
        self.painter.clone()
    }

    /// The part of a board's box in which its texts lie.
    pub(super) fn inside(place: Rect) -> Rect {
        place.shrink2(PADDING)
    }

    /// Paints the board where the layout has room for it, as near as possible to its wish. Returns its
    /// box, or `None` where there is no room.
    pub(super) fn paint(self, layout: &mut Layout, wish: Wish) -> Option<Rect> {
        if self.texts.is_empty() {
            return None;
        }
        let place = layout.place(self.name, self.size(), wish)?;
        self.paint_at(place);
        Some(place)
    }

    /// Paints the board into a box that is its own already.
    pub(super) fn paint_at(self, place: Rect) {
        self.painter.rect_filled(place, CORNER_RADIUS, BOX);
        for (offset, text) in self.texts {
            self.painter
                .galley(place.min + PADDING + offset, text, BRIGHT);
        }
    }

    /// Paints a board with one text of at most `width` points, in the first shape that has room. A text
    /// covers the hole, if it may, rather than being cut.
    pub(super) fn paint_text(
        self,
        layout: &mut Layout,
        wish: Wish,
        text: (&str, f32, Color32),
        width: f32,
    ) -> Option<Rect> {
        self.paint_in_shape(layout, wish, text, width, &[&SHAPES[..], &CUT[..]])
    }

    /// The same for a caption, which covers the hole, if it may, rather than having smaller letters.
    pub(super) fn paint_caption(
        self,
        layout: &mut Layout,
        wish: Wish,
        text: (&str, f32, Color32),
        width: f32,
    ) -> Option<Rect> {
        let (usual, smaller) = SHAPES.split_at(USUAL);
        self.paint_in_shape(layout, wish, text, width, &[usual, smaller, &CUT[..]])
    }

    /// Tries the shapes of each group, first beside the hole and then over it.
    fn paint_in_shape(
        mut self,
        layout: &mut Layout,
        wish: Wish,
        (text, size, colour): (&str, f32, Color32),
        width: f32,
        groups: &[&[Shape]],
    ) -> Option<Rect> {
        let width = width.min(layout.bounds().width() - 2.0 * PADDING.x);
        let beside = Wish {
            covers_hole: false,
            ..wish
        };
        let tries = groups.iter().copied().flat_map(|shapes| {
            [beside, wish].map(|wish| shapes.iter().map(move |shape| (wish, *shape)))
        });
        for (wish, (share, smaller, rows)) in tries.flatten() {
            let font = FontId::proportional(smaller * size);
            let mut job = LayoutJob::simple(text.to_owned(), font, colour, share * width);
            job.wrap.max_rows = rows;
            let galley = self.painter.layout_job(job);
            self.size = galley.size();
            if layout.wished(self.size(), wish).is_some() {
                self.texts = vec![(Vec2::ZERO, galley)];
                return self.paint(layout, wish);
            }
        }
        None
    }
}
