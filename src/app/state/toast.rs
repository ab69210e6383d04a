//! The toast: one sentence at the bottom of the window that says what a key has done, what was
//! refused, or where a file went. A newer sentence takes the place of an older one.

use super::FADE;
use bevy::prelude::*;
use std::time::Duration;

/// How long a short sentence stays.
const DURATION: Duration = Duration::from_secs(2);
/// The longest sentence that counts as short, in characters.
const SHORT: usize = 24;
/// Time to read one character more.
const PER_CHARACTER: Duration = Duration::from_millis(75);
/// The longest time that a sentence stays.
const MAX_DURATION: Duration = Duration::from_secs(15);

/// The least number of frames that show a sentence.
const MIN_FRAMES: u32 = 8;

/// The sentence.
#[derive(Resource, Default)]
pub(crate) struct Toast {
    text: String,
    /// How long it has been shown. `None` before its first frame.
    shown: Option<Duration>,
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
        let text = text.into();
        // A sentence that is said again stays, and does not fade in again.
        let shown = self.shown.filter(|_| self.text == text);
        *self = Self {
            shown: shown.map(|shown| shown.min(FADE)),
            text,
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

    /// The sentence, if no frame has shown it yet. Empty if there is none.
    pub(crate) fn unread(&self) -> &str {
        match self.shown {
            None => &self.text,
            Some(_) => "",
        }
    }

    /// Takes the sentence away.
    pub(crate) fn clear(&mut self) {
        self.say("");
    }

    /// The sentence. Empty if there is none.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Seconds since the sentence appeared.
    pub(crate) fn since(&self) -> f32 {
        self.shown.unwrap_or_default().as_secs_f32()
    }

    /// Seconds until the sentence goes.
    pub(crate) fn left(&self) -> f32 {
        self.stays().as_secs_f32() - self.since()
    }

    /// How long the sentence is shown in all.
    fn stays(&self) -> Duration {
        reading_time(&self.text).max(self.min_duration) + FADE
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

/// A frame counts for a share of the sentence's time at most, because nobody reads while a shader
/// compiles.
fn expire_toast(time: Res<Time<Real>>, mut toast: ResMut<Toast>) {
    if toast.text.is_empty() {
        return;
    }
    let frame = time.delta().min(toast.stays() / MIN_FRAMES);
    toast.shown = Some(toast.shown.map_or(Duration::ZERO, |shown| shown + frame));
    if toast.left() <= 0.0 {
        toast.clear();
    }
}
