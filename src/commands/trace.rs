//! `lightfall trace`: rays in, traces out, both as CSV.

use super::cli::{Device, TraceArgs};
use super::output::output_result;
use super::scene::{device, scene};
use super::stop::Stop;
use super::unused::note_unused;
use glam::DVec3;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::accuracy::rays::{RayReader, TraceWriter};
use lightfall_core::gpu;
use lightfall_core::gpu::GpuScene;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::Trace;
use lightfall_core::scene::Output;
use lightfall_platform::log::say;
use lightfall_platform::storage::{self, TextError};
use rayon::prelude::*;
use std::io::{self, BufWriter, Read};
use std::path::Path;

/// Reads the rays, traces them, and writes the traces to standard output.
pub(super) fn trace(args: &TraceArgs) -> Result<(), Stop> {
    let scene = scene(&args.scene)?;
    let of_method = |key: &str| key == "method" || key.starts_with("quality.");
    note_unused(
        &args.scene,
        &scene,
        Output::Rays,
        |without| without,
        |without| {
            let mut differences = without.differences(&scene).into_iter();
            (args.device == Device::Cpu && differences.all(|(key, _)| of_method(key)))
                .then(|| "on the CPU the reference traces every ray".into())
        },
    );
    if let Some(stars) = &args.scene.stars {
        say(format_args!(
            "lightfall: --stars {} changes nothing: traced rays carry no light",
            stars.display()
        ));
    }
    let directions = read_rays(&args.rays)?;
    let traces: Vec<Trace> = match args.device {
        Device::Cpu => {
            let reference = Reference::new(&scene).map_err(Stop::refused)?;
            directions
                .par_iter()
                .map(|&direction| reference.trace_with_delays(direction))
                .collect()
        }
        Device::Gpu => {
            GpuScene::for_rays(&scene).map_err(Stop::refused)?;
            let gpu = device()?;
            storage::note_scene(&scene);
            gpu::rays::trace(&gpu, &scene, &directions).map_err(Stop::failed)?
        }
    };
    if !args.numbers {
        return output_result(write_traces(&traces));
    }
    let numbers = directions
        .par_iter()
        .map(|&direction| Inspected::new(&scene, direction, None, scene.camera.r))
        .collect::<Result<Vec<_>, _>>()
        .map_err(Stop::refused)?;
    output_result(write_numbers(&traces, &numbers))
}

/// Maximum size of a file of rays, in bytes.
const MAX_BYTES: u64 = 1 << 30;

/// The rays of a file, or of standard input for `-`.
fn read_rays(file: &Path) -> Result<Vec<DVec3>, Stop> {
    let (text, name) = if file.as_os_str() == "-" {
        (read_standard_input(), "standard input".into())
    } else {
        let text = storage::read_text(file, MAX_BYTES);
        (text, file.display().to_string())
    };
    let text = text.map_err(|fault| Stop::refused(format!("{name}: {fault}")))?;
    let directions = RayReader::new(text.as_bytes(), &name)
        .collect::<Result<Vec<_>, _>>()
        .map_err(Stop::refused)?;
    if directions.is_empty() {
        // In a pipe the command before this one has probably failed.
        return Err(Stop::refused(format!(
            "{name}: there are no rays; a ray is a line er,etheta,ephi, such as 0,-0.1,1"
        )));
    }
    Ok(directions)
}

fn read_standard_input() -> Result<String, TextError> {
    let mut bytes = Vec::new();
    io::stdin().take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    storage::text_of(bytes, MAX_BYTES)
}

fn write_numbers(traces: &[Trace], rays: &[Inspected]) -> io::Result<()> {
    let mut writer = TraceWriter::with_numbers(BufWriter::new(io::stdout().lock()))?;
    let mut lines = traces.iter().zip(rays);
    lines.try_for_each(|(trace, ray)| writer.write_with_numbers(trace, &ray.numbers))?;
    writer.finish()
}

fn write_traces(traces: &[Trace]) -> io::Result<()> {
    let mut writer = TraceWriter::new(BufWriter::new(io::stdout().lock()))?;
    traces.iter().try_for_each(|trace| writer.write(trace))?;
    writer.finish()
}
