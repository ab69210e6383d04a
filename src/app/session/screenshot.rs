//! Screenshots: what the window shows, in new files that replace no others.

use crate::app::controls::control::AppCommand;
use crate::app::state::toast::Toast;
use crate::picture;
use crate::render::CurrentScene;
use crate::storage::{file_safe_name, pictures_folder};
use crate::worker::Worker;
use bevy::prelude::*;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Scene;
use std::fs::File;
use std::path::{Path, PathBuf};

/// The thread that encodes and writes pictures, so that no frame waits for it. It answers with a
/// message for the user.
#[derive(Resource)]
struct ScreenshotWriter(Worker<(Image, Drawable), String>);

pub(crate) fn plugin(app: &mut App) {
    let writer = Worker::serving_all(|(image, scene): (Image, Drawable), answers| {
        answers.send(match write_picture(image, &pictures_folder(), &scene) {
            Ok(file) => format!("Screenshot: {}", file.display()),
            Err(reason) => format!("Screenshot: {reason}"),
        });
    });
    app.insert_resource(ScreenshotWriter(writer))
        .add_systems(Update, (take_screenshot, report_screenshot));
}

fn take_screenshot(mut asked: MessageReader<AppCommand>, mut commands: Commands) {
    if asked
        .read()
        .any(|command| *command == AppCommand::Screenshot)
    {
        commands
            .spawn(Screenshot::primary_window())
            .observe(write_screenshot);
    }
}

fn write_screenshot(
    captured: On<ScreenshotCaptured>,
    scene: Res<CurrentScene>,
    writer: Res<ScreenshotWriter>,
) {
    writer.0.ask((captured.image.clone(), scene.0.clone()));
}

fn report_screenshot(writer: Res<ScreenshotWriter>, mut toast: ResMut<Toast>) {
    if let Some(answer) = writer.0.latest_answer() {
        toast.say(answer);
    }
}

/// Writes a picture of a scene into a folder and returns its file.
///
/// # Errors
/// The picture cannot be encoded or written; one sentence.
fn write_picture(image: Image, folder: &Path, scene: &Scene) -> Result<PathBuf, String> {
    let rgb = image
        .try_into_dynamic()
        .map_err(|error| error.to_string())?
        .to_rgb8();
    let file = reserve_file(folder, &scene.name)?;
    let done = picture::write_png(
        &file,
        rgb.width(),
        rgb.height(),
        rgb.as_raw(),
        &scene.to_preset(),
    );
    if done.is_err() {
        // The file is still empty: it only reserved the name.
        std::fs::remove_file(&file).ok();
    }
    done.map(|()| file).map_err(|error| error.to_string())
}

/// Creates an empty file for a picture of the scene with this name, so that the picture replaces no
/// other file.
///
/// # Errors
/// The folder cannot be written, or is full; one sentence that names it.
fn reserve_file(folder: &Path, scene: &str) -> Result<PathBuf, String> {
    let safe = file_safe_name(scene);
    for number in 1..10_000 {
        let file = folder.join(format!("lightfall-{safe}-{number:04}.png"));
        match File::create_new(&file) {
            Ok(_) => return Ok(file),
            Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(format!("{}: cannot be written: {error}", file.display())),
        }
    }
    Err(format!(
        "{}: holds 9999 pictures of this scene already",
        folder.display()
    ))
}
