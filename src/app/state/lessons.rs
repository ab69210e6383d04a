//! Lessons and the guided journey: what is offered, what is asked for, and whether one is under way.

use bevy::prelude::*;
use lightfall_core::scene::journey::{FLIGHTS, InspectorView, Journey, LESSONS, load};
use lightfall_platform::storage::{journey_of_file, lessons_folder, preset_files};

/// The journeys that are offered in the list of lessons: the built-in lessons and flights, then those of
/// the user.
#[derive(Resource, Default)]
pub(crate) struct Lessons(pub(crate) Vec<Journey>);

/// The guided journey of the command line, or the built-in one.
#[derive(Resource)]
pub(crate) struct GuidedJourney(pub(crate) Journey);

/// Fly this journey from its beginning.
#[derive(Message, Clone, Debug)]
pub(crate) struct StartJourney(pub(crate) Box<Journey>);

/// The lesson that the card at the end of another one offers.
#[derive(Resource, Default)]
pub(crate) struct OfferedLesson(pub(crate) Option<Box<Journey>>);

/// Whether a journey with stops is under way, whose keys go on and back.
#[derive(Resource, Default, PartialEq)]
pub(crate) struct LessonUnderWay {
    pub(crate) is_flown: bool,
    /// Whether it waits at a stop with a question, whose answer the keys of numbers type.
    pub(crate) asks: bool,
}

/// What a stop asks the ray inspector to show; none where no stop says anything.
#[derive(Resource, Default, PartialEq)]
pub(crate) struct AskedRay(pub(crate) Option<InspectorView>);

/// The direction of the ray that the inspector shows of the present picture, on the observer's axes;
/// none without one.
#[derive(Resource, Default)]
pub(crate) struct ShownRay(pub(crate) Option<[f64; 3]>);

impl Lessons {
    /// Reads the lessons. Returns what is wrong with the user's own ones.
    pub(crate) fn read(&mut self) -> Vec<String> {
        let built_in = LESSONS
            .iter()
            .chain(&FLIGHTS)
            .map(|(name, text)| load(name, text).map_err(|fault| fault.to_string()));
        let files = lessons_folder().map_or_else(Vec::new, |folder| preset_files(&folder));
        let own = files
            .iter()
            .map(|file| journey_of_file(file).map_err(|fault| fault.to_string()));
        let mut faults = Vec::new();
        self.0 = built_in
            .chain(own)
            .filter_map(|lesson| lesson.map_err(|fault| faults.push(fault)).ok())
            .collect();
        faults
    }
}

/// The lesson of a list that comes after the one with this title: the next journey that has stops.
#[must_use]
pub fn next_lesson<'a>(list: &'a [Journey], title: &str) -> Option<&'a Journey> {
    let here = list.iter().position(|lesson| lesson.title == title)?;
    let mut after = list[here + 1..].iter();
    after.find(|lesson| !lesson.stops.is_empty() && !lesson.title.is_empty())
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Lessons>()
        .init_resource::<LessonUnderWay>()
        .init_resource::<OfferedLesson>()
        .init_resource::<AskedRay>()
        .init_resource::<ShownRay>()
        .add_message::<StartJourney>();
}
