//! Scenes: fields, limits, presets, journeys, and what is refused.
#![allow(
    clippy::unwrap_used,
    reason = "a test that unwraps an error fails, as it should"
)]

mod camera_path_faults;
mod camera_paths;
mod changes;
mod disk_motion;
mod eases;
mod fields;
mod garbled;
mod journey;
mod journey_faults;
mod limits;
mod load;
mod pose;
mod presets;
#[path = "../physics/random.rs"]
mod random;
mod set_fields;
mod step_policy;
mod stops;
mod subtitles;
mod text;
mod toml_faults;
mod words;
mod wrong_keys;
