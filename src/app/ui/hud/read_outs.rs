//! The read-outs: the camera's place, its motion, and its flying speed.

use super::board::{BRIGHT, Board, QUIET, TEXT};
use super::presence::Presence;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::FlightInput;
use crate::app::input::held::HeldControls;
use crate::app::motion::disk_clock::{self, ClockDriver};
use crate::app::motion::free_fall::FreeFall;
use crate::app::motion::hand::GEAR;
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::motion::orbit_camera::OrbitCamera;
use crate::app::motion::pilot::Pilot;
use crate::app::state::helm::Helm;
use crate::app::state::paused::Paused;
use crate::app::state::preferences::Preferences;
use crate::app::state::window_shot::WindowShot;
use crate::app::ui::layout::{Layout, Slide, Wish};
use crate::app::ui::screen::Screen;
use bevy::prelude::*;
use bevy_egui::egui::{self, Align2};
use lightfall_core::numbers::{one_decimal, spin_digits, steady_digits};
use lightfall_core::optics::readout::time_dilation;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::{ObserverKind, Scene};
use lightfall_render::DrawnScene;

/// Room between two columns and between two lines, in points.
const GAP: [f32; 2] = [18.0, 3.0];

/// Largest height, as a share of the free part of the window: cards and messages have the rest.
const MAX_HEIGHT: f32 = 1.0 / 3.0;

/// Label of the factor of the flying speed.
const SPEED: &str = "flying speed";

/// One read-out.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadOut {
    /// The quantity, such as `azimuth`. Empty if the value says it.
    pub label: &'static str,
    /// Its value, such as `0.0°`.
    pub value: String,
    /// The widest usual value. The column keeps this width while its numbers change.
    pub widest: &'static str,
}

impl ReadOut {
    fn new(label: &'static str, value: String, widest: &'static str) -> Self {
        Self {
            label,
            value,
            widest,
        }
    }
}

/// The read-outs of a scene in two lines: place and motion. `speed` is the factor of the flying speed.
#[must_use]
pub fn read_outs(scene: &Scene, speed: f64, units: Units) -> [Vec<ReadOut>; 2] {
    let camera = &scene.camera;
    let degrees = |angle: f64| format!("{}°", one_decimal(angle));
    let above = match scene.disk.enabled {
        true => scene.degrees_above_disk(),
        false => 90.0 - camera.theta_deg,
    };
    let height = height(above, scene.disk.enabled);
    let distance = units.length(camera.r, steady_digits);
    let distance = match units {
        Units::Hole => ReadOut::new("r", distance, "00000 r_s"),
        Units::Everyday(_) => ReadOut::new("distance", distance, "000.0 million km"),
    };
    let mut place = vec![
        distance,
        ReadOut::new("", height, "00.0° above the equator"),
    ];
    if !units.are_simple() {
        place.extend([
            ReadOut::new("theta", degrees(camera.theta_deg), "000.0°"),
            ReadOut::new("azimuth", degrees(camera.phi_deg), "−000.0°"),
        ]);
    }
    // Most cameras do not roll.
    if camera.roll_deg.abs() >= 0.05 {
        place.push(ReadOut::new("roll", degrees(camera.roll_deg), "−000.0°"));
    }
    let motion = scene.observer.kind.properties().motion;
    let exposure = if scene.picture.automatic_exposure {
        "automatic exposure".into()
    } else {
        format!("exposure {:+.2}", scene.picture.exposure_ev)
    };
    let mut motion = vec![ReadOut::new("", motion.into(), "hovering at rest")];
    // Inside the horizon no clock far away can be compared.
    if let Ok(Some(rate)) = time_dilation(scene) {
        let rate = format!("{rate:.4} of home's");
        motion.push(ReadOut::new("clock", rate, "0.0000 of home's"));
    }
    motion.extend([
        ReadOut::new("spin", spin_digits(scene.hole.spin), "0.9999"),
        ReadOut::new(SPEED, format!("{speed:.2}×"), "00.00×"),
        ReadOut::new("", exposure, "exposure +00.00"),
    ]);
    [place, motion]
}

/// The angle above the disk's plane in words, as seen from the hole. Without a disk this plane is the
/// equator's.
fn height(above: f64, has_disk: bool) -> String {
    let (plane, place) = match has_disk {
        true => ("the disk's plane", "the disk"),
        false => ("the equator's plane", "the equator"),
    };
    match above {
        _ if above.abs() < 0.05 => format!("in {plane}"),
        _ if above > 0.0 => format!("{above:.1}° above {place}"),
        _ => format!("{:.1}° below {place}", -above),
    }
}

/// The progress of a journey, and the keys that go on with it and end it. Empty without a journey.
fn journey(player: &JourneyPlayer, paused: bool, bindings: &Bindings) -> String {
    if !player.is_playing() {
        return String::new();
    }
    let [stop, pause] = ["journey.fly", "motion.pause"].map(|id| bindings.label(id));
    let progress = player.progress();
    if let Some((_, number)) = player.waits_at() {
        let stops = player.journey().stops.len();
        return format!("Lesson, stop {number} of {stops} · {stop} leaves it");
    }
    if paused {
        format!("Journey paused at {progress} · {pause} goes on · {stop} stops it")
    } else {
        format!("Journey, {progress} · {stop} stops it")
    }
}

pub(super) fn show_read_outs(
    mut screen: Screen,
    scene: Res<DrawnScene>,
    pilot: Res<Pilot>,
    held: HeldControls,
    (free_fall, helm): (Res<FreeFall>, Res<Helm>),
    (player, paused, orbit): (Res<JourneyPlayer>, Res<Paused>, Res<OrbitCamera>),
    (bindings, shot): (Res<Bindings>, Res<WindowShot>),
    (presence, preferences): (Res<Presence>, Res<Preferences>),
) {
    if helm.has_ship() {
        return;
    }
    let mut strength = presence.of_read_outs();
    // A mode that changes what the keys do is always named.
    if orbit.is_on() {
        strength = 1.0;
    }
    let Some((context, layout)) = screen.texts().filter(|_| strength > 0.0) else {
        return;
    };
    let units = preferences.settings.units();
    // The Shift of Shift+F12 is not one that flies faster.
    let gear = match shot.holds_still() {
        true => 1.0,
        false => GEAR.powf(held.axis(FlightInput::Faster, FlightInput::Slower)),
    };
    let mut lines = read_outs(&scene, pilot.throttle * gear, units);
    let moves = free_fall.is_moving() || player.is_playing();
    let motion = &mut lines[1];
    match scene.observer.kind {
        ObserverKind::Rain if !moves => motion[0].value.push_str(", held here"),
        ObserverKind::Static if player.is_playing() => {
            motion[0].value = "as if hovering here".into()
        }
        _ => {}
    }
    // The flying speed is not a speed of the observer.
    motion.retain(|read_out| !moves || read_out.label != SPEED);
    let driver = match (moves, paused.0) {
        (true, _) => ClockDriver::Flight,
        _ if free_fall.is_over(&scene) => ClockDriver::EndOfFall,
        (_, true) => ClockDriver::Pause,
        _ => ClockDriver::Window,
    };
    let modes = [
        orbit.status(&bindings),
        journey(&player, paused.0, &bindings),
        free_fall.clocks(&scene, units),
        disk_clock::status(&scene, driver, &bindings, units),
    ];
    let modes: Vec<_> = modes.into_iter().filter(|line| !line.is_empty()).collect();
    // Where there is no room for all lines, the modes are shown alone, or the place. A part of them in
    // the corner is calmer than all of them somewhere else.
    let parts: [(&[_], &[_]); 3] = [(&lines, &modes), (&[], &modes), (&lines[..1], &[])];
    let slides = [Slide::Nowhere, Slide::Anywhere].map(|slide| parts.map(|part| (slide, part)));
    for (slide, part) in slides.into_iter().flatten() {
        let wish = Wish {
            at: layout.above_touch_bar().left_bottom(),
            ..layout.at(Align2::LEFT_BOTTOM, slide)
        };
        if paint_lines(context, layout, strength, wish, part) {
            break;
        }
    }
}

/// Paints lines of read-outs and what is under way below them. Returns whether there is room.
fn paint_lines(
    context: &egui::Context,
    layout: &mut Layout,
    strength: f32,
    wish: Wish,
    (lines, modes): (&[Vec<ReadOut>], &[String]),
) -> bool {
    let width = layout.bounds().width();
    let mut board = Board::new(context, "read-outs", strength);
    put_columns(&mut board, lines, width - 2.0 * GAP[0]);
    for line in modes {
        board.add_line(board.text(line, TEXT, BRIGHT, width - 2.0 * GAP[0]), GAP[1]);
    }
    if board.size().y > MAX_HEIGHT * layout.bounds().height() {
        return false;
    }
    board.paint(layout, wish).is_some()
}

/// Puts lines of read-outs in aligned columns. If there is not enough room, the last columns are left
/// out.
fn put_columns(board: &mut Board, lines: &[Vec<ReadOut>], room: f32) {
    let row = board.text("0", TEXT, BRIGHT, f32::INFINITY).size().y + GAP[1];
    let space = board.width_of("n", TEXT);
    let columns = lines.iter().map(Vec::len).max().unwrap_or(0);
    let mut left = 0.0;
    for column in 0..columns {
        let mut right: f32 = left;
        let mut texts = Vec::new();
        for (line, cells) in lines.iter().enumerate() {
            let Some(cell) = cells.get(column) else {
                continue;
            };
            let at = egui::vec2(left, line as f32 * row);
            let label = board.text(cell.label, TEXT, QUIET, f32::INFINITY);
            let value = board.text(&cell.value, TEXT, BRIGHT, f32::INFINITY);
            let beside = match cell.label {
                "" => 0.0,
                _ => label.size().x + space,
            };
            let width = value.size().x.max(board.width_of(cell.widest, TEXT));
            right = right.max(left + beside + width);
            texts.extend([(at, label), (at + egui::vec2(beside, 0.0), value)]);
        }
        if right > room {
            return;
        }
        for (at, text) in texts {
            board.put(at, text);
        }
        board.widen(right);
        left = right + GAP[0];
    }
}
