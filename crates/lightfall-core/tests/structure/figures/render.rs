//! Numbers, tables and lines of the documents.

pub use lightfall_core::numbers::{ratio, short_number as short};

/// A whole number, with its thousands set apart from 10 000 on.
pub fn count(number: usize) -> String {
    let digits = number.to_string();
    if number < 10_000 {
        return digits;
    }
    let head = digits.len() % 3;
    let groups = (0..=digits.len() / 3).map(|i| {
        let end = head + 3 * i;
        &digits[end.saturating_sub(3)..end]
    });
    let groups: Vec<&str> = groups.filter(|group| !group.is_empty()).collect();
    groups.join(" ")
}

/// As [`short`], but never less than the number: for what is nowhere exceeded.
pub fn at_most(number: f64) -> String {
    let text = short(number);
    if text.parse::<f64>().is_ok_and(|stated| stated < number) {
        // Half a unit of the last digit: `short` writes three digits, and two before an exponent.
        let digits = if text.contains('e') { 1 } else { 2 };
        return short(number + 0.5 * 10_f64.powi(number.log10().floor() as i32 - digits));
    }
    text
}

/// A bound of the program's: one digit and a power of ten.
pub fn bound(number: f64) -> String {
    format!("{number:.0e}")
}

/// The smallest and the largest of some numbers.
pub fn extent(numbers: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let numbers = numbers.into_iter();
    numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], number| {
        [low.min(number), high.max(number)]
    })
}

/// The largest of some numbers.
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    extent(numbers)[1]
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
    let rule = "|---".repeat(head.split('|').count());
    let mut text = format!("| {head} |\n{rule}|\n");
    for row in rows {
        text += &format!("| {} |\n", row.join(" | "));
    }
    text
}
