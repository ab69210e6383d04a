//! The command line: does what was asked for, and says how it went.

use crate::app;
use crate::commands::cli;
use crate::commands::cli::{Command, Device, FlyArgs, GpuArgs, SceneArgs, TraceArgs};
use crate::picture;
use glam::UVec2;
use lightfall_core::gpu;
use lightfall_core::gpu::{Drawable, Gpu, GpuScene};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::Trace;
use lightfall_core::reports::rays;
use lightfall_core::reports::rays::{RayReader, TraceWriter};
use lightfall_core::scene::Scene;
use rayon::prelude::*;
use std::error::Error;
use std::io::{self, BufReader, BufWriter, Read};
use std::path::PathBuf;
use std::process::ExitCode;

/// What stopped the program: its exit status and one sentence.
pub(crate) struct Stop(pub(super) u8, pub(super) String);

/// A bad command line or preset.
pub(super) fn refused(error: impl Error) -> Stop {
    Stop(2, error.to_string())
}

/// No device to work with: a bad command line if there is none of that name or interface.
pub(super) fn without_device(error: gpu::GpuError) -> Stop {
    match error {
        gpu::GpuError::UnknownAdapter { .. } | gpu::GpuError::UnknownBackend { .. } => {
            refused(error)
        }
        _ => failed(error),
    }
}

/// Any other failure.
pub(super) fn failed(error: impl Error) -> Stop {
    Stop(1, error.to_string())
}

/// Reads the command line, does what it asks for, and says how it went.
pub fn run() -> ExitCode {
    quieten_driver();
    let command = match cli::read_all(std::env::args_os()) {
        Ok((gpu, command)) => {
            choose_adapter(&gpu);
            command
        }
        Err(error) => {
            // Help and the version are results, everything else is not; clap knows which. A closed
            // stream is no news.
            let _ = error.print();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    let done = match command {
        Command::Fly(args) => fly(&args),
        Command::ListGpus => list_adapters(),
        Command::Render(args) => super::render::render(&args),
        Command::Trace(args) => trace(&args),
        Command::Bench(args) => super::bench::bench(&args),
        Command::Extremes(args) => super::extremes::extremes(&args),
        Command::Doctor(args) => super::doctor::doctor(&args),
        Command::Presets(command) => cli::presets(&command, &mut io::stdout().lock())
            .map_err(|error| Stop(error.exit_code(), error.to_string())),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(Stop(status, sentence)) => {
            eprintln!("lightfall: {sentence}");
            ExitCode::from(status)
        }
    }
}

/// Without a desktop session Mesa's chooser between graphics cards complains about Wayland, and
/// calls it an error.
#[expect(
    unsafe_code,
    reason = "the environment is the only way to reach the driver, and changing it is unsafe"
)]
fn quieten_driver() {
    if cfg!(target_os = "linux") && std::env::var_os("XDG_RUNTIME_DIR").is_none() {
        // SAFETY: nothing has been started yet, so this is the only thread.
        unsafe { std::env::set_var("NODEVICE_SELECT", "1") };
    }
}

/// What the command line says of the adapter, where Bevy and wgpu look for it.
#[expect(
    unsafe_code,
    reason = "the environment is where Bevy takes the adapter from, and changing it is unsafe"
)]
fn choose_adapter(gpu: &GpuArgs) {
    for (name, value) in [
        ("WGPU_ADAPTER_NAME", &gpu.gpu),
        ("WGPU_BACKEND", &gpu.backend),
    ] {
        if let Some(value) = value {
            // SAFETY: nothing has been started yet, so this is the only thread.
            unsafe { std::env::set_var(name, value) };
        }
    }
}

fn list_adapters() -> Result<(), Stop> {
    // Also where a name is given that none of them has.
    gpu::check_adapter().map_err(without_device)?;
    let lines: String = gpu::adapters()
        .iter()
        .map(|adapter| format!("{adapter}\n"))
        .collect();
    super::print(&lines)
}

pub(super) fn scene(args: &SceneArgs) -> Result<Scene, Stop> {
    cli::scene(args).map_err(|error| Stop(error.exit_code(), error.to_string()))
}

/// Checks that the scene can be drawn, and that there is an adapter to draw it with.
pub(super) fn drawable(scene: &Scene) -> Result<Drawable, Stop> {
    let drawable = Drawable::new(scene.clone()).map_err(refused)?;
    gpu::check_adapter().map_err(without_device)?;
    Ok(drawable)
}

fn fly(args: &FlyArgs) -> Result<(), Stop> {
    let mut scene = scene(&args.scene)?;
    let drawable = drawable(&scene)?;
    let of_file = args.journey.as_deref();
    let journey = cli::journey(of_file, &scene)
        .map_err(|error| Stop(error.exit_code(), error.to_string()))?;
    if let Err(reason) = app::display() {
        let (name, what) = match of_file {
            None => (scene.name.clone(), "the scene".to_owned()),
            Some(file) => {
                journey.apply(0.0, &mut scene);
                let name = file
                    .file_stem()
                    .unwrap_or_default()
                    .to_string_lossy()
                    .into_owned();
                (name, format!("the first moment of {}", file.display()))
            }
        };
        eprintln!("lightfall: no display ({reason}); rendering {what} to a picture instead");
        let file = unused_name(&name);
        let still = picture::render(
            &scene,
            UVec2::new(scene.picture.width, scene.picture.height),
        )
        .map_err(failed)?;
        return super::render::write_still(&file, &still, &scene);
    }
    match app::fly(drawable, journey, args.journey.is_some()) {
        bevy::app::AppExit::Success => Ok(()),
        bevy::app::AppExit::Error(_) => {
            Err(Stop(1, "the window ended with an error, see above".into()))
        }
    }
}

/// A name in the current folder that no file has: a picture nobody asked for by name replaces
/// nothing.
fn unused_name(scene: &str) -> PathBuf {
    let safe: String = scene
        .chars()
        .map(|c| {
            if c.is_alphanumeric() || c == '-' {
                c
            } else {
                '_'
            }
        })
        .collect();
    let numbered = (2..).map(|number| format!("lightfall-{safe}-{number}.png"));
    let names = std::iter::once(format!("lightfall-{safe}.png"))
        .chain(numbered)
        .map(PathBuf::from);
    names
        .into_iter()
        .find(|name| !name.exists())
        .unwrap_or_else(|| "lightfall.png".into())
}

fn trace(args: &TraceArgs) -> Result<(), Stop> {
    let scene = scene(&args.scene)?;
    let (input, name): (Box<dyn Read>, String) = if args.rays.as_os_str() == "-" {
        (Box::new(io::stdin()), "standard input".into())
    } else {
        let name = args.rays.display().to_string();
        let file = std::fs::File::open(&args.rays)
            .map_err(|error| Stop(2, format!("{name}: cannot be read: {error}")))?;
        (Box::new(file), name)
    };
    let directions = RayReader::new(BufReader::new(input), &name)
        .collect::<Result<Vec<_>, _>>()
        .map_err(refused)?;
    if directions.is_empty() {
        // More likely a command before this one that failed than a wish for nothing.
        return Err(Stop(
            2,
            format!("{name}: there are no rays; a ray is a line er,etheta,ephi, such as 0,-0.1,1"),
        ));
    }
    let traces: Vec<Trace> = match args.device {
        Device::Cpu => {
            let reference = Reference::new(&scene).map_err(refused)?;
            directions
                .par_iter()
                .map(|&direction| reference.trace(direction))
                .collect()
        }
        Device::Gpu => {
            GpuScene::for_rays(&scene).map_err(refused)?;
            let gpu = Gpu::headless().map_err(without_device)?;
            gpu::rays::trace(&gpu, &scene, &directions).map_err(failed)?
        }
    };
    match write_traces(&traces) {
        // Whoever reads has read enough.
        Err(error) if rays::is_closed_pipe(&error) => Ok(()),
        written => written.map_err(|error| Stop(1, format!("standard output: {error}"))),
    }
}

fn write_traces(traces: &[Trace]) -> io::Result<()> {
    let mut writer = TraceWriter::new(BufWriter::new(io::stdout().lock()))?;
    traces.iter().try_for_each(|trace| writer.write(trace))?;
    writer.finish()
}
