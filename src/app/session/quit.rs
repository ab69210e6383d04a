//! Ending the program. What has to be kept is written when the program ends, whatever ends it.

use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::{AppCommand, FlightInput};
use crate::app::input::held::HeldControls;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use lightfall_platform::IN_BROWSER;
use std::time::Duration;

/// A pilot who has flown down for longer than this with the key of the same modifier probably means
/// to roll, and is asked.
const FLYING_DOWN: Duration = Duration::from_secs(1);
/// How long the question waits for the second press.
const QUESTION: Duration = Duration::from_secs(4);

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, quit);
}

fn quit(
    mut commands: MessageReader<AppCommand>,
    time: Res<Time<Real>>,
    held: HeldControls,
    bindings: Res<Bindings>,
    mut toast: ResMut<Toast>,
    mut exits: MessageWriter<AppExit>,
    mut down_since: Local<Option<Duration>>,
    mut asked: Local<Option<Duration>>,
) {
    let now = time.elapsed();
    if held.axis(FlightInput::Down, FlightInput::Up) > 0.0 {
        down_since.get_or_insert(now);
    } else {
        *down_since = None;
    }
    if AppCommand::Quit.count(&mut commands) == 0 {
        return;
    }
    if IN_BROWSER {
        toast.say("To leave, close the tab");
        return;
    }
    let flies = down_since.is_some_and(|since| now.saturating_sub(since) > FLYING_DOWN);
    let confirmed = asked.is_some_and(|asked| now.saturating_sub(asked) < QUESTION);
    if flies && !confirmed {
        *asked = Some(now);
        toast.say(format!(
            "{} quits: press it again",
            bindings.label("window.quit")
        ));
    } else {
        exits.write(AppExit::Success);
    }
}
