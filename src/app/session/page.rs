//! The page around the window in a browser: its loading screen goes when the first picture is drawn,
//! and it says why the window has ended.

use bevy::prelude::*;
use lightfall_platform::browser::{State, report, show_state};
use lightfall_render::Progress;
use lightfall_render::recovery::DeviceFailure;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Last, (end_loading, report_end));
}

fn end_loading(progress: Res<Progress>, mut done: Local<bool>) {
    if !*done && progress.is_shown() {
        *done = true;
        show_state(State::Running);
    }
}

/// A window program does not return in a browser, so its caller cannot report the reason.
fn report_end(mut exits: MessageReader<AppExit>, failure: Res<DeviceFailure>) {
    if exits.read().any(AppExit::is_error) {
        report(
            failure
                .sentence()
                .unwrap_or("The window has ended with an error"),
        );
    }
}
