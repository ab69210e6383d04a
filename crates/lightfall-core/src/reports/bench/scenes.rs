//! The scenes of the measurement.

use crate::scene::{Method, Override, Scene, presets};

/// A scene to measure.
#[derive(Clone, Debug, PartialEq)]
pub struct BenchScene {
    /// The scene's name in the report.
    pub name: String,
    /// The scene. Its method does not matter.
    pub scene: Scene,
}

/// The scenes that are measured by default: the presets, without the one that is about a method, and
/// preset 2 with a spinning hole.
#[must_use]
pub fn scenes() -> Vec<BenchScene> {
    let preset = |preset: &presets::Preset, name: &str, overrides: &[Override]| {
        preset.scene(overrides).ok().map(|scene| BenchScene {
            name: name.into(),
            scene,
        })
    };
    let twin = Override {
        option: "--set",
        key: "hole.spin".into(),
        value: "0.9".into(),
    };
    let spinning = presets::PRESETS
        .iter()
        .filter(|preset| preset.number == presets::DEFAULT);
    let spinning = spinning.filter_map(|found| {
        preset(
            found,
            &format!("{}-spinning", found.name),
            std::slice::from_ref(&twin),
        )
    });
    presets::PRESETS
        .iter()
        .filter(|found| found.plain_scene().method == Method::Auto)
        .filter_map(|found| preset(found, found.name, &[]))
        .chain(spinning)
        .collect()
}
