//! Where the window opens: over the whole screen, and on which monitor.

use bevy::prelude::*;
use bevy::window::{Monitor, MonitorSelection, PrimaryWindow, WindowMode, WindowPosition};
use lightfall_platform::IN_BROWSER;
use std::sync::{Arc, OnceLock};

/// Where the window opens.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Placement {
    /// Whether it covers the whole screen.
    pub full_screen: bool,
    /// The monitor, counted from 1 from the left. None leaves the choice to the desktop.
    pub monitor: Option<usize>,
}

/// Why the window cannot open on the monitor that was asked for: one sentence. A clone still tells it
/// after the app is gone.
#[derive(Resource, Clone, Default)]
pub struct MonitorFault(Arc<OnceLock<String>>);

impl MonitorFault {
    /// The sentence, if there is no such monitor.
    #[must_use]
    pub fn sentence(&self) -> Option<&str> {
        self.0.get().map(String::as_str)
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Placement>()
        .init_resource::<MonitorFault>()
        .add_systems(Update, choose_monitor.run_if(names_monitor));
}

/// A run condition: the window opens on a monitor that the command line names.
fn names_monitor(placement: Res<Placement>) -> bool {
    !IN_BROWSER && placement.monitor.is_some()
}

/// The mode in which the window opens.
pub(crate) fn first_mode(placement: Placement) -> WindowMode {
    if placement.full_screen {
        WindowMode::BorderlessFullscreen(MonitorSelection::Primary)
    } else {
        WindowMode::Windowed
    }
}

/// The place in this list of the monitor with a number. Numbers count from 1 from the left, and from the
/// top where monitors are above each other.
///
/// # Errors
/// There is no such monitor: one sentence that lists all of them.
pub fn numbered_monitor(number: usize, monitors: &[Monitor]) -> Result<usize, String> {
    let mut order: Vec<usize> = (0..monitors.len()).collect();
    order.sort_by_key(|place| {
        let IVec2 { x, y } = monitors[*place].physical_position;
        (x, y)
    });
    let found = number.checked_sub(1).and_then(|place| order.get(place));
    found.copied().ok_or_else(|| {
        let lines = (1..).zip(&order).map(|(number, place)| {
            let monitor = &monitors[*place];
            let name = monitor
                .name
                .as_deref()
                .unwrap_or("a monitor without a name");
            let size = monitor.physical_size();
            format!("{number}: {name}, {} x {}", size.x, size.y)
        });
        let lines: Vec<String> = lines.collect();
        format!(
            "--monitor {number}: there is no such monitor; counted from the left, there is {}",
            lines.join("; ")
        )
    })
}

/// Gives a window over the whole screen the size and the place of its monitor. An X server without a
/// window manager, on which an exhibition may run, leaves both to the program.
pub(crate) fn cover(window: &mut Window, monitor: &Monitor) {
    if cfg!(target_os = "linux") {
        let size = monitor.physical_size();
        window.resolution.set_physical_resolution(size.x, size.y);
        window.position = WindowPosition::At(monitor.physical_position);
    }
}

/// Brings the window to its monitor, once the monitors are known, or ends the program with a sentence.
fn choose_monitor(
    placement: Res<Placement>,
    monitors: Query<(Entity, &Monitor)>,
    mut window: Single<&mut Window, With<PrimaryWindow>>,
    fault: Res<MonitorFault>,
    mut exits: MessageWriter<AppExit>,
    mut done: Local<bool>,
) {
    let Some(number) = placement.monitor.filter(|_| !*done) else {
        return;
    };
    let (entities, known): (Vec<Entity>, Vec<Monitor>) = monitors
        .iter()
        .map(|(entity, monitor)| (entity, monitor.clone()))
        .unzip();
    if known.is_empty() {
        return;
    }
    *done = true;
    match numbered_monitor(number, &known) {
        Ok(place) => {
            let chosen = MonitorSelection::Entity(entities[place]);
            if placement.full_screen {
                window.mode = WindowMode::BorderlessFullscreen(chosen);
                cover(&mut window, &known[place]);
            } else {
                window.position = WindowPosition::Centered(chosen);
            }
        }
        Err(sentence) => {
            fault.0.get_or_init(|| sentence);
            exits.write(AppExit::error());
        }
    }
}
