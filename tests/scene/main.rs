//! Scenes as they are asked for: fields, presets, overrides, the command line, and the rays of
//! `lightfall trace`.
#![allow(
    clippy::unwrap_used,
    reason = "a test that unwraps an error fails, as it should"
)]

mod command_line;
mod fields;
mod flights;
mod gamepad;
mod history;
mod journey;
mod keys;
mod limits;
mod load;
mod pose;
mod presets;
mod program;
mod rays;
mod settings;
