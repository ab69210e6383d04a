//! The row of presets that PageUp and PageDown turn through: the built-in ones, then the user's own.

use bevy::prelude::Resource;
use lightfall_core::scene::presets::PRESETS;
use std::path::PathBuf;

/// A preset of the row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RowPreset {
    /// The name of a built-in one.
    BuiltIn(String),
    /// The file of one of the user's own.
    Own(PathBuf),
}

/// The file that the present scene was loaded from. None for a built-in preset.
#[derive(Resource, Default)]
pub(crate) struct LoadedFile(pub(crate) Option<PathBuf>);

/// The preset `places` further on in the row, wrapping around, where the user has these own ones. From
/// a scene that is not in the row: its first or its last preset.
#[must_use]
pub fn preset_beside(now: &RowPreset, own: Vec<PathBuf>, places: i32) -> RowPreset {
    let built_in = PRESETS.map(|preset| RowPreset::BuiltIn(preset.name.into()));
    let mut row: Vec<_> = built_in
        .into_iter()
        .chain(own.into_iter().map(RowPreset::Own))
        .collect();
    let count = row.len() as i64;
    let next = match row.iter().position(|preset| preset == now) {
        Some(place) => place as i64 + i64::from(places),
        None if places > 0 => 0,
        None => -1,
    };
    row.swap_remove(next.rem_euclid(count) as usize)
}
