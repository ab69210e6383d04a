//! Numbers as text, for people.

/// A number to two or three significant digits. NaN, which stands for a missing value, is empty.
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

/// The numbers that may be meant by a text with commas and that are `allowed`, in words: a decimal comma
/// is a point, and commas between groups of three digits are nothing. `2,5` is `2.5`, `1,000,000` is
/// `1000000`, and `1,000` is `1.000 or 1000`. `None` if there is no such number.
pub fn number_with_comma(text: &str, allowed: impl Fn(f64) -> bool) -> Option<String> {
    if !text.contains(',') {
        return None;
    }
    let mut groups = text.split(',');
    let leading = groups.next()?.trim_start_matches(['-', '+']);
    let are_thousands = (1..=3).contains(&leading.len())
        && !leading.starts_with('0')
        && groups.all(|group| group.len() == 3);
    let whole = are_thousands.then(|| text.replace(',', ""));
    let meant: Vec<_> = [Some(text.replacen(',', ".", 1)), whole]
        .into_iter()
        .flatten()
        .filter(|text| text.parse().is_ok_and(&allowed))
        .collect();
    (!meant.is_empty()).then(|| meant.join(" or "))
}

/// A number of things, e.g. `1 ray` or `2 rays`.
pub fn counted(number: usize, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{plural}")
}

/// How many times as large one measured number is as another: to two significant digits, or whole.
pub fn ratio(ratio: f64) -> String {
    let digits = match ratio {
        _ if ratio < 1.0 => 2,
        _ if ratio < 10.0 => 1,
        _ => 0,
    };
    format!("{ratio:.digits$}")
}

/// The significant digits of a number in a sentence for people.
const DIGITS: i32 = 4;

/// A number with at most four significant digits, without zeros at its end, e.g. `20`, `1.12` or
/// `0.3257`. For sentences.
pub fn four_digits(number: f64) -> String {
    if number == 0.0 {
        "0".into()
    } else if (1e-3..1e6).contains(&number.abs()) {
        format!("{}", Side::Nearest.round(number))
    } else {
        format!("{number:.2e}")
    }
}

/// A number with one decimal, e.g. `-3.2`. Zero has no sign, nor has what is rounded to zero.
pub fn one_decimal(number: f64) -> String {
    // Adding zero removes the sign of a negative zero.
    format!("{:.1}", (10.0 * number).round() / 10.0 + 0.0)
}

/// A spin with at most four significant digits, or with all of them where it would be rounded to
/// one, which no hole has.
pub fn spin_digits(spin: f64) -> String {
    let digits = four_digits(spin);
    if digits.trim_start_matches('-') == "1" {
        format!("{spin}")
    } else {
        digits
    }
}

/// As [`four_digits`], with at most three, for numbers of which the size alone counts.
pub fn three_digits(number: f64) -> String {
    if number == 0.0 || !number.is_finite() {
        return four_digits(number);
    }
    let scale = 10_f64.powi(2 - number.abs().log10().floor() as i32);
    four_digits((number * scale).round() / scale)
}

/// Seconds of a Julian year.
pub const YEAR: f64 = 365.25 * 86_400.0;

/// A time in the unit that gives it the shortest number, with at most three digits, e.g. `2.82
/// minutes` or `1 year`. Years are Julian years.
pub fn duration_in_words(seconds: f64) -> String {
    const UNITS: [(f64, [&str; 2]); 6] = [
        (YEAR, ["year", "years"]),
        (86_400.0, ["day", "days"]),
        (3600.0, ["hour", "hours"]),
        (60.0, ["minute", "minutes"]),
        (1.0, ["s", "s"]),
        (1e-3, ["ms", "ms"]),
    ];
    let largest = UNITS.iter().find(|(unit, _)| seconds.abs() >= *unit);
    let (unit, [one, many]) = largest.unwrap_or(&(1.0, ["s", "s"]));
    let number = three_digits(seconds / unit);
    let name = if number == "1" { one } else { many };
    format!("{number} {name}")
}

/// A share in whole per cent, e.g. `72 %`. Only zero itself is `0 %`.
pub fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent > 0.0 && percent < 1.0 {
        "less than 1 %".into()
    } else {
        format!("{percent:.0} %")
    }
}

/// Words for the size of a number.
const SIZES: [(f64, &str); 3] = [(1e12, "trillion"), (1e9, "billion"), (1e6, "million")];

/// A computed value with at most four digits and a word for its size, such as `25.4 million`.
pub fn in_words(number: f64) -> String {
    let size = SIZES.into_iter().find(|(size, _)| number.abs() >= *size);
    match size {
        Some((size, word)) => format!("{} {word}", four_digits(number / size)),
        None => four_digits(number),
    }
}

/// The number that [`in_words`] writes, or `None` for another text.
pub fn from_words(text: &str) -> Option<f64> {
    let mut words = text.split_whitespace();
    let number: f64 = words.next()?.parse().ok()?;
    let word = words.next().unwrap_or_default();
    let size = SIZES.into_iter().find(|(_, name)| *name == word);
    Some(number * size.map_or(1.0, |(size, _)| size))
}

/// A number with four digits, zeros included, e.g. `20.00` or `0.912`. For read-outs that change
/// while they are read: their width stays the same.
pub fn steady_digits(number: f64) -> String {
    let size = number.abs();
    if !(size == 0.0 || (1e-3..1e6).contains(&size)) {
        return format!("{number:.2e}");
    }
    // Below one, the zero before the point counts, so that 0.900 is as wide as 1.100.
    let decimals = (DIGITS - 1 - size.max(1.0).log10().floor() as i32).max(0) as usize;
    let shown = format!("{number:.decimals$}");
    // Rounding up to the next power of ten adds a digit: 9.9996 is 10.00.
    if shown.trim_start_matches('-').len() > DIGITS as usize + 1 && decimals > 0 {
        format!("{number:.*}", decimals - 1)
    } else if size >= 1e4 {
        let unit = 10_f64.powi(size.log10().floor() as i32 + 1 - DIGITS);
        format!("{}", (number / unit).round() * unit)
    } else {
        shown
    }
}

/// A text with its numbers rounded to four significant digits. A number after a word for a lower
/// limit, such as `above`, is rounded up, and after one for an upper limit down, so that the
/// rounded limit is still allowed. Words that only contain digits stay as they are.
pub fn with_short_numbers(text: &str) -> String {
    let mut side = Side::Nearest;
    let words = text.split_inclusive(' ').map(|word| {
        let bare = word.trim_end_matches([' ', ',', ')', ';', '.', ']']);
        let start = bare.len() - bare.trim_start_matches(['(', '[']).len();
        let (open, digits, rest) = (&word[..start], &bare[start..], &word[bare.len()..]);
        let number = digits.parse::<f64>().ok().filter(|n| n.is_finite());
        let rounded = number.filter(|_| significant(digits) > DIGITS as usize);
        let shown = rounded.map(|number| format!("{open}{}{rest}", side.round(number)));
        side = Side::after(bare);
        shown.unwrap_or_else(|| word.to_owned())
    });
    words.collect()
}

/// The significant digits of a number as it is written.
fn significant(digits: &str) -> usize {
    let mantissa = digits.split(['e', 'E']).next().unwrap_or(digits);
    let figures: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    let figures = figures.trim_start_matches('0');
    if mantissa.contains('.') {
        figures.len()
    } else {
        figures.trim_end_matches('0').len()
    }
}

/// To which side a number in a sentence is rounded.
#[derive(Clone, Copy)]
enum Side {
    Nearest,
    Up,
    Down,
}

impl Side {
    fn after(word: &str) -> Self {
        match word {
            "from" | "above" | "least" | "than" => Self::Up,
            "to" | "most" | "below" => Self::Down,
            _ => Self::Nearest,
        }
    }

    /// The number with four significant digits.
    fn round(self, number: f64) -> f64 {
        if number == 0.0 {
            return number;
        }
        let scale = 10_f64.powi(DIGITS - 1 - number.abs().log10().floor() as i32);
        let scaled = number * scale;
        let whole = match self {
            Self::Nearest => scaled.round(),
            Self::Up => scaled.ceil(),
            Self::Down => scaled.floor(),
        };
        whole / scale
    }
}
