//! Opens what files hold: scenes, missions and journeys.

use super::lessons::StartJourney;
use super::missions::StartMission;
use super::scene_editor::SceneEditor;
use bevy::ecs::system::SystemParam;
use bevy::prelude::MessageWriter;
use lightfall_platform::storage::{Opened, open_file};
use std::path::Path;

/// The scene, and the ways to begin a mission and a journey.
#[derive(SystemParam)]
pub(crate) struct FileOpener<'w> {
    pub(crate) editor: SceneEditor<'w>,
    starts: MessageWriter<'w, StartMission>,
    flights: MessageWriter<'w, StartJourney>,
}

impl FileOpener<'_> {
    /// Opens a file. Returns whether its scene is in place.
    pub(crate) fn open(&mut self, file: &Path) -> bool {
        let opened = open_file(file, &[]).map_err(|fault| fault.to_string());
        self.show(file, opened)
    }

    /// Shows the scene that a file holds, begins its mission or its journey, or says what is wrong with it.
    /// Returns whether its scene is in place.
    pub(crate) fn show(&mut self, file: &Path, opened: Result<Opened, String>) -> bool {
        let scene = match opened {
            Ok(Opened::Mission(mission)) => {
                self.starts.write(StartMission(mission));
                return false;
            }
            Ok(Opened::Journey(journey)) => {
                self.flights.write(StartJourney(journey));
                return false;
            }
            Ok(Opened::Scene(scene)) => Ok(*scene),
            Err(fault) => Err(fault),
        };
        self.editor.load_file(file, scene)
    }
}
