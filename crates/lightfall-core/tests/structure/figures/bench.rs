//! The rows of `lightfall bench`, asked by scene, method and setting.

use super::measured::measured;
use lightfall_core::reports::bench::{Measurement, at_equal_error};
use lightfall_core::reports::import::Report;

/// The rows of one run.
pub struct Bench {
    pub rows: Vec<Measurement>,
    pub floor: f64,
}

/// A method's rows in a scene, with the row of `closed`.
pub struct InScene<'a> {
    pub scene: &'a str,
    pub closed: &'a Measurement,
    rows: Vec<&'a Measurement>,
}

impl Bench {
    pub fn read(file: &str) -> Self {
        let Report { head, rows } = measured::<Measurement>(file);
        let floor = head.floor_ms().expect("a bench measures its floor");
        Self { rows, floor }
    }

    /// The scenes in their order that this method can trace.
    fn with_method<'a>(&'a self, method: &'a str) -> impl Iterator<Item = InScene<'a>> {
        let mut scenes: Vec<&str> = self.rows.iter().map(|row| row.scene.as_str()).collect();
        scenes.dedup();
        scenes.into_iter().filter_map(move |scene| {
            let of = |method: &str| -> Vec<&Measurement> {
                let wanted = |row: &&Measurement| row.scene == scene && row.method == method;
                self.rows.iter().filter(wanted).collect()
            };
            let rows = of(method);
            let closed = *of("closed").first()?;
            (!rows.is_empty()).then_some(InScene {
                scene,
                closed,
                rows,
            })
        })
    }

    /// Every scene.
    pub fn scenes(&self) -> Vec<InScene<'_>> {
        self.with_method("mino").collect()
    }

    /// The scenes without spin, with the rows of `verlet`, which traces no others.
    pub fn without_spin(&self) -> Vec<InScene<'_>> {
        self.with_method("verlet").collect()
    }

    /// The scenes with spin, with the rows of this method.
    pub fn spinning<'a>(&'a self, method: &'a str) -> Vec<InScene<'a>> {
        let plain: Vec<&str> = self
            .without_spin()
            .iter()
            .map(|in_scene| in_scene.scene)
            .collect();
        self.with_method(method)
            .filter(|in_scene| !plain.contains(&in_scene.scene))
            .collect()
    }

    /// Every scene, with the rows of this method.
    pub fn of<'a>(&'a self, method: &'a str) -> Vec<InScene<'a>> {
        self.with_method(method).collect()
    }

    /// How many times as fast `closed` is as a method at equal error in a scene, with the floor and
    /// without.
    pub fn times_as_fast(&self, scene: &str, method: &str) -> Option<[[f64; 2]; 2]> {
        let found = at_equal_error(&self.rows, scene, "closed", method, Some(self.floor))?;
        Some([found.ratio, found.net_ratio?])
    }

    /// How many times as long as `closed` a row takes, without the floor.
    pub fn net_ratio(&self, row: &Measurement, closed: &Measurement) -> f64 {
        (row.trace_ms - self.floor) / (closed.trace_ms - self.floor)
    }
}

impl<'a> InScene<'a> {
    /// The row at the scene's own setting, which is the usual one.
    pub fn own(&self) -> &'a Measurement {
        let own = self.rows.iter().find(|row| row.own_setting);
        own.expect("the own setting is measured")
    }

    /// The row with the smallest value of the setting: the tightest, or the shortest step.
    pub fn finest(&self) -> &'a Measurement {
        let value = |row: &Measurement| row.value.expect("the method has a setting");
        let finest = self
            .rows
            .iter()
            .min_by(|a, b| value(a).total_cmp(&value(b)));
        finest.expect("the method is measured")
    }

    /// The row at this setting.
    pub fn at(&self, value: f64) -> Option<&'a Measurement> {
        self.rows
            .iter()
            .find(|row| row.value == Some(value))
            .copied()
    }

    /// The row at the scene's own setting and those at the article's qualities: cheap, balanced and
    /// high, with their budgets of steps.
    pub fn article(&self) -> Vec<&'a Measurement> {
        let is_shown = |row: &&&Measurement| row.own_setting || row.quality.is_some();
        self.rows.iter().filter(is_shown).copied().collect()
    }

    /// All rows.
    pub fn rows(&self) -> impl Iterator<Item = &'a Measurement> {
        self.rows.iter().copied()
    }
}
