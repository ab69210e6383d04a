//! Whether a shader's text is valid WGSL, as naga finds it: wgpu asks naga the same before a driver
//! sees the shader. It needs no GPU.

use super::{ShaderFault, ShaderText};
use std::error::Error;
use std::iter::successors;
use wgpu::naga::SourceLocation;
use wgpu::naga::front::wgsl::parse_str;
use wgpu::naga::valid::{Capabilities, ValidationFlags, Validator};

impl ShaderText {
    /// Parses and validates the text if all of it could be linked, and returns the names of its entry points.
    ///
    /// # Errors
    /// The first fault.
    pub fn validate(&self) -> Result<Vec<String>, ShaderFault> {
        if let Some(fault) = self.link_fault() {
            return Err(fault.clone());
        }
        let source = self.source();
        let module =
            parse_str(&source).map_err(|error| self.fault(error.location(&source), &error))?;
        Validator::new(ValidationFlags::all(), Capabilities::default())
            .validate(&module)
            .map_err(|error| self.fault(error.location(&source), error.as_inner()))?;
        let entries = module.entry_points.into_iter();
        Ok(entries.map(|entry| entry.name).collect())
    }

    fn fault(&self, place: Option<SourceLocation>, error: &(dyn Error + 'static)) -> ShaderFault {
        let line = place.map_or(1, |place| place.line_number as usize);
        let (file, line) = self.locate(line);
        // naga says where something is invalid, and what is invalid as the cause of that.
        let steps = successors(Some(error), |error| (*error).source());
        ShaderFault {
            file: file.into(),
            line,
            reason: steps
                .map(<dyn Error>::to_string)
                .collect::<Vec<_>>()
                .join(": "),
        }
    }
}
