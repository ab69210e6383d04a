//! Asks the question of a mission after its goals were reached, before the card that tells the answer.

use crate::app::controls::bindings::Bindings;
use crate::app::motion::ship::ShipFlight;
use crate::app::state::end_card::EndCard;
use crate::app::state::missions::{AskedQuestion, Missions};
use crate::app::state::preferences::Preferences;
use crate::app::state::toast::Toast;
use crate::app::ui::hud::question_field::{Step, show_answer_field};
use crate::app::ui::layout::Slide;
use crate::app::ui::screen::{Screen, show_scrolled, text_box};
use bevy::prelude::*;
use bevy_egui::egui;

/// Name of the card, which is its egui area.
const NAME: &str = "question";
/// Largest width of the card, in points.
const MAX_WIDTH: f32 = 330.0;
/// Room inside its edges, in points.
const EDGE: f32 = 14.0;
/// The size of the card before its first frame, in points.
const FIRST_SIZE: egui::Vec2 = egui::vec2(MAX_WIDTH, 120.0);

pub(in crate::app::ui::hud) fn show_question(
    mut screen: Screen,
    (ship, mut end_card): (Res<ShipFlight>, ResMut<EndCard>),
    mut asked: ResMut<AskedQuestion>,
    mut missions: ResMut<Missions>,
    mut toast: ResMut<Toast>,
    (bindings, preferences): (Res<Bindings>, Res<Preferences>),
) {
    if ship.attempt().is_none() && asked.question().is_some() {
        asked.close();
    }
    let Some(question) = asked.question().cloned() else {
        return;
    };
    let Some((context, layout)) = screen.texts().filter(|_| !end_card.is_open()) else {
        return;
    };
    if !layout.bounds().is_positive() {
        return;
    }
    let room = layout.room_for(MAX_WIDTH.min(layout.bounds().width()));
    let shown = context.memory(|memory| memory.area_rect(NAME));
    let size = shown.map_or(FIRST_SIZE, |shown| shown.size());
    let size = size.min(room.size());
    let wish = layout.at(egui::Align2::RIGHT_CENTER, Slide::Anywhere);
    let place = layout
        .wished(size, wish.even_over_hole())
        .unwrap_or_else(|| egui::Align2::RIGHT_CENTER.align_size_within_rect(size, room));
    layout.take(NAME, place);
    let units = ship.units(&preferences.settings);
    let (mut used, mut closes) = (None, false);
    egui::Area::new(NAME.into())
        .fixed_pos(place.min)
        .order(egui::Order::Foreground)
        .show(context, |ui| {
            ui.set_max_width(MAX_WIDTH.min(room.width()));
            text_box(EDGE, 8.0).show(ui, |ui| {
                // In a low window the card scrolls.
                show_scrolled(ui, room.height() - 2.0 * EDGE, |ui| {
                    let text = bindings.with_keys(&units.in_text(&question.text));
                    ui.label(egui::RichText::new(text).size(15.0));
                    ui.add_space(6.0);
                    ui.horizontal_wrapped(|ui| {
                        let answer = &mut asked.answer;
                        used = Some(show_answer_field(ui, &question, answer, 15.0));
                        closes = ui.button("Close").clicked();
                    });
                    let said = &asked.answer.said;
                    if !said.is_empty() {
                        let said = bindings.with_keys(said);
                        ui.label(egui::RichText::new(said).size(15.0));
                    }
                });
            });
        });
    let Some(step) = used else {
        return;
    };
    if closes || step == Step::IsDone {
        *end_card = asked.close();
    } else if step == Step::Answers {
        let judged = asked.judge(units);
        let kept = judged.map(|result| missions.results.correct_last(result));
        if let Some(Err(fault)) = kept {
            toast.say(fault);
        }
    }
}
