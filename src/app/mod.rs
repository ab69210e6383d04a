//! The window program: fly the camera, press the keys, see the scene.

mod adapter;
mod bindings;
mod buttons;
mod clipboard;
mod controls;
mod display;
mod dock;
mod edits;
mod end_card;
mod exposure;
mod frame_pacing;
mod free_fall;
mod gamepad;
mod help;
mod history;
mod inspector;
mod journey_player;
mod key_feedback;
mod keyboard;
mod keys;
mod last_pose;
mod legend;
mod panel;
mod pilot;
mod recovery;
mod resolution;
mod screenshot;
mod settings;
mod status_bar;
mod toast;
mod window;

pub use bindings::{Bindings, Bound, PadBindings, Switch};
pub use controls::{Action, CONTROLS, Command, Control, FlightInput, Group, control_named};
pub use display::display;
pub use edits::edited;
pub use frame_pacing::FramePacing;
pub use free_fall::FreeFall;
pub use gamepad::{deflection, squeeze};
pub use history::History;
pub use inspector::pixel_at;
pub use journey_player::{JourneyPlayer, Moment};
pub use key_feedback::remark;
pub use legend::{Swatch, legend};
pub use panel::shown_number;
pub use pilot::{Steering, steered};
pub use resolution::Resolution;
pub use settings::{
    Automatic, Settings, pictures_folder, preset_files, presets_folder, settings_file,
};

use crate::picture::quiet_log;
use crate::render::{CurrentScene, LightfallRenderPlugin, Screen, render_plugin};
use bevy::camera::RenderTarget;
use bevy::prelude::*;
use bevy::window::{PresentMode, WindowResolution};
use bevy::winit::WinitPlugin;
use bevy_egui::{EguiGlobalSettings, EguiPlugin, PrimaryEguiContext};
use last_pose::LastPose;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::Journey;

/// Three output pixels to a cell of the default grid, which fits a common laptop's screen.
const WINDOW_SIZE: [u32; 2] = [1440, 810];

/// Nearest to the hole that flying brings the camera, in r_s: there a static observer is still an
/// ordinary place.
pub const MIN_FLIGHT_RADIUS: f64 = 1.08;

/// A frame that took longer than this, in seconds, moves the camera no farther, so that slow
/// machines stay steerable.
const MAX_FRAME_SECONDS: f64 = 0.25;

/// Opens the window and flies until it is closed. The journey begins at once if it is `guided`,
/// else when it is asked for.
pub fn fly(scene: Drawable, journey: Journey, guided: bool) -> AppExit {
    program(scene, journey, guided).run()
}

/// The whole window program, as [`fly`] runs it.
pub fn program(scene: Drawable, journey: Journey, guided: bool) -> App {
    let mut guide = JourneyPlayer::new(journey);
    if guided {
        guide.restart();
    }
    let (mut preferences, fault) = window::Preferences::load();
    // Before the renderer opens a device.
    let adapter = adapter::AdapterChoice::apply(&mut preferences);
    let mut app = App::new();
    window::insert(&mut app, preferences, fault);
    app.add_plugins(
        DefaultPlugins
            .set(quiet_log())
            .set(render_plugin(false))
            .set(any_thread())
            .set(WindowPlugin {
                primary_window: Some(Window {
                    title: title(&scene),
                    name: Some("lightfall".into()),
                    resolution: WindowResolution::new(WINDOW_SIZE[0], WINDOW_SIZE[1]),
                    present_mode: PresentMode::AutoVsync,
                    ..default()
                }),
                ..default()
            }),
    )
    .add_plugins(EguiPlugin::default())
    .insert_resource(EguiGlobalSettings {
        auto_create_primary_context: false,
        ..default()
    })
    .insert_resource(History::new(scene.scene().clone()))
    .insert_resource(Resolution::new(&scene))
    .insert_resource(guide)
    .insert_resource(adapter)
    .add_plugins(LightfallRenderPlugin {
        scene,
        target: RenderTarget::default(),
    })
    .add_plugins((
        toast::plugin,
        window::plugin,
        keyboard::plugin,
        pilot::plugin,
        frame_pacing::plugin,
        resolution::plugin,
    ))
    .add_plugins((recovery::RecoveryPlugin, adapter::plugin, gamepad::plugin))
    .add_plugins((
        end_card::plugin,
        journey_player::plugin,
        free_fall::plugin,
        exposure::plugin,
    ))
    .add_plugins((
        screenshot::plugin,
        status_bar::plugin,
        legend::plugin,
        help::plugin,
        panel::plugin,
        inspector::plugin,
        clipboard::plugin,
    ))
    .add_systems(
        Update,
        (attach_ui, retitle.run_if(resource_changed::<CurrentScene>)),
    );
    app
}

/// Where the system does not mind, the program may be run by a thread that is not the first, as
/// tests are.
fn any_thread() -> WinitPlugin {
    WinitPlugin {
        run_on_any_thread: true,
    }
}

/// The user interface belongs to the screen, at its native resolution, and not to the picture.
fn attach_ui(mut commands: Commands, screens: Query<Entity, Added<Screen>>) {
    for screen in &screens {
        commands.entity(screen).insert(PrimaryEguiContext);
    }
}

fn title(scene: &Scene) -> String {
    if scene.title.is_empty() {
        "Lightfall".into()
    } else {
        format!("Lightfall: {}", scene.title)
    }
}

fn retitle(scene: Res<CurrentScene>, mut window: Single<&mut Window>) {
    let title = title(&scene);
    if window.title != title {
        window.title = title;
    }
}
