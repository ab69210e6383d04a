//! The dialog of Windows or macOS.

use super::FileRequest;
use std::path::PathBuf;

pub(super) fn pick_file(request: &FileRequest) -> Result<Option<PathBuf>, String> {
    let mut dialog = rfd::FileDialog::new()
        .set_title(request.title)
        .add_filter(request.kind, request.extensions);
    if let Some(folder) = &request.folder {
        dialog = dialog.set_directory(folder);
    }
    Ok(dialog.pick_file())
}
