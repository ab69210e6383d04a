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
mod lines;
mod measured;
mod render;

use crate::root;
use bench::Bench;
use document::{Figures, apply};
use lightfall_core::reports::bench::scenes;
use lightfall_core::scene::Method;
use lines::with_short_lines;
use measured::provenance;
use std::fs;

/// Set to write the figures into the documents instead of comparing them.
const WRITE: &str = "LIGHTFALL_WRITE_DOCS";

/// Every document with figures.
fn all() -> [(&'static str, Figures); 2] {
    [
        ("docs/ACCURACY.md", accuracy::figures()),
        ("docs/EXTREMES.md", extremes::figures()),
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
            fs::write(&path, with_short_lines(&applied.text)).expect("a document can be written");
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

/// The program tells these bounds to its users, and `lightfall doctor` tests a machine against them.
#[test]
fn every_method_keeps_in_the_csv_files_what_the_program_promises_of_it() {
    for file in ["h200/bench", "llvmpipe/bench"] {
        for row in Bench::read(file).rows.iter().filter(|row| row.own_setting) {
            let scenes = scenes();
            let scene = scenes.iter().find(|scene| scene.name == row.scene);
            let spin = scene.expect("the scene still exists").scene.hole.spin;
            let method = Method::from_word(&row.method).expect("the method still exists");
            let Some(p99) = method.backward_p99(spin) else {
                continue;
            };
            assert!(row.backward_p99 <= p99, "{file}: {row:?}");
            if method == Method::Closed {
                assert!(
                    row.backward_max <= method.backward_max(spin),
                    "{file}: {row:?}"
                );
            }
        }
    }
}
