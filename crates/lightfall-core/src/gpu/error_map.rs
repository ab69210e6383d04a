//! The view `error`: a grid of errors as it lies in the uniform of shaders/view/error.wgsl.

/// Columns and rows of the grid; a multiple of four cells.
pub const ERROR_MAP_SIZE: [u32; 2] = [64, 36];

/// How many cells that is.
const CELLS: usize = (ERROR_MAP_SIZE[0] * ERROR_MAP_SIZE[1]) as usize;

/// Cells without an error in pixels: not known yet, nothing seen there, an answer that no turn of
/// the ray explains.
const UNKNOWN: f32 = -1.0;
const UNSEEN: f32 = -2.0;
const UNEXPLAINED: f32 = 1e30;

/// The backward errors of a picture's cells, in pixels, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorMap(Vec<f32>);

impl Default for ErrorMap {
    /// None of them known yet.
    fn default() -> Self {
        Self(vec![UNKNOWN; CELLS])
    }
}

impl ErrorMap {
    /// Size of the uniform, in bytes.
    pub const SIZE: usize = CELLS * size_of::<f32>();

    /// From errors in pixels; none where nothing is seen. Cells beyond the last error are not
    /// known.
    #[must_use]
    pub fn new(errors: &[Option<f64>]) -> Self {
        let known = errors.iter().map(|error| match error {
            // What is not a number explains nothing either.
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

    /// As they lie in the uniform.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        self.0
            .iter()
            .flat_map(|error| error.to_le_bytes())
            .collect()
    }

    /// What the shader must share.
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
