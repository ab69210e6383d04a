//! The documents: what they name exists, and the promises they state are the program's. These tests
//! need neither Bevy nor a GPU.

mod links;
mod promises;

use std::path::{Path, PathBuf};

/// The folder of the whole workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
