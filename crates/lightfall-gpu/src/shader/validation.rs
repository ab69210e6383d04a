//! Validation of a shader's text by naga, as wgpu validates it before a driver sees the shader. It
//! needs no GPU.

use super::{ShaderFault, ShaderText};
use std::collections::BTreeMap;
use std::error::Error;
use std::iter::successors;
use wgpu::naga::front::wgsl::parse_str;
use wgpu::naga::valid::{Capabilities, ValidationFlags, Validator};
use wgpu::naga::{AddressSpace, Module, SourceLocation};

/// The address space and the size of each bound variable, and the line that declares it, by group
/// and binding.
type Bound = BTreeMap<(u32, u32), (AddressSpace, u32, usize)>;

impl ShaderText {
    /// Parses and validates the text if all of it could be linked, and returns the names of its
    /// entry points.
    ///
    /// # Errors
    /// The first fault.
    pub fn validate(&self) -> Result<Vec<String>, ShaderFault> {
        let entries = self.module()?.entry_points.into_iter();
        Ok(entries.map(|entry| entry.name).collect())
    }

    /// Validates the text, and compares its bindings with those of the text that it replaces in a
    /// pipeline: the program fills only these.
    ///
    /// # Errors
    /// The first fault.
    pub fn validate_in_place_of(&self, other: &Self) -> Result<(), ShaderFault> {
        let known = bound(&other.module()?, &other.source());
        for ((group, binding), (space, size, line)) in bound(&self.module()?, &self.source()) {
            let same = known.get(&(group, binding));
            if same.is_none_or(|&(other, expected, _)| (other, expected) != (space, size)) {
                let (file, line) = self.locate(line);
                return Err(ShaderFault {
                    file: file.into(),
                    line,
                    reason: format!(
                        "binding {binding} of group {group} has another size or kind than in the program, which has to be \
                         built anew"
                    ),
                });
            }
        }
        Ok(())
    }

    fn module(&self) -> Result<Module, ShaderFault> {
        if let Some(fault) = self.link_fault() {
            return Err(fault.clone());
        }
        let source = self.source();
        let module =
            parse_str(&source).map_err(|error| self.fault(error.location(&source), &error))?;
        Validator::new(ValidationFlags::all(), Capabilities::default())
            .validate(&module)
            .map_err(|error| self.fault(error.location(&source), error.as_inner()))?;
        Ok(module)
    }

    fn fault(&self, place: Option<SourceLocation>, error: &(dyn Error + 'static)) -> ShaderFault {
        let line = place.map_or(1, |place| place.line_number as usize);
        let (file, line) = self.locate(line);
        // naga's error says where something is invalid; its sources say what.
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

fn bound(module: &Module, source: &str) -> Bound {
    let variables = module.global_variables.iter();
    let bound = variables.filter_map(|(handle, variable)| {
        let place = variable.binding?;
        let size = module.types[variable.ty].inner.size(module.to_ctx());
        let span = module.global_variables.get_span(handle);
        let line = span.location(source).line_number as usize;
        Some(((place.group, place.binding), (variable.space, size, line)))
    });
    bound.collect()
}
