//! The scenes of the measurement.

use lightfall_model::scene::{Method, Override, Scene, presets};

/// A scene to measure.
#[derive(Clone, Debug, PartialEq)]
pub struct BenchScene {
    /// The scene's name in the report.
    pub name: String,
    /// The scene. Its method does not matter.
    pub scene: Scene,
}

/// The scenes that are measured by default: the presets, without the one that is about a method and
/// without those of straight rays, which every method traces alike.
/// The opening preset comes without spin, so that every method can trace it, and once more as it
/// is.
pub fn scenes() -> Vec<BenchScene> {
    let measured = |preset: &presets::Preset, name: String, overrides: &[Override]| {
        let scene = preset.scene(overrides).ok()?;
        Some(BenchScene { name, scene })
    };
    let opening = &presets::PRESETS[presets::DEFAULT - 1];
    let without_spin = [Override::new("--spin", "hole.spin", "0")];
    presets::PRESETS
        .iter()
        .filter(|preset| {
            let scene = preset.plain_scene();
            scene.method == Method::Auto && scene.effects.lensing
        })
        .filter_map(|preset| {
            let overrides: &[Override] = if preset == opening {
                &without_spin
            } else {
                &[]
            };
            measured(preset, preset.name.into(), overrides)
        })
        .chain(measured(opening, format!("{}-spinning", opening.name), &[]))
        .collect()
}
