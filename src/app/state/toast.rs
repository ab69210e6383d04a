//! The toast: one sentence in the status bar that says what was refused, or where a file went.

use bevy::prelude::*;
use std::time::Duration;

/// How long a sentence stays.
const DURATION: Duration = Duration::from_secs(10);

/// The sentence.
#[derive(Resource, Default)]
pub(crate) struct Toast {
    text: String,
    /// When it goes, as a time since the start. None before its first frame.
    ends: Option<Duration>,
}

impl Toast {
    /// Says something in place of the last sentence.
    pub(crate) fn say(&mut self, text: impl Into<String>) {
        *self = Self {
            text: text.into(),
            ends: None,
        };
    }

    /// Says something after the present sentence.
    pub(crate) fn add(&mut self, text: &str) {
        let both = if self.text.is_empty() {
            text.to_owned()
        } else {
            format!("{} · {text}", self.text)
        };
        self.say(both);
    }

    /// Takes the sentence away.
    pub(crate) fn clear(&mut self) {
        self.say("");
    }

    /// The sentence. Empty if there is none.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Toast>()
        .add_systems(Update, expire_toast);
}

fn expire_toast(time: Res<Time<Real>>, mut toast: ResMut<Toast>) {
    if toast.text.is_empty() {
        return;
    }
    match toast.ends {
        None => toast.ends = Some(time.elapsed() + DURATION),
        Some(end) if time.elapsed() > end => toast.clear(),
        Some(_) => {}
    }
}
