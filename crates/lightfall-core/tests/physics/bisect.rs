//! Bisection.

/// Where `inside` changes from true to false between `low` (true) and `high` (false), to the last
/// bit.
pub fn bisect(mut low: f64, mut high: f64, inside: impl Fn(f64) -> bool) -> f64 {
    assert!(
        inside(low) && !inside(high),
        "no change between {low} and {high}"
    );
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low.min(high) || middle >= low.max(high) {
            return middle;
        }
        if inside(middle) {
            low = middle
        } else {
            high = middle
        }
    }
}
