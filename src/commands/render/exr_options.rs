//! The options of `lightfall render` that an EXR picture alone can follow.

use crate::commands::cli::RenderArgs;
use lightfall_picture::{ChannelNames, ExrCompression, ExrForm, MissingValues};

/// The first of the given options that only an .exr can follow.
pub(super) fn exr_option(args: &RenderArgs) -> Option<&'static str> {
    // The others need --aov.
    let options = [("--aov", args.aov.is_some()), ("--exr", args.exr.is_some())];
    let given = options.into_iter().find(|(_, is_given)| *is_given);
    given.map(|(option, _)| option)
}

/// The form of an .exr that the options ask for.
pub(super) fn exr_form(args: &RenderArgs) -> ExrForm {
    let missing = args.nan.as_deref().and_then(MissingValues::from_word);
    let compression = args.exr.as_deref().and_then(ExrCompression::from_word);
    ExrForm {
        names: ChannelNames::from_word(&args.aov_names).unwrap_or_default(),
        missing: missing.unwrap_or_default(),
        compression: compression.unwrap_or_default(),
    }
}
