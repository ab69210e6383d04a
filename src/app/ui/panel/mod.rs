//! The panel at the right: every field of the scene, presets, read-outs, the machine, the limits of
//! the picture, and the settings.

mod field_value;
mod file_dialog;
mod flight_readouts;
mod limitations_page;
mod machine_page;
mod mass_choice;
mod number_field;
mod presets_page;
mod readouts_page;
mod scene_page;
mod settings_page;
mod step_count;
mod switch;

pub use flight_readouts::flight_error;

use super::dock::docked;
use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::controls::control::AppCommand;
use crate::app::input::typing::MouseOverPanel;
use crate::app::motion::free_fall::FreeFall;
use crate::app::motion::ship::ShipFlight;
use crate::app::session::clipboard::Clipboard;
use crate::app::state::file_opener::FileOpener;
use crate::app::state::kiosk::outside_kiosk;
use crate::app::state::overlays::{Overlays, PANEL, PANEL_WIDTH, Side};
use crate::app::state::paused::Paused;
use crate::app::state::preferences::Preferences;
use crate::app::state::rebinding::Rebinding;
use crate::app::state::sound::SoundFault;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use lightfall_render::PictureArea;
use machine_page::{Machine, MachinePage};
use presets_page::PresetsPage;
use readouts_page::ReadoutsPage;
use step_count::StepCounter;

/// The pages.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Page {
    #[default]
    Scene,
    Presets,
    Readouts,
    Machine,
    Limitations,
    Settings,
}

const PAGES: [(Page, &str); 6] = [
    (Page::Scene, "Scene"),
    (Page::Presets, "Presets"),
    (Page::Readouts, "Read-outs"),
    (Page::Machine, "Machine"),
    (Page::Limitations, "Limits"),
    (Page::Settings, "Settings"),
];

/// What the panel remembers from frame to frame.
#[derive(Resource, Default)]
struct Panel {
    page: Page,
    presets: PresetsPage,
    readouts: ReadoutsPage,
    machine: MachinePage,
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Panel>()
        .init_resource::<Rebinding>()
        .init_resource::<SoundFault>()
        .add_plugins((machine_page::plugin, step_count::plugin))
        .add_systems(
            Update,
            (
                presets_page::open_dropped_files.run_if(outside_kiosk),
                open_settings,
            ),
        )
        .add_systems(EguiPrimaryContextPass, show_panel);
}

/// Opens the panel on its page of settings.
fn open_settings(
    mut commands: MessageReader<AppCommand>,
    mut overlays: ResMut<Overlays>,
    mut panel: ResMut<Panel>,
) {
    if commands.read().any(|it| *it == AppCommand::Settings) {
        overlays.open_panel();
        panel.page = Page::Settings;
        overlays.at_settings = true;
    }
}

fn show_panel(
    mut contexts: EguiContexts,
    area: Res<PictureArea>,
    mut overlays: ResMut<Overlays>,
    mut panel: ResMut<Panel>,
    mut opener: FileOpener,
    mut preferences: ResMut<Preferences>,
    (mut bindings, mut pad_bindings): (ResMut<Bindings>, ResMut<PadBindings>),
    pads: Query<&Gamepad>,
    mut rebinding: ResMut<Rebinding>,
    keys: Res<ButtonInput<KeyCode>>,
    machine: Machine,
    (free_fall, ship, sound): (Res<FreeFall>, Res<ShipFlight>, Res<SoundFault>),
    mut paused: ResMut<Paused>,
    mut over_panel: ResMut<MouseOverPanel>,
    steps: Res<StepCounter>,
    clipboard: Res<Clipboard>,
) -> Result {
    if !overlays.shows_panel() {
        rebinding.0 = None;
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let panel = &mut *panel;
    over_panel.page_has_numbers = panel.page == Page::Scene;
    docked(context, PANEL, Side::Right, PANEL_WIDTH, |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            for (each, title) in PAGES {
                ui.selectable_value(&mut panel.page, each, title);
            }
            if ui.button("×").on_hover_text("Close").clicked() {
                overlays.panel = false;
            }
        });
        ui.separator();
        let at_settings = panel.page == Page::Settings;
        if overlays.at_settings != at_settings {
            overlays.at_settings = at_settings;
        }
        if !at_settings {
            rebinding.0 = None;
        }
        egui::ScrollArea::both()
            .id_salt(panel.page as u8)
            .auto_shrink(false)
            .show(ui, |ui| match panel.page {
                Page::Scene => {
                    let (size, editor) = (area.part.size(), &mut opener.editor);
                    scene_page::show(ui, editor, &steps, &bindings, &mut paused, size);
                }
                Page::Presets => panel.presets.show(ui, &mut opener, &clipboard),
                Page::Readouts => {
                    let settings = &mut preferences.settings;
                    let scene = &opener.editor.drawn_scene();
                    let flights = (&*free_fall, &*ship);
                    panel.readouts.show(ui, scene, flights, &bindings, settings);
                }
                Page::Machine => {
                    let chosen = &mut preferences.settings.adapter;
                    panel.machine.show(ui, &machine, chosen, &opener.editor);
                }
                Page::Limitations => limitations_page::show(ui, &bindings),
                Page::Settings => settings_page::show(
                    ui,
                    &mut preferences.settings,
                    &mut bindings,
                    &mut pad_bindings,
                    &mut rebinding,
                    &keys,
                    &pads,
                    sound.0.as_deref(),
                ),
            });
    });
    Ok(())
}
