//! The quantities of a journey, and their tracks through its keyframes.

use super::ease::Ease;
use super::keyframe::Values;
use super::track::Track;
use crate::geometry::sphere::wrap_degrees;
use crate::scene::Scene;
use crate::scene::value::Value;

/// A number of a scene that keyframes may lead.
struct Quantity {
    /// Its name in a keyframe. The components of the velocity share one.
    name: &'static str,
    /// Which component of the keyframe's value it is; 0 for a value that is a number.
    component: usize,
    way: Way,
    /// Its place in a scene.
    place: fn(&mut Scene) -> &mut f64,
}

/// How a quantity is interpolated.
enum Way {
    /// As it is.
    Plain,
    /// In its logarithm.
    Logarithm,
    /// As an angle in degrees, whose whole turns are left out afterwards.
    Turns,
}

impl Way {
    /// The number whose track leads a quantity of this value.
    fn led(&self, value: f64) -> f64 {
        match self {
            Self::Logarithm => value.ln(),
            Self::Plain | Self::Turns => value,
        }
    }
}

const fn quantity(name: &'static str, way: Way, place: fn(&mut Scene) -> &mut f64) -> Quantity {
    Quantity {
        name,
        component: 0,
        way,
        place,
    }
}

const QUANTITIES: [Quantity; 12] = [
    quantity("r", Way::Logarithm, |scene| &mut scene.camera.r),
    quantity("theta_deg", Way::Plain, |scene| &mut scene.camera.theta_deg),
    quantity("phi_deg", Way::Turns, |scene| &mut scene.camera.phi_deg),
    quantity("yaw_deg", Way::Turns, |scene| &mut scene.camera.yaw_deg),
    quantity("pitch_deg", Way::Turns, |scene| &mut scene.camera.pitch_deg),
    quantity("roll_deg", Way::Turns, |scene| &mut scene.camera.roll_deg),
    quantity("fov_deg", Way::Plain, |scene| &mut scene.camera.fov_deg),
    quantity("velocity", Way::Plain, |scene| {
        &mut scene.observer.velocity[0]
    }),
    Quantity {
        component: 1,
        ..quantity("velocity", Way::Plain, |scene| {
            &mut scene.observer.velocity[1]
        })
    },
    Quantity {
        component: 2,
        ..quantity("velocity", Way::Plain, |scene| {
            &mut scene.observer.velocity[2]
        })
    },
    quantity("disk_tilt_deg", Way::Plain, |scene| {
        &mut scene.disk.tilt_deg
    }),
    quantity("disk_node_deg", Way::Turns, |scene| {
        &mut scene.disk.node_deg
    }),
];

/// The tracks of all quantities; none for a quantity that no keyframe names.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Tracks([Option<Track>; QUANTITIES.len()]);

impl Tracks {
    /// The tracks through keyframes, each with its time in seconds after the beginning.
    pub(super) fn through(keyframes: &[(f64, Ease, &Values)]) -> Self {
        Self(QUANTITIES.map(|quantity| {
            let point = |(time, ease, values): &(f64, Ease, &Values)| {
                let value = component(values.get(quantity.name)?, quantity.component)?;
                Some(((*time, quantity.way.led(value)), *ease))
            };
            let (points, eases): (Vec<_>, Vec<_>) = keyframes.iter().filter_map(point).unzip();
            Track::eased(&points, |i| eases[i])
        }))
    }

    /// The tracks along a camera path. `points` gives those of a quantity by its name and component.
    pub(super) fn along(points: impl Fn(&str, usize) -> Vec<(f64, f64)>) -> Self {
        Self(QUANTITIES.map(|quantity| {
            let mut points = points(quantity.name, quantity.component);
            for (_, value) in &mut points {
                *value = quantity.way.led(*value);
            }
            Track::along(&points)
        }))
    }

    /// The track of the quantity with this name, of the velocity's first component; none if no
    /// keyframe names it.
    pub(super) fn of(&self, name: &str) -> Option<&Track> {
        let place = QUANTITIES.iter().position(|quantity| quantity.name == name);
        self.0[place?].as_ref()
    }

    /// Writes the quantities after `time` seconds into a scene.
    pub(super) fn apply(&self, time: f64, scene: &mut Scene) {
        for (quantity, track) in QUANTITIES.iter().zip(&self.0) {
            if let Some(track) = track {
                let value = track.at(time);
                *(quantity.place)(scene) = match quantity.way {
                    Way::Plain => value,
                    Way::Logarithm => value.exp(),
                    Way::Turns => wrap_degrees(value),
                };
            }
        }
    }
}

/// Whether a velocity may reach that of light between two keyframes or rows that have these: each component
/// stays between its two values, so all three at their largest must be slower than light.
pub(super) fn may_reach_light(start: [f64; 3], end: [f64; 3]) -> bool {
    let largest = |axis: usize| start[axis].abs().max(end[axis].abs());
    (0..3).map(|axis| largest(axis).powi(2)).sum::<f64>() >= 1.0
}

/// A component of a velocity, or a number.
pub(super) fn component(value: &Value, component: usize) -> Option<f64> {
    match value {
        Value::Velocity(components) => Some(components[component]),
        number => number.number(),
    }
}
