//! The window: its title, its size at the start, and the whole screen.

use super::monitor::{Placement, cover, first_mode};
use crate::app::controls::control::AppCommand;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use bevy::window::{
    Monitor, MonitorSelection, PresentMode, PrimaryMonitor, PrimaryWindow, WindowMode,
    WindowResolution,
};
use lightfall_core::scene::Scene;
use lightfall_platform::IN_BROWSER;
use lightfall_render::CurrentScene;

/// Three output pixels for each cell of the default grid. This fits a common laptop's screen.
const SIZE: [u32; 2] = [1440, 810];
/// Share of the monitor that the window takes at most, leaving room for its frame and for the
/// desktop's bars.
const MAX_MONITOR_SHARE: f32 = 0.94;

/// The window in which a scene is opened.
pub(crate) fn window_of(scene: &Scene, placement: Placement) -> Window {
    Window {
        title: title(scene),
        mode: first_mode(placement),
        name: Some("lightfall".into()),
        resolution: WindowResolution::new(SIZE[0], SIZE[1]),
        present_mode: PresentMode::AutoVsync,
        // In a browser: the page's own canvas, as large as the page.
        canvas: Some("#lightfall".into()),
        fit_canvas_to_parent: true,
        ..default()
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        Update,
        (
            toggle_full_screen,
            fit_to_monitor.run_if(|| !IN_BROWSER),
            update_title.run_if(resource_changed::<CurrentScene>),
        ),
    );
}

fn title(scene: &Scene) -> String {
    if scene.title.is_empty() {
        "Lightfall".into()
    } else {
        format!("Lightfall: {}", scene.title)
    }
}

fn update_title(scene: Res<CurrentScene>, mut window: Single<&mut Window>) {
    let title = title(&scene);
    if window.title != title {
        window.title = title;
    }
}

fn toggle_full_screen(
    mut commands: MessageReader<AppCommand>,
    mut window: Single<&mut Window, With<PrimaryWindow>>,
    mut toast: ResMut<Toast>,
) {
    for _ in 0..AppCommand::Fullscreen.count(&mut commands) {
        window.mode = match window.mode {
            WindowMode::Windowed => WindowMode::BorderlessFullscreen(MonitorSelection::Current),
            _ => WindowMode::Windowed,
        };
        toast.say(match window.mode {
            WindowMode::Windowed => "Full screen: off",
            _ => "Full screen: on",
        });
    }
}

/// Makes the first window smaller where the monitor has no room for it. It keeps its shape.
fn fit_to_monitor(
    monitors: Query<(&Monitor, Has<PrimaryMonitor>)>,
    placement: Res<Placement>,
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
    if window.mode != WindowMode::Windowed {
        // Another monitor than the first one comes to the window by itself.
        if placement.monitor.is_none() {
            cover(&mut window, monitor);
        }
        return;
    }
    if window.physical_size().cmpgt(room).any() {
        let size = UVec2::from(SIZE).as_vec2();
        let scale = (MAX_MONITOR_SHARE * room.as_vec2() / size).min_element();
        let size = (size * scale).as_uvec2();
        window.resolution.set_physical_resolution(size.x, size.y);
    }
}
