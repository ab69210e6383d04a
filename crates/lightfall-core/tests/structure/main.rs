//! The structure of the source: which module may import from which. These tests read the source
//! files and the documents, and need neither Bevy nor a GPU.
//! docs/ARCHITECTURE.md explains the order.

mod documents;
mod examples;
mod graph;
mod program;
mod promises;
mod rules;
mod source;
mod tokens;

use graph::Graph;
use std::path::{Path, PathBuf};

/// The core's modules, lowest first: each may import from those before it.
const CORE_ORDER: [&str; 9] = [
    "lightfall_core::words",
    "lightfall_core::numbers",
    "lightfall_core::random",
    "lightfall_core::geometry",
    "lightfall_core::scene",
    "lightfall_core::optics",
    "lightfall_core::gpu",
    "lightfall_core::accuracy",
    "lightfall_core::reports",
];

/// The folder of the whole workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn add_core(graph: &mut Graph) {
    graph.add_folder("lightfall_core", &root(), "crates/lightfall-core/src");
}

fn core() -> Graph {
    let mut graph = Graph::default();
    add_core(&mut graph);
    graph
}

#[test]
fn every_module_of_the_core_imports_only_from_modules_below_it() {
    let faults = rules::upward_imports(&core(), &CORE_ORDER);
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn no_files_of_the_core_import_each_other_in_a_circle() {
    let circles = rules::circles(&core(), "lightfall_core");
    let faults: Vec<String> = circles.iter().map(rules::Circle::describe).collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// The check reads one module per file, so imports of a module inside another file would escape it.
#[test]
fn every_module_of_the_core_that_imports_has_its_own_file() {
    let found = core().inline_imports();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}
