//! Lets a screenshot of the window wait until the picture is sharp.

use crate::app::controls::control::AppCommand;
use crate::app::session::frame_pacing::FramePacing;
use crate::app::state::window_shot::WindowShot;
use bevy::prelude::*;
use lightfall_render::Progress;

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<WindowShot>()
        .add_systems(Update, await_sharp_picture);
}

/// A picture is sharp once nothing has moved for a while and all of it is drawn.
pub(super) fn await_sharp_picture(
    mut asked: MessageReader<AppCommand>,
    time: Res<Time<Real>>,
    (pacing, progress): (Res<FramePacing>, Res<Progress>),
    mut shot: ResMut<WindowShot>,
) {
    let asked = AppCommand::ScreenshotOfWindow.count(&mut asked) > 0;
    let is_sharp = !pacing.running && *progress == Progress::Done;
    let next = shot.next(asked, is_sharp, time.elapsed());
    shot.set_if_neq(next);
}

/// A run condition: the window is captured in this frame.
#[cfg(not(target_arch = "wasm32"))]
pub(super) fn is_taken(shot: Res<WindowShot>) -> bool {
    *shot == WindowShot::Taken
}
