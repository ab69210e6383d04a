//! Files: those of the file system or, in a browser, texts in its storage.

#[cfg(target_arch = "wasm32")]
mod browser;
#[cfg(not(target_arch = "wasm32"))]
mod disk;
#[cfg(not(target_arch = "wasm32"))]
mod new_file;
mod text;
mod write_error;

#[cfg(target_arch = "wasm32")]
pub use browser::{
    create_parent_folder, exists, files_in, read, remove, rename, write_atomically, write_new,
};
#[cfg(not(target_arch = "wasm32"))]
pub use disk::{
    check_folder_writable, check_name, check_writable, create_parent_folder, exists, files_in,
    read, remove, rename, write_atomically, write_new,
};

#[cfg(not(target_arch = "wasm32"))]
pub use new_file::{NewFile, free_space, remove_unfinished, scratch_file};
pub use text::{TextError, read_text, text_of};
pub use write_error::WriteError;
