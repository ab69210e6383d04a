//! The missions that are offered, the built-in ones first, and what was reached in them.

use super::end_card::EndCard;
use super::mission_results::{MissionResult, MissionResults};
use super::typed_answer::TypedAnswer;
use bevy::prelude::*;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::Question;
use lightfall_core::scene::mission::{MISSIONS, Mission, load};
use lightfall_platform::storage::{Opened, mission_results_file, open_file, own_missions};

/// The missions, and the results so far.
#[derive(Resource, Default)]
pub(crate) struct Missions {
    /// The missions, in the order of the list.
    pub(crate) list: Vec<Mission>,
    /// What was reached.
    pub(crate) results: MissionResults,
    /// The name of the mission that was begun last, and whether the last end of its attempts reached its goals.
    flown: Option<(String, bool)>,
}

/// The question of a mission whose goals were reached, until it is answered or closed.
#[derive(Resource, Default)]
pub(crate) struct AskedQuestion {
    /// The question, and the result that the answer belongs to.
    asked: Option<(Question, MissionResult)>,
    /// The answer to it.
    pub(crate) answer: TypedAnswer,
    /// The card that tells the end of the mission, and with it the answer.
    card: EndCard,
}

impl AskedQuestion {
    /// Asks a question about the last result. The card waits until it is closed.
    pub(crate) fn ask(&mut self, question: Question, result: MissionResult, card: EndCard) {
        *self = Self {
            asked: Some((question, result)),
            card,
            ..Self::default()
        };
    }

    /// The question that is asked.
    pub(crate) fn question(&self) -> Option<&Question> {
        self.asked.as_ref().map(|(question, _)| question)
    }

    /// Closes the question. Returns the card that waited.
    pub(crate) fn close(&mut self) -> EndCard {
        std::mem::take(self).card
    }

    /// Judges what was typed, and returns the result with the answer. The hint has its lengths and times in
    /// these units.
    pub(crate) fn judge(&mut self, units: Units) -> Option<MissionResult> {
        let (question, result) = self.asked.as_mut()?;
        let question = Question {
            hint: units.in_text(&question.hint),
            ..question.clone()
        };
        let judged = self.answer.judge(&question)?;
        (result.answer, result.is_right) = (Some(judged.number), Some(judged.is_right));
        Some(result.clone())
    }
}

/// Begin this mission.
#[derive(Message, Clone, Debug)]
pub(crate) struct StartMission(pub(crate) Box<Mission>);

impl Missions {
    /// The next mission of the list after the one with this name that was not yet reached, or the first
    /// such one of those before it.
    pub(crate) fn next_after(&self, name: &str) -> Option<&Mission> {
        next_not_reached(&self.list, name, |name| self.results.best(name).is_some())
    }

    /// Notes the mission that has begun or come to an end, and whether its goals were reached there.
    pub(crate) fn note_flown(&mut self, name: &str, has_reached: bool) {
        self.flown = Some((name.to_owned(), has_reached));
    }

    /// Where the cursor of the list begins, as a place in it.
    pub(crate) fn first_choice(&self) -> Option<usize> {
        let flown = self
            .flown
            .as_ref()
            .map(|(name, reached)| (name.as_str(), *reached));
        first_choice(&self.list, flown, |name| self.results.best(name).is_some())
    }

    /// Reads the missions and the results. Returns what is wrong with the user's own ones.
    pub(crate) fn read(&mut self) -> Vec<String> {
        let built_in = MISSIONS
            .iter()
            .map(|(name, text)| load(name, text).map_err(|fault| fault.to_string()));
        let own = own_missions();
        let own = own.iter().map(|file| match open_file(file, &[]) {
            Ok(Opened::Mission(mission)) => Ok(*mission),
            Ok(Opened::Scene(_) | Opened::Journey(_)) => {
                Err(format!("{}: has no table [[goal]]", file.display()))
            }
            Err(fault) => Err(fault.to_string()),
        });
        let mut faults = Vec::new();
        self.list = built_in
            .chain(own)
            .filter_map(|mission| mission.map_err(|fault| faults.push(fault)).ok())
            .collect();
        self.read_results();
        faults
    }

    /// Reads the results, which must precede the end of the first attempt: what is not read has no file
    /// to keep further ones in.
    pub(crate) fn read_results(&mut self) {
        self.results = MissionResults::load(mission_results_file());
    }
}

/// The first mission, of those after the one with this name and then of those before it, that was not
/// reached.
#[must_use]
pub fn next_not_reached<'a>(
    list: &'a [Mission],
    name: &str,
    is_reached: impl Fn(&str) -> bool,
) -> Option<&'a Mission> {
    let here = list.iter().position(|mission| mission.name == name);
    let (before, after) = list.split_at(here.map_or(0, |here| here + 1));
    let mut others = after.iter().chain(before);
    others.find(|mission| mission.name != name && !is_reached(&mission.name))
}

/// Where the cursor of the list begins: at the mission that was flown last or, if its last end reached its
/// goals, at the next one that was not reached; at the start of the program, and after a mission that is
/// not in the list, at the first one that was not reached. `None` where every mission is reached.
#[must_use]
pub fn first_choice(
    list: &[Mission],
    flown: Option<(&str, bool)>,
    is_reached: impl Fn(&str) -> bool,
) -> Option<usize> {
    let place_of = |name: &str| list.iter().position(|mission| mission.name == name);
    let Some((flown, has_reached)) = flown.filter(|(name, _)| place_of(name).is_some()) else {
        return list.iter().position(|mission| !is_reached(&mission.name));
    };
    let next = next_not_reached(list, flown, is_reached).filter(|_| has_reached);
    place_of(next.map_or(flown, |next| next.name.as_str()))
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Missions>()
        .init_resource::<AskedQuestion>()
        .add_message::<StartMission>();
}
