//! The error of the time between emission and arrival against the run time of tracing with it.

use super::plan::Plan;
use super::scenes::BenchScene;
use super::settings::able_methods;
use crate::import::or_nan;
use crate::table::table;
use glam::Vec3;
use lightfall_accuracy::{Quantiles, Ray, hits, rays_over_picture};
use lightfall_gpu::rays::RayKernel;
use lightfall_gpu::timing::Stopwatch;
use lightfall_gpu::{Gpu, GpuError, Variant};
use lightfall_model::scene::Scene;
use lightfall_optics::reference::Reference;
use lightfall_optics::trace::{Hit, Trace};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::cell::LazyCell;

/// Numbers of nodes that are measured, 0 for tracing without delays: per leg of a ray of the method
/// closed, per step of the method mino.
const NODES: [u32; 5] = [0, 2, 3, 4, 8];

/// The delays of one method with one number of nodes in one scene, in r_s/c. They are compared
/// where the number of hits is right.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct DelayMeasurement {
    /// Name of the scene.
    pub scene: String,
    /// Name of the method.
    pub method: String,
    /// Number of nodes; 0 for tracing without delays.
    pub nodes: u32,
    /// Whether pictures use this number.
    pub own: bool,
    /// Median time of tracing the picture's rays, in milliseconds.
    pub trace_ms: f64,
    /// Difference between the 90th and the 10th percentile of that time, in milliseconds.
    pub trace_spread_ms: f64,
    /// The clock that the times were read from.
    pub clock: String,
    /// Number of hits.
    pub hits: usize,
    /// Error of their delays: its median.
    #[serde(deserialize_with = "or_nan")]
    pub delay_p50: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub delay_p99: f64,
    /// Its maximum.
    #[serde(deserialize_with = "or_nan")]
    pub delay_max: f64,
    /// Error in radians of the angle by which the matter turns during the delay: its 99th
    /// percentile.
    #[serde(deserialize_with = "or_nan")]
    pub turn_p99: f64,
    /// Its maximum.
    #[serde(deserialize_with = "or_nan")]
    pub turn_max: f64,
}

impl DelayMeasurement {
    /// The time relative to that of tracing without delays, which is another of these rows. NaN if
    /// none of them has it.
    pub fn time_over_none(&self, rows: &[Self]) -> f64 {
        let is_none = |none: &&Self| {
            none.nodes == 0 && (&none.scene, &none.method) == (&self.scene, &self.method)
        };
        let none = rows.iter().find(is_none);
        none.map_or(f64::NAN, |none| self.trace_ms / none.trace_ms)
    }

    /// The errors of the delays (median, 99th percentile, maximum) in r_s/c, and of the turn of the
    /// matter (99th percentile, maximum) in radians.
    pub fn errors(&self) -> [f64; 5] {
        [
            self.delay_p50,
            self.delay_p99,
            self.delay_max,
            self.turn_p99,
            self.turn_max,
        ]
    }
}

impl Plan {
    /// The methods of the plan that have delays, with their numbers of nodes, in a scene.
    fn delay_settings(&self, scene: &Scene) -> Vec<(Scene, u32)> {
        let methods = able_methods(scene, &self.methods)
            .filter(|method| method.properties().answers_every_ray);
        let settings = methods.flat_map(|method| {
            let scene = scene.with_method(method);
            let counts = counts_of_nodes(&scene).into_iter();
            counts.map(move |nodes| (scene.clone(), nodes))
        });
        settings.collect()
    }

    /// Number of rows of [`Plan::run_delays`].
    pub fn delay_rows(&self) -> usize {
        let with_disk = self.scenes.iter().filter(|scene| scene.scene.disk.enabled);
        with_disk
            .map(|scene| self.delay_settings(&scene.scene).len())
            .sum()
    }

    /// Measures the delays of the methods closed and mino, except the known rows of an earlier run.
    /// `done` is called after each new row. Returns all rows.
    ///
    /// # Errors
    /// A scene cannot be traced, the picture is too large for the device, or the device failed.
    pub fn run_delays(
        &self,
        gpu: &Gpu,
        known: &[DelayMeasurement],
        mut done: impl FnMut(&DelayMeasurement),
    ) -> Result<Vec<DelayMeasurement>, GpuError> {
        let mut rows = Vec::new();
        for bench_scene in self.scenes.iter().filter(|scene| scene.scene.disk.enabled) {
            let scene = &bench_scene.scene;
            let rays = rays_over_picture(scene, self.rays);
            let given: Vec<Vec3> = rays.iter().map(Ray::given).collect();
            let (reference, axes) = (Reference::new(scene)?, scene.camera.tetrad_from_camera());
            // Only the first row that is not known computes it.
            let truth: LazyCell<Vec<Trace>, _> = LazyCell::new(|| {
                let traces = rays.par_iter();
                let traces = traces.map(|ray| reference.trace_with_delays(axes * ray.direction()));
                traces.collect()
            });
            for (scene, nodes) in self.delay_settings(scene) {
                let wanted = (bench_scene.name.as_str(), scene.method.word(), nodes);
                let is_it = |row: &&DelayMeasurement| {
                    (row.scene.as_str(), row.method.as_str(), row.nodes) == wanted
                };
                if let Some(row) = known.iter().find(is_it) {
                    rows.push(row.clone());
                    continue;
                }
                let row = self.delays(gpu, bench_scene, (&scene, nodes), &given, &truth)?;
                done(&row);
                rows.push(row);
            }
        }
        Ok(rows)
    }

    fn delays(
        &self,
        gpu: &Gpu,
        bench_scene: &BenchScene,
        (scene, nodes): (&Scene, u32),
        given: &[Vec3],
        truth: &[Trace],
    ) -> Result<DelayMeasurement, GpuError> {
        let recorded = Variant::rays(scene);
        let with_nodes = |variant: Variant| Variant {
            delay_nodes: nodes,
            throat: nodes > 0 && recorded.throat,
            ..variant
        };
        let timed = with_nodes(Variant::timed(scene));
        let stopwatch = Stopwatch::of_variant(gpu, timed, scene, self.size, self.stage)?;
        let timing = stopwatch.time(gpu, self.effort)?;
        let own = recorded.delay_nodes == nodes;
        let mut errors = Vec::new();
        if nodes > 0 {
            let kernel = RayKernel::of_variant(gpu, with_nodes(recorded), scene)?;
            let found = kernel.trace_camera_rays(gpu, scene, given)?;
            errors = truth.iter().zip(&found).flat_map(delay_errors).collect();
        }
        let kerr = scene.kerr();
        let turn = |(r, error): &(f64, f64)| {
            let orbit = kerr.circular_orbit(*r);
            orbit.map_or(f64::NAN, |orbit| orbit.angular_velocity * error)
        };
        let delays = Quantiles::of(errors.iter().map(|(_, error)| *error));
        let turns = Quantiles::of(errors.iter().map(turn));
        Ok(DelayMeasurement {
            scene: bench_scene.name.clone(),
            method: scene.method.word().into(),
            nodes,
            own,
            trace_ms: timing.median_ms,
            trace_spread_ms: timing.spread_ms,
            clock: timing.clock.word().into(),
            hits: errors.len(),
            delay_p50: delays.p50,
            delay_p99: delays.p99,
            delay_max: delays.max,
            turn_p99: turns.p99,
            turn_max: turns.max,
        })
    }
}

/// The numbers of nodes to measure: only its own for a method with a fixed number.
fn counts_of_nodes(scene: &Scene) -> Vec<u32> {
    let own = Variant::rays(scene).delay_nodes;
    if own == 0 || NODES.contains(&own) {
        NODES.to_vec()
    } else {
        vec![0, own]
    }
}

/// The radius of each hit and the error of its delay, for a ray with the right number of hits.
fn delay_errors((expected, found): (&Trace, &Trace)) -> impl Iterator<Item = (f64, f64)> {
    let alike = hits(expected) == hits(found);
    let pairs = expected.hits.into_iter().zip(found.hits);
    pairs
        .filter(move |_| alike)
        .filter_map(|(expected, found): (Option<Hit>, Option<Hit>)| {
            let (expected, found) = (expected?, found?);
            Some((expected.r, (expected.delay? - found.delay?).abs()))
        })
}

/// The rows as a Markdown table, with each time relative to tracing without delays.
pub fn delay_table(rows: &[DelayMeasurement]) -> String {
    let cells = |row: &DelayMeasurement| {
        let errors = row.errors().map(|error| match row.nodes {
            0 => String::new(),
            _ => format!("{error:.1e}"),
        });
        format!(
            "{} | {} | {}{} | {:.4} | {:.3} | {}",
            row.scene,
            row.method,
            row.nodes,
            if row.own { " (own)" } else { "" },
            row.trace_ms,
            row.time_over_none(rows),
            errors.join(" | ")
        )
    };
    table(
        "scene | method | nodes | ms | over none | median error, r_s/c | 99 % | largest | \
         turn of the matter, 99 %, rad | largest",
        rows.iter().map(cells),
    )
}
