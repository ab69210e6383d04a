//! The limits of methods: a matrix of the hardest places, in which each method is held to a stated
//! tolerance, and a random search beyond the matrix.

mod cause;
mod cells;
mod delays;
mod far_ray;
mod grid;
mod hunt;
mod kernels;
mod matrix;
mod matter;
mod matter_cells;
mod narrow_ring;
mod random_scene;
mod verdict;
mod worst_ray;

pub use cause::Cause;
pub use cells::{Cell, cells};
pub use delays::{CellDelays, delays_table, delays_work, measure_delays};
pub use grid::grid;
pub use hunt::Hunt;
pub use matrix::{matrix_work, measure_matrix};
pub use matter::{MatterVerdict, matter_table, measure_matter};
pub use matter_cells::matter_cells;
pub use verdict::{Verdict, markdown};
pub use worst_ray::{HuntRow, WorstRay, hunt_text};
