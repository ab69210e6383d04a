//! The built-in lessons, which are journeys with stops, and other flights: part of the program itself.

use super::{Journey, load};

macro_rules! journeys {
    ($($name:literal),* $(,)?) => {
        [$((
            $name,
            include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/journeys/", $name, ".toml")),
        )),*]
    };
}

/// Names and texts of the built-in lessons, in the order in which they are offered.
pub const LESSONS: [(&str, &str); 3] = journeys!["shadow", "bright-side", "two-clocks"];

/// Names and texts of the built-in journeys without stops, besides the guided one.
pub const FLIGHTS: [(&str, &str); 1] = journeys!["layers"];

/// The built-in lesson or flight with this name.
pub fn built_in(name: &str) -> Option<Journey> {
    let mut all = LESSONS.into_iter().chain(FLIGHTS);
    let (name, text) = all.find(|(known, _)| *known == name)?;
    load(name, text).ok()
}

/// Whether a text is meant as a journey, and not as a preset: it has a table that only journeys have, or the
/// head of one with a bracket too few.
pub fn is_journey(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim_start);
    lines.any(|line| {
        ["[[keyframe]", "[[stop]", "[keyframe]", "[stop]"]
            .iter()
            .any(|table| line.starts_with(table))
    })
}
