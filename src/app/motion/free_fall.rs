//! The observer's own motion: once let go, the observer falls or orbits, in its own proper time,
//! and the camera with it.

use super::MAX_FRAME_SECONDS;
use super::flight_step::FlightStep;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::state::end_card::EndCard;
use crate::app::state::history::History;
use crate::app::state::last_pose::LastPose;
use crate::app::state::toast::Toast;
use crate::render::CurrentScene;
use bevy::prelude::*;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::ObserverError;
use lightfall_core::geometry::timelike::Limit;
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::worldline::Worldline;
use lightfall_core::scene::Scene;

/// Proper time that passes in a second, divided by r^(3/2), the time scale of a fall from r. So a
/// fall takes about as long from anywhere, and one orbit takes a minute and a half.
const DEFAULT_PACE: f64 = 0.1;
/// One press changes the pace by this factor, within a range.
const PACE_STEP: f64 = 2.0;
const MIN_PACE: f64 = DEFAULT_PACE / 1024.0;
const MAX_PACE: f64 = DEFAULT_PACE * 1024.0;

/// The motion of an observer that was let go, if one was, and its pace.
#[derive(Resource, Clone, Debug)]
pub struct FreeFall {
    motion: Option<Motion>,
    pace: f64,
}

/// A motion under way.
#[derive(Clone, Debug)]
struct Motion {
    worldline: Worldline,
    spin: f64,
    last: LastPose,
    limit: Option<Limit>,
}

impl Default for FreeFall {
    fn default() -> Self {
        Self {
            motion: None,
            pace: DEFAULT_PACE,
        }
    }
}

impl FreeFall {
    /// Whether an observer was let go and still moves.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.motion.is_some()
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
        let worldline = Worldline::start(scene)?;
        self.motion = Some(Motion {
            worldline,
            spin: scene.hole.spin,
            last: LastPose::new(scene),
            limit: None,
        });
        Ok(())
    }

    /// Holds the observer where it is.
    pub fn stop(&mut self) {
        self.motion = None;
    }

    /// Lets `seconds` pass at the present pace, but no more than one frame may: while the machine
    /// slept, the clocks stood still. A camera that is not where it was left was moved by
    /// something else, which ends the motion. Looking around does not end it.
    pub fn advance(&mut self, seconds: f64, scene: &Scene) -> FlightStep {
        let rate = self.rate(scene.camera.r);
        let Some(motion) = &mut self.motion else {
            return FlightStep::Idle;
        };
        if !motion.last.has_place_of(scene) || motion.spin != scene.hole.spin {
            self.motion = None;
            return FlightStep::Idle;
        }
        let (mut worldline, mut next) = (motion.worldline.clone(), scene.clone());
        let limit = worldline.advance(rate * seconds.min(MAX_FRAME_SECONDS), &mut next);
        match Drawable::new(next) {
            Ok(next) => {
                (motion.worldline, motion.last) = (worldline, LastPose::new(&next));
                motion.limit = limit;
                if limit.is_some() {
                    FlightStep::Ended(Box::new(next))
                } else {
                    FlightStep::Moved(Box::new(next))
                }
            }
            Err(reason) => {
                self.motion = None;
                FlightStep::Refused(reason.to_string())
            }
        }
    }

    /// The clocks in one line. Empty without motion.
    #[must_use]
    pub fn clocks(&self, r: f64) -> String {
        let Some(worldline) = self.worldline() else {
            return String::new();
        };
        let far = match worldline.coordinate_time() {
            Some(far) => format!("far time {far:.3}"),
            None => format!("ingoing time {:.3}", worldline.ingoing_time()),
        };
        format!(
            "{} · proper time {:.3} r_s/c · {far} r_s/c · {:.3} r_s/c per second",
            if worldline.is_circular() {
                "in orbit"
            } else {
                "in free fall"
            },
            worldline.proper_time(),
            self.rate(r)
        )
    }

    /// Where and when the motion has ended, for the end card.
    fn ending(&self, scene: &Scene) -> String {
        let Some(Motion {
            worldline, limit, ..
        }) = &self.motion
        else {
            return String::new();
        };
        let (r, proper_time) = (scene.camera.r, worldline.proper_time());
        match limit {
            Some(Limit::Inner) => {
                let kerr = Kerr {
                    spin: scene.hole.spin,
                };
                let (horizon, inner) = (kerr.horizon(), kerr.inner_horizon());
                let reason = if kerr.spin == 0.0 {
                    "From here on tide and blueshift grow without limit, and no picture would be true.".into()
                } else {
                    format!(
                        "Toward the inner horizon, at {inner:.3}, the blueshift of light that fell in along with the hole's rotation grows \
                         without limit, and nobody knows what a real hole is like there: no picture would be true."
                    )
                };
                format!(
                    "r = {r:.3} r_s, inside the horizon at {horizon:.3}, after {proper_time:.3} r_s/c of your proper time. {reason}"
                )
            }
            _ => format!(
                "r = {r:.3e} r_s, after {proper_time:.3e} r_s/c of your proper time. The camera goes no farther."
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
    scene: Res<CurrentScene>,
    time: Res<Time<Real>>,
    mut history: ResMut<History>,
    bindings: Res<Bindings>,
    mut toast: ResMut<Toast>,
    mut end_card: ResMut<EndCard>,
) {
    for command in commands.read() {
        match command {
            AppCommand::LetGo if free_fall.is_moving() => free_fall.stop(),
            AppCommand::LetGo => {
                end_card.close();
                match free_fall.start(&scene) {
                    Ok(()) => history.note_departure(&scene, time.elapsed()),
                    Err(error) => toast.say(error.to_string()),
                }
            }
            AppCommand::FasterTime => free_fall.change_pace(1),
            AppCommand::SlowerTime => free_fall.change_pace(-1),
            _ => continue,
        }
        // The clocks in the status bar show the pace. Without clocks, the toast does.
        if matches!(command, AppCommand::FasterTime | AppCommand::SlowerTime)
            && !free_fall.is_moving()
        {
            let rate = free_fall.rate(scene.camera.r);
            toast.say(format!(
                "Once {} lets go, proper time passes at {rate:.3} r_s/c per second",
                bindings.label("motion.let_go")
            ));
        }
    }
}

fn advance_free_fall(
    time: Res<Time>,
    mut free_fall: ResMut<FreeFall>,
    mut scene: ResMut<CurrentScene>,
    bindings: Res<Bindings>,
    mut toast: ResMut<Toast>,
    mut end_card: ResMut<EndCard>,
) {
    if !free_fall.is_moving() {
        return;
    }
    match free_fall.advance(time.delta_secs_f64(), &scene) {
        FlightStep::Idle => toast.say(format!(
            "The clocks stop here: {} lets go again",
            bindings.label("motion.let_go")
        )),
        FlightStep::Moved(next) => scene.0 = *next,
        FlightStep::Ended(next) => {
            scene.0 = *next;
            end_card.show("The fall ends here", &free_fall.ending(&scene));
            free_fall.stop();
        }
        FlightStep::Refused(reason) => toast.say(format!("The fall cannot go on: {reason}")),
    }
}
