//! The form of the end card: a column beside the hole, otherwise a strip where a whole one has room, and
//! otherwise a strip in which the words scroll, or everything does.

use super::Shown;
use crate::app::ui::layout::{Layout, Slide};
use bevy_egui::egui::{self, Align2, Id, LayerId, Order, Rect, UiBuilder, Vec2, vec2};

/// Name of the layer in which the card is measured.
const MEASURED: &str = "end card, measured";
/// Largest width of the column and of the strip, in points.
const MAX_WIDTH: f32 = 330.0;
const MAX_STRIP: f32 = 760.0;
/// The least height in which words alone scroll, in points: two lines of the strip.
const MIN_WORDS: f32 = 32.0;
/// A height that no card reaches, in points.
const MAX_HEIGHT: f32 = 1e5;
/// How many free places are tried for the strip, the largest first.
const TRIES: usize = 4;

/// The sizes of the card's parts, in points.
pub(super) struct Style {
    pub(super) is_flat: bool,
    pub(super) margin: f32,
    /// Room between two lines, and between two parts.
    pub(super) spacing: f32,
    pub(super) gap: f32,
    /// Sizes of the letters.
    pub(super) title: f32,
    pub(super) text: f32,
    pub(super) details: f32,
    pub(super) way: f32,
    /// The least size of a button.
    pub(super) button: Vec2,
}

/// The column. Its buttons are as high as a finger needs.
const COLUMN: Style = Style {
    is_flat: false,
    margin: 18.0,
    spacing: 5.0,
    gap: 6.0,
    title: 22.0,
    text: 15.0,
    details: 14.0,
    way: 15.0,
    button: vec2(72.0, 32.0),
};

/// The strip.
const STRIP: Style = Style {
    is_flat: true,
    margin: 6.0,
    spacing: 2.0,
    gap: 2.0,
    title: 14.0,
    text: 12.0,
    details: 12.0,
    way: 12.0,
    button: vec2(48.0, 24.0),
};

/// How the card is shown.
pub(super) struct Form {
    pub(super) style: &'static Style,
    pub(super) place: Rect,
    /// The width in which its lines are wrapped.
    pub(super) width: f32,
    pub(super) scrolls: Scrolls,
}

/// What scrolls of a card that is too high for its place, and the height in which it does, in points.
#[derive(Clone, Copy)]
pub(super) enum Scrolls {
    Nothing,
    Words(f32),
    Everything(f32),
}

/// Chooses the form and the place of a card, which `show` shows.
pub(super) fn choose_form(
    context: &egui::Context,
    layout: &Layout,
    show: impl Fn(&mut egui::Ui, &Style) -> Shown,
) -> Form {
    let measure =
        |style: &Style, width: f32| measured(context, (width, style.is_flat), |ui| show(ui, style));
    let whole = |style: &'static Style, place: Rect, width: f32| Form {
        style,
        place,
        width,
        scrolls: Scrolls::Nothing,
    };
    let width = MAX_WIDTH.min(layout.bounds().width());
    let (column, _) = measure(&COLUMN, width);
    let beside = layout.at(Align2::RIGHT_CENTER, Slide::Anywhere);
    if let Some(place) = layout.wished(column, beside) {
        return whole(&COLUMN, place, width);
    }
    let mut rooms = layout.free_rooms(false);
    rooms.sort_by(|a, b| b.area().total_cmp(&a.area()));
    for room in rooms.into_iter().take(TRIES) {
        let width = room.width().min(MAX_STRIP);
        let (strip, _) = measure(&STRIP, width);
        if strip.x <= room.width() && strip.y <= room.height() {
            return whole(&STRIP, at_foot(strip, room), width);
        }
    }
    if let Some(place) = layout.wished(column, beside.even_over_hole()) {
        return whole(&COLUMN, place, width);
    }
    let room = layout.room_for(width);
    let width = room.width().min(MAX_STRIP);
    let (strip, words) = measure(&STRIP, width);
    let size = strip.min(room.size());
    let left = size.y - (strip.y - words);
    Form {
        scrolls: if size.y >= strip.y {
            Scrolls::Nothing
        } else if left >= MIN_WORDS {
            Scrolls::Words(left)
        } else {
            Scrolls::Everything(size.y - 2.0 * STRIP.margin)
        },
        ..whole(&STRIP, at_foot(size, room), width)
    }
}

/// The middle of the lower edge of a free place, at whole points, which keep the letters sharp.
fn at_foot(size: Vec2, room: Rect) -> Rect {
    let place = Align2::CENTER_BOTTOM.align_size_within_rect(size, room);
    Rect::from_min_size(place.min.round(), size)
}

/// The size of contents that nobody sees, and the height of their words.
fn measured(
    context: &egui::Context,
    (width, is_flat): (f32, bool),
    contents: impl FnOnce(&mut egui::Ui) -> Shown,
) -> (Vec2, f32) {
    let place = Rect::from_min_size(context.content_rect().min, vec2(width, MAX_HEIGHT));
    let builder = UiBuilder::new()
        .layer_id(LayerId::new(Order::Background, Id::new(MEASURED)))
        .max_rect(place)
        .invisible();
    // Each form and width has a state of its own.
    let id = Id::new((MEASURED, is_flat, width.to_bits()));
    let mut ui = egui::Ui::new(context.clone(), id, builder);
    let shown = contents(&mut ui);
    (ui.min_rect().size(), shown.words)
}
