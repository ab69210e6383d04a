//! A notice: two large lines over the picture that mark a moment, for some seconds.

use bevy::prelude::*;
use std::time::Duration;

/// How long a notice stays.
const DURATION: Duration = Duration::from_secs(7);

/// The notice.
#[derive(Resource, Default)]
pub(crate) struct Notice {
    /// The title and the text. None while there is no notice.
    pub(crate) lines: Option<[&'static str; 2]>,
    /// When it goes, as a time since the start. None before its first frame.
    ends: Option<Duration>,
}

impl Notice {
    /// A notice that begins to be shown.
    pub(crate) fn new(lines: [&'static str; 2]) -> Self {
        Self {
            lines: Some(lines),
            ends: None,
        }
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Notice>()
        .add_systems(Update, expire_notice);
}

fn expire_notice(time: Res<Time<Real>>, mut notice: ResMut<Notice>) {
    let now = time.elapsed();
    if notice.lines.is_some() && now > *notice.ends.get_or_insert(now + DURATION) {
        *notice = Notice::default();
    }
}
