//! The window around the picture: which overlays are open, the whole screen, settings kept over
//! restarts.

use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::controls::table::Command;
use crate::app::state::settings::Settings;
use crate::app::state::toast::Toast;
use crate::app::ui::dock::{OverPicture, Side, look, make_room};
use crate::app::ui::{inspector, panel};
use crate::render::{CurrentScene, letterbox};
use crate::storage::settings_file;
use bevy::prelude::*;
use bevy::window::{Monitor, MonitorSelection, PrimaryMonitor, PrimaryWindow, WindowMode};
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, PrimaryEguiContext, egui};
use std::path::PathBuf;
use std::time::Duration;

/// What is open over the picture.
#[derive(Resource, Default)]
pub(crate) struct Overlays {
    pub(crate) help: bool,
    pub(crate) panel: bool,
    pub(crate) inspector: bool,
    /// Whether all of it, and the lines at the bottom, are hidden for now.
    pub(crate) hidden: bool,
    /// The panel of which side gives way, in a window too narrow for both.
    pub(crate) gives_way: Option<Side>,
    /// The side that was opened last.
    pub(crate) last: Option<Side>,
}

impl Overlays {
    /// Width at the left that the inspector takes, in points.
    pub(crate) fn left(&self) -> f32 {
        if self.inspector_seen() {
            inspector::WIDTH
        } else {
            0.0
        }
    }

    /// Width at the right that the panel takes, in points.
    pub(crate) fn right(&self) -> f32 {
        if self.panel_seen() { panel::WIDTH } else { 0.0 }
    }

    pub(crate) fn inspector_seen(&self) -> bool {
        self.inspector && !self.hidden && self.gives_way != Some(Side::Left)
    }

    pub(crate) fn panel_seen(&self) -> bool {
        self.panel && !self.hidden && self.gives_way != Some(Side::Right)
    }
}

/// The settings, and the file that they are kept in.
#[derive(Resource)]
pub(crate) struct Preferences {
    pub(crate) settings: Settings,
    /// As they are in the file.
    saved: Settings,
    file: Option<PathBuf>,
    /// When they were last seen to change, since the start.
    changed: Option<Duration>,
}

/// Time that settings must have been left alone before they are written.
const CALM: Duration = Duration::from_secs(1);

impl Preferences {
    /// Reads them; the second value says what was wrong with the file.
    pub(crate) fn load() -> (Self, Option<String>) {
        let file = settings_file();
        let (settings, fault) = file
            .as_deref()
            .map_or_else(Default::default, Settings::load);
        (
            Self {
                saved: settings.clone(),
                settings,
                file,
                changed: None,
            },
            fault,
        )
    }

    fn save(&mut self) -> Result<(), String> {
        self.changed = None;
        if self.settings == self.saved {
            return Ok(());
        }
        self.saved = self.settings.clone();
        self.file
            .as_deref()
            .map_or(Ok(()), |file| self.settings.save(file))
    }
}

/// The settings as they were loaded, with what was wrong with their file.
pub(crate) fn insert(app: &mut App, preferences: Preferences, fault: Option<String>) {
    // Checked as the file was read.
    let bindings = Bindings::new(&preferences.settings.keys).unwrap_or_default();
    let buttons = PadBindings::new(&preferences.settings.buttons).unwrap_or_default();
    app.insert_resource(preferences)
        .insert_resource(bindings)
        .insert_resource(buttons)
        .init_resource::<Overlays>();
    if let Some(fault) = fault {
        app.world_mut().get_resource_or_init::<Toast>().say(fault);
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<OverPicture>()
        .add_systems(Update, ((obey, make_room, look).chain(), keep, fit))
        .add_systems(Last, keep_at_exit)
        .add_systems(
            EguiPrimaryContextPass,
            style.run_if(any_with_component::<PrimaryEguiContext>),
        );
}

fn obey(
    mut commands: MessageReader<Command>,
    mut shown: ResMut<Overlays>,
    mut window: Single<&mut Window, With<PrimaryWindow>>,
) {
    for command in commands.read() {
        match command {
            Command::Hide => shown.hidden = !shown.hidden,
            Command::Help => toggle(&mut shown, |shown| &mut shown.help),
            Command::Panel => toggle_side(&mut shown, Side::Right, |shown| &mut shown.panel),
            Command::Inspect => toggle_side(&mut shown, Side::Left, |shown| &mut shown.inspector),
            Command::Escape => shown.help = false,
            Command::Fullscreen => {
                window.mode = match window.mode {
                    WindowMode::Windowed => {
                        WindowMode::BorderlessFullscreen(MonitorSelection::Current)
                    }
                    _ => WindowMode::Windowed,
                };
            }
            _ => {}
        }
    }
}

/// Opens or closes an overlay. One that is asked for while everything is hidden is meant to be
/// seen.
fn toggle(shown: &mut Overlays, overlay: fn(&mut Overlays) -> &mut bool) {
    let open = !*overlay(shown) || shown.hidden;
    *overlay(shown) = open;
    shown.hidden &= !open;
}

/// The same for a panel: one that gives way to another is meant to come forward.
fn toggle_side(shown: &mut Overlays, side: Side, overlay: fn(&mut Overlays) -> &mut bool) {
    if shown.gives_way != Some(side) || shown.hidden {
        toggle(shown, overlay);
    }
    if *overlay(shown) {
        shown.last = Some(side);
    }
}

/// The window's size at first, made smaller where the monitor has no room for it: so that the
/// picture fills it.
fn fit(
    monitors: Query<(&Monitor, Has<PrimaryMonitor>)>,
    scene: Res<CurrentScene>,
    mut window: Single<&mut Window, With<PrimaryWindow>>,
    mut done: Local<bool>,
) {
    let primary = monitors
        .iter()
        .find(|(_, primary)| *primary)
        .or_else(|| monitors.iter().next());
    let Some((monitor, _)) = primary.filter(|_| !*done) else {
        return;
    };
    *done = true;
    let room = monitor.physical_size();
    if window.physical_size().cmpgt(room).any() {
        // Room for the frame and the desktop's bars.
        let filled = letterbox(&scene.picture, (0.94 * room.as_vec2()).as_uvec2())
            .extent
            .as_uvec2();
        window
            .resolution
            .set_physical_resolution(filled.x, filled.y);
    }
}

/// Writes the settings once they have been left alone for a moment.
fn keep(
    time: Res<Time<Real>>,
    mut preferences: ResMut<Preferences>,
    bindings: Res<Bindings>,
    buttons: Res<PadBindings>,
    mut notice: ResMut<Toast>,
) {
    if bindings.is_changed() && !bindings.is_added() {
        preferences.settings.keys = bindings.settings();
    }
    if buttons.is_changed() && !buttons.is_added() {
        preferences.settings.buttons = buttons.settings();
    }
    if preferences.settings == preferences.saved {
        return;
    }
    match preferences.changed {
        None => preferences.changed = Some(time.elapsed()),
        Some(changed) if time.elapsed() > changed + CALM => {
            if let Err(fault) = preferences.save() {
                notice.say(fault);
            }
        }
        Some(_) => {}
    }
}

fn keep_at_exit(mut exits: MessageReader<AppExit>, mut preferences: ResMut<Preferences>) {
    if exits.read().next().is_some()
        && let Err(fault) = preferences.save()
    {
        error!("{fault}");
    }
}

/// Text that reads on any picture, at the size that the settings say.
fn style(
    mut contexts: EguiContexts,
    preferences: Res<Preferences>,
    mut scale: Local<f32>,
) -> Result {
    let context = contexts.ctx_mut()?;
    if *scale == 0.0 {
        let mut visuals = egui::Visuals::dark();
        visuals.override_text_color = Some(egui::Color32::from_gray(215));
        visuals.weak_text_color = Some(egui::Color32::from_gray(165));
        visuals.window_fill = egui::Color32::from_rgb(10, 10, 13);
        context.set_visuals(visuals);
    }
    let wanted = preferences.settings.ui_scale;
    if *scale != wanted {
        context.set_zoom_factor(wanted);
        *scale = wanted;
    }
    Ok(())
}
