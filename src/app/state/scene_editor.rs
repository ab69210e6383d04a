//! The one place that writes the scene and its frame: for keys, the panel and files, whose changes
//! can be undone, and for flights.

use super::disk_clock::DiskClock;
use super::history::History;
use super::light_meter::LightMeter;
use super::preset_row::{LoadedFile, RowPreset, preset_beside};
use super::resolution::Resolution;
use super::title::Title;
use super::toast::Toast;
use crate::app::controls::refusal::{checked_change, undrawable};
use crate::app::controls::statement::change_words;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use glam::DMat3;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Frame, Picture, Scene, presets};
use lightfall_platform::storage::{missing_stars, own_presets, read_scene};
use lightfall_render::{
    CurrentFrame, CurrentScene, FrameScene, StarCatalogue, draw_scene_in_frame,
};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The scene, what drives its frame, and the way to change both.
#[derive(SystemParam)]
pub(crate) struct SceneEditor<'w> {
    scene: ResMut<'w, CurrentScene>,
    resolution: Res<'w, Resolution>,
    meter: ResMut<'w, LightMeter>,
    clock: ResMut<'w, DiskClock>,
    history: ResMut<'w, History>,
    toast: ResMut<'w, Toast>,
    title: ResMut<'w, Title>,
    file: ResMut<'w, LoadedFile>,
    stars: Res<'w, StarCatalogue>,
    time: Res<'w, Time<Real>>,
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<LoadedFile>()
        .add_systems(FrameScene, write_frame.before(draw_scene_in_frame));
}

/// Writes the frame, once everything has happened that drives it.
fn write_frame(editor: SceneEditor, mut frame: ResMut<CurrentFrame>) {
    frame.set_if_neq(CurrentFrame(editor.frame()));
}

impl SceneEditor<'_> {
    /// The scene as it is now, at its own size: changes begin with it, and files hold it.
    pub(crate) fn scene(&self) -> Scene {
        let mut scene = self.scene.scene().clone();
        scene.picture.exposure_ev = self.meter.exposure_of(&scene);
        scene.disk.time = self.clock.time();
        scene
    }

    /// The scene as it is drawn now: flights begin with it.
    pub(crate) fn drawn_scene(&self) -> Drawable {
        self.scene.shown_in(&self.frame())
    }

    fn frame(&self) -> Frame {
        self.resolution.frame(&self.scene())
    }

    /// The scene that a picture file of what the window shows holds.
    pub(crate) fn scene_in_window(&self) -> Scene {
        let mut scene = self.scene();
        let bypass = scene.picture.bypass;
        scene.picture = self.resolution.in_window(&scene.shown_picture());
        scene.picture.bypass = bypass;
        scene
    }

    /// The picture as it is drawn while nothing moves.
    pub(crate) fn picture_at_rest(&self) -> Picture {
        self.resolution.at_rest(&self.scene().shown_picture())
    }

    /// As [`picture_at_rest`](Self::picture_at_rest), in a window without panels.
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) fn picture_without_panels(&self) -> Picture {
        self.resolution
            .at_rest_without_panels(&self.scene().shown_picture())
    }

    /// Whether the scene has changed since the last run of the system.
    pub(crate) fn has_changed(&self) -> bool {
        self.scene.is_changed()
    }

    /// Whether the pixel look is chosen. Only perspective pictures have it.
    pub(crate) fn has_pixel_look(&self) -> bool {
        !self.scene.picture.bypass
    }

    /// Whether the picture is shown in cells.
    pub(crate) fn shows_cells(&self) -> bool {
        self.scene.has_cells()
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
            .and_then(|scene| self.drawable_in_this_look(scene))
            .map(|loaded| {
                let loaded = loaded.exposed();
                let before = self.scene();
                self.history
                    .note_loaded(&before, &loaded, self.time.elapsed());
                *self.title = Title::of(&loaded);
                self.file.0 = None;
                self.put(loaded);
            });
        self.report(asker, loaded)
    }

    /// Shows a scene as if the program had begun with it: nothing that was done before can be undone.
    pub(crate) fn begin_anew(&mut self, start: &Scene) {
        match self.drawable_in_this_look(start.clone()) {
            Ok(start) => {
                let start = start.exposed();
                *self.history = History::new(start.scene().clone());
                self.file.0 = None;
                self.title.close();
                self.put(start);
            }
            Err(reason) => self.toast.say(reason),
        }
    }

    /// The file that the scene was loaded from, or saved to.
    pub(crate) fn loaded_file(&self) -> Option<&Path> {
        self.file.0.as_deref()
    }

    /// Notes that the present scene is that of a file, because it was saved there.
    pub(crate) fn note_saved(&mut self, file: &Path) {
        self.file.0 = Some(file.to_owned());
    }

    /// Loads the preset `places` further on among the built-in ones and the user's own. A preset that
    /// cannot be loaded is named and passed over.
    pub(crate) fn step_preset(&mut self, asker: &str, places: i32) {
        let own = own_presets();
        let name = &self.scene.name;
        // The program may have begun with one of them.
        let named = |file: &&PathBuf| file.file_stem().is_some_and(|stem| stem == name.as_str());
        let file = self.file.0.as_ref().or_else(|| own.iter().find(named));
        let mut now = match file {
            Some(file) => RowPreset::Own(file.clone()),
            None => RowPreset::BuiltIn(name.clone()),
        };
        let mut faults = Vec::new();
        loop {
            now = preset_beside(&now, own.clone(), places);
            match &now {
                RowPreset::BuiltIn(name) => {
                    let preset = presets::find(name).map(|preset| preset.plain_scene().clone());
                    let preset = preset.ok_or_else(|| format!("{name} is no preset"));
                    self.load(asker, preset);
                    break;
                }
                RowPreset::Own(file) => {
                    let scene = read_scene(file, &[]).map_err(|error| error.to_string());
                    if self.load_file(file, scene) {
                        break;
                    }
                    faults.push(self.toast.text().to_owned());
                }
            }
        }
        for fault in faults {
            self.toast.add(&fault);
        }
    }

    /// As [`load`](Self::load), for the scene of a file. Says so if the file is a picture of other
    /// stars than those at hand.
    pub(crate) fn load_file(&mut self, file: &Path, loaded: Result<Scene, String>) -> bool {
        let done = self.load("", loaded);
        if done {
            self.file.0 = Some(file.to_owned());
        }
        let remark = missing_stars(file.as_os_str(), self.scene.scene(), &self.stars);
        if let Some(remark) = remark.filter(|_| done) {
            self.say(remark);
        }
        done
    }

    /// Notes that a flight is about to lead the camera away, which can be undone, and takes the
    /// scene's title and the last message away, if it was shown. A flight that begins in a scene of its own, `start`,
    /// finds it in place, in the present look.
    pub(crate) fn depart(&mut self, start: Option<&Scene>) {
        let before = self.scene();
        let unread = self.toast.unread().to_owned();
        let start = start.map(|scene| self.drawable_in_this_look(scene.clone()));
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
        self.toast.say(unread);
    }

    /// Notes that the observer is about to be let go, which can be undone.
    pub(crate) fn note_departure(&mut self) {
        let before = self.scene();
        self.history.note_departure(&before, self.time.elapsed());
    }

    /// Notes that the hand is about to lead the camera away, which can be undone.
    pub(crate) fn note_departure_by_hand(&mut self) {
        let before = self.scene();
        self.history
            .note_departure_by_hand(&before, self.time.elapsed());
    }

    /// Shows the scene to which a flight has led the one that was drawn.
    pub(crate) fn fly(&mut self, flown: &Drawable) {
        self.clock.set(flown.disk.time);
        let flown = flown.shown_in(&Frame::of(&self.scene));
        // A paused flight rests, and a picture at rest is kept.
        self.scene.set_if_neq(CurrentScene(flown));
    }

    /// Turns the camera at its place to these axes (right, up, forward) on the observer's axes.
    pub(crate) fn turn(&mut self, axes: DMat3) {
        let mut turned = self.drawn_scene().into_scene();
        turned.camera.set_orientation(axes);
        match Drawable::new(turned) {
            Ok(turned) => self.fly(&turned),
            Err(reason) => self.toast.say(format!("The camera cannot turn: {reason}")),
        }
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

    /// The scene in this look, to be drawn, or why it cannot be.
    fn drawable_in_this_look(&self, scene: Scene) -> Result<Drawable, String> {
        let scene = self.in_this_look(scene);
        Drawable::new(scene.clone()).map_err(|reason| undrawable(&reason, &scene))
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

    /// Shows a toast for at least this long, unless another one takes its place.
    pub(crate) fn say_for(&mut self, min_duration: Duration, text: impl Into<String>) {
        self.toast.say_for(min_duration, text);
    }

    /// Shows a changed scene, metered at once where its exposure is automatic.
    fn put(&mut self, changed: Drawable) {
        let chosen = changed.exposed();
        self.meter.set(chosen.picture.exposure_ev);
        self.clock.set(chosen.disk.time);
        self.scene.0 = chosen;
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
