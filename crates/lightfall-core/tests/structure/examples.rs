//! The check itself, on small made-up sources: it finds what it must find, and nothing else.

use crate::graph::Graph;
use crate::rules::{circles, upward_imports};

/// Files of one made-up crate.
fn made_up(files: &[(&str, &str)]) -> Graph {
    let mut graph = Graph::default();
    for (place, text) in files {
        graph.add("core", place, place, text);
    }
    graph
}

/// The files of every circle.
fn circle_files(files: &[(&str, &str)]) -> Vec<Vec<String>> {
    circles(&made_up(files), "core")
        .into_iter()
        .map(|circle| circle.files)
        .collect()
}

const ORDER: [&str; 2] = ["core::low", "core::high"];

#[test]
fn an_import_that_runs_up_is_named_with_file_and_line() {
    let graph = made_up(&[
        ("low.rs", "//! Low.\n\nuse crate::high::Item;\n"),
        ("high.rs", "pub struct Item;\n"),
    ]);
    assert_eq!(
        upward_imports(&graph, &ORDER),
        ["low.rs:3 imports crate::high::Item from high.rs, but core::low is below core::high"]
    );
}

#[test]
fn an_import_that_runs_down_is_no_fault() {
    let graph = made_up(&[
        ("high.rs", "use crate::low::Item;\n"),
        ("low.rs", "pub struct Item;\n"),
    ]);
    assert!(upward_imports(&graph, &ORDER).is_empty());
}

#[test]
fn an_upward_import_is_found_in_a_group_under_another_name_and_in_the_code_itself() {
    for text in [
        "use crate::{high::{self, Item as Thing}};",
        "use super::high as below;",
        "fn f() -> crate::high::Item { loop {} }",
        "fn f() { super::high::make(); }",
        "pub use crate::high::*;",
        "use core::high::Item;",
    ] {
        let graph = made_up(&[
            ("lib.rs", "mod low; mod high;"),
            ("low.rs", text),
            ("high.rs", "pub struct Item; pub fn make() {}"),
        ]);
        let faults = upward_imports(&graph, &ORDER);
        assert!(!faults.is_empty(), "{text}");
    }
}

#[test]
fn an_upward_import_is_found_behind_a_reexport_at_the_crate_root() {
    let graph = made_up(&[
        ("lib.rs", "mod low; mod high; pub use high::Item as Thing;"),
        ("low.rs", "use crate::Thing;"),
        ("high.rs", "pub struct Item;"),
    ]);
    assert_eq!(
        upward_imports(&graph, &ORDER),
        ["low.rs:1 imports crate::Thing from high.rs, but core::low is below core::high"]
    );
}

#[test]
fn comments_strings_and_visibility_are_no_imports() {
    let text = r##"
        //! See [`crate::high::Item`]. use crate::high::Item;
        /* use crate::high::Item; /* nested */ crate::high::make() */
        const A: &str = "crate::high::make() \" use crate::high;";
        const B: &str = r#"use crate::high::Item; ""#;
        const C: char = '"';
        pub(in crate::high) fn f<'a>(x: &'a str) -> impl Fn() + use<'a> { || () }
    "##;
    let graph = made_up(&[("low.rs", text), ("high.rs", "pub struct Item;")]);
    assert!(upward_imports(&graph, &ORDER).is_empty());
}

#[test]
fn a_module_without_a_place_in_the_order_is_a_fault() {
    let graph = made_up(&[("low.rs", ""), ("utils/mod.rs", "")]);
    assert_eq!(
        upward_imports(&graph, &ORDER),
        ["the module core::utils has no place in the order"]
    );
}

#[test]
fn two_files_that_import_each_other_are_a_circle() {
    let graph = made_up(&[
        ("a.rs", "use crate::b::B;\npub struct A;"),
        ("b.rs", "\npub struct B(crate::a::A);"),
    ]);
    let found = circles(&graph, "core");
    assert_eq!(found.len(), 1);
    assert_eq!(
        found[0].describe(),
        "2 files import each other in a circle (a.rs, b.rs):\n    \
         a.rs:1 imports crate::b::B from b.rs\n    \
         b.rs:2 imports crate::a::A from a.rs"
    );
}

#[test]
fn a_circle_of_three_files_is_found_once() {
    let found = circle_files(&[
        ("a.rs", "use crate::b::B; pub struct A;"),
        ("b.rs", "use super::c; pub struct B; fn f() { c::make() }"),
        ("c.rs", "pub fn make() { crate::a::A; }"),
        ("d.rs", "use crate::a::A;"),
    ]);
    assert_eq!(found, [["a.rs", "b.rs", "c.rs"]]);
}

#[test]
fn a_circle_through_a_reexport_names_the_files_that_define() {
    let found = circle_files(&[
        ("room/mod.rs", "mod a; mod b; pub use {a::A, b::B};"),
        ("room/a.rs", "use super::B; pub struct A;"),
        ("room/b.rs", "use crate::room::A; pub struct B;"),
    ]);
    assert_eq!(found, [["room/a.rs", "room/b.rs"]]);
}

#[test]
fn a_circle_is_found_through_a_glob_and_through_a_renamed_module() {
    let found = circle_files(&[
        ("room/mod.rs", "mod a; mod b; pub use b::*;"),
        ("room/a.rs", "use super::B; pub struct A;"),
        (
            "room/b.rs",
            "use super::a as first; pub struct B(first::A);",
        ),
    ]);
    assert_eq!(found, [["room/a.rs", "room/b.rs"]]);
}

#[test]
fn a_parent_that_declares_and_reexports_its_children_is_no_circle() {
    let found = circle_files(&[
        (
            "room/mod.rs",
            "mod a; pub use a::{A, make}; pub struct Own;",
        ),
        (
            "room/a.rs",
            "use super::Own; pub struct A(Own); pub fn make() {}",
        ),
    ]);
    assert!(found.is_empty(), "{found:?}");
}

#[test]
fn a_parent_that_uses_a_child_which_uses_the_parents_own_type_is_a_circle() {
    let child = (
        "room/a.rs",
        "use super::Own; pub struct A(Own); pub fn make() {}",
    );
    for parent in [
        "mod a; pub use a::A; pub struct Own; fn f(_: A) {}",
        "mod a; pub use a::make; pub struct Own; fn f() { make() }",
        "mod a; use a::A; pub struct Own;",
        "mod a; pub struct Own; fn f() { a::make() }",
    ] {
        let found = circle_files(&[("room/mod.rs", parent), child]);
        assert_eq!(found, [["room/a.rs", "room/mod.rs"]], "{parent}");
    }
}

#[test]
fn a_module_inside_a_file_is_reported_if_it_imports() {
    let graph = made_up(&[
        ("low.rs", "\nmod inner {\n    use crate::high::Item;\n}"),
        (
            "high.rs",
            "mod plain { pub const A: u32 = 1; }\nconst B: u32 = plain::A;",
        ),
        ("path.rs", "mod inner { fn f() { super::super::g() } }"),
    ]);
    assert_eq!(
        graph.inline_imports(),
        [
            "low.rs:3: the module inner imports something and has no file of its own",
            "path.rs:1: the module inner imports something and has no file of its own"
        ]
    );
}
