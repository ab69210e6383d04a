//! A board: texts in a dark box, in which they are legible over any picture.

use crate::app::ui::screen::BOX;
use bevy_egui::egui;
use egui::{Align2, Color32, FontId, Galley, LayerId, Order, Painter, Pos2, Rect, Vec2};
use std::sync::Arc;

/// Height of the read-outs with three lines. The toast and the captions are above them.
pub(super) const BOTTOM_ROW: f32 = 76.0;
/// Minimum free width in points for the read-outs and the key hints.
pub(super) const MIN_WIDTH: f32 = 240.0;
/// Size of the text, in points.
pub(super) const TEXT: f32 = 13.5;

/// Colour of the most important texts.
pub(super) const BRIGHT: Color32 = Color32::from_gray(238);
/// Colour of labels and key hints.
pub(super) const QUIET: Color32 = Color32::from_gray(198);
/// Colour of warnings.
pub(super) const WARNING: Color32 = Color32::from_rgb(255, 190, 90);

/// Room between a board's texts and its edge, in points.
const PADDING: Vec2 = Vec2::new(10.0, 6.0);
const CORNER_RADIUS: f32 = 5.0;

/// Texts with their places, to be painted in a box.
pub(super) struct Board {
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
            painter,
            texts: Vec::new(),
            size: Vec2::ZERO,
        }
    }

    /// Puts the board above the panels.
    pub(super) fn raise(&mut self) {
        let name = self.painter.layer_id().id;
        self.painter
            .set_layer_id(LayerId::new(Order::Foreground, name));
    }

    /// Lays a text out in lines of at most `width` points.
    pub(super) fn text(&self, text: &str, size: f32, colour: Color32, width: f32) -> Arc<Galley> {
        let font = FontId::proportional(size);
        self.painter.layout(text.to_owned(), font, colour, width)
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

    /// Width of its texts, in points.
    pub(super) fn width(&self) -> f32 {
        self.size.x
    }

    /// Makes the board at least this wide, so that it keeps its width while its texts change.
    pub(super) fn widen(&mut self, width: f32) {
        self.size.x = self.size.x.max(width);
    }

    /// The board's box with its corner or edge `anchor` at the place `at`.
    pub(super) fn place(&self, anchor: Align2, at: Pos2) -> Rect {
        let place = anchor.anchor_size(at, self.size + 2.0 * PADDING);
        // Whole pixels keep the letters sharp.
        place.translate(place.min.round() - place.min)
    }

    /// Paints the board in the box that [`place`](Self::place) gives. Returns the box.
    pub(super) fn paint(self, anchor: Align2, at: Pos2) -> Rect {
        let place = self.place(anchor, at);
        if !self.texts.is_empty() {
            self.painter.rect_filled(place, CORNER_RADIUS, BOX);
        }
        for (offset, text) in self.texts {
            self.painter
                .galley(place.min + PADDING + offset, text, BRIGHT);
        }
        place
    }
}
