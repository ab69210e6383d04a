//! A ship and its motion, with the error of the flight.

use super::coast::{Coast, geodesic};
use super::motion::State;
use super::vectors::{deviation, largest, orthonormal, spatial};
use super::{Place, ShipError, VectorConstants};
use crate::geometry::kerr::Kerr;
use crate::geometry::timelike::{Geodesic, Limit};
use glam::{DMat3, DMat4, DVec3, DVec4, Vec4Swizzles};

/// Largest difference of the last two entries of a step's tableau, relative to the largest
/// component of the axes. Since a step is added up apart from its start, rounding alone makes it
/// less. Balances are ten times better than with 1e-13, for 12 % more evaluations.
pub const DEFAULT_TOLERANCE: f64 = 3e-15;

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

/// A ship: its place, its axes, its clock, and the error of its flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ship {
    pub(super) kerr: Kerr,
    pub(super) state: State,
    pub(super) proper_time: f64,
    /// The smallest and the largest radius of the flight, in r_s.
    pub(super) limits: [f64; 2],
    pub(super) tolerance: f64,
    /// The length of the step to try next, in r_s.
    pub(super) next_step: f64,
    pub(super) coast: Option<Coast>,
    pub(super) error: FlightError,
    /// E, L and K' at the start.
    pub(super) start: DVec3,
    pub(super) evaluations: u64,
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
