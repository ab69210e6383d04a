//! The desktop's file dialog. Systems with a desktop portal show the portal's one, Windows and macOS
//! their own. A browser's is in `browser`, because it gives a file's contents and not its path.

#[cfg(any(windows, target_os = "macos"))]
mod native;
#[cfg(all(unix, not(target_os = "macos")))]
mod portal;

#[cfg(any(windows, target_os = "macos"))]
use native as system;
#[cfg(all(unix, not(target_os = "macos")))]
use portal as system;
#[cfg(all(unix, not(target_os = "macos")))]
pub use portal::Portal;

use std::path::PathBuf;

/// What a dialog asks for.
#[derive(Clone, Debug)]
pub struct FileRequest {
    /// The dialog's title.
    pub title: &'static str,
    /// What the files are, in plural.
    pub kind: &'static str,
    /// The extensions of such files.
    pub extensions: &'static [&'static str],
    /// The folder that the dialog opens in.
    pub folder: Option<PathBuf>,
}

/// Shows a dialog and waits for the user. Returns the file that the user chose; none if the user
/// cancelled the dialog.
///
/// # Errors
/// Why the system shows no dialog or gives no answer. On Windows and macOS a dialog that fails looks
/// like one that the user cancelled.
pub fn pick_file(request: &FileRequest) -> Result<Option<PathBuf>, String> {
    system::pick_file(request)
}
