//! The page about the machine: how fast it is, what the passes cost, which adapter draws and what
//! it compiled.

use crate::app::session::adapter::AdapterChoice;
use crate::app::session::frame_pacing::FramePacing;
use crate::render::{Chain, cost_report};
use bevy::diagnostic::DiagnosticsStore;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy::render::diagnostic::RenderDiagnosticsPlugin;
use bevy::render::renderer::RenderAdapterInfo;
use bevy_egui::egui;
use lightfall_core::gpu;
use lightfall_core::gpu::{AdapterName, Listed, Variant};
use lightfall_core::scene::Scene;
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// A pass that has not run for this long is not one that runs.
const STALE: Duration = Duration::from_secs(2);
/// Longest time that counts as one frame, in seconds.
const MAX_LENGTH: f64 = 2.0;
/// Weight of the newest frame in the mean.
const FRESH: f64 = 0.1;

/// Width of the names in what a scene needs.
const NAME_WIDTH: usize = 16;

/// What the page remembers.
#[derive(Default)]
pub(super) struct State {
    /// What the scene needs, line by line, and of which variant and chain that is said.
    lines: Vec<(String, String)>,
    of: Option<(Variant, Chain)>,
    /// The adapters that there are; looked for when the page is first opened, in a thread of its
    /// own.
    adapters: Option<Arc<OnceLock<Vec<Listed>>>>,
}

/// Mean time of a frame, in seconds.
#[derive(Resource, Default)]
pub struct FrameTime(pub f64);

/// What the page reads.
#[derive(SystemParam)]
pub struct Machine<'w> {
    passes: Res<'w, DiagnosticsStore>,
    adapter: Option<Res<'w, RenderAdapterInfo>>,
    frame: Res<'w, FrameTime>,
    pace: Res<'w, FramePacing>,
    choice: Res<'w, AdapterChoice>,
}

pub(super) fn plugin(app: &mut App) {
    app.add_plugins(RenderDiagnosticsPlugin)
        .init_resource::<FrameTime>()
        .add_systems(First, measure);
}

fn measure(time: Res<Time<Real>>, mut frame: ResMut<FrameTime>) {
    // A machine that slept did not draw meanwhile.
    let seconds = time.delta_secs_f64().min(MAX_LENGTH);
    frame.0 = if frame.0 == 0.0 {
        seconds
    } else {
        frame.0 + FRESH * (seconds - frame.0)
    };
}

impl Machine<'_> {
    /// Each pass that ran lately, with its smoothed GPU time in milliseconds.
    fn passes(&self) -> Vec<(&str, f64)> {
        let now = Instant::now();
        let pass = |diagnostic: &'_ bevy::diagnostic::Diagnostic| {
            let fresh = diagnostic
                .measurement()
                .is_some_and(|last| now.duration_since(last.time) < STALE);
            diagnostic.smoothed().filter(|_| fresh)
        };
        let mut passes: Vec<_> = self
            .passes
            .iter()
            .filter_map(|diagnostic| {
                let name = diagnostic
                    .path()
                    .as_str()
                    .strip_prefix("render/")?
                    .strip_suffix("/elapsed_gpu")?;
                Some((name, pass(diagnostic)?))
            })
            .collect();
        passes.sort_by(|a, b| b.1.total_cmp(&a.1));
        passes
    }
}

pub(super) fn show(
    ui: &mut egui::Ui,
    state: &mut State,
    machine: &Machine,
    chosen: &mut Option<AdapterName>,
    drawn: &Scene,
    meant: &Scene,
) {
    ui.strong("Speed");
    let milliseconds = 1e3 * machine.frame.0;
    let resting = if machine.pace.resting {
        ", for nothing moves"
    } else {
        ""
    };
    ui.label(format!(
        "{:.1} frames a second, {milliseconds:.1} ms each{resting}",
        1e3 / milliseconds.max(1e-3)
    ));
    let (scene, drawn, meant) = (drawn, drawn.picture, meant.picture);
    let coarser = if drawn == meant {
        String::new()
    } else {
        format!(" in place of {} x {}", meant.width, meant.height)
    };
    ui.label(format!(
        "drawn with {} x {} pixels{coarser}",
        drawn.width, drawn.height
    ));
    ui.add_space(8.0);
    ui.strong("GPU time of the passes");
    let passes = machine.passes();
    egui::Grid::new("passes")
        .num_columns(2)
        .spacing([16.0, 3.0])
        .striped(true)
        .show(ui, |ui| {
            for (name, time) in &passes {
                ui.label(*name);
                ui.monospace(format!("{time:8.3} ms"));
                ui.end_row();
            }
        });
    if passes.is_empty() {
        ui.weak("No pass ran lately, or the adapter does not measure time.");
    }
    ui.add_space(8.0);
    ui.strong("Graphics adapter");
    if let Some(info) = &machine.adapter {
        ui.label(format!(
            "{} ({} through {})",
            info.name,
            gpu::kind(info.device_type),
            info.backend
        ));
        ui.label(format!("{} {}", info.driver, info.driver_info));
    }
    adapters(ui, state, machine, chosen);
    ui.add_space(8.0);
    ui.strong("What this scene needs");
    for (what, how) in state.lines(scene) {
        ui.horizontal_top(|ui| {
            let left = egui::Layout::left_to_right(egui::Align::Min);
            ui.allocate_ui_with_layout(egui::vec2(104.0, 18.0), left, |ui| {
                ui.set_min_width(104.0);
                ui.weak(what);
            });
            ui.add(egui::Label::new(how).wrap());
        });
    }
}

/// Which adapter the next start is to use.
fn adapters(
    ui: &mut egui::Ui,
    state: &mut State,
    machine: &Machine,
    chosen: &mut Option<AdapterName>,
) {
    let list = state.adapters.get_or_insert_with(|| {
        let list = Arc::new(OnceLock::new());
        let found = Arc::clone(&list);
        std::thread::spawn(move || found.set(gpu::adapters()));
        list
    });
    let present = machine.adapter.as_deref().map(|info| AdapterName::of(info));
    ui.weak("From the next start on:");
    ui.radio_value(chosen, None, "the best that there is");
    let listed = list.get().map_or(&[][..], Vec::as_slice);
    for Listed {
        name, kind, driver, ..
    } in listed
    {
        let mark = if present.as_ref() == Some(name) {
            ", in use now"
        } else {
            ""
        };
        ui.radio_value(chosen, Some(name.clone()), format!("{name}{mark}"))
            .on_hover_text(format!("{kind}, {driver}"));
    }
    if let Some(gone) = chosen
        .clone()
        .filter(|gone| list.get().is_some() && listed.iter().all(|it| it.name != *gone))
    {
        ui.radio_value(chosen, Some(gone.clone()), format!("{gone}, not there"));
    }
    if let Some(variable) = gpu::named_by_environment() {
        ui.weak(format!(
            "This start was told by the command line or {variable}."
        ));
    } else if *chosen != machine.choice.used {
        ui.weak("Kept in the settings; it holds from the next start.");
    }
}

impl State {
    /// The lines of `lightfall presets show NAME --needs`, made again when they have changed.
    fn lines(&mut self, scene: &Scene) -> &[(String, String)] {
        let of = (Variant::picture(scene), Chain::of(scene));
        if self.of != Some(of) {
            let line = |line: &str| {
                let (what, how) = line.split_at_checked(NAME_WIDTH).unwrap_or((line, ""));
                (what.trim().to_owned(), how.trim().to_owned())
            };
            // The first line names the scene.
            (self.lines, self.of) = (
                cost_report(scene).lines().skip(1).map(line).collect(),
                Some(of),
            );
        }
        &self.lines
    }
}
