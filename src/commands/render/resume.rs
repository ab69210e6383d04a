//! `--resume`: which pictures of a sequence are there already.

use super::cube::{file_of, is_of_side, layout, side_of, sides};
use super::farm::{row_of, write};
use super::large::Tiling;
use super::pictures::Pictures;
use crate::commands::stop::Stop;
use glam::UVec2;
use lightfall_core::optics::stars::Catalogue;
use lightfall_core::scene::{Projection, Scene};
use lightfall_picture::{
    Channels, ExrForm, Format, Found, Manifest, PictureError, Wanted, WantedForm, find_picture,
};
use lightfall_platform::log::say;
use lightfall_platform::storage::PictureRecord;
use lightfall_platform::termination;
use std::path::{Path, PathBuf};

/// The numbers of the frames that are not there. Those that are there get their rows in the manifest.
pub(super) fn left_to_draw(
    pictures: &Pictures,
    (channels, form): (&Channels, ExrForm),
    tiling: Option<&Tiling>,
    stars: &Catalogue,
    manifest: Option<&mut Manifest>,
) -> Result<Vec<u32>, Stop> {
    let form = match pictures.format {
        Format::Exr => WantedForm::Exr(channels, form),
        // Other formats have no pictures in files of their own.
        _ => WantedForm::Png(tiling.map(|tiling| tiling.bits).unwrap_or_default()),
    };
    let (mut left, mut there) = (Vec::new(), Vec::new());
    for number in pictures.numbers() {
        if termination::is_asked() {
            return Err(PictureError::Terminated.into());
        }
        let (scene, file) = (pictures.scene_of(number), pictures.file_of(number));
        let files = files_of_scene(&scene, &file, pictures.format);
        let mut is_there = true;
        for (file, drawn, size) in &files {
            let wanted = Wanted {
                size: *size,
                record: &PictureRecord::new(drawn, stars, None),
                is_metered: scene.picture.automatic_exposure,
                form,
            };
            let found = find_picture(file, &wanted).map_err(|fault| {
                Stop::refused(format!(
                    "--resume: {} {fault}; without --resume it is replaced",
                    file.display()
                ))
            })?;
            is_there &= found == Found::Whole;
            if found == Found::Partial {
                say(format_args!(
                    "lightfall: {} is not whole, and is drawn again",
                    file.display()
                ));
            }
        }
        if is_there {
            there.extend(files.into_iter().map(|(file, _, _)| (number, file)));
        } else {
            left.push(number);
        }
    }
    if let Some(manifest) = manifest {
        there.retain(|(number, file)| !manifest.knows(*number, file));
        for (number, file) in &there {
            manifest.insert(row_of(*number, file)?);
        }
        if !there.is_empty() {
            write(manifest)?;
        }
    }
    let all = pictures.numbers.len();
    if (1..all).contains(&left.len()) {
        say(format_args!(
            "lightfall: {} of {all} frames are there",
            all - left.len()
        ));
    }
    Ok(left)
}

/// The files of the picture of a scene, each with the scene whose preset it holds and its size.
fn files_of_scene(scene: &Scene, file: &Path, format: Format) -> Vec<(PathBuf, Scene, UVec2)> {
    if scene.camera.projection != Projection::Cube {
        return vec![(file.into(), scene.clone(), scene.picture.size())];
    }
    let layout = layout(format, file);
    if !is_of_side(file) {
        return vec![(file.into(), scene.clone(), layout.size(side_of(scene)))];
    }
    let files = sides(scene, layout).into_iter().map(|(face, own)| {
        let size = own.picture.size();
        (file_of(file, &face), own, size)
    });
    files.collect()
}
