//! Bisection.

/// The ends of an interval after so many halvings, each of which keeps the half between a place for
/// which `is_low` and one for which it does not hold.
pub fn bisection(ends: [f64; 2], halvings: u32, is_low: impl Fn(f64) -> bool) -> [f64; 2] {
    let [mut low, mut high] = ends;
    for _ in 0..halvings {
        let middle = 0.5 * (low + high);
        if is_low(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    [low, high]
}
