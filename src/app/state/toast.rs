//! One sentence at the bottom of the window: what was refused, or where a file went.

use bevy::prelude::*;
use std::time::Duration;

/// How long a sentence stays.
const STAYS: Duration = Duration::from_secs(10);

/// The sentence.
#[derive(Resource, Default)]
pub(crate) struct Toast {
    text: String,
    /// Time since the start at which it goes; set at the first look at it.
    ends: Option<Duration>,
}

impl Toast {
    /// Says something in place of what was said before.
    pub(crate) fn say(&mut self, text: impl Into<String>) {
        *self = Self {
            text: text.into(),
            ends: None,
        };
    }

    /// Says something beside what is being said.
    pub(crate) fn add(&mut self, text: &str) {
        let both = if self.text.is_empty() {
            text.to_owned()
        } else {
            format!("{} · {text}", self.text)
        };
        self.say(both);
    }

    /// Takes back what was said.
    pub(crate) fn clear(&mut self) {
        self.say("");
    }

    /// What is said; empty if nothing.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Toast>().add_systems(Update, fade);
}

fn fade(time: Res<Time<Real>>, mut notice: ResMut<Toast>) {
    if notice.text.is_empty() {
        return;
    }
    match notice.ends {
        None => notice.ends = Some(time.elapsed() + STAYS),
        Some(end) if time.elapsed() > end => notice.clear(),
        Some(_) => {}
    }
}
