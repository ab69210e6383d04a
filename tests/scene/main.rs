//! Scenes as they are asked for: fields, presets, overrides, the command line, and the rays of
//! `lightfall trace`.
#![allow(
    clippy::print_stderr,
    reason = "what a test says is read beside its result"
)]
#![allow(
    clippy::unwrap_used,
    reason = "a test that unwraps an error fails, as it should"
)]

#[path = "../../crates/lightfall-core/tests/gpu/adapter.rs"]
mod adapter;
mod camera_files;
mod canvas;
mod command_line;
mod comparison;
mod console;
mod cost_report;
mod crash;
mod disk_clock;
mod doctor;
mod edge_view;
#[cfg(target_os = "linux")]
mod equal_adapters;
mod exit_status;
mod failures;
#[cfg(target_os = "linux")]
mod farm_scripts;
#[cfg(target_os = "linux")]
mod file_dialog;
mod file_names;
mod film_files;
mod films;
mod flight_error;
mod flights;
#[cfg(target_os = "linux")]
#[path = "../../crates/lightfall-window-tests/tests/window/font_folder.rs"]
mod font_folder;
mod gamepad;
mod gestures;
#[cfg(target_os = "linux")]
mod glyphs;
mod handout;
mod history;
mod key_labels;
mod keys;
mod kiosk;
mod legends;
mod lesson_player;
mod lesson_results;
mod lessons;
#[path = "../../crates/lightfall-core/tests/gpu/light.rs"]
mod light;
mod menu;
mod missions;
mod never_lost;
mod panel;
mod pilot_places;
#[cfg(target_os = "linux")]
mod portal;
mod program;
mod projections;
#[path = "../../crates/lightfall-core/tests/physics/random.rs"]
mod random;
mod rays;
mod release;
mod resolution;
mod settings;
mod ship;
mod steering;
mod unused;
mod unwritable;
mod words;
mod worker;
