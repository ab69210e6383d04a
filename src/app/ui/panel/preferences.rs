//! The page of settings, which outlast the program: size of the text, speed, calm, keys and
//! buttons.

use crate::app::controls::bindings::{Bindings, Bound, PadBindings, Switch};
use crate::app::controls::table::Group;
use crate::app::input::gamepad::NO_GAMEPAD;
use crate::app::session::window::Preferences;
use crate::app::state::settings::{Automatic, FRAME_RATES, UI_SCALES};
use crate::storage::{pictures_folder, settings_file};
use bevy::prelude::*;
use bevy_egui::egui;

/// The control that waits for its new key or button, by name.
#[derive(Resource, Default)]
pub struct Rebinding(Option<&'static str>);

impl Rebinding {
    /// Whether one waits; keyboard and gamepad then do nothing else.
    pub fn waits(&self) -> bool {
        self.0.is_some()
    }

    pub(super) fn stop(&mut self) {
        self.0 = None;
    }
}

pub(super) fn show(
    ui: &mut egui::Ui,
    preferences: &mut Preferences,
    bindings: &mut ResMut<Bindings>,
    buttons: &mut ResMut<PadBindings>,
    rebinding: &mut Rebinding,
    keys: &ButtonInput<KeyCode>,
    pads: &Query<&Gamepad>,
) {
    let settings = &mut preferences.settings;
    ui.strong("Comfort");
    egui::Grid::new("comfort").num_columns(2).spacing([12.0, 6.0]).show(ui, |ui| {
        ui.label("size of text and panel");
        // Changed where it is let go, or the slider would run away under the mouse.
        let mut scale = ui.data(|data| data.get_temp(scale_id())).unwrap_or(settings.ui_scale);
        let slider = ui.add(egui::Slider::new(&mut scale, UI_SCALES[0]..=UI_SCALES[1]).step_by(0.05).fixed_decimals(2));
        if slider.dragged() {
            ui.data_mut(|data| data.insert_temp(scale_id(), scale));
        } else {
            ui.data_mut(|data| data.remove::<f32>(scale_id()));
            settings.ui_scale = scale;
        }
        ui.end_row();
        ui.label("reduced motion").on_hover_text("No roll in journeys, no exposure that changes by itself");
        ui.checkbox(&mut settings.reduced_motion, "");
        ui.end_row();
        ui.label("coarser while moving").on_hover_text(
            "While something moves, the picture is drawn with fewer pixels, as few as hold the frame rate; what stands \
             still is drawn in full. auto: on software and integrated graphics",
        );
        ui.horizontal(|ui| {
            for (value, text) in [(Automatic::Auto, "auto"), (Automatic::On, "on"), (Automatic::Off, "off")] {
                ui.selectable_value(&mut settings.automatic_resolution, value, text);
            }
        });
        ui.end_row();
        ui.label("frame rate to hold");
        ui.add(egui::Slider::new(&mut settings.frame_rate, FRAME_RATES[0]..=120.0).integer().suffix(" /s"));
        ui.end_row();
        ui.label("most frames");
        ui.horizontal(|ui| {
            let mut capped = settings.most_frames != 0.0;
            if ui.checkbox(&mut capped, "").changed() {
                settings.most_frames = if capped { 60.0 } else { 0.0 };
            }
            if capped {
                ui.add(
                    egui::Slider::new(&mut settings.most_frames, FRAME_RATES[0]..=FRAME_RATES[1])
                        .integer()
                        .suffix(" /s"),
                );
            } else {
                ui.weak("as the monitor shows");
            }
        });
        ui.end_row();
    });
    ui.separator();
    ui.horizontal(|ui| {
        ui.strong("Keys");
        if ui.button("All as they were").clicked() {
            **bindings = Bindings::default();
            **buttons = PadBindings::default();
        }
    });
    ui.weak("Click on one, then press the new key, or a button of the gamepad; Esc leaves it as it was.");
    if let Some(reason) = NO_GAMEPAD {
        ui.weak(reason);
    }
    capture(bindings, rebinding, keys.get_just_pressed());
    capture(
        buttons,
        rebinding,
        pads.iter().flat_map(Gamepad::get_just_pressed),
    );
    for group in Group::ALL {
        egui::CollapsingHeader::new(group.title()).show(ui, |ui| {
            egui::Grid::new(group.title())
                .spacing([12.0, 4.0])
                .show(ui, |ui| {
                    for (control, _) in bindings
                        .iter()
                        .filter(|(control, _)| control.group == group)
                    {
                        let words = bindings.in_words(control);
                        let waits = rebinding.0 == Some(control.id);
                        let text = match words.as_str() {
                            _ if waits => "press a key",
                            "" => "none",
                            words => words,
                        };
                        if ui
                            .add_sized([110.0, 20.0], egui::Button::selectable(waits, text))
                            .clicked()
                        {
                            rebinding.0 = Some(control.id);
                        }
                        if !pads.is_empty() {
                            ui.weak(buttons.in_words(control));
                        }
                        ui.add(egui::Label::new(control.id).truncate())
                            .on_hover_text(control.does);
                        ui.end_row();
                    }
                });
        });
    }
    ui.separator();
    if let Some(file) = settings_file() {
        ui.weak(format!("Settings are kept in {}", file.display()));
    }
    ui.weak(format!("Screenshots go to {}", pictures_folder().display()));
}

/// The key that binds nothing.
const LEAVE: &str = "Esc";

fn scale_id() -> egui::Id {
    egui::Id::new("scale that is dragged")
}

/// Binds the first of the switches that were just pressed while a control waits for one.
fn capture<'a, S: Switch>(
    bindings: &mut ResMut<Bound<S>>,
    rebinding: &mut Rebinding,
    pressed: impl IntoIterator<Item = &'a S>,
) {
    let Some(id) = rebinding.0 else { return };
    let Some(pressed) = pressed.into_iter().find(|switch| switch.name().is_some()) else {
        return;
    };
    // Esc means to leave it, but where it is that very key's control.
    let leaves = S::named(LEAVE) == Some(*pressed) && id != "fly.escape";
    if !leaves {
        bindings.bind(id, *pressed);
    }
    rebinding.stop();
}
