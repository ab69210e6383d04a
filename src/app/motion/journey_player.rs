//! The guided journey: it starts, stops, starts again, and ends when something else moves the
//! camera.

use super::MAX_FRAME_SECONDS;
use super::flight_step::FlightStep;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::state::end_card::EndCard;
use crate::app::state::history::History;
use crate::app::state::last_pose::LastPose;
use crate::app::state::preferences::Preferences;
use crate::app::state::toast::Toast;
use crate::render::CurrentScene;
use bevy::prelude::*;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::journey::{Journey, Unflyable, between};
use lightfall_core::scene::{Camera, Scene};

/// Seconds in which the camera comes from where it is to where the journey is.
const APPROACH: f64 = 4.0;

/// A journey, and how far it has been flown.
#[derive(Resource, Clone, Debug)]
pub struct JourneyPlayer {
    journey: Journey,
    /// Seconds along the journey.
    time: f64,
    flight: Option<Flight>,
}

/// A journey under way.
#[derive(Clone, Debug)]
struct Flight {
    /// The camera at the start, which the flight leaves within [`APPROACH`] seconds.
    from: Camera,
    /// Seconds since the start.
    since: f64,
    last: Option<LastPose>,
}

impl JourneyPlayer {
    /// A journey that has not begun.
    #[must_use]
    pub fn new(journey: Journey) -> Self {
        Self {
            journey,
            time: 0.0,
            flight: None,
        }
    }

    /// Whether the journey is being flown.
    #[must_use]
    pub fn is_playing(&self) -> bool {
        self.flight.is_some()
    }

    /// Seconds along the journey.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// How far the journey has been flown, in words.
    #[must_use]
    pub fn progress(&self) -> String {
        format!("{:.0} of {:.0} s", self.time.floor(), self.journey.duration)
    }

    /// Checks whether the rest of the journey can be flown in this scene; after its end, whether
    /// all of it can.
    ///
    /// # Errors
    /// The first moment that cannot be flown, and why.
    pub fn check(&self, scene: &Scene) -> Result<(), Unflyable> {
        self.journey.check(scene, self.time, Drawable::new)
    }

    /// Goes on from where the journey was left, and approaches that place gently from where the
    /// camera is. After the end, starts again from the beginning.
    pub fn start(&mut self, scene: &Scene) {
        if self.time >= self.journey.duration {
            self.time = 0.0;
        }
        self.flight = Some(Flight {
            from: scene.camera,
            since: 0.0,
            last: None,
        });
    }

    /// Starts from the beginning, with the camera there at once.
    pub fn restart(&mut self) {
        self.time = 0.0;
        self.flight = Some(Flight {
            from: Camera::default(),
            since: APPROACH,
            last: None,
        });
    }

    /// Leaves the camera where it is.
    pub fn stop(&mut self) {
        self.flight = None;
    }

    /// Lets `seconds` pass, but no more than one frame may: a machine that slept did not fly
    /// meanwhile. A camera that is not where it was left was moved by something else, which ends
    /// the flight. A calm flight does not roll.
    pub fn advance(&mut self, seconds: f64, scene: &Scene, calm: bool) -> FlightStep {
        let Some(flight) = &mut self.flight else {
            return FlightStep::Idle;
        };
        if flight
            .last
            .as_ref()
            .is_some_and(|last| !last.has_camera_of(scene))
        {
            self.flight = None;
            return FlightStep::Idle;
        }
        // The first frame shows the start itself.
        if flight.last.is_some() {
            self.time += seconds.min(MAX_FRAME_SECONDS);
            flight.since += seconds.min(MAX_FRAME_SECONDS);
        }
        let mut next = scene.clone();
        self.journey.apply(self.time, &mut next);
        if calm {
            next.camera.roll_deg = scene.camera.roll_deg;
        }
        next.camera = between(&flight.from, &next.camera, flight.since / APPROACH);
        match Drawable::new(next) {
            Ok(next) if self.time >= self.journey.duration => {
                self.flight = None;
                FlightStep::Ended(Box::new(next))
            }
            Ok(next) => {
                flight.last = Some(LastPose::new(&next));
                FlightStep::Moved(Box::new(next))
            }
            Err(reason) => {
                self.flight = None;
                FlightStep::Refused(reason.to_string())
            }
        }
    }

    /// Where the journey has ended, for the end card.
    fn ending(&self, scene: &Scene, bindings: &Bindings) -> String {
        let title = self.journey.title.trim();
        let heading = if title.is_empty() {
            String::new()
        } else {
            format!("{title}.\n\n")
        };
        let r = scene.camera.r;
        let horizon = Kerr {
            spin: scene.hole.spin,
        }
        .horizon();
        if r < horizon {
            return format!(
                "{heading}r = {r:.3} r_s, inside the horizon at {horizon:.3}. What you see fell in after you. Nothing that you send \
                 reaches the outside, and every way leads farther in."
            );
        }
        let let_go = bindings.label("motion.let_go");
        let observer = scene.observer.kind.properties();
        let here = if observer.falls_freely {
            format!("You are {}: {let_go} lets it go on.", observer.motion)
        } else {
            "Closer to it, hovering takes ever more thrust, without limit.".into()
        };
        format!("{heading}r = {r:.3} r_s. The horizon is at {horizon:.3}. {here}")
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, (apply_journey_commands, advance_journey).chain());
}

fn apply_journey_commands(
    mut commands: MessageReader<AppCommand>,
    mut player: ResMut<JourneyPlayer>,
    scene: Res<CurrentScene>,
    time: Res<Time<Real>>,
    mut history: ResMut<History>,
    bindings: Res<Bindings>,
    mut toast: ResMut<Toast>,
    mut end_card: ResMut<EndCard>,
) {
    for command in commands.read() {
        match command {
            AppCommand::Journey if player.is_playing() => {
                player.stop();
                toast.say(format!(
                    "The journey stops at {}: {}",
                    player.progress(),
                    how_to_go_on(&bindings)
                ));
                end_card.close();
                continue;
            }
            AppCommand::Journey => player.start(&scene),
            AppCommand::RestartJourney => player.restart(),
            _ => continue,
        }
        history.note_departure(&scene, time.elapsed());
        toast.clear();
        end_card.close();
        // A journey that cannot be flown to its end is flown as far as possible.
        if let Err(fault) = player.check(&scene) {
            toast.say(format!(
                "This journey cannot be flown to its end here: {fault}"
            ));
        }
    }
}

/// Which keys go on with a journey that was left.
fn how_to_go_on(bindings: &Bindings) -> String {
    let [on, again] = ["journey.fly", "journey.again"].map(|id| bindings.label(id));
    format!("{on} goes on, {again} starts again")
}

fn advance_journey(
    time: Res<Time>,
    mut player: ResMut<JourneyPlayer>,
    mut scene: ResMut<CurrentScene>,
    preferences: Res<Preferences>,
    bindings: Res<Bindings>,
    mut toast: ResMut<Toast>,
    mut end_card: ResMut<EndCard>,
) {
    if !player.is_playing() {
        return;
    }
    let calm = preferences.settings.reduced_motion;
    match player.advance(time.delta_secs_f64(), &scene, calm) {
        FlightStep::Idle => toast.say(format!(
            "You are flying now. The journey waits at {}: {}",
            player.progress(),
            how_to_go_on(&bindings)
        )),
        FlightStep::Moved(next) => scene.0 = *next,
        FlightStep::Ended(next) => {
            scene.0 = *next;
            end_card.show("The journey ends here", &player.ending(&scene, &bindings));
        }
        FlightStep::Refused(reason) => toast.say(format!("The journey cannot go on: {reason}")),
    }
}
