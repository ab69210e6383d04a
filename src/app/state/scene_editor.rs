//! The scene's door: every change of the scene that can be undone goes through here, whether a key,
//! the panel or a file asks for it.

use super::history::History;
use super::resolution::Resolution;
use super::title::Title;
use super::toast::Toast;
use crate::app::controls::refusal::{checked_change, undrawable};
use crate::app::controls::statement::change_words;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Picture, Scene};
use lightfall_render::CurrentScene;

/// The scene, and the way to change it so that the change can be undone.
#[derive(SystemParam)]
pub(crate) struct SceneEditor<'w> {
    scene: ResMut<'w, CurrentScene>,
    resolution: ResMut<'w, Resolution>,
    history: ResMut<'w, History>,
    toast: ResMut<'w, Toast>,
    title: ResMut<'w, Title>,
    time: Res<'w, Time<Real>>,
}

impl SceneEditor<'_> {
    /// The scene at its own resolution.
    pub(crate) fn scene(&self) -> Scene {
        self.resolution.full_scene(&self.scene)
    }

    /// The scene that a picture file of what the window shows holds, and the scene that is drawn for
    /// it.
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) fn scene_and_drawing(&self) -> [Scene; 2] {
        [
            self.resolution.scene_in_window(&self.scene),
            self.resolution.drawn_for_file(&self.scene),
        ]
    }

    /// The scene at the resolution that is drawn now.
    pub(crate) fn drawn_scene(&self) -> &Scene {
        &self.scene
    }

    /// The picture as it is drawn while nothing moves.
    pub(crate) fn picture_at_rest(&self) -> Picture {
        self.resolution.picture_at_rest(&self.scene.picture)
    }

    /// Whether the picture is shown in cells.
    pub(crate) fn shows_cells(&self) -> bool {
        !self.scene.picture.bypass
    }

    /// The scene as it was loaded.
    pub(crate) fn loaded(&self) -> &Scene {
        self.history.loaded()
    }

    /// Puts a changed scene in place, or says why it cannot be drawn. `asker` is the key or button
    /// that asked for it. Returns whether the scene is in place.
    pub(crate) fn change(&mut self, asker: &str, changed: Scene) -> bool {
        let done = self.try_change(changed);
        self.report(asker, done)
    }

    /// As [`change`](Self::change), without a toast.
    ///
    /// # Errors
    /// Why the scene cannot be drawn.
    pub(crate) fn try_change(&mut self, changed: Scene) -> Result<(), String> {
        let before = self.scene();
        let changed = checked_change(&before, changed)?;
        self.history.note(&before, &changed, self.time.elapsed());
        self.put(changed);
        Ok(())
    }

    /// Puts another scene altogether in place, or says why it cannot be read or drawn. Returns
    /// whether the scene is in place. The pixel look is the user's choice and stays as it is.
    pub(crate) fn load(&mut self, asker: &str, loaded: Result<Scene, String>) -> bool {
        let loaded = loaded
            .map(|scene| self.in_this_look(scene))
            .and_then(|scene| {
                Drawable::new(scene.clone()).map_err(|reason| undrawable(&reason, &scene))
            })
            .map(|loaded| {
                let loaded = loaded.exposed();
                let before = self.scene();
                self.history
                    .note_loaded(&before, &loaded, self.time.elapsed());
                *self.title = Title::of(&loaded);
                self.put(loaded);
            });
        self.report(asker, loaded)
    }

    /// Notes that a flight is about to lead the camera away, which can be undone, and takes the
    /// scene's title and the last message away. A flight that begins in a scene of its own, `start`,
    /// finds it in place, in the present look.
    pub(crate) fn depart(&mut self, start: Option<&Scene>) {
        let before = self.scene();
        let start = start.map(|scene| Drawable::new(self.in_this_look(scene.clone())));
        match start {
            Some(Ok(start)) => {
                let start = start.exposed();
                self.history
                    .note_departure_elsewhere(&before, &start, self.time.elapsed());
                self.put(start);
            }
            // A built-in preset can be drawn in every look.
            Some(Err(_)) | None => self.history.note_departure(&before, self.time.elapsed()),
        }
        self.title.close();
        self.toast.clear();
    }

    /// Returns every field to what was loaded, except the pixel look.
    pub(crate) fn reset(&mut self) -> bool {
        let loaded = self.in_this_look(self.loaded().clone());
        self.change("Reset", loaded)
    }

    /// The scene, shown with or without cells as the present one is.
    fn in_this_look(&self, mut scene: Scene) -> Scene {
        scene.picture.bypass = self.scene.picture.bypass;
        scene
    }

    /// Takes the last change back.
    pub(crate) fn undo(&mut self) {
        let now = self.scene();
        match self.history.undo(&now) {
            None => self.toast.say("There is nothing to undo"),
            Some(Ok(undone)) => {
                let change = change_words(&now, &undone);
                self.put(undone);
                self.toast.say(format!("Undone: {change}"));
            }
            Some(Err(reason)) => self.toast.say(format!("This cannot be undone: {reason}")),
        }
    }

    /// Shows a toast.
    pub(crate) fn say(&mut self, text: impl Into<String>) {
        self.toast.say(text);
    }

    /// Keeps the toast for at least this long, unless another one takes its place.
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) fn keep_saying_for(&mut self, duration: std::time::Duration) {
        self.toast.keep_for(duration);
    }

    /// Shows a changed scene, metered at once where its exposure is automatic.
    fn put(&mut self, changed: Drawable) {
        self.scene.0 = self.resolution.adopt(&changed.exposed());
        self.toast.clear();
    }

    fn report(&mut self, asker: &str, done: Result<(), String>) -> bool {
        match &done {
            Ok(()) => {}
            Err(reason) if asker.is_empty() => self.toast.say(reason),
            Err(reason) => self.toast.say(format!("{asker}: {reason}")),
        }
        done.is_ok()
    }
}
