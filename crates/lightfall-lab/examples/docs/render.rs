//! Numbers and tables of the documents.

pub use lightfall_model::numbers::{ratio, short_number as short};

/// A whole number, with its thousands set apart from 10 000 on.
pub fn count(number: usize) -> String {
    let digits = number.to_string();
    if number < 10_000 {
        return digits;
    }
    let groups = digits.as_bytes().rchunks(3).rev();
    let groups: Vec<_> = groups.map(String::from_utf8_lossy).collect();
    groups.join(" ")
}

/// The largest of some numbers.
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(f64::NEG_INFINITY, f64::max)
}

/// The middle one of some numbers, or the mean of the two in the middle.
pub fn median(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let mut numbers: Vec<f64> = numbers.into_iter().collect();
    numbers.sort_by(f64::total_cmp);
    let [below, above] = [(numbers.len() - 1) / 2, numbers.len() / 2];
    0.5 * (numbers[below] + numbers[above])
}

/// A Markdown table with this head: its columns, separated by `|`.
pub fn table(head: &str, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    lightfall_lab::table::table(head, rows.into_iter().map(|row| row.join(" | ")))
}
