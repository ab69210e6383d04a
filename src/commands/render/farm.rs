//! The part of a sequence that one of several processes draws, and the manifest of it.

use super::cube::file_of_all;
use super::pictures::Pictures;
use crate::commands::circumstances::commit;
use crate::commands::cli::{RenderArgs, first_given};
use crate::commands::stop::Stop;
use lightfall_core::reason::reason;
use lightfall_picture::{
    DeviceFacts, Format, Manifest, ManifestRow, PictureError, Sequence, Studio,
};
use lightfall_platform::storage;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The numbers of the frames that this process draws; one for a single picture.
pub(super) fn numbers(args: &RenderArgs, sequence: Option<&Sequence>) -> Vec<u32> {
    match (&args.frames, args.farm.shard, sequence) {
        (Some(frames), Some(shard), _) => shard.of(frames),
        (Some(frames), None, _) => frames.numbers().to_vec(),
        (None, _, Some(sequence)) => (sequence.frames.first..=sequence.frames.last).collect(),
        (None, _, None) => vec![0],
    }
}

/// Whether the pictures are a run without gaps, of which a video can be made as soon as they are drawn.
pub(super) fn is_run(args: &RenderArgs) -> bool {
    let is_run = match &args.frames {
        Some(frames) => frames.run().is_some(),
        None => args.loop_seconds.is_some(),
    };
    is_run && args.farm.shard.is_none()
}

/// Checks that the options of a part go with the format of the file.
pub(super) fn check_farm(args: &RenderArgs, format: Format) -> Result<(), Stop> {
    let farm = &args.farm;
    let options = [
        ("--shard", farm.shard.is_some()),
        ("--resume", farm.resume),
        ("--manifest", farm.manifest),
    ];
    match first_given(options) {
        Some(option) if format.holds_sequence() => Err(Stop::refused(format!(
            "{option} is for pictures in files of their own: the name must end in .png or .exr"
        ))),
        _ => Ok(()),
    }
}

/// What is said where a process has nothing to draw.
pub(super) fn nothing_to_draw(args: &RenderArgs) -> String {
    let all = args
        .frames
        .as_ref()
        .map_or(0, |frames| frames.numbers().len());
    match args.farm.shard {
        Some(shard) if shard.number as usize > all => format!(
            "nothing to draw: shard {}/{} has none of the {all} frames",
            shard.number, shard.count
        ),
        _ => "nothing to draw: all frames are there".into(),
    }
}

/// The manifest of the frames, if there is to be one, with the rows that it has already.
pub(super) fn open_manifest(
    args: &RenderArgs,
    pictures: &Pictures,
) -> Result<Option<Manifest>, Stop> {
    let ending = match args.farm.shard {
        Some(shard) => format!(".{}-of-{}.jsonl", shard.number, shard.count),
        None if args.farm.manifest => ".jsonl".into(),
        None => return Ok(None),
    };
    let Some(sequence) = &pictures.sequence else {
        return Ok(None);
    };
    let path = file_of_all(&sequence.beside(&ending));
    storage::check_name(&path).map_err(Stop::failed)?;
    Manifest::open(&path).map(Some).map_err(Stop::refused)
}

/// Adds the files of a frame that was drawn and written in this time.
pub(super) fn note_frame(
    manifest: &mut Manifest,
    (number, files): (u32, &[PathBuf]),
    time: Duration,
    studio: &Studio,
) -> Result<(), Stop> {
    let DeviceFacts { backend, pci, host } = studio.device_facts();
    for file in files {
        let row = row_of(number, file)?;
        manifest.insert(ManifestRow {
            // Milliseconds are as much as one run has in common with the next.
            seconds: Some((time.as_secs_f64() * 1000.0).round() / 1000.0),
            commit: row.commit.clone().or_else(commit),
            backend: backend.clone(),
            pci: pci.clone(),
            host: host.clone(),
            ..row
        });
    }
    write(manifest)
}

/// The row of a picture that is there.
pub(super) fn row_of(number: u32, file: &Path) -> Result<ManifestRow, Stop> {
    ManifestRow::of_file(number, file).map_err(|error| {
        let reason = reason(&error);
        Stop::failed(format!("{}: cannot be read: {reason}", file.display()))
    })
}

pub(super) fn write(manifest: &Manifest) -> Result<(), Stop> {
    manifest
        .write()
        .map_err(|error| PictureError::from(error).into())
}
