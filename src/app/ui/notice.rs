//! Draws the large lines over the picture: a notice, or why the picture is black and which keys help.

use crate::app::controls::bindings::Bindings;
use crate::app::motion::steering::is_inside;
use crate::app::state::end_card::EndCard;
use crate::app::state::hole_in_view::HoleInView;
use crate::app::state::menu::Menu;
use crate::app::state::notice::Notice;
use crate::app::state::overlays::Overlays;
use crate::app::ui::screen::Screen;
use bevy::prelude::*;
use bevy_egui::{EguiPrimaryContextPass, egui};
use egui::RichText;
use lightfall_render::CurrentScene;

/// Sizes of the two lines, in points.
const TITLE_SIZE: f32 = 28.0;
const TEXT_SIZE: f32 = 15.0;
/// Colours of the two lines.
const TITLE: egui::Color32 = egui::Color32::from_gray(238);
const TEXT: egui::Color32 = egui::Color32::from_gray(200);
/// Height of a notice from the top, as a share of the window's height: above the hole.
const NOTICE_HEIGHT: f32 = 0.2;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show_notice);
}

fn show_notice(
    mut screen: Screen,
    scene: Res<CurrentScene>,
    notice: Res<Notice>,
    hole: Res<HoleInView>,
    (end_card, menu): (Res<EndCard>, Res<Menu>),
    overlays: Res<Overlays>,
    bindings: Res<Bindings>,
) {
    let is_covered = overlays.help || end_card.is_open() || menu.is_open();
    let Some((context, room)) = screen.room().filter(|_| !is_covered) else {
        return;
    };
    let middle = room.center();
    if let Some([title, text]) = notice.lines {
        let height = NOTICE_HEIGHT * context.content_rect().height();
        draw(context, egui::pos2(middle.x, height), title, text);
    } else if hole.0.is_some_and(|hole| hole.fills_view) {
        let text = way_out(is_inside(&scene), &bindings);
        draw(context, middle, "The hole fills the view", &text);
    } else if scene.view.shows_light() && !scene.shines() {
        let [disk, sky] = ["scene.disk", "scene.sky"].map(|id| bindings.first_label(id));
        let text = format!("{disk} shows the disk  ·  {sky} shows the sky");
        draw(context, middle, "Nothing shines here", &text);
    }
}

/// The keys that lead out of a black picture.
fn way_out(inside: bool, bindings: &Bindings) -> String {
    let [face, away, undo] =
        ["fly.face", "fly.backward", "scene.undo"].map(|id| bindings.label(id));
    let away = if inside {
        String::new()
    } else {
        format!("{away} backs away  ·  ")
    };
    format!("{face} faces outward  ·  {away}{undo} returns")
}

/// Draws two lines around this point.
fn draw(context: &egui::Context, middle: egui::Pos2, title: &str, text: &str) {
    egui::Area::new("notice".into())
        .pivot(egui::Align2::CENTER_CENTER)
        .fixed_pos(middle)
        .interactable(false)
        .order(egui::Order::Background)
        .show(context, |ui| {
            ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
            let frame = egui::Frame::new()
                .fill(egui::Color32::from_black_alpha(215))
                .inner_margin(egui::Margin::symmetric(24, 16))
                .corner_radius(10);
            frame.show(ui, |ui| {
                ui.vertical_centered(|ui| {
                    ui.label(RichText::new(title).size(TITLE_SIZE).color(TITLE));
                    ui.add_space(4.0);
                    ui.label(RichText::new(text).size(TEXT_SIZE).color(TEXT));
                });
            });
        });
}
