//! Progress bars of long commands.

use indicatif::{ProgressBar, ProgressStyle};

/// A progress bar on standard error, with the current task and the remaining time. Nothing is drawn
/// if standard error is not a terminal.
pub(super) fn progress(length: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len}, {eta} left: {wide_msg}");
    ProgressBar::new(length as u64)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
