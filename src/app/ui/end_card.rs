//! Draws the end card beside the hole, and lets mouse and fingers use what it offers.

mod form;

use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::controls::control::{Action, AppCommand};
use crate::app::controls::statement::capitalised;
use crate::app::controls::table::control_named;
use crate::app::state::end_card::{CardButtons, Closes, EndCard, Lamp, LampKind, Way};
use crate::app::state::helm::CommandSender;
use crate::app::ui::layout::Importance;
use crate::app::ui::screen::{Screen, show_scrolled, text_box};
use bevy::prelude::*;
use bevy_egui::{EguiPrimaryContextPass, egui};
use form::{Scrolls, Style, choose_form};

/// Name of the card, which is its egui area.
const NAME: &str = "end card";
/// Colour of the names of keys.
const KEY: egui::Color32 = egui::Color32::from_rgb(255, 205, 120);
/// Colours of the other words.
const WHITE: egui::Color32 = egui::Color32::from_gray(240);
const GREY: egui::Color32 = egui::Color32::from_gray(215);
/// Colours of the lamps that are lit.
const GOALS: egui::Color32 = egui::Color32::from_rgb(90, 225, 120);
const PAR: egui::Color32 = egui::Color32::from_rgb(255, 200, 60);
const TIME: egui::Color32 = egui::Color32::from_rgb(110, 190, 255);

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        EguiPrimaryContextPass,
        show_end_card.in_set(Importance::Cards),
    );
}

/// A way on: its keys, what it does, and what a click on it sends. The keys that fly have no button.
struct ShownWay {
    inputs: String,
    does: String,
    command: Option<AppCommand>,
}

/// What was shown.
struct Shown {
    /// What was clicked.
    used: Option<AppCommand>,
    buttons: Vec<egui::Rect>,
    /// The height of the words above the ways, in points.
    words: f32,
}

fn show_end_card(
    mut screen: Screen,
    mut end_card: ResMut<EndCard>,
    mut buttons: ResMut<CardButtons>,
    (bindings, pad_bindings): (Res<Bindings>, Res<PadBindings>),
    pads: Query<&Gamepad>,
    mut commands: CommandSender,
) {
    buttons.0.clear();
    let Some((context, layout)) = screen.texts().filter(|_| end_card.is_open()) else {
        return;
    };
    if !layout.bounds().is_positive() {
        return;
    }
    // The keys of a control and, with a gamepad, its buttons.
    let inputs = |id: &str| {
        let keys = match id {
            "preset.next" => ["preset.1", "preset.9"]
                .map(|id| bindings.label(id))
                .join(" to "),
            _ => bindings.label(id),
        };
        let buttons = match id {
            // At the ship's controls this button holds the orbit.
            "journey.fly" if commands.helm.has_ship() => String::new(),
            _ => pad_bindings.label(id),
        };
        match (pads.is_empty() || buttons.is_empty(), keys.is_empty()) {
            (true, _) => keys,
            (false, true) => buttons,
            (false, false) => format!("{keys} or {buttons}"),
        }
    };
    let way = |(id, does): &Way| {
        let command = command_of(id).filter(|_| end_card.closes != Closes::Flying);
        ShownWay {
            inputs: inputs(id),
            does: match command {
                Some(_) => capitalised(does),
                None => (*does).to_owned(),
            },
            command,
        }
    };
    let mut ways: Vec<ShownWay> = end_card.ways.iter().map(way).collect();
    ways.retain(|way| way.command.is_some() || !way.inputs.is_empty());
    let (card, ways): (&EndCard, &[ShownWay]) = (&end_card, &ways);
    let form = choose_form(context, layout, |ui, style| {
        show(ui, (card, ways), style, Scrolls::Nothing)
    });
    layout.take(NAME, form.place);
    let shown = egui::Area::new(NAME.into())
        .fixed_pos(form.place.min)
        .constrain(false)
        .fade_in(false)
        .order(egui::Order::Foreground)
        .show(context, |ui| {
            ui.set_max_width(form.width);
            show(ui, (card, ways), form.style, form.scrolls)
        })
        .inner;
    // A card that scrolls may be dragged anywhere.
    let kept = match form.scrolls {
        Scrolls::Nothing => shown.buttons,
        Scrolls::Words(_) | Scrolls::Everything(_) => vec![form.place],
    };
    let zoom = context.zoom_factor();
    let in_pixels = |place: egui::Rect| {
        let [[left, top], [right, bottom]] = [place.min, place.max].map(|at| [at.x, at.y]);
        Rect::new(zoom * left, zoom * top, zoom * right, zoom * bottom)
    };
    buttons.0 = kept.into_iter().map(in_pixels).collect();
    if let Some(command) = shown.used {
        commands.send(command);
        if end_card.closes == Closes::Anything {
            end_card.close();
        }
    }
}

/// The command that a control sends, if it sends one.
fn command_of(id: &str) -> Option<AppCommand> {
    match control_named(id)?.action {
        Action::Do(command) => Some(command),
        _ => None,
    }
}

fn words(text: &str, size: f32, colour: egui::Color32) -> egui::RichText {
    egui::RichText::new(text).size(size).color(colour)
}

/// Shows the card. Where its words scroll, the ways stay below them.
fn show(
    ui: &mut egui::Ui,
    (card, ways): (&EndCard, &[ShownWay]),
    style: &Style,
    scrolls: Scrolls,
) -> Shown {
    let mut shown = Shown {
        used: None,
        buttons: Vec::new(),
        words: 0.0,
    };
    text_box(style.margin, 8.0).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = style.spacing;
        let mut show_all = |ui: &mut egui::Ui, most: Option<f32>| {
            shown.words = match most {
                Some(most) => show_scrolled(ui, most, |ui| show_words(ui, card, style)),
                None => {
                    let words = ui.scope(|ui| show_words(ui, card, style));
                    words.response.rect.height()
                }
            };
            ui.add_space(style.gap);
            show_ways(ui, ways, style, &mut shown);
        };
        match scrolls {
            Scrolls::Nothing => show_all(ui, None),
            Scrolls::Words(most) => show_all(ui, Some(most)),
            Scrolls::Everything(most) => {
                show_scrolled(ui, most, |ui| show_all(ui, None));
            }
        }
    });
    shown
}

/// Shows the ways on: one below the other in the column, and in lines in the strip.
fn show_ways(ui: &mut egui::Ui, ways: &[ShownWay], style: &Style, shown: &mut Shown) {
    if style.is_flat {
        ui.horizontal_wrapped(|ui| {
            for way in ways {
                // A key stays beside its button.
                if ui.available_size_before_wrap().x < width_of(ui, way, style) {
                    ui.end_row();
                }
                show_way(ui, way, style, shown);
                ui.add_space(6.0);
            }
        });
        return;
    }
    let grid = egui::Grid::new("ways").num_columns(2);
    grid.spacing([16.0, 5.0]).show(ui, |ui| {
        for way in ways {
            show_way(ui, way, style, shown);
            ui.end_row();
        }
    });
}

/// The width of the keys of a way and its button, in points.
fn width_of(ui: &egui::Ui, way: &ShownWay, style: &Style) -> f32 {
    let font = egui::FontId::proportional(style.way);
    let width = |text: &str| {
        let text = text.to_owned();
        let laid_out = ui.fonts_mut(|fonts| fonts.layout_no_wrap(text, font.clone(), WHITE));
        laid_out.size().x
    };
    let spacing = ui.spacing();
    let button = width(&way.does) + 2.0 * spacing.button_padding.x;
    width(&way.inputs) + spacing.item_spacing.x + button.max(style.button.x)
}

/// Shows the keys of a way, and what it does.
fn show_way(ui: &mut egui::Ui, way: &ShownWay, style: &Style, shown: &mut Shown) {
    ui.label(words(&way.inputs, style.way, KEY));
    let does = words(&way.does, style.way, WHITE);
    let Some(command) = way.command else {
        ui.label(does);
        return;
    };
    let button = ui.add(egui::Button::new(does).min_size(style.button));
    shown.buttons.push(button.rect);
    if button.clicked() {
        shown.used = Some(command);
    }
}

/// Shows what the card says above the ways.
fn show_words(ui: &mut egui::Ui, card: &EndCard, style: &Style) {
    ui.label(words(&card.title, style.title, WHITE));
    ui.add_space(style.gap);
    if !card.text.is_empty() {
        ui.label(words(&card.text, style.text, GREY));
        ui.add_space(style.gap);
    }
    show_lamps(ui, &card.lamps, style.text);
    if !card.details.is_empty() {
        ui.add_space(style.gap);
        ui.label(words(&card.details, style.details, GREY));
    }
}

/// Shows the lamps, each with its name and what it needed.
fn show_lamps(ui: &mut egui::Ui, lamps: &[Lamp], size: f32) {
    for lamp in lamps {
        let lit = match lamp.kind {
            LampKind::Goals => GOALS,
            LampKind::Par => PAR,
            LampKind::Time => TIME,
        };
        let (sign, colour) = if lamp.is_lit {
            ("●", lit)
        } else {
            ("○", GREY)
        };
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.label(words(sign, 1.3 * size, colour));
            ui.label(words(lamp.kind.word(), size, WHITE).strong());
            ui.label(words(&lamp.needed, 0.9 * size, GREY));
        });
    }
}
