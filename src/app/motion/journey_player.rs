//! The guided journey in the window: starts, stops, begins again, and gives way to the hand.

use super::MAX_FRAME_SECONDS;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::table::Command;
use crate::app::session::window::Preferences;
use crate::app::state::history::History;
use crate::app::state::last_pose::LastPose;
use crate::app::state::toast::Toast;
use crate::app::ui::end_card::EndCard;
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
    /// Where the camera was, and since how many seconds it leaves there.
    from: Camera,
    since: f64,
    last: Option<LastPose>,
}

/// What a moment of a guided flight comes to.
#[derive(Clone, Debug, PartialEq)]
pub enum Moment {
    /// Nothing: there is no flight, or somebody else has moved the camera and keeps it.
    None,
    /// The scene as it is now.
    Scene(Box<Drawable>),
    /// As before, and that is the end of it.
    End(Box<Drawable>),
    /// It cannot go on, for this reason.
    Refused(String),
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

    /// Whether it is under way.
    #[must_use]
    pub fn flies(&self) -> bool {
        self.flight.is_some()
    }

    /// Seconds along the journey.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// How far along the journey it is, in words.
    #[must_use]
    pub fn progress(&self) -> String {
        format!("{:.0} of {:.0} s", self.time.floor(), self.journey.duration)
    }

    /// Whether what is left of it can be flown in this scene: all of it where it would begin again.
    ///
    /// # Errors
    /// The first moment that cannot, and why.
    pub fn check(&self, scene: &Scene) -> Result<(), Unflyable> {
        self.journey.check(scene, self.time, Drawable::new)
    }

    /// The journey's title as the beginning of a text; empty if it has none.
    fn heading(&self) -> String {
        let title = self.journey.title.trim();
        if title.is_empty() {
            String::new()
        } else {
            format!("{title}.\n\n")
        }
    }

    /// Goes on from where the journey was left, coming gently from where the camera is; after its
    /// end from the beginning.
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

    /// Begins again, with the camera at the beginning.
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

    /// Lets `seconds` pass, but no more than a slow frame's: a machine that slept meanwhile did not
    /// fly. A camera that is not where it was left has been taken over by somebody, and the flight
    /// is over. A calm flight does not roll.
    pub fn pass(&mut self, seconds: f64, scene: &Scene, calm: bool) -> Moment {
        let Some(flight) = &mut self.flight else {
            return Moment::None;
        };
        if flight
            .last
            .as_ref()
            .is_some_and(|last| !last.left_alone(scene))
        {
            self.flight = None;
            return Moment::None;
        }
        // The first moment shows where it begins.
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
            Ok(next) => {
                flight.last = Some(LastPose::new(&next));
                let ended = self.time >= self.journey.duration;
                if ended {
                    self.flight = None;
                }
                if ended {
                    Moment::End(Box::new(next))
                } else {
                    Moment::Scene(Box::new(next))
                }
            }
            Err(reason) => {
                self.flight = None;
                Moment::Refused(reason.to_string())
            }
        }
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, (obey, fly).chain());
}

fn obey(
    mut commands: MessageReader<Command>,
    mut guide: ResMut<JourneyPlayer>,
    scene: Res<CurrentScene>,
    time: Res<Time<Real>>,
    mut history: ResMut<History>,
    bindings: Res<Bindings>,
    mut notice: ResMut<Toast>,
    mut card: ResMut<EndCard>,
) {
    for command in commands.read() {
        match command {
            Command::Journey if guide.flies() => {
                notice.say(format!(
                    "The journey stops at {}: {}",
                    guide.progress(),
                    onward(&bindings)
                ));
                guide.stop();
                card.close();
                continue;
            }
            Command::Journey => guide.start(&scene),
            Command::JourneyAgain => guide.restart(),
            _ => continue,
        }
        history.note_departure(&scene, time.elapsed());
        notice.clear();
        card.close();
        // What can be flown of it is.
        if let Err(fault) = guide.check(&scene) {
            notice.say(format!(
                "This journey cannot be flown to its end here: {fault}"
            ));
        }
    }
}

/// How a journey that was left goes on.
fn onward(bindings: &Bindings) -> String {
    let [on, again] = ["journey.fly", "journey.again"].map(|id| bindings.named(id));
    format!("{on} goes on, {again} begins again")
}

fn fly(
    time: Res<Time>,
    mut guide: ResMut<JourneyPlayer>,
    mut scene: ResMut<CurrentScene>,
    preferences: Res<Preferences>,
    bindings: Res<Bindings>,
    mut notice: ResMut<Toast>,
    mut card: ResMut<EndCard>,
) {
    if !guide.flies() {
        return;
    }
    match guide.pass(
        time.delta_secs_f64(),
        &scene,
        preferences.settings.reduced_motion,
    ) {
        Moment::None => {
            notice.say(format!(
                "You fly now. The journey waits at {}: {}",
                guide.progress(),
                onward(&bindings)
            ));
        }
        Moment::Scene(next) => scene.0 = *next,
        Moment::End(next) => {
            scene.0 = *next;
            card.show(
                "The journey ends here",
                &format!("{}{}", guide.heading(), ending(&scene, &bindings)),
            );
        }
        Moment::Refused(reason) => notice.say(format!("The journey cannot go on here: {reason}")),
    }
}

/// Where a journey has ended, in a sentence.
fn ending(scene: &Scene, bindings: &Bindings) -> String {
    let (r, horizon) = (
        scene.camera.r,
        Kerr {
            spin: scene.hole.spin,
        }
        .horizon(),
    );
    if r < horizon {
        return format!(
            "r = {r:.3} r_s, inside the horizon at {horizon:.3}. What you see fell in after you; nothing that you send reaches \
             the outside, and every way leads further in."
        );
    }
    let observer = scene.observer.kind.properties();
    let let_go = bindings.named("motion.let_go");
    let here = match (observer.falls_freely, observer.equatorial) {
        (false, _) => "The nearer it is, the more thrust hovering takes, without limit.".into(),
        (true, true) => format!("You circle it: {let_go} lets the orbit go on."),
        (true, false) => format!("You fall freely: {let_go} lets the fall go on."),
    };
    format!("r = {r:.3} r_s. The horizon is at {horizon:.3}. {here}")
}
