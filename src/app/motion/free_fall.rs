//! The observer's own motion: once let go, the observer falls or orbits, in its own proper time,
//! and the camera with it.

use super::edge_view::EdgeView;
use super::facing::{Aim, Facing};
use super::flight_step::FlightStep;
use super::journey_player::JourneyPlayer;
use super::pose::{Pose, pose_of};
use super::steering::is_inside;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::controls::refusal::no_observer;
use crate::app::state::MAX_FRAME_SECONDS;
use crate::app::state::end_card::EndCard;
use crate::app::state::hole_in_view::HoleInView;
use crate::app::state::paused::Paused;
use crate::app::state::preferences::Preferences;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::state::window_shot::WindowShot;
use bevy::prelude::*;
use lightfall_core::geometry::observer::ObserverError;
use lightfall_core::geometry::timelike::Limit;
use lightfall_core::numbers::{four_digits, three_digits, with_short_numbers};
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::worldline::Worldline;
use lightfall_core::scene::Scene;

/// Proper time that passes in a second, divided by r^(3/2), the time scale of a fall from r. So a
/// fall takes about as long from anywhere, and one orbit takes a minute and a half.
const DEFAULT_PACE: f64 = 0.1;
/// One press changes the pace by this factor, within a range.
const PACE_STEP: f64 = 2.0;
const MIN_PACE: f64 = DEFAULT_PACE / 1024.0;
const MAX_PACE: f64 = DEFAULT_PACE * 1024.0;

/// Longer than any fall inside a horizon lasts, in r_s/c: half of pi at most, without spin.
const LONGEST_FALL: f64 = 10.0;

/// The time until a fall inside the horizon ends, in words, and where it ends. Without spin it is
/// the centre: from the end of the picture at 0.1 r_s it is 0.0211 r_s/c more (2/3 r^(3/2), exact
/// from rest at infinity; for any other fall it changes no digit that is shown, or the last one).
fn time_left(worldline: &Worldline, scene: &Scene, units: Units) -> [String; 2] {
    let (mut ahead, mut then) = (worldline.clone(), scene.clone());
    ahead.advance(LONGEST_FALL, &mut then);
    let left = ahead.proper_time() - worldline.proper_time();
    let words = |left: f64, end: &str| [units.steady_time(left), end.into()];
    if scene.hole.spin == 0.0 {
        words(left + 2.0 / 3.0 * then.camera.r.powf(1.5), "to the centre")
    } else {
        words(left, "to the last picture")
    }
}

/// The motion of an observer that was let go, if one was, and its pace.
#[derive(Resource, Clone, Debug)]
pub struct FreeFall {
    motion: Option<Motion>,
    pace: f64,
    /// Where the last fall came to its end.
    end: Option<Pose>,
}

/// A motion under way.
#[derive(Clone, Debug)]
struct Motion {
    worldline: Worldline,
    last: Pose,
    limit: Option<Limit>,
}

impl Default for FreeFall {
    fn default() -> Self {
        Self {
            motion: None,
            pace: DEFAULT_PACE,
            end: None,
        }
    }
}

impl FreeFall {
    /// Whether an observer was let go and still moves.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.motion.is_some()
    }

    /// Whether an observer was let go and falls, rather than orbits.
    #[must_use]
    pub fn is_fall(&self) -> bool {
        self.worldline().is_some_and(|line| !line.is_circular())
    }

    /// The motion, with its clocks.
    #[must_use]
    pub fn worldline(&self) -> Option<&Worldline> {
        self.motion.as_ref().map(|motion| &motion.worldline)
    }

    /// Proper time, in r_s, that passes in a second at the radius `r` (r_s).
    #[must_use]
    pub fn rate(&self, r: f64) -> f64 {
        self.pace * r.powf(1.5)
    }

    /// Doubles the pace this many times. A negative number halves it.
    pub fn change_pace(&mut self, steps: i32) {
        self.pace = (self.pace * PACE_STEP.powi(steps)).clamp(MIN_PACE, MAX_PACE);
    }

    /// Lets go of the scene's observer.
    ///
    /// # Errors
    /// The scene's observer cannot exist.
    pub fn start(&mut self, scene: &Scene) -> Result<(), ObserverError> {
        self.motion = Some(Motion {
            worldline: Worldline::start(scene)?,
            last: pose_of(scene),
            limit: None,
        });
        Ok(())
    }

    /// Holds the observer where it is.
    pub fn stop(&mut self) {
        self.motion = None;
    }

    /// Ends a fall that can go no farther.
    fn finish(&mut self, scene: &Scene) {
        self.end = self.is_fall().then(|| pose_of(scene));
        self.stop();
    }

    /// Whether the camera is where a fall came to its end.
    #[must_use]
    pub fn is_over(&self, scene: &Scene) -> bool {
        self.motion.is_none() && self.end == Some(pose_of(scene))
    }

    /// Lets `seconds` pass at the present pace, but no more than one frame may: while the machine
    /// slept, the clocks stood still. A camera that is not where it was left was moved by
    /// something else, which ends the motion. Looking around does not end it.
    pub fn advance(&mut self, seconds: f64, scene: &Scene) -> FlightStep {
        let rate = self.rate(scene.camera.r);
        let Some(motion) = &mut self.motion else {
            return FlightStep::Idle;
        };
        if motion.last != pose_of(scene) {
            self.motion = None;
            return FlightStep::Idle;
        }
        let mut next = scene.clone();
        let proper_time = rate * seconds.min(MAX_FRAME_SECONDS);
        motion.limit = motion.worldline.advance(proper_time, &mut next);
        motion.last = pose_of(&next);
        let step = FlightStep::to(next, motion.limit.is_some());
        if matches!(step, FlightStep::Refused(_)) {
            self.motion = None;
        }
        step
    }

    /// The clocks in one line: the observer's own since the release, and those far away; inside the
    /// horizon, where no clock far away can be compared, the time that is left. Empty without
    /// motion.
    #[must_use]
    pub fn clocks(&self, scene: &Scene, units: Units) -> String {
        let Some(worldline) = self.worldline() else {
            return String::new();
        };
        let own = format!("clock {}", units.steady_time(worldline.proper_time()));
        // The read-outs above already name a fall.
        let own = match (worldline.is_circular(), is_inside(scene)) {
            (true, _) => format!("In orbit · your {own}"),
            (false, false) => format!("Your {own}"),
            (false, true) => {
                let [left, end] = time_left(worldline, scene, units);
                return format!("Inside the horizon · your {own} · {left} {end}");
            }
        };
        let far = worldline.coordinate_time();
        let far = far.map_or_else(String::new, |far| {
            format!(" · far clock {}", units.steady_time(far))
        });
        if worldline.is_circular() {
            return format!("{own}{far}");
        }
        let horizon = units.length(scene.kerr().horizon(), four_digits);
        format!("{own}{far} · horizon at {horizon}")
    }

    /// How fast time passes, in one sentence, e.g. `Time rate in free fall: 4.472 r_s/c per second
    /// (190 s for Sgr A*)`.
    #[must_use]
    pub fn rate_words(&self, r: f64, mass: HoleMass, units: Units) -> String {
        let rate = self.rate(r);
        if units.are_simple() {
            let time = units.time(rate, four_digits);
            return format!("A second here is {time} of the fall, for {}", mass.name);
        }
        format!(
            "Time rate in free fall: {} r_s/c per second ({} s for {})",
            four_digits(rate),
            three_digits(rate * mass.seconds()),
            mass.name
        )
    }

    /// Where and when the motion has ended, for the end card.
    fn ending(&self, scene: &Scene, units: Units) -> String {
        let Some(Motion {
            worldline, limit, ..
        }) = &self.motion
        else {
            return String::new();
        };
        let length = |length| units.length(length, four_digits);
        let r = length(scene.camera.r);
        let proper_time = units.time(worldline.proper_time(), four_digits);
        match limit {
            Some(Limit::Inner) => {
                let kerr = scene.kerr();
                let (horizon, inner) = (length(kerr.horizon()), length(kerr.inner_horizon()));
                let reason = if kerr.spin == 0.0 {
                    "Deeper in, tides and blueshift grow without limit, and no picture would be true.".into()
                } else {
                    format!(
                        "Toward the inner horizon, at {inner}, blueshift grows without limit. Nobody knows what a \
                         real hole is like there, and no picture would be true."
                    )
                };
                format!(
                    "You are {r} from the centre, inside the horizon at {horizon}. Your clock has run {proper_time} since \
                     you let go. {reason}"
                )
            }
            _ => format!(
                "You are {r} from the hole, and your clock has run {proper_time} since you let go. The camera goes no \
                 farther."
            ),
        }
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<FreeFall>().add_systems(
        Update,
        (apply_free_fall_commands, advance_free_fall).chain(),
    );
}

fn apply_free_fall_commands(
    mut commands: MessageReader<AppCommand>,
    mut free_fall: ResMut<FreeFall>,
    player: Res<JourneyPlayer>,
    mut editor: SceneEditor,
    bindings: Res<Bindings>,
    preferences: Res<Preferences>,
    mut paused: ResMut<Paused>,
    (mut end_card, mut facing): (ResMut<EndCard>, ResMut<Facing>),
    hole: Res<HoleInView>,
) {
    for command in commands.read() {
        let scene = editor.drawn_scene();
        match command {
            // These move the camera by themselves.
            AppCommand::OrbitCamera | AppCommand::Journey | AppCommand::RestartJourney
                if free_fall.is_moving() =>
            {
                free_fall.stop();
            }
            AppCommand::LetGo if free_fall.is_moving() => {
                free_fall.stop();
                editor.say(format!("Held at r {} r_s", four_digits(scene.camera.r)));
            }
            AppCommand::LetGo if free_fall.is_over(&scene) => editor.say(format!(
                "The fall is over: {} goes back to where you let go",
                bindings.label("scene.undo")
            )),
            AppCommand::LetGo => {
                paused.0 = false;
                end_card.close();
                match free_fall.start(&scene) {
                    Ok(()) => {
                        editor.note_departure();
                        let mut said = released(&free_fall, &bindings);
                        // The camera faces the hole, so that the user sees where the fall leads.
                        if free_fall.is_fall() && hole.0.is_some_and(|hole| !hole.in_picture) {
                            facing.start(Aim::Hole, &scene);
                            said.push_str(&format!(
                                " · facing the hole, {} looks outward",
                                bindings.label("fly.face")
                            ));
                        }
                        editor.say(said);
                    }
                    Err(error) => editor.say(no_observer(&error, &scene)),
                }
            }
            AppCommand::FasterTime | AppCommand::SlowerTime
                if keys_change_disk_rate(&scene, &free_fall, &player) => {}
            AppCommand::FasterTime | AppCommand::SlowerTime => {
                let faster = *command == AppCommand::FasterTime;
                free_fall.change_pace(if faster { 1 } else { -1 });
                let settings = &preferences.settings;
                editor.say(free_fall.rate_words(scene.camera.r, settings.mass(), settings.units()));
            }
            _ => {}
        }
    }
}

/// Says that the observer was let go, and how to hold it again.
fn released(free_fall: &FreeFall, bindings: &Bindings) -> String {
    let motion = match free_fall.worldline() {
        Some(worldline) if worldline.is_circular() => "In orbit",
        _ => "Falling freely",
    };
    format!("{motion}: {} holds again", bindings.label("motion.let_go"))
}

/// Moves the observer for one frame.
pub(super) fn advance_free_fall(
    time: Res<Time>,
    mut free_fall: ResMut<FreeFall>,
    mut editor: SceneEditor,
    bindings: Res<Bindings>,
    (paused, shot): (Res<Paused>, Res<WindowShot>),
    preferences: Res<Preferences>,
    (mut facing, mut edge_view): (ResMut<Facing>, ResMut<EdgeView>),
    mut end_card: ResMut<EndCard>,
) {
    if !free_fall.is_moving() {
        return;
    }
    // A paused fall still notices that something else moves the camera.
    let seconds = if paused.0 || shot.holds_still() {
        0.0
    } else {
        time.delta_secs_f64()
    };
    let before = editor.drawn_scene();
    let step = free_fall.advance(seconds, &before);
    if let FlightStep::Moved(next) | FlightStep::Ended(next) = &step {
        facing.carry(&before, next);
        edge_view.carry(&before, next);
    }
    match step {
        FlightStep::Idle => editor.say(format!(
            "You are flying by hand: {} lets go again",
            bindings.label("motion.let_go")
        )),
        FlightStep::Moved(next) => editor.fly(&next),
        FlightStep::Ended(next) => {
            editor.fly(&next);
            let units = preferences.settings.units();
            let again = ("scene.undo", "back to where you let go");
            end_card.show(
                "The fall ends here",
                &free_fall.ending(&next, units),
                again,
                None,
            );
            free_fall.finish(&next);
        }
        FlightStep::Refused(reason) => editor.say(format!(
            "The fall cannot go on: {}",
            with_short_numbers(&reason)
        )),
    }
}

/// Whether the keys that slow down and speed up time change the rate of the disk's clock. While a
/// fall or a journey is under way, and where nothing else moves, they change the pace of a fall.
pub(super) fn keys_change_disk_rate(
    scene: &Scene,
    free_fall: &FreeFall,
    player: &JourneyPlayer,
) -> bool {
    scene.disk_moves() && !free_fall.is_moving() && !player.is_playing()
}
