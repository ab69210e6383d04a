//! The data of the view `error`: a grid of errors, laid out as the uniform of
//! shaders/view/error.wgsl.

use super::shader::text::{add_f32, add_u32};

/// Columns and rows of the grid; a multiple of four cells.
pub const ERROR_MAP_SIZE: [u32; 2] = [64, 36];

const CELLS: usize = (ERROR_MAP_SIZE[0] * ERROR_MAP_SIZE[1]) as usize;

/// Values of cells without an error in pixels: the error is not known yet, nothing is seen, or no
/// turn of the ray explains its answer.
const UNKNOWN: f64 = -1.0;
const UNSEEN: f64 = -2.0;
const UNEXPLAINED: f64 = 1e30;

/// The backward errors of a picture's cells, in pixels, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorMap(Vec<f32>);

impl Default for ErrorMap {
    /// A grid in which no error is known yet.
    fn default() -> Self {
        Self(vec![UNKNOWN as f32; CELLS])
    }
}

impl ErrorMap {
    /// The grid of these errors in pixels, `None` where nothing is seen. The errors of further
    /// cells are not known.
    pub fn new(errors: &[Option<f64>]) -> Self {
        let mut cells = Self::default();
        for (cell, error) in cells.0.iter_mut().zip(errors) {
            // The minimum with NaN is the other number, so NaN counts as unexplained, too.
            *cell = error.map_or(UNSEEN, |error| error.min(UNEXPLAINED)) as f32;
        }
        cells
    }

    /// The bytes of the uniform.
    pub fn bytes(&self) -> Vec<u8> {
        self.0
            .iter()
            .flat_map(|error| error.to_le_bytes())
            .collect()
    }

    /// Appends the constants that the shader shares.
    pub(super) fn add_constants(prelude: &mut String) {
        let [columns, rows] = ERROR_MAP_SIZE;
        add_u32(prelude, "ERROR_COLUMNS", columns);
        add_u32(prelude, "ERROR_ROWS", rows);
        add_f32(prelude, "UNKNOWN", UNKNOWN);
        add_f32(prelude, "UNSEEN", UNSEEN);
        add_f32(prelude, "UNEXPLAINED", UNEXPLAINED);
    }
}
