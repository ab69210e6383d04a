//! Numbers as the user interface shows them.

use lightfall_core::numbers::four_digits;

/// A value that the user sets, with at most four decimals, or with its first eight digits if four
/// decimals would hide them.
pub(crate) fn four_decimals(number: f64) -> String {
    let number = eight_digits(number);
    match number.abs() {
        0.0 => "0".into(),
        1e-3..0.01 => format!("{number}"),
        0.01..1e9 => trimmed(format!("{number:.4}")),
        _ => format!("{number:e}"),
    }
}

/// A number rounded to eight significant digits.
pub(crate) fn eight_digits(number: f64) -> f64 {
    format!("{number:.7e}").parse().unwrap_or(number)
}

/// Words for the size of a number.
const SIZES: [(f64, &str); 3] = [(1e12, "trillion"), (1e9, "billion"), (1e6, "million")];

/// A computed value with at most four digits and a word for its size, such as `25.4 million`.
pub(crate) fn in_words(number: f64) -> String {
    let size = SIZES.into_iter().find(|(size, _)| number.abs() >= *size);
    match size {
        Some((size, word)) => format!("{} {word}", four_digits(number / size)),
        None => four_digits(number),
    }
}

/// The number that [`in_words`] writes, or `None` for another text.
pub(crate) fn from_words(text: &str) -> Option<f64> {
    let mut words = text.split_whitespace();
    let number: f64 = words.next()?.parse().ok()?;
    let word = words.next().unwrap_or_default();
    let size = SIZES.into_iter().find(|(_, name)| *name == word);
    Some(number * size.map_or(1.0, |(size, _)| size))
}

/// The longest of 1, 2, 5, 10, ... and of 0.5, 0.2, 0.1, ... that is at most `longest`, for a scale
/// bar. `None` if `longest` is far from every length of a scene.
pub(crate) fn round_length(longest: f64) -> Option<f64> {
    if !(1e-12..1e12).contains(&longest) {
        return None;
    }
    let power = longest.log10().floor();
    let digits = longest / 10_f64.powf(power);
    let digit = [5, 2].into_iter().find(|digit| f64::from(*digit) <= digits);
    // Parsed from decimal digits, so that no digit of a binary fraction follows them.
    format!("{}e{power}", digit.unwrap_or(1)).parse().ok()
}

/// Decimal digits without the zeros at their end.
pub(crate) fn trimmed(digits: String) -> String {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        digits
    }
}
