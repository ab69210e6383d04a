//! The panel: every field of the scene, presets, what the machine does, what is exact, and the
//! settings.

mod fields;
mod limitations;
mod machine;
mod preferences;
mod presets;
mod readouts;
mod steps;

pub use fields::shown_number;
pub(crate) use preferences::Rebinding;

use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::input::keyboard::SceneEditor;
use crate::app::motion::free_fall::FreeFall;
use crate::app::session::window::{Overlays, Preferences};
use crate::app::ui::dock::{Side, docked};
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// Width of the panel, in points.
pub(crate) const WIDTH: f32 = 384.0;

/// The pages.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Page {
    #[default]
    Scene,
    Presets,
    Readouts,
    Machine,
    Honesty,
    Settings,
}

const PAGES: [(Page, &str); 6] = [
    (Page::Scene, "Scene"),
    (Page::Presets, "Presets"),
    (Page::Readouts, "Read-outs"),
    (Page::Machine, "Machine"),
    (Page::Honesty, "Truth"),
    (Page::Settings, "Settings"),
];

/// What the panel remembers from frame to frame.
#[derive(Resource, Default)]
struct Panel {
    page: Page,
    fields: fields::State,
    presets: presets::State,
    readouts: readouts::State,
    machine: machine::State,
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Panel>()
        .init_resource::<Rebinding>()
        .add_plugins((machine::plugin, steps::plugin))
        .add_systems(Update, presets::drop_file)
        .add_systems(EguiPrimaryContextPass, show);
}

fn show(
    mut contexts: EguiContexts,
    window: Single<&Window, With<PrimaryWindow>>,
    mut shown: ResMut<Overlays>,
    mut panel: ResMut<Panel>,
    mut editor: SceneEditor,
    mut preferences: ResMut<Preferences>,
    mut bindings: ResMut<Bindings>,
    mut buttons: ResMut<PadBindings>,
    pads: Query<&Gamepad>,
    mut rebinding: ResMut<Rebinding>,
    keys: Res<ButtonInput<KeyCode>>,
    machine: machine::Machine,
    voyage: Res<FreeFall>,
    steps: Res<steps::Steps>,
) -> Result {
    if !shown.panel_seen() {
        rebinding.stop();
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let Panel {
        page,
        fields,
        presets,
        readouts,
        machine: needs,
    } = &mut *panel;
    docked(context, "panel", Side::Right, WIDTH, |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            for (each, title) in PAGES {
                ui.selectable_value(page, each, title);
            }
            if ui.button("×").on_hover_text("Close").clicked() {
                shown.panel = false;
            }
        });
        ui.separator();
        if *page != Page::Settings {
            rebinding.stop();
        }
        egui::ScrollArea::both()
            .id_salt(*page as u8)
            .auto_shrink(false)
            .show(ui, |ui| match page {
                Page::Scene => {
                    fields::show(ui, fields, &mut editor, &steps, window.physical_size())
                }
                Page::Presets => presets::show(ui, presets, &mut editor),
                Page::Readouts => {
                    readouts::show(
                        ui,
                        readouts,
                        editor.drawn(),
                        &voyage,
                        &mut preferences.settings,
                    );
                }
                Page::Machine => {
                    let chosen = &mut preferences.settings.adapter;
                    machine::show(ui, needs, &machine, chosen, editor.drawn(), &editor.meant());
                }
                Page::Honesty => limitations::show(ui),
                Page::Settings => {
                    preferences::show(
                        ui,
                        &mut preferences,
                        &mut bindings,
                        &mut buttons,
                        &mut rebinding,
                        &keys,
                        &pads,
                    );
                }
            });
    });
    Ok(())
}
