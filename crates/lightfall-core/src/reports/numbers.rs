//! Numbers as text, for people.

/// A number to two or three significant digits. NaN, which stands for a missing value, is empty.
#[must_use]
pub fn short_number(number: f64) -> String {
    match number {
        _ if number.is_nan() => String::new(),
        _ if number.is_infinite() => "no bound".into(),
        0.0 => "0".into(),
        _ if (0.01..1000.0).contains(&number.abs()) => {
            let digits = (2 - number.abs().log10().floor() as i32).max(0) as usize;
            format!("{number:.digits$}")
        }
        _ => format!("{number:.1e}"),
    }
}
