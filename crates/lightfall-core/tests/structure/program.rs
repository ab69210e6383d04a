//! The program: which module may import from which.

use crate::graph::Graph;
use crate::{CORE_ORDER, add_core, root, rules};

/// The program's modules, lowest first, above those of the core.
const ORDER: [&str; 9] = [
    "lightfall::worker",
    "lightfall::browser",
    "lightfall::storage",
    "lightfall::log",
    "lightfall::render",
    "lightfall::picture",
    "lightfall::app",
    "lightfall::commands",
    "lightfall::page",
];

/// The window's folders, lowest first.
const APP_ORDER: [&str; 6] = [
    "lightfall::app::controls",
    "lightfall::app::state",
    "lightfall::app::input",
    "lightfall::app::session",
    "lightfall::app::motion",
    "lightfall::app::ui",
];

/// The sources of both crates.
fn sources() -> Graph {
    let mut graph = Graph::default();
    add_core(&mut graph);
    graph.add_folder("lightfall", &root(), "src");
    graph
}

#[test]
fn every_module_of_the_program_imports_only_from_modules_below_it() {
    let order = [&CORE_ORDER[..], &ORDER].concat();
    let faults = rules::upward_imports(&sources(), &order);
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn every_folder_of_the_window_imports_only_from_folders_below_it() {
    let faults = rules::upward_imports(&sources(), &APP_ORDER);
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn no_files_of_the_program_import_each_other_in_a_circle() {
    let circles = rules::circles(&sources(), "lightfall");
    let faults: Vec<String> = circles.iter().map(rules::Circle::describe).collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// The check reads one module per file, so imports of a module inside another file would escape it.
#[test]
fn every_module_of_the_program_that_imports_has_its_own_file() {
    let found = sources().inline_imports();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}
