//! Screenshots as downloads of the browser. A page cannot draw beside its window and wait, so the
//! picture by itself is what the window shows in a frame without anything over the picture.

use super::pixels::{SAVED, pixels};
use crate::app::controls::control::AppCommand;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::state::window_shot::WindowShot;
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use bevy_egui::{EguiPostUpdateSet, EguiRenderOutput};
use lightfall_platform::browser;
use lightfall_platform::storage::{PictureRecord, encoded_png, file_safe_name};
use lightfall_render::StarCatalogue;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        PostUpdate,
        capture_window.after(EguiPostUpdateSet::ProcessOutput),
    );
}

fn capture_window(
    mut asked: MessageReader<AppCommand>,
    shot: Res<WindowShot>,
    mut overlays: Query<&mut EguiRenderOutput>,
    mut commands: Commands,
) {
    let by_itself = AppCommand::Screenshot.count(&mut asked) > 0;
    if !by_itself && *shot != WindowShot::Taken {
        return;
    }
    for mut output in overlays.iter_mut().filter(|_| by_itself) {
        output.paint_jobs.clear();
    }
    commands
        .spawn(Screenshot::primary_window())
        .observe(download_picture);
}

fn download_picture(
    captured: On<ScreenshotCaptured>,
    mut editor: SceneEditor,
    (stars, adapter): (Res<StarCatalogue>, Option<Res<RenderAdapterInfo>>),
) {
    let scene = editor.scene_in_window();
    let record = PictureRecord::new(&scene, &stars, adapter.as_deref());
    let name = format!("lightfall-{}.png", file_safe_name(&scene.name));
    let download = || {
        let (size, rgb) = pixels(captured.image.clone())?;
        let png = encoded_png(size.x, size.y, &rgb, &record).map_err(|error| error.to_string())?;
        browser::download(&name, &png)?;
        Ok(format!("Downloaded {name}, {} x {} pixels", size.x, size.y))
    };
    let said = download().unwrap_or_else(|reason: String| format!("Nothing is saved: {reason}"));
    editor.say_for(SAVED, said);
}
