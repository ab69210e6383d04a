//! The options of `lightfall render` that an EXR picture alone can follow.

use super::pictures::Pictures;
use crate::commands::cli::RenderArgs;
use crate::commands::stop::Stop;
use lightfall_core::scene::View;
use lightfall_picture::{
    ChannelNames, Channels, ExrCompression, ExrForm, MissingValues, Transparent,
};

/// The first of the given options that only an .exr can follow.
pub(super) fn exr_option(args: &RenderArgs) -> Option<&'static str> {
    // The others need --aov.
    let options = [
        ("--aov", args.aov.is_some()),
        ("--layers", args.layers),
        ("--alpha", args.alpha.is_some()),
        ("--exr", args.exr.is_some()),
    ];
    let given = options.into_iter().find(|(_, is_given)| *is_given);
    given.map(|(option, _)| option)
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
    let scenes = || pictures.numbers().map(move |number| pictures.get(number).0);
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
