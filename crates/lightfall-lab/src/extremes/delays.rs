//! The errors of delays in the hardest places, as angles by which the disk's matter turns.

use super::cells::Cell;
use super::kernels::Kernels;
use super::matrix::work_of;
use crate::bench::able_methods;
use crate::import::or_nan;
use crate::table::grouped_table;
use lightfall_accuracy::{DelayError, TimedRay, greater};
use lightfall_gpu::{Gpu, GpuError};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::numbers::short_number;
use lightfall_model::scene::promises::MATTER_TURN;
use lightfall_model::scene::{Method, Scene};
use lightfall_optics::reference::Reference;
use lightfall_optics::trace::Trace;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// The delays of a method in a cell, compared with the reference's.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct CellDelays {
    /// What is extreme.
    pub group: String,
    /// How extreme.
    pub cell: String,
    /// The method, at its default setting.
    pub method: String,
    /// Number of hits that are compared.
    pub hits: usize,
    /// Largest difference between the method's delay and the reference's, in r_s/c.
    #[serde(deserialize_with = "or_nan")]
    pub delay_max: f64,
    /// Largest angle, in radians, by which the matter at the hit turns in the difference.
    #[serde(deserialize_with = "or_nan")]
    pub turn_max: f64,
    /// The same for the difference from the delay of the place that the method has found, of hits
    /// whose place is the reference's to 0.003 of the radius.
    #[serde(deserialize_with = "or_nan")]
    pub turn_at_place_max: f64,
    /// Number of hits where the matter turns by more than a thousandth of a radian in the
    /// difference. Each is counted once more in one of the next three classes.
    pub over: usize,
    /// Those whose delay is right for the method's place, to the same thousandth and to f32's
    /// rounding of this place.
    pub place: usize,
    /// Those whose place is so far away that its delay is not known as precisely.
    pub far: usize,
    /// The rest: their delay is wrong for the place.
    pub unexplained: usize,
    /// Number of rays with another outcome or number of hits than the reference, whose hits are not
    /// compared.
    pub lost: usize,
}

/// Measures the delays of the methods that have them, in every cell. `done` is called with each row
/// and its share of the [`delays_work`].
///
/// # Errors
/// A cell cannot be traced, or the device failed.
pub fn measure_delays(
    gpu: &Gpu,
    cells: &[Cell],
    methods: &[Method],
    mut done: impl FnMut(&CellDelays, f64),
) -> Result<Vec<CellDelays>, GpuError> {
    let mut kernels = Kernels::default();
    let mut rows = Vec::new();
    for cell in cells {
        let (reference, axes) = (
            Reference::new(&cell.scene)?,
            cell.scene.camera.tetrad_from_camera(),
        );
        let rays = cell.rays.par_iter();
        let truth: Vec<TimedRay> = rays
            .map(|ray| TimedRay::of(&reference, axes * ray.direction()))
            .collect();
        for scene in variations(&cell.scene, methods) {
            let found = kernels.traces(gpu, &scene, &cell.rays)?;
            let row = CellDelays::new(cell, scene.method, &truth, &found);
            done(&row, work_of(cell, &scene));
            rows.push(row);
        }
    }
    Ok(rows)
}

/// The work of measuring the delays of these methods in these cells, in any unit.
pub fn delays_work(cells: &[Cell], methods: &[Method]) -> f64 {
    let work = |cell: &Cell| -> f64 {
        variations(&cell.scene, methods)
            .map(|scene| work_of(cell, &scene))
            .sum()
    };
    cells.iter().map(work).sum()
}

/// The scene with each of the methods that can trace it and that are held to their delays.
fn variations(scene: &Scene, methods: &[Method]) -> impl Iterator<Item = Scene> {
    able_methods(scene, methods)
        .filter(|method| method.properties().answers_every_ray)
        .map(|method| scene.with_method(method))
}

impl CellDelays {
    fn new(cell: &Cell, method: Method, truth: &[TimedRay], found: &[Trace]) -> Self {
        let mut row = Self {
            group: cell.group.into(),
            cell: cell.name.clone(),
            method: method.word().into(),
            ..Self::default()
        };
        let kerr = cell.scene.kerr();
        for (truth, found) in truth.iter().zip(found) {
            match truth.errors(found) {
                Some(errors) => errors.iter().for_each(|error| row.add(kerr, error)),
                None => row.lost += 1,
            }
        }
        row
    }

    fn add(&mut self, kerr: Kerr, error: &DelayError) {
        let orbit = kerr.circular_orbit(error.truth.r);
        let rate = orbit.map_or(f64::NAN, |orbit| orbit.angular_velocity.abs());
        let turn = rate * error.plain.abs();
        let at_place = rate * error.at_place.abs();
        self.hits += 1;
        self.delay_max = greater(self.delay_max, error.plain.abs());
        self.turn_max = greater(self.turn_max, turn);
        if error.same_place() {
            self.turn_at_place_max = greater(self.turn_at_place_max, at_place);
        }
        // NaN is not small.
        if turn <= MATTER_TURN {
            return;
        }
        self.over += 1;
        if at_place <= MATTER_TURN + rate * error.light_time_of_rounding(kerr) {
            self.place += 1;
        } else if !error.same_place() && error.plain.is_finite() {
            self.far += 1;
        } else {
            self.unexplained += 1;
        }
    }
}

/// The rows as a Markdown table, for people, with what its classes mean.
pub fn delays_table(rows: &[CellDelays]) -> String {
    let cells = |row: &CellDelays| {
        let errors = [row.delay_max, row.turn_max, row.turn_at_place_max].map(short_number);
        format!(
            "{} | {} | {} | {} | {} | {} | {} | {} | {}",
            row.cell,
            row.method,
            row.hits,
            errors.join(" | "),
            row.over,
            row.place,
            row.far,
            row.unexplained,
            row.lost,
        )
    };
    grouped_table(
        "cell | method | hits | delay max, r_s/c | turn max, rad | at the place found | over | place | \
         far | unexplained | lost",
        rows.iter().map(|row| (&*row.group, cells(row))),
    ) + NOTES
}

/// What the columns of the table mean.
const NOTES: &str = "
* hits: those of rays with the reference's outcome and number of hits; only these are compared.
* turn: the angle by which the disk's matter at the hit turns in the error of the delay.
* at the place found: the same after subtracting what the hit's own shift does to the delay, of hits
  that are shifted by no more than 0.003 of their radius.
* over: hits with a turn of more than 1e-3 rad. Each of them is in one of the next three classes.
* place: the delay is right for the place that the method has found, to 1e-3 rad and to the time that
  light takes across the radius's last digits, and up to whole turns about the hole if that place is
  far. The ray's own error has moved the hit.
* far: the hit is more than 0.003 of its radius from the reference's, and the reference's ray does
  not tell the delay there to 1e-3 rad.
* unexplained: the delay is wrong for the place.
* lost: rays with another outcome or number of hits, which are not compared.
";
