//! What runs around the picture: the window, the frame rate, resolution and exposure, the graphics
//! adapter, screenshots and the clipboard.

pub(crate) mod adapter;
pub(crate) mod adaptive_resolution;
pub(crate) mod canvas;
pub(crate) mod clipboard;
pub(crate) mod comparison;
pub(crate) mod crash_notes;
pub(crate) mod detail_limits;
pub(crate) mod display;
pub(crate) mod exposure;
pub(crate) mod frame_pacing;
pub(crate) mod handout_file;
pub(crate) mod icon;
pub(crate) mod kiosk;
pub(crate) mod link;
pub(crate) mod monitor;
#[cfg(target_arch = "wasm32")]
pub(crate) mod page;
pub(crate) mod pixel_look;
pub(crate) mod quit;
pub(crate) mod recovery;
pub(crate) mod screenshot;
pub(crate) mod shader_news;
#[cfg(feature = "sound")]
pub(crate) mod speaker;
pub(crate) mod window;
