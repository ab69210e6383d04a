//! The window program: fly the camera, press the keys, see the scene.
//!
//! Each folder may use those above it in this list:
//!
//! 1. `controls`: what keys and buttons mean, and what they are bound to.
//! 2. `state`: what the program remembers, and the door through which the scene is changed.
//! 3. `input`: keyboard, gamepads, mouse and fingers.
//! 4. `session`: the window, the frame rate, resolution, exposure, screenshots, the clipboard.
//! 5. `motion`: what moves the camera and the disk.
//! 6. `ui`: what is drawn over the picture.

mod controls;
mod input;
mod motion;
mod session;
mod state;
mod ui;

pub use controls::bindings::{Bindable, Bindings, PadBindings};
pub use controls::control::{Action, Control, Group, Modifier};
pub use controls::edits::edited;
pub use controls::key_feedback::remark;
pub use controls::key_labels::{KeyLabels, PRINTED};
pub use controls::kiosk::is_for_visitors;
pub use controls::refusal::checked_change;
pub use controls::sections::{SECTIONS, Shown};
pub use controls::statement::{change_words, statement};
pub use controls::table::{CONTROLS, control_named};
pub use controls::text_keys::unknown_controls;
pub use input::gamepad::{NO_GAMEPAD, deflection, squeeze};
pub use input::gestures::{Gesture, Gestures};
pub use motion::disk_clock::{disk_rate_words, stepped_rate};
pub use motion::edge_view::{edge_distance, edge_in_view};
pub use motion::facing::{Aim, aimed, between_axes, next_aim};
pub use motion::flight_step::FlightStep;
pub use motion::free_fall::FreeFall;
pub use motion::journey_player::{JourneyPlayer, NotedAnswer};
pub use motion::orbit_camera::{OrbitStep, orbited};
pub use motion::ship::{
    Engine, Flown, HoldKind, News, Nose, ShipFlight, ShipFrame, Stick, Track, lamps, own_time_rate,
    solution_time,
};
pub use motion::steering::{Barrier, Steered, Steering, steered, thrust_fades};
pub use motion::zoom::zoomed;
pub use session::adaptive_resolution::{next_share, wanted_rate};
pub use session::display::{display, prefers_dead_wayland};
pub use session::frame_pacing::FramePacing;
#[cfg(not(target_arch = "wasm32"))]
pub use session::link::command_line;
pub use session::monitor::{MonitorFault, Placement, numbered_monitor};
pub use state::disk_clock::DiskClock;
pub use state::history::History;
pub use state::kiosk::{Exhibition, Show};
pub use state::kiosk_round::{
    END_PAUSE, JourneyNow, KioskRound, RoundStep, VisitorInput, stop_reading_time,
};
pub use state::lesson_results::LessonAnswer;
pub use state::lessons::next_lesson;
pub use state::menu::{Menu, MenuEntry, MenuList};
pub use state::mission_results::{MissionResult, MissionResults};
pub use state::missions::{first_choice, next_not_reached};
pub use state::preferences::Preferences;
pub use state::preset_row::{RowPreset, preset_beside};
pub use state::resolution::{Canvas, Resolution};
pub use state::result_file::time_in_utc;
pub use state::settings::{Automatic, PictureShape, SETTINGS_VERSION, Settings};
pub use state::settings_fault::SettingsFault;
pub use state::sound::{CockpitSound, NO_SOUND};
pub use state::toast::reading_time;
pub use state::view_point::ViewPoint;
pub use ui::glyphs::lacking;
pub use ui::help::{help_rows, help_rows_at_helm};
pub use ui::hud::{
    Instrument, PathLine, PilotNeeds, PilotPlaces, ReadOut, Wanted, differences, instruments,
    map_half_width, most_rows, outside_horizon, physics_off, pilot_places, read_outs, wanted,
};
pub use ui::inspector::plane_handout;
pub use ui::layout::{Layout, Slide, Taken, Wish};
pub use ui::panel::flight_error;
pub use ui::ship_help::ship_rows;

use bevy::app::PluginGroupBuilder;
use bevy::camera::RenderTarget;
use bevy::prelude::*;
use bevy::winit::WinitPlugin;
use bevy_egui::EguiPlugin;
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::stars::Catalogue;
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::Journey;
use lightfall_core::scene::mission::Mission;
use lightfall_platform::log::{quiet_log, say};
use lightfall_render::recovery::DeviceFailure;
use lightfall_render::{LightfallRenderPlugin, LiveShaders, StarCatalogue, render_plugin};
use session::adapter::AdapterChoice;
use state::kiosk::Kiosk;
use state::lessons::GuidedJourney;
use state::light_meter::LightMeter;
use state::missions::StartMission;
use state::paused::Paused;
use state::title::Title;
use state::toast::Toast;
use std::path::{Path, PathBuf};

/// What the window starts with.
pub struct Start {
    /// What the window says first.
    pub message: Option<String>,
    /// The first scene.
    pub scene: Drawable,
    /// The stars.
    pub stars: &'static Catalogue,
    /// The guided journey.
    pub journey: Journey,
    /// Whether the journey starts at once. Otherwise it starts when its key is pressed.
    pub plays_journey: bool,
    /// The mission that begins at once; the first scene is that of its start.
    pub mission: Option<Box<Mission>>,
    /// Whether the first scene says itself whether it is shown in cells. Otherwise the settings do.
    pub keeps_own_look: bool,
    /// The folder of shaders that are linked again whenever one of its files changes.
    pub shaders: Option<PathBuf>,
    /// What is shown to visitors, in a window for them. The first scene is that of its first journey.
    pub exhibition: Option<Exhibition>,
    /// Where the window opens.
    pub placement: Placement,
}

impl Start {
    /// Starts with a scene that flies the journey only when asked, in the look of the settings.
    #[must_use]
    pub fn new(scene: Drawable, journey: Journey) -> Self {
        Self {
            message: None,
            scene,
            stars: Catalogue::built_in(),
            journey,
            plays_journey: false,
            mission: None,
            keeps_own_look: false,
            shaders: source_shaders(),
            exhibition: None,
            placement: Placement::default(),
        }
    }
}

/// The folder of shaders in the source code, in builds for its development.
fn source_shaders() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders");
    (cfg!(debug_assertions) && folder.is_dir()).then_some(folder)
}

/// Opens the window and flies until it is closed.
///
/// # Errors
/// The window ended by itself. One sentence says why.
pub fn fly(start: Start) -> Result<(), String> {
    run(program(start))
}

/// Runs a window program until its window is closed.
///
/// # Errors
/// As [`fly`].
pub fn run(mut app: App) -> Result<(), String> {
    let failure = app.world().get_resource::<DeviceFailure>().cloned();
    if app.run().is_success() {
        return Ok(());
    }
    let sentence = failure.as_ref().and_then(DeviceFailure::sentence);
    Err(sentence
        .unwrap_or("the window ended with an error; `lightfall doctor` examines this machine")
        .into())
}

/// The whole window program, as [`fly`] runs it.
pub fn program(start: Start) -> App {
    let Start {
        message,
        mut scene,
        stars,
        journey,
        plays_journey,
        mission,
        keeps_own_look,
        shaders,
        exhibition,
        placement,
    } = start;
    let has_visitors = exhibition.is_some();
    let mut player = JourneyPlayer::new(journey);
    // A journey or a mission that begins at once shows a title of its own.
    let title = if plays_journey || mission.is_some() || has_visitors {
        Title::default()
    } else {
        Title::of(&scene)
    };
    let (mut preferences, fault) = match &exhibition {
        Some(exhibition) => Preferences::for_visitors(exhibition.volume),
        None => Preferences::load(),
    };
    if !keeps_own_look {
        scene = in_look(scene, preferences.settings.pixel_look);
    }
    let scene = scene.exposed();
    if plays_journey {
        player.rewind(scene.scene());
        player.restart();
    }
    // The adapter has to be chosen before the renderer opens a device.
    let (adapter, other_adapter) = AdapterChoice::apply(&mut preferences, !has_visitors);
    let mut app = App::new();
    let labels = input::layout::current_labels();
    let clash = state::preferences::insert(&mut app, preferences, &labels);
    let faults: Vec<String> = fault
        .into_iter()
        .chain(other_adapter)
        .chain(clash)
        .collect();
    for fault in &faults {
        // The window says it for some seconds only. The log has not begun yet.
        say(format_args!("lightfall: {fault}"));
    }
    let messages: Vec<String> = message.into_iter().chain(faults).collect();
    // Visitors cannot mend what is wrong with the settings.
    if !messages.is_empty() && !has_visitors {
        app.world_mut()
            .get_resource_or_init::<Toast>()
            .say(messages.join("\n"));
    }
    app.add_plugins(bevy_plugins(&scene, placement, has_visitors))
        .add_plugins(EguiPlugin::default())
        .insert_resource(History::new(scene.scene().clone()))
        .init_resource::<Resolution>()
        .init_resource::<Paused>()
        .insert_resource(LightMeter::at(scene.picture.exposure_ev))
        .insert_resource(DiskClock::at(scene.disk.time))
        .insert_resource(title)
        .insert_resource(GuidedJourney(player.journey().clone()))
        .insert_resource(player)
        .insert_resource(adapter)
        .insert_resource(StarCatalogue(stars))
        .insert_resource(LiveShaders::new(shaders))
        .insert_resource(Kiosk::new(exhibition))
        .insert_resource(placement)
        .add_plugins(LightfallRenderPlugin {
            scene,
            target: RenderTarget::default(),
        })
        .add_plugins((
            (state::toast::plugin, state::helm::plugin),
            (state::missions::plugin, state::lessons::plugin),
            (state::lesson_draft::plugin, state::kiosk::plugin),
            state::end_card::plugin,
            state::menu::plugin,
            state::notice::plugin,
            state::hole_in_view::plugin,
            state::scene_editor::plugin,
            state::shown_picture::plugin,
        ))
        .add_plugins((
            (input::typing::plugin, input::clicks::plugin),
            input::key_modifiers::plugin,
            input::pointer::plugin,
            (input::keyboard::plugin, input::begin::plugin),
            input::layout::plugin,
            input::gamepad::plugin,
            input::touch::plugin,
        ))
        .add_plugins((
            (session::window::plugin, session::monitor::plugin),
            (session::icon::plugin, session::kiosk::plugin),
            session::frame_pacing::plugin,
            session::detail_limits::plugin,
            session::canvas::plugin,
            session::pixel_look::plugin,
            session::adaptive_resolution::plugin,
            session::comparison::plugin,
            session::exposure::plugin,
            session::adapter::plugin,
            session::recovery::plugin,
            session::quit::plugin,
            session::screenshot::plugin,
            session::clipboard::plugin,
            (session::crash_notes::plugin, session::shader_news::plugin),
        ))
        .add_plugins((
            motion::pilot::plugin,
            motion::zoom::plugin,
            (motion::journey::plugin, motion::stops::plugin),
            (motion::lesson::plugin, motion::kiosk::plugin),
            motion::free_fall::plugin,
            motion::ship::plugin,
            motion::edge_view::plugin,
            motion::pause::plugin,
            motion::disk_clock::plugin,
        ))
        .add_plugins((
            (ui::theme::plugin, ui::glyphs::plugin),
            (ui::dock::plugin, ui::layout::plugin),
            ui::hud::plugin,
            ui::legend::plugin,
            (ui::guides::plugin, ui::star_names::plugin),
            ui::help::plugin,
            ui::panel::plugin,
            ui::inspector::plugin,
            ui::end_card::plugin,
            ui::menu::plugin,
            ui::photo_mode::plugin,
            ui::notice::plugin,
            ui::compass::plugin,
            ui::touch_bar::plugin,
        ));
    if let Some(mission) = mission {
        app.world_mut().write_message(StartMission(mission));
    }
    #[cfg(target_arch = "wasm32")]
    app.add_plugins((session::page::plugin, session::link::plugin));
    app
}

/// The scene, shown with cells or without them.
fn in_look(drawable: Drawable, pixel_look: bool) -> Drawable {
    let mut scene = drawable.scene().clone();
    scene.picture.bypass = !pixel_look;
    Drawable::new(scene).unwrap_or(drawable)
}

fn bevy_plugins(scene: &Scene, placement: Placement, has_visitors: bool) -> PluginGroupBuilder {
    DefaultPlugins
        .set(quiet_log())
        .set(render_plugin(false))
        .set(WindowPlugin {
            primary_window: Some(session::window::window_of(scene, placement)),
            // Visitors do not close the window: the desktop's own keys ask it in vain.
            close_when_requested: !has_visitors,
            ..default()
        })
        // Tests run the program on a thread other than the first, where the system allows this.
        .set(WinitPlugin {
            run_on_any_thread: true,
        })
}
