//! Numbers as the user interface shows them.

/// A number with four decimals at most, or with all of its digits where four decimals would hide
/// it. For values that are set.
pub(crate) fn four_decimals(number: f64) -> String {
    let size = number.abs();
    if number == 0.0 {
        "0".into()
    } else if (0.01..1e9).contains(&size) {
        trimmed(format!("{number:.4}"))
    } else if (1e-3..1e9).contains(&size) {
        format!("{number}")
    } else {
        format!("{number:e}")
    }
}

/// A number with six digits at most. For values that are computed.
pub(crate) fn six_digits(number: f64) -> String {
    let size = number.abs();
    if number == 0.0 || (1e-3..1e6).contains(&size) {
        let whole = size.max(1.0).log10().floor() as usize;
        trimmed(format!("{number:.*}", 5_usize.saturating_sub(whole)))
    } else {
        format!("{number:.5e}")
    }
}

/// Decimal digits without the zeros at their end.
fn trimmed(digits: String) -> String {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        digits
    }
}
