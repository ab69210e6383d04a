//! Lightfall.
fn main() {}
