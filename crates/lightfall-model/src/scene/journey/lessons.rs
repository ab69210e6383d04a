//! The built-in lessons: journeys with stops, part of the program itself.

use super::{Journey, load};

macro_rules! lessons {
    ($($name:literal),* $(,)?) => {
        [$((
            $name,
            include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/journeys/", $name, ".toml")),
        )),*]
    };
}

/// Names and texts of the built-in lessons, in the order in which they are offered.
pub const LESSONS: [(&str, &str); 3] = lessons!["shadow", "bright-side", "two-clocks"];

/// The built-in lesson with this name.
pub fn built_in(name: &str) -> Option<Journey> {
    let (name, text) = LESSONS.into_iter().find(|(known, _)| *known == name)?;
    load(name, text).ok()
}

/// Whether a text is meant as a journey, and not as a preset: it has a table that only journeys have.
pub fn is_journey(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim_start);
    lines.any(|line| {
        ["[[keyframe]]", "[[stop]]"]
            .iter()
            .any(|table| line.starts_with(table))
    })
}
