//! The card of the stop at which a lesson waits: its lines, its question, and what goes on.

use super::board::{BRIGHT, QUIET, WARNING};
use super::question_field::{Step, show_answer_field};
use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::controls::control::AppCommand;
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::state::helm::CommandSender;
use crate::app::state::lesson_results::LessonAnswer;
use crate::app::state::preferences::Preferences;
use crate::app::state::result_file::time_now;
use crate::app::state::toast::Toast;
use crate::app::state::typed_answer::TypedAnswer;
use crate::app::ui::layout::{Layout, Slide, Wish};
use crate::app::ui::screen::{MARGIN, Screen, show_scrolled, text_box};
use bevy::prelude::*;
use bevy_egui::egui::{self, Align2, Color32, RichText, vec2};
use lightfall_core::scene::{JudgedAnswer, Question};
use lightfall_platform::storage::lesson_results_file;

/// Name of the card, which is its egui area.
const NAME: &str = "stop";
/// Largest width of the card, in points.
const MAX_WIDTH: f32 = 780.0;
/// Size of the caption, in points. It follows the text size of the settings alone, in every window.
const SIZE: f32 = 19.0;
/// The largest share of the free height that the card takes, and the least height of its caption, for which
/// it takes more: three lines. What is longer scrolls.
const MAX_SHARE: f32 = 0.5;
const MIN_CAPTION: f32 = 3.0 * 1.35 * SIZE;
/// Size of the other words against the caption's.
const SMALL: f32 = 0.75;
/// Room for the toast below the card, in points.
const TOAST: f32 = 44.0;

/// What is known of the card, and the answer to its question.
#[derive(Default)]
pub(super) struct Card {
    /// The stop's number, and when it is.
    stop: Option<(usize, f64)>,
    answer: TypedAnswer,
    /// Height of the card without its caption as shown last, in points.
    rest: f32,
}

pub(super) fn show_stop(
    mut screen: Screen,
    mut player: ResMut<JourneyPlayer>,
    (bindings, pads, connected): (Res<Bindings>, Res<PadBindings>, Query<&Gamepad>),
    preferences: Res<Preferences>,
    mut card: Local<Card>,
    (mut commands, mut toast): (CommandSender, ResMut<Toast>),
) {
    let Some((stop, number)) = player.waits_at() else {
        return;
    };
    let Some((context, layout)) = screen.texts() else {
        return;
    };
    let is = Some((number, stop.time));
    if card.stop != is {
        *card = Card {
            stop: is,
            ..Card::default()
        };
    }
    let journey = player.journey();
    let head = format!("{number} of {}", journey.stops.len());
    let head = match journey.title.trim() {
        "" => head,
        title => format!("{} · {head}", bindings.with_keys(title)),
    };
    let with_pad = !connected.is_empty();
    let key = |key: &str, button: &str| match with_pad {
        true => pads.label(button),
        false => bindings.first_label(key),
    };
    let back = (number > 1).then(|| key("preset.previous", "preset.previous"));
    let keys = [key("fly.up", "journey.fly"), back.unwrap_or_default()];
    // Panels may leave no room at all: then the card lies over them.
    let room = match layout.bounds().is_positive() {
        true => layout.room_for(MAX_WIDTH.min(layout.bounds().width())),
        false => context.content_rect().shrink(MARGIN),
    };
    let width = MAX_WIDTH.min(room.width());
    let usual = MAX_SHARE * room.height();
    let most = usual.max(card.rest + MIN_CAPTION).min(room.height());
    let shown = context.memory(|memory| memory.area_rect(NAME));
    let size = shown.map_or(vec2(width, 120.0), |shown| shown.size());
    let place = place_of(layout, size.min(vec2(room.width(), most)), room);
    layout.take(NAME, place);
    let (mut command, mut judged, mut caption_height) = (None, None, 0.0);
    let drawn = egui::Area::new(NAME.into())
        .fixed_pos(place.min)
        .constrain(false)
        .order(egui::Order::Foreground)
        .show(context, |ui| {
            ui.set_max_width(width);
            text_box(12.0, 8.0).show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 0.35 * SIZE;
                if !stop.caption.is_empty() {
                    let caption = bindings.with_keys(&stop.caption);
                    // Each stop begins at its first line.
                    ui.push_id(number, |ui| {
                        caption_height = show_scrolled(ui, most - card.rest, |ui| {
                            ui.label(words(&caption, SIZE, BRIGHT));
                        });
                    });
                }
                if let Some(question) = &stop.question {
                    let asked = ask(ui, question, (&mut card.answer, &*bindings));
                    command = asked.goes_on.then_some(AppCommand::GoOn);
                    judged = asked.judged;
                }
                command = command.or(show_ways(ui, (keys, &head)));
            });
        });
    // Next frame the caption makes room for the rest.
    let rest = drawn.response.rect.height() - caption_height;
    if (card.rest - rest).abs() > 0.5 {
        card.rest = rest;
        context.request_repaint();
    }
    if let Some(command) = command {
        commands.send(command);
    }
    if let Some(judged) = judged {
        let pupil = preferences.settings.pupil.as_str();
        keep(&mut player, (&judged, pupil), |fault| toast.say(fault));
    }
}

/// Notes an answer, and keeps it with the pupil's name in the file of results, if there is one.
fn keep(
    player: &mut JourneyPlayer,
    (judged, pupil): (&JudgedAnswer, &str),
    say: impl FnOnce(String),
) {
    let Some(noted) = player.note_answer(judged.is_right) else {
        return;
    };
    let answer = LessonAnswer {
        lesson: player.journey().title.clone(),
        question: noted.question,
        answer: judged.number,
        is_right: judged.is_right,
        tries: noted.tries,
        time: time_now(),
        pupil: pupil.into(),
    };
    let kept = lesson_results_file().map(|file| answer.keep(&file));
    if let Some(Err(fault)) = kept {
        say(fault);
    }
}

/// The place of a card of this size: above the toast and beside the hole, and otherwise as low over the hole
/// as the read-outs allow.
fn place_of(layout: &Layout, size: egui::Vec2, room: egui::Rect) -> egui::Rect {
    let beside_hole = Wish {
        covers_hole: false,
        ..layout.above_read_outs(TOAST)
    };
    let over_hole = layout.above_read_outs(0.0);
    let lowest = layout.at(Align2::CENTER_BOTTOM, Slide::Anywhere);
    [beside_hole, over_hole, lowest.even_over_hole()]
        .into_iter()
        .find_map(|wish| layout.wished(size, wish))
        .unwrap_or_else(|| Align2::CENTER_BOTTOM.align_size_within_rect(size, room))
}

fn words(text: &str, size: f32, colour: Color32) -> RichText {
    RichText::new(text).size(size).color(colour)
}

/// What was done at a question.
struct Asked {
    /// Whether the lesson goes on.
    goes_on: bool,
    /// The answer that was given, if it is a number.
    judged: Option<JudgedAnswer>,
}

/// Asks the question and judges the answer.
fn ask(
    ui: &mut egui::Ui,
    question: &Question,
    (answer, bindings): (&mut TypedAnswer, &Bindings),
) -> Asked {
    let text = bindings.with_keys(&question.text);
    ui.label(words(&text, 0.9 * SIZE, BRIGHT));
    let line = ui.horizontal(|ui| {
        let step = show_answer_field(ui, question, answer, 0.9 * SIZE);
        let said = bindings.with_keys(&answer.said);
        ui.label(words(&said, 0.9 * SIZE, WARNING));
        step
    });
    let step = line.inner;
    let judged = match step {
        // The field does not take the keyboard back, so that the keys that go on and back work.
        Step::Answers => answer.judge(question),
        Step::Types | Step::IsDone => None,
    };
    Asked {
        goes_on: step == Step::IsDone,
        judged,
    }
}

/// Shows the buttons that go on and back, with their keys, and the title behind them. Returns what was
/// clicked.
fn show_ways(ui: &mut egui::Ui, (keys, title): ([String; 2], &str)) -> Option<AppCommand> {
    let size = SMALL * SIZE;
    let [on, back] = keys;
    let ways = [
        ("Go on", on, AppCommand::GoOn),
        ("Back", back, AppCommand::GoBack),
    ];
    let mut clicked = None;
    ui.horizontal_wrapped(|ui| {
        for (name, key, command) in ways {
            if command == AppCommand::GoBack && key.is_empty() {
                continue;
            }
            let text = words(name, size, BRIGHT);
            // As high as a finger needs.
            let button = egui::Button::new(text).min_size(vec2(72.0, 34.0));
            if ui.add(button).clicked() {
                clicked = Some(command);
            }
            ui.label(words(&key, size, QUIET));
            ui.add_space(8.0);
        }
        ui.label(words(title, size, WARNING));
    });
    clicked
}
