//! The lesson that is made in the window, and the file in which it is kept.

use bevy::prelude::*;
use lightfall_core::scene::journey::{Draft, Shown};
use lightfall_platform::storage::{
    create_parent_folder, exists, lessons_folder, read_text, write_atomically, write_new,
};
use std::path::PathBuf;

/// The largest number in the name of a lesson's file.
const MAX_NUMBER: u32 = 9999;
/// What stands above the text of a lesson.
const HEAD: &str = "# A lesson, made in the window. Write the captions here: each may have several lines.\n\
    # docs/JOURNEYS.md explains the format.\n";

/// The lesson under construction.
#[derive(Resource, Default)]
pub(crate) struct LessonDraft {
    draft: Draft,
    /// The file that it was saved as, and the text that was written there.
    saved: Option<(PathBuf, String)>,
    /// Whether there are stops that no file has.
    pub(crate) has_changed: bool,
}

impl LessonDraft {
    /// The number of stops so far.
    pub(crate) fn stops(&self) -> usize {
        self.draft.len()
    }

    /// Adds what is shown as the next stop.
    ///
    /// # Errors
    /// One sentence: why no lesson leads there.
    pub(crate) fn add(&mut self, shown: Shown) -> Result<(), String> {
        self.draft.add(shown).map_err(|fault| fault.to_string())?;
        self.has_changed = true;
        Ok(())
    }

    /// The file that saving writes: the lesson's own one, or a new one.
    ///
    /// # Errors
    /// One sentence: there is no folder, or no free name in it.
    pub(crate) fn file(&self) -> Result<PathBuf, String> {
        if let Some((file, written)) = &self.saved
            && read_text(file, written.len() as u64).is_ok_and(|text| text == *written)
        {
            return Ok(file.clone());
        }
        let folder = lessons_folder()
            .ok_or("This system has no folder for settings, so lessons cannot be kept")?;
        (1..=MAX_NUMBER)
            .map(|number| folder.join(format!("lesson-{number}.toml")))
            .find(|file| !exists(file))
            .ok_or_else(|| format!("{} has no free name for a lesson", folder.display()))
    }

    /// Saves the lesson, whole or not at all. A file that somebody else wrote or has edited since stays
    /// as it is, and the lesson becomes a new file.
    ///
    /// # Errors
    /// One sentence: there is nothing to save, or the file cannot be written.
    pub(crate) fn save(&mut self) -> Result<PathBuf, String> {
        if self.draft.is_empty() {
            return Err("The lesson has no stop yet".into());
        }
        let file = self.file()?;
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        self.draft.title = name.replace('-', " ").replace("lesson", "Lesson");
        let journey = self.draft.journey().map_err(|fault| fault.to_string())?;
        let text = HEAD.to_owned() + &journey.to_toml();
        let is_own = self.saved.as_ref().is_some_and(|(own, _)| *own == file);
        let write = if is_own { write_atomically } else { write_new };
        create_parent_folder(&file)
            .and_then(|()| write(&file, text.as_bytes()))
            .map_err(|error| error.to_string())?;
        self.saved = Some((file.clone(), text));
        self.has_changed = false;
        Ok(file)
    }

    /// Forgets the stops: the next one begins a new lesson.
    pub(crate) fn begin_anew(&mut self) {
        *self = Self::default();
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<LessonDraft>();
}
