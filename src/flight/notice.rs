//! One sentence at the bottom of the window: what was refused, or where a file went.

use bevy::prelude::*;
use std::time::Duration;

/// How long a sentence stays.
const STAYS: Duration = Duration::from_secs(10);

/// The sentence.
#[derive(Resource, Default)]
pub(super) struct Notice {
    text: String,
    /// Time since the start at which it goes; set at the first look at it.
    ends: Option<Duration>,
}

impl Notice {
    /// Says something in place of what was said before.
    pub(super) fn say(&mut self, text: impl Into<String>) {
        *self = Self {
            text: text.into(),
            ends: None,
        };
    }

    /// Says something beside what is being said.
    pub(super) fn add(&mut self, text: &str) {
        let both = if self.text.is_empty() {
            text.to_owned()
        } else {
            format!("{} · {text}", self.text)
        };
        self.say(both);
    }

    /// Takes back what was said.
    pub(super) fn clear(&mut self) {
        self.say("");
    }

    /// What is said; empty if nothing.
    pub(super) fn text(&self) -> &str {
        &self.text
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Notice>().add_systems(Update, fade);
}

fn fade(time: Res<Time<Real>>, mut notice: ResMut<Notice>) {
    if notice.text.is_empty() {
        return;
    }
    match notice.ends {
        None => notice.ends = Some(time.elapsed() + STAYS),
        Some(end) if time.elapsed() > end => notice.clear(),
        Some(_) => {}
    }
}
