//! What each control does, written out by hand: the fields of the scene that its key changes, or
//! another part of the program's state.

use super::scripts;
use crate::session::Session;
use watched::State;

/// What the keys of a control do to the plain scene.
pub enum Effect {
    /// These fields of the scene get these values, as in JSON, and no others change.
    Fields(&'static [(&'static str, &'static str)]),
    /// A number of the scene becomes smaller while the key is held.
    Falls(&'static str),
    /// A number of the scene becomes larger while the key is held.
    Grows(&'static str),
    /// The built-in preset with this name is loaded.
    Loads(&'static str),
    /// Something of the program's state is switched on, and off when the key is pressed again.
    Switches(fn(&State) -> bool),
    /// What this function looks at, which is given the key.
    Script(fn(&mut Session, &str)),
}

use Effect::{Falls, Fields, Grows, Loads, Script, Switches};

/// Every control with its effect, in the order in which a session tests them: a loaded preset is
/// what switches return to, and nothing comes after the end.
pub const EFFECTS: &[(&str, Effect)] = &[
    ("scene.disk", Fields(&[("disk.enabled", "false")])),
    ("scene.isco", Fields(&[("disk.follow_isco", "true")])),
    ("scene.sky", Fields(&[("sky.mode", "\"off\"")])),
    ("scene.sky_mode", Fields(&[("sky.mode", "\"procedural\"")])),
    ("scene.probe", Fields(&[("probe.enabled", "true")])),
    ("scene.spin", Fields(&[("hole.spin", "0.9")])),
    ("scene.observer", Fields(&[("observer.kind", "\"zamo\"")])),
    ("light.lensing", Fields(&[("effects.lensing", "false")])),
    ("light.doppler", Fields(&[("effects.doppler", "false")])),
    ("light.beaming", Fields(&[("effects.beaming", "false")])),
    (
        "light.gravitational_shift",
        Fields(&[("effects.gravitational_shift", "false")]),
    ),
    ("view.unfinished", Script(scripts::empty_view)),
    ("view.classes", Fields(&[("view", "\"classes\"")])),
    ("view.residual", Script(scripts::empty_view)),
    ("view.order", Fields(&[("view", "\"order\"")])),
    ("view.delay", Fields(&[("view", "\"delay\"")])),
    ("view.steps", Script(scripts::empty_view)),
    ("view.redshift", Fields(&[("view", "\"redshift\"")])),
    ("view.error", Fields(&[("view", "\"error\"")])),
    ("view.depth", Script(scripts::empty_view)),
    ("view.samples", Script(scripts::empty_view)),
    ("view.light_error", Script(scripts::empty_view)),
    ("picture.bloom", Fields(&[("picture.bloom", "0.0")])),
    ("picture.antialias", Fields(&[("probe.antialias", "true")])),
    ("picture.bypass", Fields(&[("picture.bypass", "true")])),
    ("picture.dither", Fields(&[("picture.dither", "false")])),
    ("picture.levels", Fields(&[("picture.levels", "256")])),
    (
        "picture.brighter",
        Fields(&[("picture.exposure_ev", "2.25")]),
    ),
    ("picture.darker", Fields(&[("picture.exposure_ev", "1.75")])),
    (
        "picture.automatic_exposure",
        Fields(&[("picture.automatic_exposure", "true")]),
    ),
    ("scene.undo", Script(scripts::undo)),
    // The camera faces the hole: forward is inward, and growing phi is to the right.
    ("fly.forward", Falls("camera.r")),
    ("fly.backward", Grows("camera.r")),
    ("fly.left", Falls("camera.phi_deg")),
    ("fly.right", Grows("camera.phi_deg")),
    ("fly.up", Falls("camera.theta_deg")),
    ("fly.down", Grows("camera.theta_deg")),
    ("fly.look_left", Falls("camera.yaw_deg")),
    ("fly.look_right", Grows("camera.yaw_deg")),
    ("fly.look_up", Grows("camera.pitch_deg")),
    ("fly.look_down", Falls("camera.pitch_deg")),
    ("fly.roll_left", Falls("camera.roll_deg")),
    ("fly.roll_right", Grows("camera.roll_deg")),
    ("fly.narrower", Falls("camera.fov_deg")),
    ("fly.wider", Grows("camera.fov_deg")),
    ("fly.faster", Script(scripts::faster)),
    ("fly.slower", Script(scripts::slower)),
    ("fly.face", Script(scripts::face)),
    // Only the ship's nose has more than two headings.
    ("fly.face_back", Script(scripts::face)),
    ("fly.orbit", Script(scripts::orbit)),
    ("fly.mouse", Script(scripts::mouse_look)),
    ("fly.escape", Switches(|state| state.menu)),
    (
        "window.help",
        Switches(|state| state.shows("Physics: switch it off and on")),
    ),
    ("window.panel", Switches(|state| state.shows("Machine"))),
    (
        "window.inspector",
        Switches(|state| state.shows("Ray inspector")),
    ),
    (
        "window.guides",
        Switches(|state| state.shows("edge of the shadow")),
    ),
    ("window.star_names", Switches(|state| state.shows("Shaula"))),
    ("window.hide", Script(scripts::photo_mode)),
    ("window.screenshot", Script(scripts::screenshot)),
    ("window.screenshot_of_window", Script(scripts::screenshot)),
    ("window.fullscreen", Switches(|state| state.full_screen)),
    ("picture.compare", Script(scripts::compare)),
    ("picture.difference", Script(scripts::difference)),
    ("motion.let_go", Switches(|state| state.falls)),
    ("ship.fly", Switches(|state| state.ship.is_some())),
    ("ship.map", Script(scripts::map)),
    ("ship.missions", Script(scripts::missions)),
    ("motion.slower", Script(scripts::slower_time)),
    ("motion.faster", Script(scripts::faster_time)),
    ("journey.fly", Switches(|state| state.journey.is_some())),
    ("journey.again", Script(scripts::journey_again)),
    ("journey.back", Script(scripts::journey_back)),
    ("journey.ahead", Script(scripts::journey_ahead)),
    ("lesson.add_stop", Script(scripts::add_stop)),
    ("lesson.save", Script(scripts::save_lesson)),
    ("motion.pause", Script(scripts::pause)),
    ("preset.1", Loads("telescope")),
    ("preset.2", Loads("edge-on")),
    ("preset.3", Loads("above")),
    ("preset.4", Loads("close")),
    ("preset.5", Loads("einstein-ring")),
    ("preset.6", Loads("probe")),
    ("preset.7", Loads("limit")),
    ("preset.8", Loads("extremal")),
    ("preset.9", Loads("falling")),
    // The plain scene has the name of the second preset.
    ("preset.previous", Loads("telescope")),
    ("preset.next", Loads("above")),
    ("window.quit", Script(scripts::quit)),
];
