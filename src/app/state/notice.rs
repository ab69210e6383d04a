//! A notice: two large lines over the picture that mark a moment, for some seconds.

use bevy::prelude::*;
use std::time::Duration;

/// How long a notice stays.
const DURATION: Duration = Duration::from_secs(7);

/// The notice. Empty while there is none.
#[derive(Resource, Default)]
pub(crate) struct Notice {
    title: String,
    text: String,
    /// When it goes, as a time since the start. None before its first frame.
    ends: Option<Duration>,
}

impl Notice {
    /// Shows a notice in place of the last one.
    pub(crate) fn show(&mut self, title: &str, text: &str) {
        *self = Self {
            title: title.into(),
            text: text.into(),
            ends: None,
        };
    }

    /// Takes the notice away.
    pub(crate) fn close(&mut self) {
        if self.lines().is_some() {
            *self = Self::default();
        }
    }

    /// The title and the text, if there is a notice.
    pub(crate) fn lines(&self) -> Option<[&str; 2]> {
        (!self.title.is_empty()).then_some([&self.title, &self.text])
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Notice>()
        .add_systems(Update, expire_notice);
}

fn expire_notice(time: Res<Time<Real>>, mut notice: ResMut<Notice>) {
    if notice.lines().is_none() {
        return;
    }
    match notice.ends {
        None => notice.ends = Some(time.elapsed() + DURATION),
        Some(end) if time.elapsed() > end => notice.close(),
        Some(_) => {}
    }
}
