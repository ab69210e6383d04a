//! Whole numbers of the command line.

/// Reads a whole number from `low` to `high`.
pub(super) fn whole_number<T: TryFrom<u64>>(
    low: u64,
    high: u64,
) -> impl Fn(&str) -> Result<T, String> + Clone {
    move |text: &str| {
        text.parse()
            .ok()
            .filter(|number| (low..=high).contains(number))
            .and_then(|number| T::try_from(number).ok())
            .ok_or_else(|| format!("it must be a whole number from {low} to {high}"))
    }
}
