//! The shaders: whether naga, which checks them before a driver sees them, accepts every one that the
//! passes of scenes run.

use lightfall_core::scene::Scene;
use lightfall_render::{PassShader, pass_shaders};
use serde::Serialize;
use std::collections::HashSet;

/// The check of shaders.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ShaderCheck {
    /// Names of the scenes whose shaders were checked.
    pub scenes: Vec<String>,
    /// How many different shaders these are.
    pub shaders: usize,
    /// Those with a fault.
    pub faults: Vec<FaultyShader>,
}

/// A shader with a fault.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FaultyShader {
    /// Name of the first scene that needs the shader.
    pub scene: String,
    /// Name of the pass that runs it.
    pub pass: &'static str,
    /// The fault, with the file and line of the shader.
    pub fault: String,
}

impl ShaderCheck {
    /// Checks the shaders of every pass of these scenes.
    #[must_use]
    pub fn of<'a>(scenes: impl IntoIterator<Item = &'a Scene>) -> Self {
        Self::of_passes(
            scenes
                .into_iter()
                .map(|scene| (scene.name.clone(), pass_shaders(scene))),
        )
    }

    /// Checks the shaders of passes, by the names of their scenes. A text that several scenes or
    /// passes share is checked once for the same entry points.
    #[must_use]
    pub fn of_passes(scenes: impl IntoIterator<Item = (String, Vec<PassShader>)>) -> Self {
        let mut check = Self::default();
        let mut seen = HashSet::new();
        for (scene, shaders) in scenes {
            let new =
                |shader: &PassShader| seen.insert((shader.text.source(), shader.entries.clone()));
            for shader in shaders.into_iter().filter(new) {
                check.shaders += 1;
                check
                    .faults
                    .extend(fault(&shader).map(|fault| FaultyShader {
                        scene: scene.clone(),
                        pass: shader.pass,
                        fault,
                    }));
            }
            check.scenes.push(scene);
        }
        check
    }
}

/// What is wrong with a shader: its text, or that it lacks an entry point.
fn fault(shader: &PassShader) -> Option<String> {
    match shader.text.validate() {
        Ok(found) => {
            let is_missing = |entry: &&&str| !found.iter().any(|name| name == **entry);
            let missing = shader.entries.iter().find(is_missing)?;
            Some(format!("it has no entry point {missing}"))
        }
        Err(fault) => Some(fault.to_string()),
    }
}

impl FaultyShader {
    /// A sentence that says what is wrong and what to do.
    pub(super) fn sentence(&self) -> String {
        let Self { scene, pass, fault } = self;
        format!(
            "the shader of the pass {pass} (scene {scene}) is not valid: {fault}; this is a fault of the program, please \
             report it to its makers"
        )
    }
}
