//! What the program asks of the system that it runs on. Each module may use those above it in this
//! list:
//!
//! 1. [`worker`]: background threads.
//! 2. `browser`: what the program asks of a browser, where it runs in one.
//! 3. [`storage`]: files and folders, and scenes by name.
//! 4. [`log`]: what is logged.
//! 5. [`memory`]: how much memory is free.
//! 6. [`fonts`]: fonts of the system.

/// Whether the program runs in a browser.
pub const IN_BROWSER: bool = cfg!(target_arch = "wasm32");

#[cfg(target_arch = "wasm32")]
pub mod browser;
pub mod fonts;
pub mod log;
pub mod memory;
pub mod storage;
pub mod worker;
