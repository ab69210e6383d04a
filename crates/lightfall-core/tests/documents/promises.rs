//! What the documents promise is what the program promises.

use crate::root;
use lightfall_core::scene::promises;
use std::fs;

#[test]
fn every_promise_names_tests_that_exist() {
    let folder = root().join("crates/lightfall-core/tests/gpu");
    for promise in promises::promises() {
        for file in promise.tests.split(", ") {
            assert!(
                folder.join(file).is_file(),
                "{}: no file {file}",
                promise.what
            );
        }
    }
}

#[test]
fn the_documents_state_the_promises_of_the_code() {
    let text = fs::read_to_string(root().join("docs/ACCURACY.md")).expect("the document is there");
    let table = promises::table();
    assert!(
        text.contains(&table),
        "scripts/docs writes this table into docs/ACCURACY.md:\n{table}"
    );
}
