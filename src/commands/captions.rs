//! `lightfall captions`: the captions of a journey as subtitles of a video.

use super::cli::CaptionsArgs;
use super::output::print;
use super::stop::Stop;
use crate::app::Bindings;
use lightfall_core::scene::journey::{self, SubtitleFormat};
use lightfall_platform::storage;
use std::path::Path;

/// Writes the captions of a journey or a lesson as subtitles.
pub(super) fn captions(args: &CaptionsArgs) -> Result<(), Stop> {
    let format = format_of(&args.out)?;
    let (name, journey) = match &args.journey {
        Some(file) => (file.display().to_string(), storage::journey_by_name(file)?),
        None => {
            let name = "the built-in journey";
            let journey = journey::load(name, journey::DEFAULT).map_err(Stop::refused)?;
            (name.into(), journey)
        }
    };
    // The keys of the defaults: whoever sees the video has keys of their own, or none.
    let bindings = Bindings::default();
    let subtitles = journey.subtitles(args.fps, |text| bindings.with_keys(text));
    if subtitles.is_empty() {
        return Err(Stop::refused(format!(
            "{name}: it has neither captions nor stops with a caption, so there is nothing to write"
        )));
    }
    storage::check_writable(&args.out).map_err(Stop::failed)?;
    let text = subtitles.to_text(format);
    storage::write_atomically(&args.out, text.as_bytes()).map_err(Stop::failed)?;
    print(&format!("{}\n", args.out.display()))
}

/// The format that the ending of a file's name says.
fn format_of(file: &Path) -> Result<SubtitleFormat, Stop> {
    let extension = file.extension().unwrap_or_default().to_string_lossy();
    let format = SubtitleFormat::from_word(&extension.to_ascii_lowercase());
    format.ok_or_else(|| {
        let fault = match &*extension {
            "" => "the name has no extension that says which format the subtitles have".to_owned(),
            extension => format!("unknown format of subtitles {extension:?}"),
        };
        Stop::refused(format!(
            "{}: {fault}; allowed are .srt and .vtt",
            file.display()
        ))
    })
}
