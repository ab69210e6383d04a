//! Real motion in the window: let go, and the camera moves as an observer who falls or circles, in
//! her own time.

use super::MAX_FRAME_SECONDS;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::table::Command;
use crate::app::motion::journey_player::Moment;
use crate::app::state::history::History;
use crate::app::state::last_pose::LastPose;
use crate::app::state::toast::Toast;
use crate::app::ui::end_card::EndCard;
use crate::render::CurrentScene;
use bevy::prelude::*;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::ObserverError;
use lightfall_core::geometry::timelike::Limit;
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::worldline::Worldline;
use lightfall_core::scene::Scene;

/// Own time that passes in a second, over the time r^(3/2) in which things fall from r: so a fall
/// takes about as long from anywhere, and a turn of an orbit a minute and a half.
const PACE: f64 = 0.1;
/// The pace changes by this factor, within a range.
const PACE_NOTCH: f64 = 2.0;
const MIN_TIME_RATE: f64 = PACE / 1024.0;
const MAX_TIME_RATE: f64 = PACE * 1024.0;

/// An observer on her way, if one was let go.
#[derive(Resource, Clone, Debug)]
pub struct FreeFall {
    way: Option<Way>,
    pace: f64,
}

#[derive(Clone, Debug)]
struct Way {
    worldline: Worldline,
    spin: f64,
    last: LastPose,
    limit: Option<Limit>,
}

impl Default for FreeFall {
    fn default() -> Self {
        Self {
            way: None,
            pace: PACE,
        }
    }
}

impl FreeFall {
    /// Whether she is on her way.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.way.is_some()
    }

    /// Her motion, with the clocks.
    #[must_use]
    pub fn worldline(&self) -> Option<&Worldline> {
        self.way.as_ref().map(|way| &way.worldline)
    }

    /// Own time, in r_s, that passes in a second at the radius `r` (r_s).
    #[must_use]
    pub fn rate(&self, r: f64) -> f64 {
        self.pace * r.powf(1.5)
    }

    /// Faster or slower by so many notches.
    pub fn turn_pace(&mut self, notches: i32) {
        self.pace = (self.pace * PACE_NOTCH.powi(notches)).clamp(MIN_TIME_RATE, MAX_TIME_RATE);
    }

    /// Lets the scene's observer go.
    ///
    /// # Errors
    /// If the scene's observer cannot exist.
    pub fn start(&mut self, scene: &Scene) -> Result<(), ObserverError> {
        let worldline = Worldline::start(scene)?;
        self.way = Some(Way {
            worldline,
            spin: scene.hole.spin,
            last: LastPose::new(scene),
            limit: None,
        });
        Ok(())
    }

    /// Stays where she is.
    pub fn stop(&mut self) {
        self.way = None;
    }

    /// Lets `seconds` pass at the pace that is set, but no more than a slow frame's: while the
    /// machine slept, her clock stood still. A camera that is not where it was left has been taken
    /// over by somebody, and the motion is over; looking around is left to everybody.
    pub fn pass(&mut self, seconds: f64, scene: &Scene) -> Moment {
        let rate = self.rate(scene.camera.r);
        let Some(way) = &mut self.way else {
            return Moment::None;
        };
        if !way.last.place_left_alone(scene) || way.spin != scene.hole.spin {
            self.way = None;
            return Moment::None;
        }
        let (mut worldline, mut next) = (way.worldline.clone(), scene.clone());
        let limit = worldline.advance(rate * seconds.min(MAX_FRAME_SECONDS), &mut next);
        match Drawable::new(next) {
            Ok(next) => {
                (way.worldline, way.last) = (worldline, LastPose::new(&next));
                way.limit = limit;
                if limit.is_some() {
                    Moment::End(Box::new(next))
                } else {
                    Moment::Scene(Box::new(next))
                }
            }
            Err(reason) => {
                self.way = None;
                Moment::Refused(reason.to_string())
            }
        }
    }

    /// The clocks, in a line; empty without motion.
    #[must_use]
    pub fn clocks(&self, r: f64) -> String {
        let Some(Way { worldline, .. }) = &self.way else {
            return String::new();
        };
        let far = match worldline.coordinate_time() {
            Some(far) => format!("far time {far:.3}"),
            None => format!("ingoing time {:.3}", worldline.ingoing_time()),
        };
        format!(
            "{} · own time {:.3} r_s/c · {far} r_s/c · {:.3} r_s/c a second",
            if worldline.is_circular() {
                "circling"
            } else {
                "falling freely"
            },
            worldline.proper_time(),
            self.rate(r)
        )
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<FreeFall>()
        .add_systems(Update, (obey, go).chain());
}

fn obey(
    mut commands: MessageReader<Command>,
    mut voyage: ResMut<FreeFall>,
    scene: Res<CurrentScene>,
    time: Res<Time<Real>>,
    mut history: ResMut<History>,
    bindings: Res<Bindings>,
    mut notice: ResMut<Toast>,
    mut card: ResMut<EndCard>,
) {
    for command in commands.read() {
        match command {
            Command::LetGo if voyage.moves() => voyage.stop(),
            Command::LetGo => {
                card.close();
                match voyage.start(&scene) {
                    Ok(()) => history.note_departure(&scene, time.elapsed()),
                    Err(error) => notice.say(error.to_string()),
                }
            }
            Command::TimeFaster => voyage.turn_pace(1),
            Command::TimeSlower => voyage.turn_pace(-1),
            _ => continue,
        }
        // The clocks in the hint tell the pace; where there are none, this does.
        if matches!(command, Command::TimeFaster | Command::TimeSlower) && !voyage.moves() {
            let (rate, key) = (voyage.rate(scene.camera.r), bindings.named("motion.let_go"));
            notice.say(format!(
                "Own time will pass at {rate:.3} r_s/c a second, once {key} lets go"
            ));
        }
    }
}

fn go(
    time: Res<Time>,
    mut voyage: ResMut<FreeFall>,
    mut scene: ResMut<CurrentScene>,
    bindings: Res<Bindings>,
    mut notice: ResMut<Toast>,
    mut card: ResMut<EndCard>,
) {
    if !voyage.moves() {
        return;
    }
    match voyage.pass(time.delta_secs_f64(), &scene) {
        Moment::None => notice.say(format!(
            "The clocks stop here: {} lets go again",
            bindings.named("motion.let_go")
        )),
        Moment::Scene(next) => scene.0 = *next,
        Moment::End(next) => {
            scene.0 = *next;
            card.show("The fall ends here", &ending(&voyage, &scene));
            voyage.stop();
        }
        Moment::Refused(reason) => {
            notice.say(format!("The fall cannot be followed farther: {reason}"))
        }
    }
}

/// Where and when a fall has ended.
fn ending(voyage: &FreeFall, scene: &Scene) -> String {
    let Some(Way {
        worldline, limit, ..
    }) = &voyage.way
    else {
        return String::new();
    };
    let (r, own) = (scene.camera.r, worldline.proper_time());
    match limit {
        Some(Limit::Inner) => {
            let kerr = Kerr {
                spin: scene.hole.spin,
            };
            let (horizon, inner) = (kerr.horizon(), kerr.inner_horizon());
            let reason = match kerr.spin == 0.0 {
                true => {
                    "From here on the tide and the blueshift grow without limit, and no picture would be true.".into()
                }
                false => format!(
                    "Toward the inner horizon, at {inner:.3}, light that fell in with the hole's turning is blueshifted without limit, and what a \
                     real hole is like there nobody knows: no picture would be true."
                ),
            };
            format!(
                "r = {r:.3} r_s, inside the horizon at {horizon:.3}, {own:.3} r_s/c of your own time after letting go. {reason}"
            )
        }
        _ => format!(
            "r = {r:.3e} r_s, {own:.3e} r_s/c of your own time after letting go: as far as a camera goes."
        ),
    }
}
