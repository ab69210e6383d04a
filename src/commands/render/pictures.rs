//! The pictures that a command line asks for: one, or the frames of a sequence.

use crate::commands::cli::RenderArgs;
use crate::commands::scene::{drawable, journey_of_frames};
use crate::commands::stop::Stop;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Scene;
use lightfall_picture as picture;
use lightfall_picture::{Format, Frames, Sequence};
use lightfall_platform::log::say;
use std::path::PathBuf;

pub(super) fn sequence(args: &RenderArgs, frames: Frames, scene: &Scene) -> Result<Sequence, Stop> {
    let journey = journey_of_frames(args.journey.as_deref(), args.fps, scene)?;
    if let (Some(preset), Some(file), None) = (
        journey.as_ref().and_then(|journey| journey.preset),
        &args.journey,
        &args.scene.preset,
    ) {
        say(format_args!(
            "lightfall: {}: its preset is that of the window; --preset {} draws it here",
            file.display(),
            preset.name
        ));
    }
    let sequence = Sequence::new(journey, frames, args.fps, &args.out).map_err(Stop::refused)?;
    match sequence.end() {
        Some(end) if f64::from(frames.last) > end && scene.disk_moves() => {
            say(format_args!(
                "lightfall: the journey ends at frame {end}; later frames show the disk from there"
            ));
        }
        Some(end) if f64::from(frames.last) > end => {
            say(format_args!(
                "lightfall: the journey ends at frame {end}; later frames show its end"
            ));
        }
        None if !scene.disk_moves() => {
            say(
                "lightfall: nothing moves in this scene without a journey: all frames are the same",
            );
        }
        _ => {}
    }
    Ok(sequence)
}

/// The pictures to draw, with their files: one, or the frames of a sequence, by number.
pub(super) struct Pictures {
    pub(super) format: Format,
    pub(super) scene: Scene,
    pub(super) file: PathBuf,
    pub(super) sequence: Option<Sequence>,
    /// How long the shutter is open, as a share of the time from one frame to the next.
    pub(super) shutter: Option<f64>,
    /// The numbers of the frames that are drawn, in this order; one for a single picture.
    pub(super) numbers: Vec<u32>,
}

impl Pictures {
    pub(super) fn numbers(&self) -> impl ExactSizeIterator<Item = u32> {
        self.numbers.iter().copied()
    }

    /// The number of the first picture.
    pub(super) fn first(&self) -> u32 {
        self.numbers.first().copied().unwrap_or_default()
    }

    /// The scene of the picture of this number.
    pub(super) fn scene_of(&self, number: u32) -> Scene {
        match &self.sequence {
            Some(sequence) => sequence.scene(&self.scene, number),
            None => self.scene.clone(),
        }
    }

    /// The file of the picture of this number, or the one that holds all frames.
    pub(super) fn file_of(&self, number: u32) -> PathBuf {
        match &self.sequence {
            Some(sequence) if !self.format.holds_sequence() => sequence.file(number),
            _ => self.file.clone(),
        }
    }

    /// The moments whose light is averaged for the picture of this number; none without a shutter.
    pub(super) fn moments(&self, number: u32) -> Vec<Scene> {
        match (&self.sequence, self.shutter) {
            (Some(sequence), Some(shutter)) => {
                picture::moments(sequence, &self.scene, number, shutter)
            }
            _ => Vec::new(),
        }
    }

    /// Checks that all pictures can be drawn, so that the last frame of a long sequence does not
    /// come as a surprise.
    pub(super) fn check(&self) -> Result<(), Stop> {
        drawable(&self.scene_of(self.first()))?;
        let Some(sequence) = &self.sequence else {
            return Ok(());
        };
        for number in self.numbers() {
            // The frame's own moment, and the one at which the shutter closes.
            let closing = self.shutter.map(|open| f64::from(number) + open);
            for moment in [Some(f64::from(number)), closing].into_iter().flatten() {
                Drawable::new(sequence.scene_at(&self.scene, moment))
                    .map_err(|reason| Stop::refused(format!("frame {number}: {reason}")))?;
            }
        }
        Ok(())
    }
}

/// The scene as it is drawn for a file of this format. An EXR has no cells.
pub(super) fn drawn_scene(scene: &Scene, format: Format) -> Scene {
    match format {
        Format::Png | Format::Apng | Format::Film => picture::filled(scene),
        Format::Exr => scene.clone(),
    }
}
