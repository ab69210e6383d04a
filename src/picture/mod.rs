//! Pictures without a window: the same chain, drawn to an image and written as a whole file.

mod file;
mod still;

pub use file::{PictureError, check_path, write_png, write_text};
pub(crate) use still::quiet_log;
pub use still::{PassTime, Still, Studio, check_size, render, render_timed};
