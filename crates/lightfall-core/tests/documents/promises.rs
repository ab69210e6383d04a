//! What the documents promise is what the program promises.

use crate::root;
use lightfall_core::scene::promises;
use std::fs;

#[test]
fn the_documents_state_the_promises_of_the_code() {
    let text = fs::read_to_string(root().join("docs/ACCURACY.md")).expect("the document is there");
    let table = promises::table();
    assert!(
        text.contains(&table),
        "scripts/docs writes this table into docs/ACCURACY.md:\n{table}"
    );
}
