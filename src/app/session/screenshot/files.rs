//! Screenshots as new files that replace no others.

use super::pixels::{SAVED, pixels};
use super::sharpness::{await_sharp_picture, is_taken};
use crate::app::controls::control::AppCommand;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use lightfall_core::scene::Scene;
use lightfall_picture as picture;
use lightfall_picture::{HeadlessOptions, PictureError, Still, Studio};
use lightfall_platform::storage::{PictureRecord, WriteError, file_safe_name, pictures_folder};
use lightfall_platform::worker::Worker;
use lightfall_render::{Comparison, StarCatalogue};
use std::fs::File;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// How long the window says that a picture is being saved: until it is, however slow the adapter.
const MAX_SAVING: Duration = Duration::from_secs(600);

/// What is to be written.
enum Order {
    /// The picture of a scene, at that scene's size, under these stars, beside what it is compared
    /// with. The second scene is the one that is drawn.
    Picture(Box<[Scene; 2]>, StarCatalogue, Box<Comparison>),
    /// What the window shows, with everything that is drawn over the picture, whose scene has this
    /// name and whose record is given.
    Window(String, PictureRecord, Box<Image>),
}

/// The thread that draws, encodes and writes pictures, so that no frame waits for it. It answers
/// with a message for the user.
#[derive(Resource)]
struct ScreenshotWriter(Worker<Order, String>);

pub(crate) fn plugin(app: &mut App) {
    let writer = Worker::serving_all(|order, answers| {
        answers.send(match write(order, &pictures_folder()) {
            Ok(message) => message,
            Err(reason) => format!("Nothing is saved: {reason}"),
        });
    });
    app.insert_resource(ScreenshotWriter(writer)).add_systems(
        Update,
        (
            save_picture,
            save_window.run_if(is_taken).after(await_sharp_picture),
            report_screenshot,
        ),
    );
}

fn save_picture(
    mut asked: MessageReader<AppCommand>,
    mut editor: SceneEditor,
    writer: Res<ScreenshotWriter>,
    (stars, comparison): (Res<StarCatalogue>, Res<Comparison>),
) {
    if AppCommand::Screenshot.count(&mut asked) > 0 {
        let scene = editor.scene_in_window();
        // In cells the file has those of the window, and without them its full size.
        let drawn = if editor.shows_cells() {
            Scene {
                picture: editor.picture_without_panels(),
                ..scene.clone()
            }
        } else {
            picture::filled(&scene)
        };
        let scenes = Box::new([scene, drawn]);
        writer
            .0
            .ask(Order::Picture(scenes, *stars, Box::new(comparison.clone())));
        editor.say_for(MAX_SAVING, "Saving the picture");
    }
}

fn save_window(mut commands: Commands) {
    commands
        .spawn(Screenshot::primary_window())
        .observe(write_window);
}

fn write_window(
    captured: On<ScreenshotCaptured>,
    editor: SceneEditor,
    writer: Res<ScreenshotWriter>,
    (stars, adapter): (Res<StarCatalogue>, Option<Res<RenderAdapterInfo>>),
) {
    let scene = editor.scene_in_window();
    let record = PictureRecord::new(&scene, &stars, adapter.as_deref());
    let image = Box::new(captured.image.clone());
    writer.0.ask(Order::Window(scene.name, record, image));
}

fn report_screenshot(writer: Res<ScreenshotWriter>, mut toast: ResMut<Toast>) {
    if let Some(answer) = writer.0.latest_answer() {
        toast.say_for(SAVED, answer);
    }
}

/// Serves an order, and says which file it has written and how large the picture is.
///
/// # Errors
/// The picture cannot be drawn, encoded or written; one sentence.
fn write(order: Order, folder: &Path) -> Result<String, String> {
    let (name, record, still) = match order {
        Order::Picture(scene, StarCatalogue(stars), comparison) => {
            let [scene, drawn] = *scene;
            let options = HeadlessOptions {
                stars,
                ..HeadlessOptions::default()
            };
            let fault = |error: PictureError| error.to_string();
            let size = scene.picture.size();
            let mut studio = Studio::with_options(&drawn, size, options).map_err(fault)?;
            if comparison.0.is_some() {
                studio.show_comparison(*comparison);
                studio.settle().map_err(fault)?;
            }
            let still = studio.picture().map_err(fault)?;
            (scene.name.clone(), studio.record(&scene), still)
        }
        Order::Window(name, record, image) => {
            let (size, rgb) = pixels(*image)?;
            (name, record, Still { size, rgb })
        }
    };
    let file = reserve_file(folder, &name)?;
    picture::write_png(&file, &still, &record).map_err(|error| {
        // The file is still empty: it only reserved the name.
        std::fs::remove_file(&file).ok();
        error.to_string()
    })?;
    let UVec2 { x, y } = still.size;
    Ok(format!("Saved {}, {x} x {y} pixels", file.display()))
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
            Err(error) => return Err(WriteError::new(&file, error).to_string()),
        }
    }
    Err(format!(
        "{}: holds 9999 pictures of this scene already",
        folder.display()
    ))
}
