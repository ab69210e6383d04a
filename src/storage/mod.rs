//! Files of the program: in which folders they are, how they are written, and how a scene is found
//! by name or read from a file.

mod atomic_file;
mod crash_report;
mod embedded_preset;
mod file_name;
mod folders;
mod scene_source;

pub use atomic_file::{WriteError, check_folder_writable, check_writable, write_atomically};
pub use crash_report::{note_adapter, note_log, note_scene, report_panics};
pub use embedded_preset::{PRESET_KEY, embedded_preset, is_picture};
pub use file_name::file_safe_name;
pub use folders::{
    create_parent_folder, pictures_folder, preset_files, presets_folder, settings_file,
};
pub use scene_source::{SourceError, own_presets, read_journey, read_scene, scene_by_name};
