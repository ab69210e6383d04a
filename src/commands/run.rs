//! Reads the command line, runs the command, and reports the result as the exit status.

use super::adapters::list_adapters;
use super::bench::bench;
use super::camera::camera;
use super::captions::captions;
use super::cli::{self, Command, GpuArgs};
use super::console;
use super::doctor::doctor;
use super::extremes::extremes;
use super::fly::fly;
use super::lut::lut;
use super::presets::presets;
use super::render::render;
use super::stop::Stop;
use super::trace::trace;
use super::video::video;
use crate::app;
use bevy::app::App;
use lightfall_platform::storage;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

/// Runs the program.
pub fn run() -> ExitCode {
    run_with(|_| ())
}

/// Runs the program, with an addition to that of the window: tests watch it by one.
pub fn run_with(addition: impl FnOnce(&mut App)) -> ExitCode {
    silence_driver();
    storage::report_panics(console::report);
    let command = match cli::read_all(std::env::args_os()) {
        Ok((gpu, command)) => {
            choose_adapter(&gpu);
            if matches!(command, Command::Fly(_)) {
                forget_dead_wayland();
            }
            command
        }
        Err(error) => {
            // clap knows whether this is an error or help, and which stream it goes to. If that
            // stream is closed, nobody reads it.
            error.print().ok();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    // The report of a panic is its sentence. A panic that reaches this far leaves nothing half done.
    let done = catch_unwind(AssertUnwindSafe(|| execute(command, addition)));
    match done {
        Ok(Ok(())) => ExitCode::SUCCESS,
        Ok(Err(stop)) => {
            console::report(&stop.to_string());
            ExitCode::from(stop.status)
        }
        Err(_) => ExitCode::FAILURE,
    }
}

/// Does what the command line asks for.
fn execute(command: Command, addition: impl FnOnce(&mut App)) -> Result<(), Stop> {
    match command {
        Command::Fly(args) => fly(&args, addition),
        Command::ListGpus => list_adapters(),
        Command::Render(args) => render(&args),
        Command::Camera(args) => camera(&args),
        Command::Captions(args) => captions(&args),
        Command::Trace(args) => trace(&args),
        Command::Bench(args) => bench(&args),
        Command::Extremes(args) => extremes(&args),
        Command::Video(args) => video(&args),
        Command::Lut(args) => lut(&args),
        Command::Doctor(args) => doctor(&args),
        Command::Presets(command) => presets(&command, &mut io::stdout().lock()),
    }
}

/// Switches off Mesa's device selection layer where there is no desktop session: without Wayland it
/// prints a harmless error.
fn silence_driver() {
    if cfg!(target_os = "linux") && std::env::var_os("XDG_RUNTIME_DIR").is_none() {
        set_variable("NODEVICE_SELECT", "1");
    }
}

/// Copies the adapter options of the command line to the environment, where Bevy and wgpu look for
/// them.
fn choose_adapter(gpu: &GpuArgs) {
    for (name, value) in [
        ("WGPU_ADAPTER_NAME", &gpu.gpu),
        ("WGPU_BACKEND", &gpu.backend),
    ] {
        if let Some(value) = value {
            set_variable(name, value);
        }
    }
}

#[expect(
    unsafe_code,
    reason = "the environment is the only way to reach the driver and Bevy's choice of the adapter, and changing it is unsafe"
)]
fn set_variable(name: &str, value: &str) {
    // SAFETY: nothing has been started yet, so this is the only thread.
    unsafe { std::env::set_var(name, value) };
}

/// Forgets a Wayland server that does not answer where an X server does: the window system asks
/// Wayland first, and would not open a window at all.
#[expect(
    unsafe_code,
    reason = "the environment is where the window system finds its server, and changing it is unsafe"
)]
fn forget_dead_wayland() {
    if app::prefers_dead_wayland() {
        // SAFETY: the command has not started yet, so this is the only thread.
        unsafe { std::env::remove_var("WAYLAND_DISPLAY") };
    }
}
