//! The page of settings, which are kept when the program ends: size of texts, motion, frame rate,
//! keys and buttons.

use super::switch::switch;
use crate::app::controls::bindings::{Bindable, BindingTable, Bindings, PadBindings};
use crate::app::controls::control::{Control, Group};
use crate::app::controls::table::CONTROLS;
use crate::app::input::gamepad::NO_GAMEPAD;
use crate::app::state::rebinding::Rebinding;
use crate::app::state::settings::{
    Automatic, FRAME_RATES, MAX_PUPIL_CHARS, MOUSE_SENSITIVITIES, PictureShape, Settings,
    UI_SCALES, VOLUMES,
};
use crate::app::state::sound::NO_SOUND;
use bevy::prelude::*;
use bevy_egui::egui;
use lightfall_platform::IN_BROWSER;
#[cfg(not(target_arch = "wasm32"))]
use lightfall_platform::storage::{pictures_folder, settings_file};

/// The only control that [`CANCEL`] can be bound to.
const ESCAPE: &str = "fly.escape";
/// The key that keeps the old binding of a control.
const CANCEL: &str = "Esc";

pub(super) fn show(
    ui: &mut egui::Ui,
    settings: &mut Settings,
    bindings: &mut ResMut<Bindings>,
    pad_bindings: &mut ResMut<PadBindings>,
    rebinding: &mut Rebinding,
    keys: &ButtonInput<KeyCode>,
    pads: &Query<&Gamepad>,
    no_sound: Option<&str>,
) {
    comfort(ui, settings, no_sound);
    ui.separator();
    ui.horizontal(|ui| {
        ui.strong("Keys");
        let reset = ui.button("Reset keys");
        let reset = reset.on_hover_text("Every key and button as it was at first");
        if reset.clicked() {
            **bindings = Bindings::with_defaults(bindings.labels());
            **pad_bindings = PadBindings::default();
        }
    });
    ui.weak(format!(
        "Click a key, then press the new key or gamepad button. {CANCEL} keeps the old one."
    ));
    if let Some(reason) = NO_GAMEPAD {
        ui.weak(reason);
    }
    bind_pressed(bindings, rebinding, keys.get_just_pressed());
    let buttons = pads.iter().flat_map(Gamepad::get_just_pressed);
    bind_pressed(pad_bindings, rebinding, buttons);
    let buttons = Some(&**pad_bindings).filter(|_| !pads.is_empty());
    for group in Group::ALL {
        egui::CollapsingHeader::new(group.title())
            .show(ui, |ui| key_table(ui, group, bindings, buttons, rebinding));
    }
    ui.separator();
    for line in places() {
        ui.weak(line);
    }
}

/// Where settings and screenshots are.
#[cfg(not(target_arch = "wasm32"))]
fn places() -> Vec<String> {
    let settings = settings_file().map(|file| format!("Settings are kept in {}", file.display()));
    let screenshots = format!("Screenshots go to {}", pictures_folder().display());
    settings.into_iter().chain([screenshots]).collect()
}

#[cfg(target_arch = "wasm32")]
fn places() -> [&'static str; 2] {
    [
        "Settings are kept in this browser, for this page",
        "Screenshots are downloads",
    ]
}

/// The choices of a setting that can be automatic.
const AUTOMATIC: [(Automatic, &str); 3] = [
    (Automatic::Auto, "Auto"),
    (Automatic::On, "On"),
    (Automatic::Off, "Off"),
];
/// The choices of the picture's shape.
const SHAPES: [(PictureShape, &str); 2] = [
    (PictureShape::Window, "Window"),
    (PictureShape::Preset, "Preset"),
];

/// Shows choices side by side.
fn choose<T: Copy + PartialEq, const N: usize>(
    ui: &mut egui::Ui,
    setting: &mut T,
    choices: [(T, &str); N],
) {
    ui.horizontal(|ui| {
        for (value, text) in choices {
            ui.selectable_value(setting, value, text);
        }
    });
}

/// Shows a slider for frames per second.
fn frame_rate(ui: &mut egui::Ui, setting: &mut f64, highest: f64) {
    let slider = egui::Slider::new(setting, FRAME_RATES[0]..=highest);
    ui.add(slider.integer().suffix(" /s"));
}

fn comfort(ui: &mut egui::Ui, settings: &mut Settings, no_sound: Option<&str>) {
    ui.strong("Comfort");
    egui::Grid::new("comfort")
        .num_columns(2)
        .spacing([12.0, 6.0])
        .show(ui, |ui| {
            ui.label("Text and panel size");
            ui_scale(ui, settings);
            ui.end_row();
            ui.label("Reduced motion")
                .on_hover_text("Journeys do not roll, and the exposure stays as it is during a flight");
            switch(ui, &mut settings.reduced_motion);
            ui.end_row();
            ui.label("Kilometres and minutes").on_hover_text(
                "For a mission's own mass, or the one on the page Read-outs, in place of r_s and r_s/c, and no rows for \
                 specialists",
            );
            switch(ui, &mut settings.simple_words);
            ui.end_row();
            ui.label("Key hints")
                .on_hover_text("The keys for newcomers at the lower right. Unless you choose, they go away after some use");
            let before = settings.key_hints;
            switch(ui, &mut settings.key_hints);
            settings.keep_key_hints |= settings.key_hints != before;
            ui.end_row();
            ui.label("Pixel look")
                .on_hover_text("The picture is shown in large cells of few tones. Presets keep this choice");
            switch(ui, &mut settings.pixel_look);
            ui.end_row();
            ui.label("Picture shape").on_hover_text(
                "The picture fills the window, or it has the preset's own shape with a black frame around it",
            );
            choose(ui, &mut settings.picture_shape, SHAPES);
            ui.end_row();
            ui.label("Mouse sensitivity")
                .on_hover_text("How far the mouse turns the camera, and moves the orbit camera");
            let [low, high] = MOUSE_SENSITIVITIES;
            let slider = egui::Slider::new(&mut settings.mouse_sensitivity, low..=high);
            ui.add(slider.logarithmic(true).fixed_decimals(2));
            ui.end_row();
            ui.label("Invert Y")
                .on_hover_text("Look down when the mouse or the right stick moves up");
            switch(ui, &mut settings.invert_y);
            ui.end_row();
            if NO_SOUND.is_none() {
                ui.label("Volume")
                    .on_hover_text("Of what you hear at the ship's controls: home's beacon, the engine, and clicks for the light");
                volume(ui, &mut settings.volume);
                ui.end_row();
            }
            ui.label("Pupil")
                .on_hover_text("A name that stands in every row of the results of lessons and missions");
            pupil(ui, &mut settings.pupil);
            ui.end_row();
            ui.label("Average frames at rest").on_hover_text(
                "While nothing moves, the picture becomes the mean of 16 frames, whose rays go through other places of each \
                 pixel. Auto: on with a graphics card",
            );
            choose(ui, &mut settings.average_at_rest, AUTOMATIC);
            ui.end_row();
            ui.label("Lower resolution while moving").on_hover_text(
                "While something moves, the picture is drawn with as many pixels as the target frame rate allows. A picture at \
                 rest is drawn in full. Auto: on for software and integrated graphics, and without the pixel look",
            );
            choose(ui, &mut settings.automatic_resolution, AUTOMATIC);
            ui.end_row();
            ui.label("Frame rate while moving");
            frame_rate(ui, &mut settings.frame_rate, 120.0);
            ui.end_row();
            if !IN_BROWSER {
                ui.label("Frame limit");
                frame_rate_limit(ui, settings);
                ui.end_row();
            }
        });
    if let Some(fault) = no_sound {
        ui.weak(fault);
    }
    ui.weak(
        NO_SOUND.unwrap_or(
            "No sound crosses vacuum: what you hear aboard the ship are its instruments.",
        ),
    );
}

/// A field for a name, of one line as the settings file has it.
fn pupil(ui: &mut egui::Ui, setting: &mut String) {
    let edit = egui::TextEdit::singleline(setting)
        .hint_text("none")
        .char_limit(MAX_PUPIL_CHARS)
        .desired_width(180.0);
    if ui.add(edit).changed() {
        setting.retain(|c| !c.is_control());
    }
}

/// A slider for the volume, in percent.
fn volume(ui: &mut egui::Ui, setting: &mut f64) {
    let [low, high] = VOLUMES.map(|volume| 100.0 * volume);
    let mut percent = 100.0 * *setting;
    let slider = egui::Slider::new(&mut percent, low..=high).integer();
    if ui.add(slider.suffix(" %")).changed() {
        *setting = percent / 100.0;
    }
}

/// A slider for the size. The size takes effect when the slider is released, so that the slider does
/// not move under the mouse.
fn ui_scale(ui: &mut egui::Ui, settings: &mut Settings) {
    let id = egui::Id::new("scale being dragged");
    let dragged = ui.data(|data| data.get_temp(id));
    let mut scale = dragged.unwrap_or(settings.ui_scale);
    let slider = egui::Slider::new(&mut scale, UI_SCALES[0]..=UI_SCALES[1])
        .step_by(0.05)
        .fixed_decimals(2);
    if ui.add(slider).dragged() {
        ui.data_mut(|data| data.insert_temp(id, scale));
    } else {
        ui.data_mut(|data| data.remove::<f32>(id));
        settings.ui_scale = scale;
    }
}

fn frame_rate_limit(ui: &mut egui::Ui, settings: &mut Settings) {
    ui.horizontal(|ui| {
        let mut limited = settings.most_frames != 0.0;
        if switch(ui, &mut limited) {
            settings.most_frames = if limited { 60.0 } else { 0.0 };
        }
        if limited {
            frame_rate(ui, &mut settings.most_frames, FRAME_RATES[1]);
        } else {
            ui.weak("as the monitor");
        }
    });
}

/// The controls of a group with their keys and, where there is a gamepad, their buttons. A control
/// whose key is clicked waits for a new one.
fn key_table(
    ui: &mut egui::Ui,
    group: Group,
    bindings: &Bindings,
    pad_bindings: Option<&PadBindings>,
    rebinding: &mut Rebinding,
) {
    let grid = egui::Grid::new(group.title()).spacing([12.0, 4.0]);
    grid.show(ui, |ui| {
        for control in CONTROLS.iter().filter(|control| control.group == group) {
            let keys = bindings.label_of(control);
            let waits = rebinding.0 == Some(control.id);
            let text = match keys.as_str() {
                _ if waits => "press a key",
                "" => "none",
                keys => keys,
            };
            let button = egui::Button::selectable(waits, text);
            if ui.add_sized([110.0, 20.0], button).clicked() {
                rebinding.0 = Some(control.id);
            }
            if let Some(pad_bindings) = pad_bindings {
                ui.weak(pad_bindings.label_of(control));
            }
            ui.add(egui::Label::new(description(control)).truncate())
                .on_hover_text(format!("{} in the settings file", control.id));
            ui.end_row();
        }
    });
}

/// What a control does. If several controls have the same description, the last part of the
/// control's name follows.
fn description(control: &Control) -> String {
    let words = control.description;
    let same = CONTROLS.iter().filter(|other| other.description == words);
    match control.id.rsplit_once('.') {
        Some((_, part)) if same.count() > 1 => format!("{words} ({})", part.replace('_', " ")),
        _ => words.into(),
    }
}

/// Binds the control that waits, if one does, to the first of these inputs.
fn bind_pressed<'a, B: Bindable>(
    bindings: &mut ResMut<BindingTable<B>>,
    rebinding: &mut Rebinding,
    pressed: impl IntoIterator<Item = &'a B>,
) {
    let Some(id) = rebinding.0 else {
        return;
    };
    let Some(pressed) = pressed.into_iter().find(|input| input.name().is_some()) else {
        return;
    };
    let cancels = B::from_name(CANCEL) == Some(*pressed) && id != ESCAPE;
    if !cancels {
        bindings.bind(id, *pressed);
    }
    rebinding.0 = None;
}
