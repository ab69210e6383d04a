//! The clock of a disk that moves: it runs while the picture shows the motion, and its rate is
//! changed by keys.
//!
//! `disk.time` is the time at the camera, so the clock depends on how the camera moves:
//!
//! * An observer that falls or orbits, or flies a ship, has clocks of its own. Its worldline says how
//!   much coordinate time goes by, and the fall or the ship sets the clock. Where a fall has come to its end, the clock stands:
//!   there is no time left in which anything could be seen.
//! * A journey drives the clock itself, by the same rule as for numbered pictures.
//! * A hand moves the camera faster than light, and no observer sees what such a camera would. The
//!   picture then keeps the stage that the disk is seen at: the clock is set forward by the change of
//!   [`Scene::disk_time_lead`], so that the disk neither leaps nor runs backward.
//!
//! Views of rays and of shifts do not depend on the time. There the clock stands still, so that the
//! window can rest. What the clock does is no edit of the scene: it cannot be undone.

use super::free_fall::{FreeFall, advance_free_fall, keys_change_disk_rate};
use super::journey::advance_journey;
use super::journey_player::JourneyPlayer;
use super::pilot::steer_camera;
use super::ship::advance_ship;
use super::steering::is_inside;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::state::disk_clock::DiskClock;
use crate::app::state::helm::Helm;
use crate::app::state::paused::Paused;
use crate::app::state::preferences::Preferences;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::state::window_shot::WindowShot;
use bevy::prelude::*;
use lightfall_core::numbers::{duration_in_words, four_digits, one_decimal};
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::Scene;
use lightfall_render::{ComparedScene, CurrentScene};

/// One press changes the rate by this factor, within a range of r_s/c per second.
const RATE_STEP: f64 = 2.0;
const RATES: [f64; 2] = [1.0 / 64.0, 1000.0];

/// The rate of the disk's clock after this many presses; a negative number slows it down. Beyond
/// the range of the keys it stays as it is, unless it comes nearer to the range. A clock that
/// stands begins with the slowest rate.
#[must_use]
pub fn stepped_rate(rate: f64, presses: i32) -> f64 {
    let [slowest, fastest] = RATES;
    if rate == 0.0 {
        return if presses > 0 { slowest } else { 0.0 };
    }
    (rate * RATE_STEP.powi(presses)).clamp(slowest.min(rate), fastest.max(rate))
}

/// What a second of the window is for the disk of a hole of this mass, e.g. `Disk's clock: 4 r_s/c
/// per second (2.82 minutes for Sgr A*)`.
#[must_use]
pub fn disk_rate_words(rate: f64, mass: HoleMass, units: Units) -> String {
    if units.are_simple() {
        let time = units.time(rate, four_digits);
        return format!("Disk's clock: a second here is {time} for {}", mass.name);
    }
    format!(
        "Disk's clock: {} r_s/c per second ({} for {})",
        four_digits(rate),
        duration_in_words(rate * mass.seconds()),
        mass.name
    )
}

/// What decides how the disk's clock goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ClockDriver {
    /// A fall or a journey.
    Flight,
    /// Nothing: a fall has come to its end, and no more time goes by for who fell.
    EndOfFall,
    /// Nothing: the user has paused it.
    Pause,
    /// The window's time.
    Window,
}

/// The clock in one line, with what it does. Empty where nothing moves, and in a flight inside the
/// horizon.
#[must_use]
pub(crate) fn status(
    scene: &Scene,
    driver: ClockDriver,
    bindings: &Bindings,
    units: Units,
) -> String {
    if !scene.disk_moves() {
        return String::new();
    }
    let time = units.time(scene.disk.time, one_decimal);
    let pause = bindings.label("motion.pause");
    match driver {
        // Inside the horizon the clock counts another time, and none far away can be compared.
        ClockDriver::Flight if is_inside(scene) => String::new(),
        ClockDriver::EndOfFall if is_inside(scene) => {
            "Disk's clock stands: the fall is over".into()
        }
        ClockDriver::Flight => format!("Disk's clock {time}"),
        ClockDriver::EndOfFall => format!("Disk's clock stands at {time}: the fall is over"),
        ClockDriver::Pause => format!("Disk's clock paused at {time} · {pause} goes on"),
        ClockDriver::Window if scene.shows_sources() => {
            let rate = match units {
                Units::Hole => four_digits(scene.disk.rate),
                Units::Everyday(_) => units.time(scene.disk.rate, four_digits),
            };
            format!("Disk's clock {time}, {rate} per second · {pause} pauses")
        }
        ClockDriver::Window => format!("Disk's clock stands at {time} in this view"),
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        Update,
        (
            change_rate,
            // After all that moves the camera, so that no frame has its place and an older time.
            run_disk_clock
                .after(steer_camera)
                .after(advance_free_fall)
                .after(advance_ship)
                .after(advance_journey),
        ),
    );
}

/// Lets the clock run for one frame.
fn run_disk_clock(
    time: Res<Time>,
    (paused, shot): (Res<Paused>, Res<WindowShot>),
    (free_fall, helm): (Res<FreeFall>, Res<Helm>),
    player: Res<JourneyPlayer>,
    compared: Res<ComparedScene>,
    scene: Res<CurrentScene>,
    mut clock: ResMut<DiskClock>,
) {
    let mut scene = scene.scene().clone();
    scene.disk.time = clock.time();
    // Both sides of a comparison have the same clock.
    let pinned = compared.drawn().map(|(pinned, _)| pinned.scene());
    let either = |has: fn(&Scene) -> bool| has(&scene) || pinned.is_some_and(has);
    // At a stop the hole's neighbourhood goes on, and only the journey waits.
    let leads = player.is_playing() && !player.rests();
    let flies = free_fall.is_moving() || leads || helm.has_ship();
    if flies || !either(Scene::disk_moves) {
        clock.follow(&scene);
        return;
    }
    let held = paused.0 || shot.holds_still() || free_fall.is_over(&scene);
    let runs = !held && either(Scene::shows_disk_motion);
    let seconds = if runs { time.delta_secs_f64() } else { 0.0 };
    let mut next = scene.clone();
    next.disk.time = clock.advance(seconds, &scene);
    if let Err(reason) = next.check() {
        clock.follow(&scene);
        error_once!("the disk's clock cannot go on: {reason}");
    }
}

/// Changes the rate of the disk's clock by the keys for the rate of time, unless a fall or a
/// journey uses them.
fn change_rate(
    mut commands: MessageReader<AppCommand>,
    free_fall: Res<FreeFall>,
    player: Res<JourneyPlayer>,
    preferences: Res<Preferences>,
    mut editor: SceneEditor,
) {
    for command in commands.read() {
        let presses = match command {
            AppCommand::FasterTime => 1,
            AppCommand::SlowerTime => -1,
            _ => continue,
        };
        let scene = editor.scene();
        if !keys_change_disk_rate(&scene, &free_fall, &player) {
            continue;
        }
        let mut changed = scene;
        changed.disk.rate = stepped_rate(changed.disk.rate, presses);
        let settings = &preferences.settings;
        let words = disk_rate_words(changed.disk.rate, settings.mass(), settings.units());
        if editor.change("Disk's clock", changed) {
            editor.say(words);
        }
    }
}
