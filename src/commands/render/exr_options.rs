//! The options of `lightfall render` that an EXR picture alone can follow, and what is transparent.

use super::pictures::Pictures;
use crate::commands::cli::{Cells, RenderArgs, first_given};
use crate::commands::stop::Stop;
use lightfall_core::scene::{Projection, Scene, View};
use lightfall_picture::{
    ChannelNames, Channels, ExrCompression, ExrForm, Format, MissingValues, PngBits, Transparent,
};
use lightfall_platform::log::say;

/// The first of the given options that only an .exr can follow.
pub(super) fn exr_option(args: &RenderArgs) -> Option<&'static str> {
    // The others need --aov.
    let options = [
        ("--aov", args.aov.is_some()),
        ("--layers", args.layers),
        ("--exr", args.exr.is_some()),
    ];
    first_given(options)
}

/// The form of an .exr that the options ask for.
pub(super) fn exr_form(args: &RenderArgs) -> ExrForm {
    let missing = args.nan.as_deref().and_then(MissingValues::from_word);
    let transparent = args.alpha.as_deref().and_then(Transparent::from_word);
    let compression = args.exr.as_deref().and_then(ExrCompression::from_word);
    ExrForm {
        names: ChannelNames::from_word(&args.aov_names).unwrap_or_default(),
        missing: missing.unwrap_or_default(),
        transparent,
        compression: compression.unwrap_or_default(),
    }
}

/// Prepares a scene for a .png whose sky or hole is transparent, if that is asked for: it has no cells, 8
/// bits, and is drawn at once.
///
/// # Errors
/// The options ask for something else.
pub(super) fn show_transparent(
    args: &RenderArgs,
    format: Format,
    scene: &mut Scene,
) -> Result<(), Stop> {
    if args.alpha.is_none() || format == Format::Exr {
        return Ok(());
    }
    if format.holds_sequence() {
        return Err(Stop::refused(format!(
            "--alpha: {} has no transparent parts; numbered .png and .exr pictures may have them",
            format.noun()
        )));
    }
    if args.scene.cells == Some(Cells::On) {
        return Err(Stop::refused(
            "--cells on: a picture with transparent parts has no cells",
        ));
    }
    let has_other = [
        ("without --shutter", args.shutter.is_some()),
        (
            "with 8 bits",
            args.bits.as_deref() == Some(PngBits::Sixteen.word()),
        ),
        (
            "in another projection than the cube",
            scene.camera.projection == Projection::Cube,
        ),
    ];
    if let Some(what) = first_given(has_other) {
        return Err(Stop::refused(format!(
            "--alpha: a .png has transparent parts only {what}; an .exr has them in any case"
        )));
    }
    if scene.has_cells() {
        say(
            "lightfall: a picture with transparent parts has no cells: every pixel is shown, as with --cells off",
        );
        scene.picture.bypass = true;
    }
    Ok(())
}

/// The channels of the pictures of an .exr. A layer that one picture of a sequence has is in all of them.
///
/// # Errors
/// The pictures show no light, and layers are asked for.
pub(super) fn channels(args: &RenderArgs, pictures: &Pictures) -> Result<Channels, Stop> {
    let of_rays = args.aov.clone().unwrap_or_default();
    let channels = of_rays.of_scene(&pictures.scene);
    let option = match (args.layers, &args.alpha) {
        (true, _) => "--layers",
        (false, Some(_)) => "--alpha",
        (false, None) => return Ok(channels),
    };
    let scenes = || {
        pictures
            .numbers()
            .map(move |number| pictures.scene_of(number))
    };
    if let Some(other) = scenes().find(|scene| scene.view != View::Colour) {
        return Err(Stop::refused(format!(
            "{option}: only the view \"colour\" has light to divide, and view is {:?}",
            other.view.word()
        )));
    }
    Ok(if args.layers {
        channels.with_layers_of(scenes())
    } else {
        channels
    })
}
