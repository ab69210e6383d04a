//! The shaders of the passes that draw a scene, by the names of the passes.

use crate::chain::Chain;
use lightfall_core::gpu::stars::StarKernel;
use lightfall_core::gpu::{
    Accumulation, Bloom, Developer, Difference, EdgeTraits, Presentation, Print, ShaderText,
    Variant,
};
use lightfall_core::scene::Scene;

/// A shader, and the pass that runs it.
#[derive(Clone, Debug)]
pub struct PassShader {
    /// Name of the pass, or of the passes that share the shader.
    pub pass: &'static str,
    /// Names of the entry points that the pass runs.
    pub entries: Vec<&'static str>,
    /// The text.
    pub text: ShaderText,
}

impl PassShader {
    fn new(pass: &'static str, entries: &[&'static str], text: ShaderText) -> Self {
        Self {
            pass,
            entries: entries.to_vec(),
            text,
        }
    }

    fn of_variant(pass: &'static str, variant: Variant) -> Self {
        Self::new(pass, variant.entry.points(), variant.text())
    }
}

/// The shaders of every pass that draws the scene in a window or a file, with those that keys ask
/// for without another scene: a comparison, the picture without cells, and the mean of a picture at
/// rest. The rays of reports and of the inspector come last.
#[must_use]
pub fn pass_shaders(scene: &Scene) -> Vec<PassShader> {
    let chain = Chain::of(scene);
    let picture = Variant::picture(scene);
    let mut shaders = vec![PassShader::of_variant("geodesic", picture)];
    if let Some(refined) = picture.refined() {
        let edges = EdgeTraits {
            samples: chain.samples,
        };
        shaders.extend([
            PassShader::new("edges", &["edges"], edges.shader()),
            PassShader::of_variant("refine", refined),
        ]);
    }
    if chain.stars {
        shaders.extend(
            StarKernel::of(scene)
                .map(|kernel| PassShader::new("stars", &[kernel.word()], kernel.text(scene))),
        );
    }
    let compared = Variant {
        antialias: false,
        ..picture
    };
    shaders.extend([
        PassShader::of_variant("geodesic_pinned", compared),
        PassShader::new(
            "difference",
            &["vertex", "difference"],
            Difference::shader(),
        ),
        PassShader::new(
            "accumulate",
            &["vertex", "accumulate"],
            Accumulation::shader(),
        ),
        PassShader::new("bloom", &Bloom::ENTRIES, Bloom::shader()),
        PassShader::new(
            "develop",
            &["vertex", "develop"],
            Developer::of(scene, chain.bloom.is_some()).shader(),
        ),
        PassShader::new("print", &["vertex", "print"], Print::shader()),
        PassShader::new(
            "pixelate, expand and fit",
            &["vertex", "pixelate", "expand", "fit"],
            Presentation::shader(),
        ),
        PassShader::of_variant("rays", Variant::rays(scene)),
    ]);
    shaders
}
