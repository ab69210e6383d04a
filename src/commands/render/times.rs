//! The GPU time of each pass of a picture.

use crate::commands::circumstances::circumstances;
use crate::commands::scene::device;
use crate::commands::stop::Stop;
use glam::UVec2;
use lightfall_lab::export::csv;
use lightfall_picture::PassTime;
use lightfall_platform::log::say;
use lightfall_platform::storage;
use std::path::Path;

/// Number of frames that `render --timings` takes the median of.
pub(super) const TIMED_FRAMES: usize = 15;

/// Writes the times of a picture of this size as CSV.
pub(super) fn write_times(file: &Path, times: &[PassTime], size: UVec2) -> Result<(), Stop> {
    let size = format!("{}x{}", size.x, size.y);
    let circumstances = circumstances(&device()?, size, "fragment");
    storage::write_atomically(file, csv(&circumstances, times).as_bytes()).map_err(Stop::failed)
}

pub(super) fn print_times(times: &[PassTime]) {
    say(format_args!(
        "{:>10}{:>10}  pass (GPU time in ms, median of {TIMED_FRAMES} frames: of frames that draw the scene, and of \
         frames that keep its picture)",
        "drawn", "kept"
    ));
    for PassTime {
        pass,
        median_ms,
        kept_ms,
    } in times
    {
        say(format_args!("{median_ms:>10.3}{kept_ms:>10.3}  {pass}"));
    }
}
