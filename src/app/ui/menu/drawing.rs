//! Draws the menu, and lets the mouse operate it.

use super::actions::MenuActions;
use crate::app::controls::bindings::Bindings;
use crate::app::state::menu::{Menu, MenuEntry, MenuList};
use crate::app::state::preferences::Preferences;
use crate::app::ui::theme::{ACCENT, TEXT, WEAK_TEXT};
use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};
use egui::{Align2, Color32, FontId, Sense};

/// Width of the first list and of those of places, missions and lessons, in points.
const WIDTH: f32 = 300.0;
const LIST_WIDTH: f32 = 640.0;
/// Usual and minimum height of an entry, in points.
const ENTRY_HEIGHT: f32 = 34.0;
const MIN_ENTRY_HEIGHT: f32 = 21.0;
/// Room around the entries, and height of the title and of the line below them, in points.
const PADDING: f32 = 14.0;
const TITLE_HEIGHT: f32 = 38.0;
const HINT_HEIGHT: f32 = 28.0;
/// The same where the line may be two: what a mission or a lesson teaches.
const TALL_HINT_HEIGHT: f32 = 46.0;
/// An entry, and the words at its left and its right.
type Row = (MenuEntry, [String; 2]);
/// Colour that darkens the picture behind the menu.
const SHADE: Color32 = Color32::from_black_alpha(130);

pub(super) fn show_menu(
    mut contexts: EguiContexts,
    (bindings, preferences): (Res<Bindings>, Res<Preferences>),
    mut actions: MenuActions,
) -> Result {
    if !actions.menu.is_open() {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let screen = context.content_rect();
    let mut clicked = None;
    egui::Area::new("menu".into())
        .order(egui::Order::Foreground)
        .fixed_pos(screen.min)
        .constrain(false)
        .show(context, |ui| {
            // The shade takes every click beside the menu.
            ui.painter().rect_filled(screen, 0.0, SHADE);
            ui.allocate_rect(screen, Sense::click_and_drag());
            let title = match actions.menu.list() {
                MenuList::Main => "Lightfall",
                MenuList::Places => "Places",
                MenuList::Missions(_) => "Missions",
                MenuList::Lessons(_) => "Lessons",
            };
            let settings = &preferences.settings;
            let hint = actions.hint(&bindings, settings);
            let entries = actions.menu.entries();
            let rows: Vec<Row> = entries
                .into_iter()
                .map(|entry| (entry, actions.words(entry, &bindings, settings)))
                .collect();
            let frame = menu_frame(screen, &actions.menu);
            ui.painter()
                .rect_filled(frame, 10.0, Color32::from_rgb(12, 12, 16));
            let mut inside = ui.new_child(egui::UiBuilder::new().max_rect(frame.shrink(PADDING)));
            clicked = show_entries(&mut inside, [title, &hint], &mut actions.menu, &rows);
        });
    if let Some(entry) = clicked {
        actions.choose(entry);
    }
    Ok(())
}

/// The box of the menu on a screen.
pub(crate) fn menu_frame(screen: egui::Rect, menu: &Menu) -> egui::Rect {
    let width = match menu.list() {
        MenuList::Main => WIDTH,
        MenuList::Places | MenuList::Missions(_) | MenuList::Lessons(_) => LIST_WIDTH,
    };
    let entries = ENTRY_HEIGHT * menu.entries().len() as f32;
    let (hint, _) = hint_size(menu.list());
    let height = entries + 2.0 * PADDING + TITLE_HEIGHT + hint;
    let size = egui::vec2(width, height).min(screen.size() - egui::Vec2::splat(16.0));
    egui::Rect::from_center_size(screen.center(), size)
}

/// The height of the words below the entries, in points, and the most lines of them.
fn hint_size(list: MenuList) -> (f32, usize) {
    match list {
        MenuList::Main | MenuList::Places => (HINT_HEIGHT, 1),
        MenuList::Missions(_) | MenuList::Lessons(_) => (TALL_HINT_HEIGHT, 2),
    }
}

/// Shows the title, the entries and a line about the keys. The line and the title are left out where they
/// would leave no room for all entries. Returns the entry that was clicked.
fn show_entries(
    ui: &mut egui::Ui,
    [title, hint]: [&str; 2],
    menu: &mut Menu,
    rows: &[Row],
) -> Option<MenuEntry> {
    let mut clicked = None;
    ui.spacing_mut().item_spacing.y = 0.0;
    let spare = ui.available_height() - MIN_ENTRY_HEIGHT * rows.len() as f32;
    if spare >= TITLE_HEIGHT {
        ui.label(egui::RichText::new(title).size(20.0).color(ACCENT));
        ui.add_space(10.0);
    }
    let (hint_height, lines) = hint_size(menu.list());
    let has_hint = spare >= TITLE_HEIGHT + hint_height;
    let room = ui.available_height() - if has_hint { hint_height } else { 0.0 };
    let height = (room / rows.len() as f32).clamp(MIN_ENTRY_HEIGHT, ENTRY_HEIGHT);
    egui::ScrollArea::vertical()
        .max_height(room)
        .min_scrolled_height(0.0)
        .auto_shrink([false, true])
        .show(ui, |ui| {
            for (entry, words) in rows {
                let selected = menu.selected() == *entry;
                let response = show_entry(ui, words, height, selected);
                if response.hovered() && ui.input(|input| input.pointer.is_moving()) {
                    menu.select(*entry);
                }
                if selected && !response.hovered() {
                    response.scroll_to_me(None);
                }
                if response.clicked() {
                    clicked = Some(*entry);
                }
            }
        });
    if !has_hint {
        return clicked;
    }
    ui.add_space(10.0);
    let font = FontId::proportional(12.5);
    let width = ui.available_width();
    let mut hint = egui::text::LayoutJob::simple(hint.to_owned(), font, WEAK_TEXT, width);
    // What is longer ends in an ellipsis.
    hint.wrap.max_rows = lines;
    let hint = ui.painter().layout_job(hint);
    let (area, _) = ui.allocate_exact_size(hint.size(), Sense::hover());
    ui.painter().galley(area.min, hint, WEAK_TEXT);
    clicked
}

/// Shows one entry: its name at the left, its key or what was reached at the right.
fn show_entry(
    ui: &mut egui::Ui,
    [name, key]: &[String; 2],
    height: f32,
    selected: bool,
) -> egui::Response {
    let size = egui::vec2(ui.available_width(), height);
    let (area, response) = ui.allocate_exact_size(size, Sense::click());
    let painter = ui.painter();
    if selected {
        painter.rect_filled(area, 5.0, ACCENT.gamma_multiply(0.16));
        let bar = egui::Rect::from_min_size(area.min, egui::vec2(3.0, area.height()));
        painter.rect_filled(bar, 1.5, ACCENT);
    }
    let colour = if selected { Color32::WHITE } else { TEXT };
    let inside = area.shrink2(egui::vec2(12.0, 0.0));
    let key = painter.text(
        inside.right_center(),
        Align2::RIGHT_CENTER,
        key,
        FontId::proportional(13.0),
        WEAK_TEXT,
    );
    // A name that is too long ends in an ellipsis before the key.
    let mut name =
        egui::text::LayoutJob::simple_singleline(name.clone(), FontId::proportional(16.0), colour);
    name.wrap = egui::text::TextWrapping::truncate_at_width(key.left() - 12.0 - inside.left());
    let name = painter.layout_job(name);
    let at = inside.left_center() - egui::vec2(0.0, 0.5 * name.size().y);
    painter.galley(at, name, colour);
    response
}
