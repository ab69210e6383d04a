//! What the program asks of the system that it runs on. Each module may use those above it in this
//! list:
//!
//! 1. [`worker`]: background threads.
//! 2. `browser`: what the program asks of a browser, where it runs in one.
//! 3. [`storage`]: files and folders, and scenes by name.
//! 4. [`log`]: what is logged.
//! 5. [`memory`]: how much memory is free.
//! 6. [`fonts`]: fonts of the system.
//! 7. `file_dialog`: the desktop's file dialog, where there is a desktop.

/// Whether the program runs in a browser.
pub const IN_BROWSER: bool = cfg!(target_arch = "wasm32");

#[cfg(target_arch = "wasm32")]
pub mod browser;
#[cfg(not(target_arch = "wasm32"))]
pub mod file_dialog;
pub mod fonts;
pub mod log;
pub mod memory;
pub mod storage;
pub mod worker;
