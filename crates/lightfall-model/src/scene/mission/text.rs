//! The tables of a mission's text.

use super::{Condition, MissionKey, Quantity};
use crate::scene::ObserverKind;
use crate::scene::question::Question;
use serde::Deserialize;

/// The text of a mission, table by table.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Text {
    #[serde(rename = "schema")]
    pub(super) _schema: i64,
    pub(super) name: String,
    pub(super) title: String,
    pub(super) preset: String,
    pub(super) hole: HoleOfMission,
    pub(super) ship: Ship,
    pub(super) start: Start,
    pub(super) brief: String,
    #[serde(default)]
    pub(super) teaches: String,
    pub(super) keys: Option<Vec<MissionKey>>,
    pub(super) goal: Vec<Goal>,
    #[serde(default)]
    pub(super) fail: Vec<Fail>,
    #[serde(default)]
    pub(super) caption: Vec<Caption>,
    #[serde(default)]
    pub(super) hint: Vec<Hint>,
    #[serde(default)]
    pub(super) question: Vec<Question>,
    #[serde(default)]
    pub(super) par: Vec<Par>,
    pub(super) ending: Ending,
    #[serde(default)]
    pub(super) solution: Vec<BurnText>,
}

/// The hole of a mission.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HoleOfMission {
    /// chi, as `hole.spin` of a preset.
    pub spin: f64,
    /// Its mass, in suns, for years and g.
    pub mass_suns: f64,
}

/// The ship of a mission.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ship {
    /// The rapidity of a full tank.
    pub rapidity: f64,
    /// The largest proper acceleration, in c^2/r_s.
    pub acceleration: f64,
    /// The speed of the exhaust, in c.
    pub exhaust: f64,
}

/// Where and how the ship starts.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Start {
    /// `camera.r`.
    pub r: f64,
    /// `camera.theta_deg`.
    #[serde(default = "equator")]
    pub theta_deg: f64,
    /// `camera.phi_deg`.
    #[serde(default)]
    pub phi_deg: f64,
    /// `observer.kind`.
    pub observer: ObserverKind,
    /// `observer.velocity`.
    #[serde(default)]
    pub velocity: [f64; 3],
    /// Where the nose points.
    pub face: Face,
    /// The place of the star that the nose faces, as theta and phi of the sky in degrees; without it, the
    /// star that lies straight outward from the hole at the start.
    #[serde(default)]
    pub star_deg: Option<[f64; 2]>,
    /// What the pilot looks at.
    #[serde(default)]
    pub look: Look,
}

impl Start {
    /// Theta and phi of the star that the nose faces, on the sky in the hole's frame, in degrees.
    pub fn star_place_deg(&self) -> [f64; 2] {
        self.star_deg.unwrap_or([self.theta_deg, self.phi_deg])
    }
}

fn equator() -> f64 {
    90.0
}

crate::words! {
    /// What a ship's nose can face.
    pub enum Face {
        /// The hole.
        Hole = "hole",
        /// The motion's direction.
        Prograde = "prograde",
        /// The opposite one.
        Retrograde = "retrograde",
        /// Away from the hole.
        Outward = "outward",
        /// A star.
        Star = "star",
    }
}

crate::words! {
    /// What a ship's pilot looks at.
    pub enum Look {
        /// What is ahead of the nose.
        Nose = "nose",
        /// The hole, wherever the nose points, with the disk level.
        Hole = "hole",
    }
}

crate::words! {
    /// A direction that a ship can push toward.
    pub enum Course {
        /// Toward the hole.
        Hole = "hole",
        /// Away from it.
        Outward = "outward",
        /// Along the motion.
        Prograde = "prograde",
        /// Against the motion.
        Retrograde = "retrograde",
    }
}

/// What a player has to reach.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Goal {
    /// What it is, in a sentence.
    pub text: String,
    /// The conditions that must hold together.
    pub all: Vec<Condition>,
    /// For how long they must hold, in own time.
    #[serde(default)]
    pub hold: f64,
}

/// What ends a mission without success.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fail {
    /// What happened, in a sentence.
    pub text: String,
    /// The conditions that must hold together.
    pub all: Vec<Condition>,
}

/// A text that is shown once.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Caption {
    /// What it says.
    pub text: String,
    /// The conditions under which it appears; none for one at the start.
    #[serde(default)]
    pub when: Vec<Condition>,
}

/// A text that is shown after failed attempts.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Hint {
    /// What it says.
    pub text: String,
    /// After how many.
    pub after: u32,
}

/// What a good flight needs.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Par {
    /// Of what.
    pub quantity: Quantity,
    /// How much.
    pub value: f64,
    /// Whether more of it is better.
    #[serde(default)]
    pub better: Better,
}

crate::words! {
    /// Which side of a par is the better one.
    pub enum Better {
        /// Less is better.
        Less = "less",
        /// More is better.
        More = "more",
    }
}

/// What the card at the end says.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ending {
    /// After success.
    pub success: String,
    /// After a failure that has no text of its own.
    pub failure: String,
}

/// A part of a solution as it is written.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BurnText {
    pub(super) thrust: Option<Push>,
    pub(super) coast: Option<bool>,
    pub(super) hover: Option<f64>,
    pub(super) orbit: Option<f64>,
    pub(super) a: Option<f64>,
    pub(super) until: Option<UntilText>,
    #[serde(rename = "for")]
    pub(super) duration: Option<f64>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(try_from = "String")]
pub(super) struct UntilText(pub(super) Until);

impl TryFrom<String> for UntilText {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        Ok(Self(if text == "apsis" {
            Until::Apsis
        } else {
            Until::Holds(text.try_into()?)
        }))
    }
}

/// A part of a solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Burn {
    /// What the engine does.
    pub push: Push,
    /// The proper acceleration, or the largest of a hold, in c^2/r_s.
    pub acceleration: f64,
    /// When it ends.
    pub until: Until,
}

/// What an engine does in a part of a solution.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(
    untagged,
    expecting = "it must be one of hole, outward, prograde, retrograde, or three numbers on the axes of the observer, \
                 such as [1, 0, 0]"
)]
pub enum Push {
    /// Thrust along a course.
    Along(Course),
    /// Thrust along a direction on the axes of the scene's observer.
    Axes([f64; 3]),
    /// Nothing.
    #[serde(skip)]
    Off,
    /// Holds still at this radius.
    #[serde(skip)]
    Hover(f64),
    /// Holds the circle of this radius.
    #[serde(skip)]
    Orbit(f64),
}

/// When a part of a solution ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Until {
    /// At the next turning point.
    Apsis,
    /// When a condition holds.
    Holds(Condition),
    /// After this own time.
    Passed(f64),
}
