//! The data of the view `error`: a grid of errors, laid out as the uniform of
//! shaders/view/error.wgsl.

/// Columns and rows of the grid; a multiple of four cells.
pub const ERROR_MAP_SIZE: [u32; 2] = [64, 36];

const CELLS: usize = (ERROR_MAP_SIZE[0] * ERROR_MAP_SIZE[1]) as usize;

/// Values of cells without an error in pixels: the error is not known yet, nothing is seen, or no
/// turn of the ray explains its answer.
const UNKNOWN: f32 = -1.0;
const UNSEEN: f32 = -2.0;
const UNEXPLAINED: f32 = 1e30;

/// The backward errors of a picture's cells, in pixels, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorMap(Vec<f32>);

impl Default for ErrorMap {
    /// A grid in which no error is known yet.
    fn default() -> Self {
        Self(vec![UNKNOWN; CELLS])
    }
}

impl ErrorMap {
    /// The grid of these errors in pixels, `None` where nothing is seen. The errors of further
    /// cells are not known.
    pub fn new(errors: &[Option<f64>]) -> Self {
        let known = errors.iter().map(|error| match error {
            // The minimum with NaN is the other number, so NaN counts as unexplained, too.
            Some(error) => f64::min(*error, UNEXPLAINED.into()) as f32,
            None => UNSEEN,
        });
        Self(
            known
                .chain(std::iter::repeat(UNKNOWN))
                .take(CELLS)
                .collect(),
        )
    }

    /// The bytes of the uniform.
    pub fn bytes(&self) -> Vec<u8> {
        self.0
            .iter()
            .flat_map(|error| error.to_le_bytes())
            .collect()
    }

    /// The constants that the shader shares, as name, type and value.
    pub(super) fn constants() -> [(&'static str, &'static str, String); 5] {
        let [columns, rows] = ERROR_MAP_SIZE;
        [
            ("ERROR_COLUMNS", "u32", format!("{columns}u")),
            ("ERROR_ROWS", "u32", format!("{rows}u")),
            ("UNKNOWN", "f32", format!("{UNKNOWN:?}")),
            ("UNSEEN", "f32", format!("{UNSEEN:?}")),
            ("UNEXPLAINED", "f32", format!("{UNEXPLAINED:?}")),
        ]
    }
}
