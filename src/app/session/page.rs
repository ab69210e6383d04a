//! The page around the window in a browser: its loading screen goes when the first picture is drawn.

use crate::browser::{State, show_state};
use crate::render::DrawRequest;
use bevy::prelude::*;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Last, end_loading);
}

fn end_loading(request: Res<DrawRequest>, mut done: Local<bool>) {
    if !*done && request.is_drawn() {
        *done = true;
        show_state(State::Running);
    }
}
