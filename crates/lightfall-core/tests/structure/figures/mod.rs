//! The measured figures of the documents: each table and each sentence that states one says what the
//! CSV files in docs/bench say. `scripts/docs` writes the figures into the documents.
//!
//! A table stands between `<!-- table NAME -->` and `<!-- end -->`, and the line that says what
//! measured a CSV file between `<!-- source FILE -->` and `<!-- end -->`. The figures of a sentence
//! are found by the words around them. There is one file here for each document.

mod accuracy;
mod bench;
mod document;
mod examples;
mod extremes;
mod hits;
mod lines;
mod measured;
mod passes;
mod plots;
mod promises;
mod refine;
mod render;
mod scenes;
mod sources;
mod timings;

use crate::root;
use document::{Figures, apply};
use lines::with_short_lines;
use measured::provenance;
use std::fs;

/// Set to write the figures into the documents instead of comparing them.
const WRITE: &str = "LIGHTFALL_WRITE_DOCS";

/// Every document with figures.
fn all() -> [(&'static str, Figures); 5] {
    [
        ("docs/ACCURACY.md", accuracy::figures()),
        ("docs/EXTREMES.md", extremes::figures()),
        ("docs/PASSES.md", passes::figures()),
        ("docs/SCENES.md", scenes::figures()),
        (
            "src/app/ui/panel/limitations_page.rs",
            promises::of_limitations_page(),
        ),
    ]
}

#[test]
fn every_measured_figure_of_the_documents_is_that_of_its_csv_file() {
    let write = std::env::var_os(WRITE).is_some();
    let mut faults = Vec::new();
    for (name, figures) in all() {
        let path = root().join(name);
        let text = fs::read_to_string(&path).expect("a document is UTF-8");
        let applied = apply(name, &text, &figures, provenance);
        faults.extend(applied.faults);
        if write {
            let text = match name.ends_with(".md") {
                true => with_short_lines(&applied.text),
                false => applied.text,
            };
            fs::write(&path, text).expect("a document can be written");
        } else {
            faults.extend(applied.differences);
        }
    }
    assert!(
        faults.is_empty(),
        "\n{}\nscripts/docs writes the figures of docs/bench into the documents",
        faults.join("\n")
    );
}
