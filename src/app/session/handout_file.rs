//! Where handouts go: into new files in the folder for pictures, or to the browser's downloads.

use lightfall_platform::storage::file_safe_name;

/// The largest number in the name of a handout.
#[cfg(not(target_arch = "wasm32"))]
const MAX_NUMBER: u32 = 9999;

/// Writes a handout of the scene of this name, and says where it is or why nothing is written.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) fn save_handout(scene: &str, svg: &str) -> String {
    use lightfall_platform::storage::{exists, pictures_folder, write_new};
    let (folder, name) = (pictures_folder(), file_safe_name(scene));
    let files = (1..=MAX_NUMBER).map(|n| folder.join(format!("lightfall-{name}-ray-{n:04}.svg")));
    let Some(file) = files.into_iter().find(|file| !exists(file)) else {
        return format!(
            "Nothing is saved: {} has too many handouts",
            folder.display()
        );
    };
    match write_new(&file, svg.as_bytes()) {
        Ok(()) => format!("Saved: {}", file.display()),
        Err(error) => format!("Nothing is saved: {error}"),
    }
}

/// Offers a handout as a download.
#[cfg(target_arch = "wasm32")]
pub(crate) fn save_handout(scene: &str, svg: &str) -> String {
    let name = format!("lightfall-{}-ray.svg", file_safe_name(scene));
    match lightfall_platform::browser::download(&name, svg.as_bytes()) {
        Ok(()) => format!("Downloaded {name}"),
        Err(reason) => format!("Nothing is saved: {reason}"),
    }
}
