//! The pictures that a command line asks for: one, or the frames of a sequence.

use crate::commands::cli::RenderArgs;
use crate::commands::scene::{NO_JOURNEY, drawable, journey};
use crate::commands::stop::Stop;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Scene;
use lightfall_picture as picture;
use lightfall_picture::{Format, Frames, Sequence};
use lightfall_platform::log::say;
use std::ops::Range;
use std::path::{Path, PathBuf};

pub(super) fn sequence(args: &RenderArgs, frames: Frames, scene: &Scene) -> Result<Sequence, Stop> {
    let journey = match args.journey.as_deref() {
        Some(file) if file == Path::new(NO_JOURNEY) => None,
        file => Some(journey(file, scene)?),
    };
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
}

impl Pictures {
    pub(super) fn numbers(&self) -> Range<u32> {
        self.sequence
            .as_ref()
            .map_or(0..1, |Sequence { frames, .. }| {
                frames.first..frames.last + 1
            })
    }

    pub(super) fn get(&self, number: u32) -> (Scene, PathBuf) {
        match &self.sequence {
            Some(sequence) => {
                let file = match self.format {
                    Format::Apng | Format::Film => self.file.clone(),
                    Format::Png | Format::Exr => sequence.file(number),
                };
                (sequence.scene(&self.scene, number), file)
            }
            None => (self.scene.clone(), self.file.clone()),
        }
    }

    /// Checks that all pictures can be drawn, so that the last frame of a long sequence does not
    /// come as a surprise.
    pub(super) fn check(&self) -> Result<(), Stop> {
        drawable(&self.get(self.numbers().start).0)?;
        let Some(sequence) = &self.sequence else {
            return Ok(());
        };
        for number in self.numbers() {
            Drawable::new(sequence.scene(&self.scene, number))
                .map_err(|reason| Stop::refused(format!("frame {number}: {reason}")))?;
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
