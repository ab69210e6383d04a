//! A ship and its motion, with the error of the flight.

use super::extrapolation::{Step, evaluations, step};
use super::motion::{AXES, NUMBERS, PLACE, State};
use super::vectors::{axes, carried_to, minkowski, orthonormal};
use super::{Place, ShipError, VectorConstants};
use crate::geometry::kerr::Kerr;
use crate::geometry::timelike::{Geodesic, Limit};
use glam::{DMat3, DMat4, DVec3, DVec4, Vec4Swizzles};

/// Largest difference of the last two entries of a step's tableau, relative to the largest
/// component of the axes. Since a step is added up apart from its start, rounding alone makes it
/// less. Balances are ten times better than with 1e-13, for 12 % more evaluations.
pub const DEFAULT_TOLERANCE: f64 = 3e-15;

/// How much longer the next step is tried where one converged before the last row.
const GROWTH: f64 = 1.5;

/// The number of rows from which on the next step is not tried longer.
const ROWS_TO_GROW: usize = 5;

/// Maximum number of halvings of one step. No motion outside the inner horizon needs as many.
const MAX_HALVINGS: u32 = 60;

/// Number of halvings that find where a step meets a limit, to the last digit.
const LIMIT_HALVINGS: u32 = 60;

/// Largest deviation of axes from orthonormal ones that counts as rounding, per square of their
/// largest component.
const MAX_DEVIATION: f64 = 1e-9;

/// What the pilot sets: both vectors are on the ship's axes, and constant until they are set anew.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Controls {
    /// Proper acceleration, in c^2/r_s.
    pub acceleration: DVec3,
    /// Rotation relative to the ship's gyroscopes, right-handed, in radians per r_s/c of the ship's
    /// own time.
    pub rotation: DVec3,
}

/// The error of a flight so far, measured in several ways. All are sums of absolute values over the
/// flight, so nothing cancels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FlightError {
    /// Differences of the last two entries of each step's tableau in the axes, relative to the
    /// largest component.
    pub axes: f64,
    /// The same in the place, relative to r.
    pub place: f64,
    /// |u.u + 1| that each step left before the axes were made orthonormal again.
    pub norm: f64,
    /// With the engine off, the difference between the integrated four-velocity and that of the
    /// geodesic, relative to the largest component of the axes: an independent measure.
    pub geodesic: f64,
}

impl FlightError {
    /// The error in one number: the larger of axes and place.
    pub fn stated(&self) -> f64 {
        self.axes.max(self.place)
    }
}

/// The motion with the engine off.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Coast {
    geodesic: Geodesic,
    /// T plus r minus the geodesic's ingoing time.
    time: f64,
}

/// A ship: its place, its axes, its clock, and the error of its flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ship {
    kerr: Kerr,
    state: State,
    proper_time: f64,
    /// The smallest and the largest radius of the flight, in r_s.
    limits: [f64; 2],
    tolerance: f64,
    /// The length of the step to try next, in r_s.
    next_step: f64,
    coast: Option<Coast>,
    error: FlightError,
    /// E, L and K' at the start.
    start: DVec3,
    evaluations: u64,
}

impl Ship {
    /// A ship at `place` at the time `time` (T, in r_s), with the axes `frame`: the columns are the
    /// four-velocity and three right-handed axes, on the Kerr-Schild frame. Its flight ends at the
    /// radii `limits` (r_s).
    ///
    /// # Errors
    /// The place lies outside the limits, or the axes are not orthonormal.
    pub fn new(
        place: &Place,
        time: f64,
        frame: &DMat4,
        limits: [f64; 2],
    ) -> Result<Self, ShipError> {
        let [inner, outer] = limits;
        if !(place.r >= inner && place.r <= outer) {
            let r = place.r;
            return Err(ShipError::Place { r, inner, outer });
        }
        let by = deviation(frame);
        let size = largest(frame);
        if !(by <= MAX_DEVIATION * size * size && time.is_finite()) {
            return Err(ShipError::Axes { by });
        }
        let frame = orthonormal(frame);
        let constants = constants(place, frame.x_axis);
        Ok(Self {
            kerr: place.kerr,
            state: State {
                place: DVec4::from((time, place.position)),
                frame,
                work: DVec3::ZERO,
            },
            proper_time: 0.0,
            limits,
            tolerance: DEFAULT_TOLERANCE,
            next_step: f64::INFINITY,
            coast: None,
            error: FlightError::default(),
            start: constants,
            evaluations: 0,
        })
    }

    /// The same ship with steps of another tolerance, in place of [`DEFAULT_TOLERANCE`].
    ///
    /// # Errors
    /// The tolerance is not between rounding and a thousandth.
    pub fn with_tolerance(mut self, tolerance: f64) -> Result<Self, ShipError> {
        if !(1e-15..=1e-3).contains(&tolerance) {
            return Err(ShipError::Tolerance(tolerance));
        }
        self.tolerance = tolerance;
        Ok(self)
    }

    /// The hole.
    pub fn kerr(&self) -> Kerr {
        self.kerr
    }

    /// Where the ship is.
    pub fn place(&self) -> Place {
        match &self.coast {
            Some(coast) => coast.place(self.kerr),
            None => Place::new(self.kerr, self.state.place.yzw()),
        }
    }

    /// T = v - r, in r_s/c.
    pub fn time(&self) -> f64 {
        self.state.place.x
    }

    /// The ship's own clock since the start, in r_s/c.
    pub fn proper_time(&self) -> f64 {
        self.proper_time
    }

    /// The four-velocity and the three axes on the Kerr-Schild frame, one per column.
    pub fn frame(&self) -> DMat4 {
        self.state.frame
    }

    /// The four-velocity on the Kerr-Schild frame.
    pub fn velocity(&self) -> DVec4 {
        self.state.frame.x_axis
    }

    /// The ship's constants of the motion: E, L and the rest, per unit mass.
    pub fn constants(&self) -> VectorConstants {
        VectorConstants::new(&self.place(), self.velocity())
    }

    /// The radii at which the flight ends, in r_s.
    pub fn limits(&self) -> [f64; 2] {
        self.limits
    }

    /// The geodesic on which the ship coasts, or would coast.
    pub fn geodesic(&self) -> Geodesic {
        let place = self.place();
        match &self.coast {
            Some(coast) => coast.geodesic,
            None => geodesic(&place, self.velocity()),
        }
    }

    /// The error of the flight so far.
    pub fn error(&self) -> FlightError {
        self.error
    }

    /// E, L and K' now, minus those at the start and minus what the engine added. Zero but for
    /// errors.
    pub fn balance(&self) -> [f64; 3] {
        (constants(&self.place(), self.velocity()) - self.start - self.state.work).to_array()
    }

    /// How often the equations of motion were evaluated so far.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// The axes turned at once, which costs nothing: the columns of `rotation` are the new axes on
    /// the old ones.
    pub fn turn(&mut self, rotation: DMat3) {
        self.state.frame = orthonormal(&(self.state.frame * spatial(rotation)));
    }

    /// Advances the ship by `proper_time` (r_s/c, not negative). If it reaches one of its limits
    /// earlier, it stays there.
    ///
    /// With the engine off, place and velocity are those of the geodesic, and the axes are
    /// integrated beside it.
    ///
    /// # Errors
    /// The controls or the time are not finite, or time runs backward.
    pub fn advance(
        &mut self,
        controls: &Controls,
        proper_time: f64,
    ) -> Result<Option<Limit>, ShipError> {
        for (what, vector) in [
            ("acceleration", controls.acceleration),
            ("rotation", controls.rotation),
        ] {
            if !vector.is_finite() {
                let given = vector.to_array();
                return Err(ShipError::Controls { what, given });
            }
        }
        if !(proper_time >= 0.0 && proper_time.is_finite()) {
            return Err(ShipError::Duration(proper_time));
        }
        Ok(if controls.acceleration == DVec3::ZERO {
            self.coast(controls, proper_time)
        } else {
            self.coast = None;
            self.fly(controls, proper_time)
        })
    }

    fn coast(&mut self, controls: &Controls, proper_time: f64) -> Option<Limit> {
        let mut coast = match self.coast {
            Some(coast) => coast,
            None => Coast::new(&self.place(), self.time(), self.velocity()),
        };
        let before = coast.geodesic.state.proper_time;
        let mut limit = coast.geodesic.advance(proper_time, self.limits);
        let passed = coast.geodesic.state.proper_time - before;
        // The axes go as far as the geodesic does, and past no limit of their own.
        let own_limits = std::mem::replace(&mut self.limits, [0.0, f64::INFINITY]);
        let lost = self.fly(controls, passed);
        self.limits = own_limits;
        limit = limit.or(lost);
        let place = coast.place(self.kerr);
        let u = coast.velocity(&place);
        let difference = largest_of((self.velocity() - u).to_array());
        self.error.geodesic += difference / largest(&self.state.frame);
        self.state.frame = carried_to(&self.state.frame, u);
        self.state.place = DVec4::from((coast.time(place.r), place.position));
        self.coast = Some(coast);
        limit
    }

    /// Integrates the equations of motion.
    fn fly(&mut self, controls: &Controls, proper_time: f64) -> Option<Limit> {
        let mut left = proper_time;
        loop {
            let place = Place::new(self.kerr, self.state.place.yzw());
            if let Some(limit) = self.limit_at(&place) {
                return Some(limit);
            }
            if left <= 0.0 {
                return None;
            }
            let Some((length, step)) = self.converged_step(&place, controls, left) else {
                return Some(Limit::Lost);
            };
            if self.is_within_limits(&step) {
                self.accept(length, &step);
                left = if length < left { left - length } else { 0.0 };
            } else {
                let (length, step) = self.step_to_limit(controls, length)?;
                self.accept(length, &step);
                let inward = step_radius(self.kerr, &step) < place.r;
                return Some(if inward { Limit::Inner } else { Limit::Outer });
            }
        }
    }

    /// The limit that the ship has reached, if it moves toward it.
    fn limit_at(&self, place: &Place) -> Option<Limit> {
        const ROUNDING: f64 = 1e-12;
        let [inner, outer] = self.limits;
        let radial = VectorConstants::new(place, self.velocity()).radial;
        if place.r <= inner * (1.0 + ROUNDING) && radial <= 0.0 {
            Some(Limit::Inner)
        } else if place.r >= outer * (1.0 - ROUNDING) && radial >= 0.0 {
            Some(Limit::Outer)
        } else {
            None
        }
    }

    fn is_within_limits(&self, step: &Step<NUMBERS>) -> bool {
        let r = step_radius(self.kerr, step);
        r >= self.limits[0] && r <= self.limits[1]
    }

    /// The longest step that converges, of those that are the next one's length or its halves.
    fn converged_step(
        &mut self,
        place: &Place,
        controls: &Controls,
        left: f64,
    ) -> Option<(f64, Step<NUMBERS>)> {
        // A sixth of the time of a turn at this radius, about.
        let most = if self.next_step.is_finite() {
            self.next_step
        } else {
            place.r * place.r.sqrt()
        };
        let mut length = most.min(left);
        for _ in 0..MAX_HALVINGS {
            if let Some(step) = self.try_step(controls, length) {
                let next = if step.rows <= ROWS_TO_GROW {
                    GROWTH * length
                } else {
                    length
                };
                // A step that the end of the time made short says nothing about a longer one.
                self.next_step = if length < most.min(left) {
                    next
                } else {
                    next.max(most)
                };
                return Some((length, step));
            }
            length *= 0.5;
        }
        None
    }

    fn try_step(&mut self, controls: &Controls, length: f64) -> Option<Step<NUMBERS>> {
        let kerr = self.kerr;
        let limit = self.tolerance * (1.0 + largest(&self.state.frame));
        let mut numbers = self.state.numbers();
        // No rate depends on the time, which is added without loss of its last digits.
        numbers[0] = 0.0;
        let rate =
            |numbers: &[f64; NUMBERS]| State::of_numbers(numbers).rate(kerr, controls).numbers();
        let agree = |last: &[f64; NUMBERS], before: &[f64; NUMBERS]| {
            AXES.clone().all(|i| (last[i] - before[i]).abs() < limit)
        };
        let step = step(&numbers, length, rate, agree);
        let rows = step
            .as_ref()
            .map_or(super::extrapolation::MAX_ROWS, |step| step.rows);
        self.evaluations += evaluations(rows);
        step
    }

    /// The step that ends at a limit: by bisection of its length, on the near side. `None` if the
    /// steps do not converge.
    fn step_to_limit(&mut self, controls: &Controls, length: f64) -> Option<(f64, Step<NUMBERS>)> {
        let (mut low, mut high) = (0.0, length);
        let mut found = None;
        for _ in 0..LIMIT_HALVINGS {
            let middle = 0.5 * (low + high);
            match self.try_step(controls, middle) {
                Some(step) if self.is_within_limits(&step) => {
                    low = middle;
                    found = Some((middle, step));
                }
                _ => high = middle,
            }
        }
        found
    }

    /// Takes a step, and adds up its error.
    fn accept(&mut self, length: f64, step: &Step<NUMBERS>) {
        let mut end = State::of_numbers(&step.end);
        let difference = |range: std::ops::Range<usize>| {
            step.difference[range].iter().copied().fold(0.0, f64::max)
        };
        self.error.axes += difference(AXES) / largest(&end.frame);
        self.error.place += difference(PLACE) / end.place.yzw().length();
        self.error.norm += (minkowski(end.frame.x_axis, end.frame.x_axis) + 1.0).abs();
        end.place.x += self.state.place.x;
        end.frame = orthonormal(&end.frame);
        self.state = end;
        self.proper_time += length;
    }
}

impl Coast {
    fn new(place: &Place, time: f64, u: DVec4) -> Self {
        Self {
            geodesic: geodesic(place, u),
            time: time + place.r,
        }
    }

    fn place(&self, kerr: Kerr) -> Place {
        let state = &self.geodesic.state;
        Place::at(kerr, 1.0 / state.u, self.turned(state.n))
    }

    /// The four-velocity on the Kerr-Schild frame.
    fn velocity(&self, place: &Place) -> DVec4 {
        let Geodesic { constants, state } = &self.geodesic;
        VectorConstants {
            energy: constants.energy,
            angular_momentum: constants.angular_momentum,
            radial: -state.du * place.r * place.r,
            w: self.turned(state.dn),
            mass2: 1.0,
        }
        .vector(place)
    }

    fn time(&self, r: f64) -> f64 {
        self.time + self.geodesic.state.ingoing_time - r
    }

    /// A vector of the celestial sphere with Kerr's ingoing azimuth, of one with the azimuth psi.
    fn turned(&self, v: DVec3) -> DVec3 {
        DMat3::from_rotation_z(self.geodesic.state.chi) * v
    }
}

fn geodesic(place: &Place, u: DVec4) -> Geodesic {
    let photon = VectorConstants::new(place, u).photon(place);
    Geodesic::new(place.kerr, &photon, place.r, place.n, 0.0)
}

/// E, L and K' of the four-velocity `u`.
fn constants(place: &Place, u: DVec4) -> DVec3 {
    let constants = VectorConstants::new(place, u);
    DVec3::new(
        constants.energy,
        constants.angular_momentum,
        constants.k_prime(place),
    )
}

fn step_radius(kerr: Kerr, step: &Step<NUMBERS>) -> f64 {
    let [x, y, z] = [1, 2, 3].map(|i| step.end[i]);
    Place::new(kerr, DVec3::new(x, y, z)).r
}

/// A rotation as a transformation that leaves the four-velocity.
fn spatial(rotation: DMat3) -> DMat4 {
    let column = |i: usize| DVec4::from((0.0, rotation.col(i)));
    DMat4::from_cols(DVec4::X, column(0), column(1), column(2))
}

/// How far the axes are from orthonormal ones, with the first along time and to the future.
fn deviation(frame: &DMat4) -> f64 {
    let axes = axes(frame);
    let mut most = if axes[0].x > 0.0 { 0.0 } else { f64::INFINITY };
    for i in 0..4 {
        for j in 0..=i {
            let product = match (i, j) {
                (0, 0) => -1.0,
                (i, j) if i == j => 1.0,
                _ => 0.0,
            };
            most = f64::max(most, (minkowski(axes[i], axes[j]) - product).abs());
        }
    }
    // A component that is not a number makes no product a number.
    if frame.is_finite() { most } else { f64::NAN }
}

/// The largest component of the axes, which is at least one.
fn largest(frame: &DMat4) -> f64 {
    largest_of(frame.to_cols_array())
}

fn largest_of<const N: usize>(numbers: [f64; N]) -> f64 {
    numbers.into_iter().fold(0.0, |most, x| most.max(x.abs()))
}
