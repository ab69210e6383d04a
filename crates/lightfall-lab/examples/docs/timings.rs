//! The times of passes, as scripts/timings measures them, for docs/PASSES.md and docs/SCENES.md.

use crate::measured::{measured, provenance};
use crate::render::{ratio, short, table};
use serde::Deserialize;

/// The machines, by their folder in docs/bench and their name in tables.
const MACHINES: [(&str, &str); 2] = [("llvmpipe", "Mesa llvmpipe"), ("h200", "NVIDIA H200")];

#[derive(Deserialize)]
struct Row {
    view: String,
    pass: String,
    median_ms: f64,
    kept_ms: f64,
}

/// The times on one machine, in milliseconds.
pub struct Machine {
    name: &'static str,
    rows: Vec<Row>,
}

/// A pass, or several that count as one.
pub type Passes = &'static [&'static str];

/// The lines about the files of all machines.
pub fn sources() -> Result<String, String> {
    let lines = MACHINES.map(|(folder, _)| provenance(&format!("{folder}/timings")));
    Ok(lines
        .into_iter()
        .collect::<Result<Vec<_>, _>>()?
        .join("\n\n"))
}

impl Machine {
    fn of<'a>(&'a self, view: &'a str, passes: Passes) -> impl Iterator<Item = &'a Row> {
        let rows = self.rows.iter().filter(move |row| row.view == view);
        rows.filter(move |row| passes.is_empty() || passes.contains(&row.pass.as_str()))
    }

    /// The time of these passes in a view; of all, if there are none.
    pub fn drawn(&self, view: &str, passes: Passes) -> f64 {
        self.of(view, passes).map(|row| row.median_ms).sum()
    }

    /// The same in a frame that keeps its picture.
    pub fn kept(&self, view: &str, passes: Passes) -> f64 {
        self.of(view, passes).map(|row| row.kept_ms).sum()
    }

    /// The time of all passes but those of these rows.
    pub fn others(&self, view: &str, rows: &[(&str, Passes)]) -> f64 {
        let of_rows = rows.iter().map(|(_, passes)| self.drawn(view, passes));
        self.drawn(view, &[]) - of_rows.sum::<f64>()
    }
}

/// A table with the same columns for each machine. A row has a title, and that from which `numbers`
/// takes its cells for a machine.
pub fn by_machine<R, const N: usize>(
    title: &str,
    columns: [&str; N],
    rows: &[(&str, R)],
    numbers: impl Fn(&Machine, &R) -> [String; N],
) -> Result<String, String> {
    let machines = MACHINES.map(|(folder, name)| {
        let rows = measured(&format!("{folder}/timings"))?.rows;
        Ok::<_, String>(Machine { name, rows })
    });
    let machines = machines.into_iter().collect::<Result<Vec<_>, _>>()?;
    let mut head = vec![title.to_owned()];
    for machine in &machines {
        head.extend(columns.map(|column| format!("{}: {column}", machine.name)));
    }
    let rows = rows.iter().map(|(title, row)| {
        let cells = machines.iter().flat_map(|machine| numbers(machine, row));
        [(*title).to_owned()].into_iter().chain(cells).collect()
    });
    Ok(table(&head.join(" | "), rows))
}

/// Two times, and how many times as long the first takes.
pub fn compared(with: f64, without: f64) -> [String; 3] {
    let times = (without > 0.0).then(|| ratio(with / without));
    [short(with), short(without), times.unwrap_or_default()]
}
