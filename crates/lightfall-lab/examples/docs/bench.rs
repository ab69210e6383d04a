//! The rows of `lightfall bench`, asked by scene and method.

use crate::measured::measured;
use lightfall_lab::bench::{Measurement, at_equal_error};

/// The rows of one run.
pub struct Bench {
    rows: Vec<Measurement>,
}

impl Bench {
    pub fn read(file: &str) -> Result<Self, String> {
        let rows = measured(file)?.rows;
        Ok(Self { rows })
    }

    /// The row of `auto` in each scene, in their order.
    pub fn of_auto(&self) -> impl Iterator<Item = &Measurement> {
        self.rows.iter().filter(|row| row.auto)
    }

    /// The row of a method at the scene's own setting, if the method traces the scene.
    pub fn own(&self, scene: &str, method: &str) -> Option<&Measurement> {
        let mut rows = self.rows.iter();
        rows.find(|row| row.scene == scene && row.method == method && row.own_setting)
    }

    /// How many times as fast `closed` is as a method at equal error: the least and the largest ratio.
    pub fn times_as_fast(&self, scene: &str, method: &str) -> Option<[f64; 2]> {
        let found = at_equal_error(&self.rows, scene, "closed", method, None)?;
        Some(found.ratio)
    }
}
