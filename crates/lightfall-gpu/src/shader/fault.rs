//! What is wrong with a shader.

use thiserror::Error;

/// What is wrong with a shader's text, in one line that names the file below shaders/.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{file}:{line}: {reason}")]
pub struct ShaderFault {
    /// The file.
    pub file: String,
    /// The line in that file, counted from 1.
    pub line: usize,
    /// What is wrong there.
    pub reason: String,
}
