//! Pictures of what the window shows, as files that replace no other.

use crate::app::controls::table::Command;
use crate::app::state::toast::Toast;
use crate::picture;
use crate::render::CurrentScene;
use crate::storage::{file_safe_name, pictures_folder};
use bevy::prelude::*;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use lightfall_core::scene::Scene;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, Sender, channel};

/// Where threads that write pictures say how it went.
#[derive(Resource)]
struct Answers {
    sender: Sender<String>,
    receiver: Mutex<Receiver<String>>,
}

pub(crate) fn plugin(app: &mut App) {
    let (sender, receiver) = channel();
    app.insert_resource(Answers {
        sender,
        receiver: Mutex::new(receiver),
    })
    .add_systems(Update, (take, answer));
}

fn take(mut asked: MessageReader<Command>, mut commands: Commands) {
    if asked.read().any(|command| *command == Command::Screenshot) {
        commands.spawn(Screenshot::primary_window()).observe(write);
    }
}

/// Encodes and writes in a thread of its own, so that no frame waits for it.
fn write(captured: On<ScreenshotCaptured>, scene: Res<CurrentScene>, answers: Res<Answers>) {
    let (image, scene, sender) = (
        captured.image.clone(),
        scene.0.clone(),
        answers.sender.clone(),
    );
    std::thread::spawn(move || {
        let answer = match written(image, &pictures_folder(), &scene) {
            Ok(file) => format!("Screenshot: {}", file.display()),
            Err(reason) => format!("Screenshot: {reason}"),
        };
        // Nobody listens once the window is closed.
        let _ = sender.send(answer);
    });
}

fn written(image: Image, folder: &Path, scene: &Scene) -> Result<PathBuf, String> {
    let rgb = image
        .try_into_dynamic()
        .map_err(|error| error.to_string())?
        .to_rgb8();
    let file = reserved(folder, &scene.name)?;
    let done = picture::write_png(
        &file,
        rgb.width(),
        rgb.height(),
        rgb.as_raw(),
        &scene.to_preset(),
    );
    if done.is_err() {
        // Only the empty file that holds the name.
        let _ = std::fs::remove_file(&file);
    }
    done.map(|()| file).map_err(|error| error.to_string())
}

/// A file of its own for a picture of the scene with this name: created empty, so that no other can
/// take its place.
///
/// # Errors
/// The folder cannot be written; one sentence that names it.
fn reserved(folder: &Path, scene: &str) -> Result<PathBuf, String> {
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

fn answer(answers: Res<Answers>, mut notice: ResMut<Toast>) {
    let receiver = answers
        .receiver
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner);
    if let Some(answer) = receiver.try_iter().last() {
        notice.say(answer);
    }
}
