//! The command line: one file for each command.
//!
//! [`cli`] describes the arguments. Every command returns a [`Stop`] where it cannot do what was
//! asked, and [`run`] turns it into the exit status.

mod adapters;
mod bench;
mod camera;
mod captions;
mod circumstances;
pub mod cli;
mod console;
pub mod doctor;
mod extremes;
mod fly;
mod glyphs;
mod kept_rows;
mod kiosk;
mod lut;
mod output;
mod presets;
mod progress;
mod render;
mod run;
mod scene;
mod stop;
mod trace;
mod unused;
mod video;

pub use console::StandardError;
pub use kiosk::{check_options, shows};
pub use presets::presets;
pub use progress::in_words;
pub use render::still_drawing;
pub use run::{run, run_with};
pub use scene::{journey, opened, scene};
pub use stop::Stop;
