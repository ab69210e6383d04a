//! Numbers as the user interface shows them.

use lightfall_core::optics::readout::units::Units;

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

/// The length of a scale bar in r_s, at most `longest`, and in words: a round number of `units`. `None`
/// if `longest` is far from every length of a scene.
pub(crate) fn scale_bar(longest: f64, units: Units) -> Option<(f64, String)> {
    let units_per_length = match units {
        Units::Hole => 1.0,
        Units::Everyday(mass) => mass.metres() / 1000.0,
    };
    let length = round_number(longest * units_per_length)? / units_per_length;
    Some((length, units.length(length, four_decimals)))
}

/// The largest of 1, 2, 5, 10, ... and of 0.5, 0.2, 0.1, ... that is at most `longest`.
fn round_number(longest: f64) -> Option<f64> {
    if !(1e-12..1e20).contains(&longest) {
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
