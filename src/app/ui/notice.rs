//! Draws the large lines over the picture: a notice, or why the picture is black and which keys help.

use crate::app::controls::bindings::Bindings;
use crate::app::motion::steering::is_inside;
use crate::app::state::end_card::EndCard;
use crate::app::state::helm::Helm;
use crate::app::state::hole_in_view::HoleInView;
use crate::app::state::notice::Notice;
use crate::app::ui::layout::{Importance, Layout, Slide};
use crate::app::ui::screen::{Screen, show_placed, text_box};
use bevy::prelude::*;
use bevy_egui::{EguiPrimaryContextPass, egui};
use egui::RichText;
use lightfall_core::scene::Scene;
use lightfall_render::CurrentScene;

/// Sizes of the two lines, in points.
const TITLE_SIZE: f32 = 28.0;
const TEXT_SIZE: f32 = 15.0;
/// Colours of the two lines.
const TITLE: egui::Color32 = egui::Color32::from_gray(238);
const TEXT: egui::Color32 = egui::Color32::from_gray(200);
/// Distance of a notice from the top, as a share of the window's height: above the hole.
const NOTICE_HEIGHT: f32 = 0.12;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        EguiPrimaryContextPass,
        show_notice.in_set(Importance::Cards),
    );
}

fn show_notice(
    mut screen: Screen,
    scene: Res<CurrentScene>,
    notice: Res<Notice>,
    hole: Res<HoleInView>,
    end_card: Res<EndCard>,
    (bindings, helm): (Res<Bindings>, Res<Helm>),
) {
    let Some((context, layout)) = screen.texts().filter(|_| !end_card.is_open()) else {
        return;
    };
    if let Some([title, text]) = notice.lines {
        draw(context, layout, title, text);
    } else if hole.0.is_some_and(|hole| hole.fills_view) && !helm.has_ship() {
        // A ship's pilot knows where the hole is, and these keys do other things there.
        let text = way_out(is_inside(&scene), &bindings);
        draw(context, layout, "The hole fills the view", &text);
    } else if scene.view.shows_light() && !scene.shines() {
        let text = way_to_light(&scene, &bindings);
        draw(context, layout, "Nothing shines here", &text);
    }
}

/// The keys that bring light. A key helps only where the brightness is not zero.
fn way_to_light(scene: &Scene, bindings: &Bindings) -> String {
    let lights = [
        ("scene.disk", "disk", scene.disk.brightness),
        ("scene.sky", "sky", scene.sky.brightness),
    ];
    let keys: Vec<_> = lights
        .into_iter()
        .filter(|(_, _, brightness)| *brightness > 0.0)
        .map(|(id, name, _)| format!("{} shows the {name}", bindings.first_label(id)))
        .collect();
    if keys.is_empty() {
        let panel = bindings.first_label("window.panel");
        return format!("The brightness of disk and sky is 0: {panel} opens the panel");
    }
    keys.join("  ·  ")
}

/// The keys that lead out of a black picture.
fn way_out(inside: bool, bindings: &Bindings) -> String {
    let [face, away, undo] =
        ["fly.face", "fly.backward", "scene.undo"].map(|id| bindings.label(id));
    if inside {
        return format!("{face} faces the light at its edge  ·  {undo} returns");
    }
    format!("{face} faces outward  ·  {away} backs away  ·  {undo} returns")
}

/// Draws two lines above the middle of the picture.
fn draw(context: &egui::Context, layout: &mut Layout, title: &str, text: &str) {
    let mut wish = layout
        .at(egui::Align2::CENTER_TOP, Slide::Anywhere)
        .even_over_hole();
    wish.at.y += NOTICE_HEIGHT * layout.bounds().height();
    show_placed(context, layout, "notice", wish, |ui| {
        text_box(16.0, 10.0).show(ui, |ui| {
            ui.label(RichText::new(title).size(TITLE_SIZE).color(TITLE));
            ui.add_space(4.0);
            ui.label(RichText::new(text).size(TEXT_SIZE).color(TEXT));
        });
    });
}
