//! The page about the machine: its speed, the graphics adapter, the time of each pass, and what the
//! scene compiles.

use crate::app::session::adapter::AdapterChoice;
use crate::app::session::frame_pacing::FramePacing;
use crate::app::state::scene_editor::SceneEditor;
use bevy::diagnostic::{Diagnostic, DiagnosticsStore, FrameTimeDiagnosticsPlugin};
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy::render::diagnostic::RenderDiagnosticsPlugin;
use bevy::render::renderer::RenderAdapterInfo;
use bevy_egui::egui;
use lightfall_core::gpu;
use lightfall_core::gpu::{AdapterName, Listed, Variant};
use lightfall_core::scene::{Disk, Method, Picture, Scene, View};
use lightfall_platform::IN_BROWSER;
use lightfall_platform::worker::Follower;
use lightfall_render::{Chain, DetailLimits, cost_rows};
use std::time::Duration;
use web_time::Instant;

/// A pass that has not run for this long is not listed.
const STALE: Duration = Duration::from_secs(2);
/// Maximum duration of a frame that counts, in milliseconds. A longer one means that the machine slept.
const MAX_FRAME_MS: f64 = 2000.0;
/// Number of frames in the mean.
const FRAMES: usize = 20;
/// Width of the topics of the cost report, in points.
const TOPIC_WIDTH: f32 = 104.0;

/// What the page remembers.
#[derive(Default)]
pub(super) struct MachinePage {
    /// The rows of the scene's cost report, after what they depend on.
    costs: Option<(CostKey, Vec<(&'static str, String)>)>,
    /// The adapters of this machine. A thread looks for them when the page is first opened.
    adapters: Option<Follower<(), Vec<Listed>>>,
}

/// What a scene's cost report depends on.
type CostKey = (Method, View, Disk, Variant, Chain, DetailLimits);

/// What the page reads.
#[derive(SystemParam)]
pub(super) struct Machine<'w> {
    diagnostics: Res<'w, DiagnosticsStore>,
    adapter: Option<Res<'w, RenderAdapterInfo>>,
    pacing: Res<'w, FramePacing>,
    choice: Res<'w, AdapterChoice>,
    waves: Res<'w, DetailLimits>,
}

pub(super) fn plugin(app: &mut App) {
    app.add_plugins((
        RenderDiagnosticsPlugin,
        FrameTimeDiagnosticsPlugin::new(FRAMES),
    ));
}

impl Machine<'_> {
    /// Mean time of the last frames, in milliseconds.
    fn frame_time(&self) -> f64 {
        let frames = self
            .diagnostics
            .get(&FrameTimeDiagnosticsPlugin::FRAME_TIME);
        let times: Vec<f64> = frames
            .into_iter()
            .flat_map(Diagnostic::values)
            .copied()
            .collect();
        let sum: f64 = times.iter().map(|time| time.min(MAX_FRAME_MS)).sum();
        sum / times.len().max(1) as f64
    }

    /// Each pass that ran lately, with its smoothed GPU time in milliseconds.
    fn passes(&self) -> Vec<(&str, f64)> {
        let now = Instant::now();
        let mut passes: Vec<_> = self
            .diagnostics
            .iter()
            .filter_map(|diagnostic| {
                let path = diagnostic.path().as_str();
                let name = path.strip_prefix("render/")?.strip_suffix("/elapsed_gpu")?;
                let fresh = now.duration_since(diagnostic.measurement()?.time) < STALE;
                Some((name, diagnostic.smoothed().filter(|_| fresh)?))
            })
            .collect();
        passes.sort_by(|a, b| b.1.total_cmp(&a.1));
        passes
    }
}

impl MachinePage {
    pub(super) fn show(
        &mut self,
        ui: &mut egui::Ui,
        machine: &Machine,
        chosen: &mut Option<AdapterName>,
        editor: &SceneEditor,
    ) {
        let drawn = editor.drawn_scene();
        speed(ui, machine, &drawn.picture, &editor.picture_at_rest());
        ui.add_space(8.0);
        ui.strong("Graphics adapter");
        if let Some(info) = &machine.adapter {
            ui.label(format!(
                "{} ({} through {})",
                info.name,
                gpu::kind(info.device_type),
                info.backend
            ));
            ui.label(gpu::driver(info));
        }
        self.choose_adapter(ui, machine, chosen);
        ui.add_space(8.0);
        egui::CollapsingHeader::new("GPU time of each pass")
            .show_unindented(ui, |ui| passes(ui, machine));
        let costs = egui::CollapsingHeader::new("What this scene compiles and allocates");
        costs.show_unindented(ui, |ui| {
            for (topic, items) in self.costs(&drawn, *machine.waves) {
                ui.horizontal_top(|ui| {
                    ui.allocate_ui(egui::vec2(TOPIC_WIDTH, 18.0), |ui| {
                        ui.set_min_width(TOPIC_WIDTH);
                        ui.weak(*topic);
                    });
                    ui.add(egui::Label::new(items).wrap());
                });
            }
        });
    }

    /// The rows of a scene's cost report. They are made again only when something that they depend
    /// on has changed.
    fn costs(&mut self, scene: &Scene, limits: DetailLimits) -> &[(&'static str, String)] {
        let disk = scene.without_clock().disk;
        let (variant, chain) = (Variant::picture(scene), Chain::of(scene));
        let wanted = (scene.method, scene.view, disk, variant, chain, limits);
        self.costs.take_if(|(made_for, _)| *made_for != wanted);
        let costs = self
            .costs
            .get_or_insert_with(|| (wanted, cost_rows(scene, limits)));
        &costs.1
    }

    /// Chooses the adapter for the next start.
    fn choose_adapter(
        &mut self,
        ui: &mut egui::Ui,
        machine: &Machine,
        chosen: &mut Option<AdapterName>,
    ) {
        let adapters = self.adapters.get_or_insert_with(|| {
            // A page gets the adapter that the browser chooses.
            let list = || {
                if IN_BROWSER {
                    Vec::new()
                } else {
                    adapters_by_name()
                }
            };
            Follower::new(move |()| list())
        });
        adapters.follow(());
        let found = adapters.answer();
        let present = machine.adapter.as_deref().map(|info| AdapterName::of(info));
        ui.weak("From the next start on:");
        ui.radio_value(chosen, None, "the best one");
        let listed = found.map_or(&[][..], Vec::as_slice);
        for adapter in listed {
            let name = &adapter.name;
            let in_use = present.as_ref() == Some(name);
            let mark = if in_use { ", in use now" } else { "" };
            ui.radio_value(chosen, Some(name.clone()), format!("{name}{mark}"))
                .on_hover_text(format!("{}, {}", adapter.kind, adapter.driver));
        }
        let is_missing =
            |name: &AdapterName| found.is_some() && listed.iter().all(|it| it.name != *name);
        if let Some(missing) = chosen.clone().filter(is_missing) {
            let text = format!("{missing}, missing");
            ui.radio_value(chosen, Some(missing), text);
        }
        if let Some(variable) = gpu::named_by_environment() {
            ui.weak(format!(
                "The command line or {variable} chose the adapter of this start."
            ));
        } else if *chosen != machine.choice.used {
            ui.weak("Kept in the settings. It takes effect at the next start.");
        }
    }
}

/// The adapters of this machine, each name once: the settings tell them apart by their names.
fn adapters_by_name() -> Vec<Listed> {
    let mut listed: Vec<Listed> = Vec::new();
    for adapter in gpu::adapters() {
        if listed.iter().all(|other| other.name != adapter.name) {
            listed.push(adapter);
        }
    }
    listed
}

fn speed(ui: &mut egui::Ui, machine: &Machine, drawn: &Picture, at_rest: &Picture) {
    ui.strong("Speed");
    let milliseconds = machine.frame_time();
    let rate = format!("{:.0} frames per second", 1e3 / milliseconds.max(1e-3));
    ui.label(egui::RichText::new(rate).size(20.0));
    let mut frame = format!("{milliseconds:.1} ms per frame");
    if machine.pacing.resting {
        frame += ": fewer, because nothing moves";
    }
    ui.label(frame);
    let mut pixels = format!("{} x {} pixels drawn", drawn.width, drawn.height);
    if drawn.size() != at_rest.size() {
        pixels += &format!(", {} x {} at rest", at_rest.width, at_rest.height);
    }
    if !at_rest.bypass {
        pixels += &format!(
            ", in {} x {} cells",
            at_rest.grid_width, at_rest.grid_height
        );
    }
    ui.label(pixels);
}

fn passes(ui: &mut egui::Ui, machine: &Machine) {
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
}
