//! The lowest and the highest point of the orbit on which a ship would coast.

use lightfall_model::geometry::bisection::bisection;
use lightfall_model::geometry::ship::Ship;
use lightfall_model::geometry::timelike::Limit;

/// Number of halvings that find a root to its last digit.
const HALVINGS: u32 = 100;

/// An orbit whose turning points differ by less, as a share of the radius, counts as a circle: there
/// rounding decides where the next one is. At the innermost stable orbit, a root of third degree, rounding
/// makes it the cubic root of 1e-16.
const CIRCLE: f64 = 1e-4;

/// The same for a round orbit, on which turning points do not show.
const ROUND: f64 = 0.01;

/// The turning points of a free motion, in r_s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apsides {
    /// The lowest radius; `None` for a ship that falls in if it only coasts, or fell in.
    pub periapsis: Option<f64>,
    /// The highest radius; `None` for a ship that comes away, or fell in.
    pub apoapsis: Option<f64>,
}

impl Apsides {
    /// The turning points of the ship's motion with its engine off.
    ///
    /// u'^2 = U(u) as in [`timelike`](lightfall_model::geometry::timelike), a polynomial of fourth
    /// degree. It is expanded about the present u, where it is u'^2 and so never negative by rounding:
    /// so both turning points of a nearly circular orbit are found.
    pub fn of(ship: &Ship) -> Self {
        let (kerr, place) = (ship.kerr(), ship.place());
        if place.r <= kerr.horizon() {
            return Self {
                periapsis: None,
                apoapsis: None,
            };
        }
        let constants = ship.constants();
        let (a, energy) = (kerr.a(), constants.energy);
        let k_prime = constants.k_prime(&place);
        let b = a * (a * energy - constants.angular_momentum);
        let u = 1.0 / place.r;
        let slope = constants.radial * u * u;
        let potential = [
            (energy - 1.0) * (energy + 1.0),
            1.0,
            2.0 * energy * b - a * a - k_prime,
            k_prime,
            b * b - a * a * k_prime,
        ];
        let mut shifted = about(potential, u);
        shifted[0] = slope * slope;
        let radius = |s: f64| 1.0 / (u + s);
        Self {
            periapsis: nearest_end(&shifted, 1.0 / kerr.horizon() - u).map(radius),
            apoapsis: nearest_end(&shifted, -u).map(radius),
        }
    }

    /// Whether the orbit is so round that turning points are not worth a mark: they differ by less than
    /// a hundredth of the radius.
    pub fn are_round(&self) -> bool {
        self.differ_by_less_than(ROUND)
    }

    /// Whether there are two that differ by less than this share of the radius.
    fn differ_by_less_than(&self, share: f64) -> bool {
        match (self.periapsis, self.apoapsis) {
            (Some(low), Some(high)) => high - low < share * high,
            _ => false,
        }
    }
}

/// The coefficients of a polynomial about `x`: Horner's shift.
fn about(mut c: [f64; 5], x: f64) -> [f64; 5] {
    for low in 0..4 {
        for i in (low..4).rev() {
            c[i] += c[i + 1] * x;
        }
    }
    c
}

fn value(c: &[f64], x: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// The nearest place to zero, on the way to `end`, beyond which a polynomial that is not negative at
/// zero is negative. `None` if there is none.
fn nearest_end(c: &[f64], end: f64) -> Option<f64> {
    let mut from = 0.0;
    for to in extrema(c, end).into_iter().chain([end]) {
        if value(c, to) < 0.0 {
            let [low, high] = bisection([from, to], HALVINGS, |x| value(c, x) >= 0.0);
            return Some(0.5 * (low + high));
        }
        from = to;
    }
    None
}

/// The places between zero and `end`, in this order, where a polynomial's slope changes its sign.
fn extrema(c: &[f64], end: f64) -> Vec<f64> {
    let slope: Vec<f64> = c
        .iter()
        .enumerate()
        .skip(1)
        .map(|(k, c)| k as f64 * c)
        .collect();
    if slope.len() < 2 {
        return Vec::new();
    }
    let mut found = Vec::new();
    let mut from = 0.0;
    for to in extrema(&slope, end).into_iter().chain([end]) {
        let is_low = value(&slope, from) < 0.0;
        if is_low != (value(&slope, to) < 0.0) {
            let [low, high] =
                bisection([from, to], HALVINGS, |x| (value(&slope, x) < 0.0) == is_low);
            found.push(0.5 * (low + high));
        }
        from = to;
    }
    found
}

/// The proper time until a ship that coasts reaches its next turning point, in r_s/c. `None` if it
/// reaches a limit of its flight before, moves on a circle, or goes round more than ten times before.
pub fn time_to_apsis(ship: &Ship) -> Option<f64> {
    if Apsides::of(ship).differ_by_less_than(CIRCLE) {
        return None;
    }
    let mut geodesic = ship.geodesic();
    let start = geodesic.state.proper_time;
    match geodesic.advance_to_apsis(ship.limits()) {
        None => Some(geodesic.state.proper_time - start),
        Some(Limit::Inner | Limit::Outer | Limit::Lost) => None,
    }
}
