//! The scenes of the measurement.

use lightfall_model::scene::presets::{DEFAULT, PRESETS};
use lightfall_model::scene::{Method, Scene};

/// A scene to measure.
#[derive(Clone, Debug, PartialEq)]
pub struct BenchScene {
    /// The scene's name in the report.
    pub name: String,
    /// The scene. Its method does not matter.
    pub scene: Scene,
}

/// The scenes that are measured by default: the presets, without the one that is about a method,
/// without those of straight rays, which every method traces alike, and without those of matter with
/// depth, which one method traces and `lightfall bench --medium` measures.
/// The opening preset comes without spin, so that every method can trace it, and once more as it
/// is.
pub fn scenes() -> Vec<BenchScene> {
    let named = |name: &str, scene: &Scene| BenchScene {
        name: name.into(),
        scene: scene.clone(),
    };
    let opening = &PRESETS[DEFAULT - 1];
    let presets = PRESETS.iter().filter_map(|preset| {
        let mut scene = preset.plain_scene().clone();
        if preset == opening {
            scene.hole.spin = 0.0;
        }
        let is_measured =
            scene.method == Method::Auto && scene.effects.lensing && !scene.has_medium();
        is_measured.then(|| named(preset.name, &scene))
    });
    let spinning = format!("{}-spinning", opening.name);
    presets
        .chain([named(&spinning, opening.plain_scene())])
        .collect()
}
