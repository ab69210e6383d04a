//! Faults of shaders.

use thiserror::Error;

/// A fault of a shader's text, in one line that names the file below shaders/.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{file}:{line}: {reason}")]
pub struct ShaderFault {
    /// The file.
    pub file: String,
    /// The line in that file, counted from 1.
    pub line: usize,
    /// The fault.
    pub reason: String,
}
