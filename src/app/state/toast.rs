//! The toast: one sentence at the bottom of the window that says what a key has done, what was
//! refused, or where a file went. A newer sentence takes the place of an older one.

use bevy::prelude::*;
use std::time::Duration;

/// How long a short sentence stays.
const DURATION: Duration = Duration::from_secs(2);
/// The longest sentence that counts as short, in characters.
const SHORT: usize = 32;
/// Time to read one character more.
const PER_CHARACTER: Duration = Duration::from_millis(60);
/// The longest time that a sentence stays.
const MAX_DURATION: Duration = Duration::from_secs(12);
/// How long it takes to fade away afterwards.
const FADE: Duration = Duration::from_millis(250);

/// The sentence.
#[derive(Resource, Default)]
pub(crate) struct Toast {
    text: String,
    /// When it begins to fade, as a time since the start. None before its first frame.
    ends: Option<Duration>,
    /// How much of it is left while it fades, from 1 to 0.
    strength: f32,
    /// The shortest time for which it stays.
    min_duration: Duration,
}

impl Toast {
    /// Says something in place of the last sentence.
    pub(crate) fn say(&mut self, text: impl Into<String>) {
        self.say_for(Duration::ZERO, text);
    }

    /// Says something for at least this long, unless another sentence takes its place.
    pub(crate) fn say_for(&mut self, min_duration: Duration, text: impl Into<String>) {
        *self = Self {
            text: text.into(),
            ends: None,
            strength: 1.0,
            min_duration,
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

    /// How much of the sentence is to be seen, from 0 to 1: it fades at its end.
    pub(crate) fn strength(&self) -> f32 {
        self.strength
    }
}

/// How long a sentence stays. A longer sentence stays longer.
#[must_use]
pub fn reading_time(text: &str) -> Duration {
    let more = text.chars().count().saturating_sub(SHORT) as u32;
    (DURATION + PER_CHARACTER * more).min(MAX_DURATION)
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Toast>()
        .add_systems(Update, expire_toast);
}

fn expire_toast(time: Res<Time<Real>>, mut toast: ResMut<Toast>) {
    if toast.text.is_empty() {
        return;
    }
    let now = time.elapsed();
    let stays = reading_time(&toast.text).max(toast.min_duration);
    let end = *toast.ends.get_or_insert(now + stays);
    if now > end + FADE {
        toast.clear();
    } else {
        toast.strength = 1.0 - now.saturating_sub(end).as_secs_f32() / FADE.as_secs_f32();
    }
}
