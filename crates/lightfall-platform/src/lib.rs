//! What the program asks of the system that it runs on. Each module may use those above it in this
//! list:
//!
//! 1. [`worker`]: background threads.
//! 2. `browser`: what the program asks of a browser, where it runs in one.
//! 3. [`storage`]: files and folders, and scenes by name.
//! 4. [`log`]: what is logged.
//! 5. [`memory`]: how much memory is free.
//! 6. `termination`: the request to end that schedulers send, where there are schedulers.
//! 7. `host`: the name of the machine.
//! 8. [`fonts`]: fonts of the system.
//! 9. `file_dialog`: the desktop's file dialog, where there is a desktop.

/// Whether the program runs in a browser.
pub const IN_BROWSER: bool = cfg!(target_arch = "wasm32");

#[cfg(target_arch = "wasm32")]
pub mod browser;
#[cfg(not(target_arch = "wasm32"))]
pub mod file_dialog;
pub mod fonts;
#[cfg(not(target_arch = "wasm32"))]
pub mod host;
pub mod log;
pub mod memory;
pub mod storage;
#[cfg(not(target_arch = "wasm32"))]
pub mod termination;
pub mod worker;
