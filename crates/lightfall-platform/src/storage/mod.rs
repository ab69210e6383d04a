//! Files of the program: in which folders they are, how they are written, and how a scene is found
//! by name or read from a file. In a browser they are in its storage.

mod crash_report;
mod embedded_preset;
mod file_name;
mod files;
mod folders;
mod hash;
mod opened;
mod panorama;
mod picture_record;
mod scene_source;

pub use crash_report::{note_adapter, note_log, note_scene, report_panics, unless_it_panics};
pub use embedded_preset::{
    EXR_SIGNATURE, PNG_SIGNATURE, embedded_preset, embedded_text, encoded_png, header_text,
    is_picture, preset_pieces, set_up_png,
};
pub use file_name::file_safe_name;
#[cfg(not(target_arch = "wasm32"))]
pub use files::{
    NewFile, check_folder_writable, check_name, check_writable, free_space, remove_unfinished,
    scratch_file,
};
pub use files::{
    TextError, WriteError, create_parent_folder, exists, read_text, remove, rename, text_of,
    write_atomically, write_new,
};
#[cfg(not(target_arch = "wasm32"))]
pub use folders::pictures_folder;
pub use folders::{
    lesson_results_file, lessons_folder, mission_results_file, missions_folder, preset_files,
    presets_folder, settings_file,
};
pub use hash::{hash_of_file, hash_of_text};
pub use opened::{
    Opened, open_by_name, open_contents, open_file, own_missions, own_presets, read_scene,
    scene_by_name, with_whole_sky_path,
};
pub use picture_record::{PictureRecord, missing_stars};
pub use scene_source::{
    SourceError, flyable_journey, journey_at_rate, journey_by_name, journey_of_file, read_journey,
    read_stars,
};
