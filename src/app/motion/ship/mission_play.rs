//! A mission under way: its captions, its goals, and what is said and kept at its end.

use super::score::{lamps, solution_time};
use super::ship_flight::ShipFlight;
use super::words;
use crate::app::controls::bindings::Bindings;
use crate::app::motion::camera_motions::CameraMotions;
use crate::app::state::end_card::{Closes, EndCard};
use crate::app::state::mission_results::MissionResult;
use crate::app::state::missions::{AskedQuestion, Missions, StartMission};
use crate::app::state::overlays::Overlays;
use crate::app::state::preferences::Preferences;
use crate::app::state::result_file::time_now;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::state::toast::reading_time;
use bevy::prelude::*;
use lightfall_core::numbers::with_short_numbers;
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::ship::{Attempt, Clocks, Outcome};
use lightfall_core::scene::mission::{Better, Hint, Mission};
use lightfall_platform::worker::Follower;
use lightfall_render::Comparison;
use std::time::Duration;

/// What the window remembers of a mission besides the flight.
#[derive(Resource, Default, Debug)]
pub(crate) struct MissionPlay {
    /// How many attempts have come to their end, and how many of them have failed.
    ended: u32,
    failed: u32,
    /// Which captions were shown.
    shown: Vec<bool>,
    /// The caption that is shown, and since when.
    caption: Option<(usize, Duration)>,
    /// Which captions were shown, which one is, and how many goals were reached, at the last goal.
    at_goal: (Vec<bool>, Option<usize>, usize),
    /// The result of this attempt, if it has come to an end: going back goes on with the same attempt.
    kept: Option<MissionResult>,
    /// How many goals were reached when the window last looked.
    reached: usize,
    /// Whether the end of the attempt was told.
    told: bool,
}

impl MissionPlay {
    /// The caption that is shown, as a place in the mission's list.
    pub(crate) fn caption(&self) -> Option<usize> {
        self.caption.map(|(index, _)| index)
    }

    /// Whether the end of the attempt was told, and its result kept.
    pub(super) fn is_told(&self) -> bool {
        self.told
    }

    /// Begins another attempt.
    pub(super) fn begin_again(&mut self) {
        *self = Self {
            ended: self.ended,
            failed: self.failed,
            ..Self::default()
        };
    }

    /// Goes on with the attempt from the last goal, or from the start.
    pub(super) fn go_back(&mut self, to_goal: bool) {
        let (shown, caption, reached) = if to_goal {
            self.at_goal.clone()
        } else {
            Default::default()
        };
        // One that was read when the goal was reached gives way to what is due now.
        let caption = caption.map(|index| (index, Duration::ZERO));
        *self = Self {
            ended: self.ended,
            failed: self.failed,
            kept: self.kept.take(),
            at_goal: self.at_goal.clone(),
            shown,
            caption,
            reached,
            ..Self::default()
        };
    }

    /// Notes how many goals are reached. Returns whether one more is, and the attempt goes on.
    fn note_goals(&mut self, reached: usize, is_over: bool) -> bool {
        let has_more = reached > self.reached && !is_over;
        if has_more {
            self.at_goal = (self.shown.clone(), self.caption(), reached);
        }
        self.reached = reached;
        has_more
    }

    /// Chooses the caption: a new one whose conditions hold, once the last one can have been read.
    fn choose_caption(&mut self, attempt: &Attempt, now: Duration) {
        let captions = &attempt.mission.captions;
        self.shown.resize(captions.len(), false);
        let is_read = self.caption.is_none_or(|(index, since)| {
            now.saturating_sub(since) > reading_time(&captions[index].text) / 2
        });
        if !is_read {
            return;
        }
        let due = captions
            .iter()
            .zip(&self.shown)
            .position(|(caption, shown)| !shown && attempt.voyage().meets(&caption.when));
        if let Some(index) = due {
            self.shown[index] = true;
            self.caption = Some((index, now));
        }
    }
}

/// A thread that flies the solution of the mission under way, which may take a second.
#[derive(Resource)]
pub(super) struct SolutionTimes(Follower<Mission, Option<f64>>);

impl Default for SolutionTimes {
    fn default() -> Self {
        Self(Follower::new(solution_time))
    }
}

/// Begins missions. A mission has the picture for itself: what lay over it, and a comparison with
/// another scene, would cover the flight.
pub(super) fn start_missions(
    mut starts: MessageReader<StartMission>,
    mut ship: ResMut<ShipFlight>,
    (mut play, mut times): (ResMut<MissionPlay>, ResMut<SolutionTimes>),
    (mut missions, mut asked): (ResMut<Missions>, ResMut<AskedQuestion>),
    (mut overlays, mut comparison): (ResMut<Overlays>, ResMut<Comparison>),
    mut camera: CameraMotions,
    mut end_card: ResMut<EndCard>,
    (bindings, preferences): (Res<Bindings>, Res<Preferences>),
    mut editor: SceneEditor,
) {
    for StartMission(mission) in starts.read() {
        editor.depart(Some(mission.scene()));
        if let Err(error) = ship.start(mission, &editor.drawn_scene()) {
            editor.say(with_short_numbers(&format!("{}: {error}", mission.title)));
            continue;
        }
        camera.end();
        asked.close();
        overlays.clear_picture();
        Comparison::end(&mut comparison);
        // One that the command line names, or a file that is dropped, comes before any list is read. The
        // list says what is wrong with its files when it is opened.
        if missions.list.is_empty() {
            drop(missions.read());
        } else {
            missions.read_results();
        }
        *play = MissionPlay::default();
        missions.note_flown(&mission.name, false);
        times.0.follow(Mission::clone(mission));
        let units = ship.units(&preferences.settings);
        *end_card = EndCard::new(
            &bindings.with_keys(&mission.title),
            &bindings.with_keys(&words::brief(mission, units)),
            words::first_keys(mission),
            Closes::Flying,
        );
    }
}

/// Watches a mission: shows captions, and says when goals are reached and how it has ended.
pub(super) fn watch_mission(
    ship: Res<ShipFlight>,
    (mut play, mut times): (ResMut<MissionPlay>, ResMut<SolutionTimes>),
    (mut missions, mut asked): (ResMut<Missions>, ResMut<AskedQuestion>),
    (time, bindings): (Res<Time<Real>>, Res<Bindings>),
    preferences: Res<Preferences>,
    mut end_card: ResMut<EndCard>,
    mut editor: SceneEditor,
) {
    let Some(attempt) = ship.attempt() else {
        // Whoever leaves a mission leaves its card.
        if end_card.is_open() && end_card.closes != Closes::Anything {
            end_card.close();
        }
        return;
    };
    let units = ship.units(&preferences.settings);
    let reached = attempt.reached().len();
    let is_over = attempt.is_over();
    if play.note_goals(reached, is_over) {
        let goal = units.in_text(&attempt.mission.goals[reached - 1].text);
        let goal = bindings.with_keys(&goal);
        editor.say(format!("Reached: {goal}"));
    }
    // Captions come after the card with the task.
    if !end_card.is_open() {
        play.choose_caption(attempt, time.elapsed());
    }
    if !is_over {
        play.told = false;
        return;
    }
    if play.told {
        return;
    }
    times.0.follow(attempt.mission.clone());
    let Some(solution_time) = times.0.answer().copied() else {
        return;
    };
    play.told = true;
    play.caption = None;
    let before = play.kept.take();
    play.ended += u32::from(before.is_none());
    let has_succeeded = attempt.outcome() == Outcome::Success;
    missions.note_flown(&attempt.mission.name, has_succeeded);
    if !has_succeeded {
        play.failed += 1;
    }
    let lit = lamps(attempt, solution_time);
    let pupil = preferences.settings.pupil.as_str();
    let kept = result_row(attempt, (lit, play.ended), pupil);
    let hint = (!has_succeeded)
        .then(|| due_hint(&attempt.mission.hints, play.failed))
        .flatten();
    let best = missions.results.best(&kept.mission).cloned();
    let nearest = nearest_miss(&missions, attempt).cloned();
    let (row, written) = missions.results.keep(before, kept.clone());
    if let Err(fault) = written {
        editor.say(fault);
    }
    play.kept = Some(row.clone());
    let end = words::End {
        attempt,
        kept: &kept,
        best: best.as_ref(),
        nearest: nearest.as_ref(),
        lit,
        solution_time,
        hint,
        has_next: missions.next_after(&kept.mission).is_some(),
    };
    let mut card = words::end(&end, units);
    card.title = bindings.with_keys(&card.title);
    card.text = bindings.with_keys(&card.text);
    card.details = bindings.with_keys(&card.details);
    let question = attempt.mission.questions.first();
    match question.filter(|_| has_succeeded) {
        Some(question) => asked.ask(question.clone(), row, card),
        None => *end_card = card,
    }
}

/// The failed attempt so far that came nearest to the par of a mission that wants more of something.
fn nearest_miss<'a>(missions: &'a Missions, attempt: &Attempt) -> Option<&'a MissionResult> {
    let mission = &attempt.mission;
    let par = mission.pars.first();
    let par = par.filter(|par| par.better == Better::More)?;
    missions.results.nearest_miss(&mission.name, par.quantity)
}

/// The hint after so many failures: the last one that is due.
fn due_hint(hints: &[Hint], failed: u32) -> Option<&str> {
    let due = hints.iter().filter(|hint| hint.after <= failed);
    due.max_by_key(|hint| hint.after)
        .map(|hint| hint.text.as_str())
}

/// What is kept of an attempt that has come to its end now, with the lamps that are lit and its number.
fn result_row(attempt: &Attempt, (lit, number): ([bool; 3], u32), pupil: &str) -> MissionResult {
    let mission = &attempt.mission;
    let flown = attempt.scored();
    let mass = HoleMass::of_suns(mission.hole.mass_suns);
    let clocks = Clocks::new(&flown.flight.ship);
    let records = flown.records();
    let par = mission.pars.first();
    MissionResult {
        mission: mission.name.clone(),
        reached: lit[0],
        lamps: lit.into_iter().filter(|lit| *lit).count(),
        attempt: number,
        own_time: clocks.own,
        far_time: clocks.far,
        rapidity_used: flown.flight.rocket.used(),
        par: par.and_then(|par| Some((par.quantity, flown.quantity(par.quantity)?))),
        peak_g: records.acceleration * mass.gees(),
        peak_tide: records.tide * mass.gees() / mass.metres(),
        lowest: records.lowest,
        error: flown.flight.ship.error().stated(),
        answer: None,
        is_right: None,
        time: time_now(),
        pupil: pupil.into(),
    }
}
