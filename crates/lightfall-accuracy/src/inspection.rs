//! Everything about one ray, as numbers that can be read, copied and compared: the contents of the
//! ray inspector.

use crate::{Ray, Truth, greater};
use glam::DVec3;
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::scene::Scene;
use lightfall_optics::disk;
use lightfall_optics::disk::Profile;
use lightfall_optics::path::Path;
use lightfall_optics::ray_plane::RayPlane;
use lightfall_optics::reference::Reference;
use lightfall_optics::trace::{Hit, Outcome, Trace};
use serde::Serialize;
use std::f64::consts::PI;
use std::fmt::Write;

/// The numbers of one ray. Missing values are `None`; text leaves them out.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Inspection {
    /// The scene's name.
    pub scene: String,
    /// The pixel of the picture, from its upper left corner, in pixels.
    pub pixel: Option<[f64; 2]>,
    /// Looking direction on the observer's axes: outward.
    pub er: f64,
    /// Looking direction: toward increasing theta.
    pub etheta: f64,
    /// Looking direction: toward increasing phi.
    pub ephi: f64,
    /// The f64 reference's answer, in the fields of `lightfall trace`.
    pub cpu: Record,
    /// The GPU's answer, in the same fields.
    pub gpu: Option<Record>,
    /// b = sqrt(eta + lambda^2), in r_s.
    pub impact_parameter: Option<f64>,
    /// L/E, in r_s.
    pub lambda: Option<f64>,
    /// Q/E^2, in r_s^2.
    pub eta: Option<f64>,
    /// Angle by which gravity turns the light from the sky on its way to the camera, in radians:
    /// [`RayPlane::deflection`].
    pub deflection: Option<f64>,
    /// Smallest r along the ray, in r_s; that of the horizon for a captured ray.
    pub closest_r: f64,
    /// Angle swept about the hole up to what is seen first, in half-turns.
    pub half_turns: f64,
    /// Order of the image: whole half-turns.
    pub order: Option<u32>,
    /// Temperature of the matter at the first hit, in kelvin, for a disk without structure and hot
    /// spot.
    pub hit1_temperature_k: Option<f64>,
    /// Boyer-Lindquist time from the emission there to the camera, in r_s/c: `cpu.hit1_t` under
    /// its older name.
    pub hit1_delay: Option<f64>,
    /// As hit1_temperature_k, at the second hit.
    pub hit2_temperature_k: Option<f64>,
    /// As hit1_delay, at the second hit.
    pub hit2_delay: Option<f64>,
    /// The difference between the GPU's answer and the reference's.
    pub difference: Option<Difference>,
}

/// How far the GPU is from the reference, for one ray: see [`RayError`](crate::RayError).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// Whether both have the same outcome and the same number of hits.
    pub same_class: bool,
    /// Angle between the two directions at infinity, in radians.
    pub sky: Option<f64>,
    /// Largest relative difference of the hits' radii.
    pub hit_r: Option<f64>,
    /// Largest relative difference of the hits' g.
    pub hit_g: Option<f64>,
    /// Largest difference of the hits' delays, in r_s/c.
    pub hit_t: Option<f64>,
    /// The turn of the ray that explains the difference, in radians; `None` if no turn does.
    pub backward: Option<f64>,
    /// The same as a multiple of the angle that a pixel in the picture's middle covers.
    pub backward_px: Option<f64>,
}

/// A trace in the fields of `lightfall trace`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[expect(
    missing_docs,
    reason = "`lightfall trace --help` says what each field means"
)]
pub struct Record {
    pub outcome: Outcome,
    pub sky_x: Option<f64>,
    pub sky_y: Option<f64>,
    pub sky_z: Option<f64>,
    pub hit1_r: Option<f64>,
    pub hit1_phi: Option<f64>,
    pub hit1_g: Option<f64>,
    pub hit2_r: Option<f64>,
    pub hit2_phi: Option<f64>,
    pub hit2_g: Option<f64>,
    pub steps: u32,
    pub residual: f64,
    pub hit1_t: Option<f64>,
    pub hit2_t: Option<f64>,
}

impl From<&Trace> for Record {
    fn from(trace: &Trace) -> Self {
        let [first, second] = trace.hits;
        let of = |hit: Option<Hit>, part: fn(Hit) -> f64| hit.map(part);
        Self {
            outcome: trace.outcome,
            sky_x: trace.sky.map(|sky| sky.x),
            sky_y: trace.sky.map(|sky| sky.y),
            sky_z: trace.sky.map(|sky| sky.z),
            hit1_r: of(first, |hit| hit.r),
            hit1_phi: of(first, |hit| hit.phi),
            hit1_g: of(first, |hit| hit.g),
            hit2_r: of(second, |hit| hit.r),
            hit2_phi: of(second, |hit| hit.phi),
            hit2_g: of(second, |hit| hit.g),
            steps: trace.steps,
            residual: trace.residual,
            hit1_t: first.and_then(|hit| hit.delay),
            hit2_t: second.and_then(|hit| hit.delay),
        }
    }
}

/// A ray, inspected: its numbers and its path.
#[derive(Clone, Debug, PartialEq)]
pub struct Inspected {
    /// The numbers.
    pub numbers: Inspection,
    /// The path of the reference.
    pub path: Path,
    /// The path in its own plane.
    pub plane: RayPlane,
    /// The reference's trace.
    pub trace: Trace,
}

impl Inspected {
    /// Inspects the ray of `scene` that arrives from `direction`, on the observer's axes, a unit
    /// vector; the path goes as far out as `farthest`, in r_s.
    ///
    /// # Errors
    /// The scene's observer cannot exist.
    pub fn new(
        scene: &Scene,
        direction: DVec3,
        pixel: Option<[f64; 2]>,
        farthest: f64,
    ) -> Result<Self, ObserverError> {
        let reference = Reference::new(scene)?;
        let (cpu, path) = Path::of(&reference, direction, farthest);
        let plane = RayPlane::of(scene, &reference, direction, &cpu, &path);
        let (profile, lit) = (Profile::new(scene), disk::lit(scene));
        let temperature =
            |hit: Option<Hit>| hit.map(|hit| disk::temperature(&lit, profile.flux(hit.r)));
        let numbers = Inspection {
            scene: scene.name.clone(),
            pixel,
            er: direction.x,
            etheta: direction.y,
            ephi: direction.z,
            cpu: Record::from(&cpu),
            gpu: None,
            impact_parameter: path.constants.map(|constants| constants.impact_parameter),
            lambda: path.constants.map(|constants| constants.lambda),
            eta: path.constants.map(|constants| constants.eta),
            deflection: plane.deflection,
            closest_r: path.closest_r,
            half_turns: path.swept_angle / PI,
            order: path.order(&cpu),
            hit1_temperature_k: temperature(cpu.hits[0]),
            hit1_delay: cpu.hits[0].and_then(|hit| hit.delay),
            hit2_temperature_k: temperature(cpu.hits[1]),
            hit2_delay: cpu.hits[1].and_then(|hit| hit.delay),
            difference: None,
        };
        Ok(Self {
            numbers,
            path,
            plane,
            trace: cpu,
        })
    }

    /// Adds the GPU's answer to the same ray of a picture of `scene` that is `height` pixels high.
    ///
    /// # Errors
    /// The scene's observer cannot exist.
    pub fn compare(&mut self, scene: &Scene, ray: Ray, gpu: &Trace) -> Result<(), ObserverError> {
        self.numbers.gpu = Some(Record::from(gpu));
        let errors = Truth::of(scene, vec![ray])?.judge(std::slice::from_ref(gpu));
        let hit_t = largest_delay_difference(&self.trace, gpu);
        self.numbers.difference = errors.first().map(|error| {
            let backward = Some(error.backward).filter(|turn| turn.is_finite());
            Difference {
                same_class: !error.misclassified,
                sky: error.sky,
                hit_r: error.hit_r,
                hit_g: error.hit_g,
                hit_t,
                backward,
                backward_px: backward.map(|turn| turn / scene.pixel_angle()),
            }
        });
        Ok(())
    }
}

/// The largest difference of the delays of the hits that both traces have, in r_s/c.
fn largest_delay_difference(one: &Trace, other: &Trace) -> Option<f64> {
    let pairs = one.hits.iter().zip(&other.hits);
    let differences = pairs.filter_map(|(one, other)| {
        let (one, other) = (one.as_ref()?.delay?, other.as_ref()?.delay?);
        Some((one - other).abs())
    });
    differences.reduce(greater)
}

impl Inspection {
    /// As JSON.
    pub fn to_json(&self) -> String {
        serde_json::to_string_pretty(self).expect("numbers and words only")
    }

    /// As lines `name = value`. The names of records begin with `cpu.` and `gpu.`. Missing values
    /// are left out.
    pub fn to_text(&self) -> String {
        let value = serde_json::to_value(self).expect("numbers and words only");
        let mut text = String::new();
        // The order of the fields, which a JSON object in memory does not keep.
        for name in FIELDS {
            line(&mut text, name, &value[*name]);
        }
        text
    }
}

/// The fields of an inspection, in order.
const FIELDS: &[&str] = &[
    "scene",
    "pixel",
    "er",
    "etheta",
    "ephi",
    "impact_parameter",
    "lambda",
    "eta",
    "deflection",
    "closest_r",
    "half_turns",
    "order",
    "hit1_temperature_k",
    "hit1_delay",
    "hit2_temperature_k",
    "hit2_delay",
    "cpu",
    "gpu",
    "difference",
];

fn line(text: &mut String, name: &str, value: &serde_json::Value) {
    match value {
        serde_json::Value::Null => {}
        serde_json::Value::Object(fields) => {
            let known = super::rays::HEADER
                .iter()
                .copied()
                .filter(|field| fields.contains_key(*field));
            let others = fields
                .keys()
                .map(String::as_str)
                .filter(|field| !super::rays::HEADER.contains(field));
            let ordered: Vec<&str> = if fields.contains_key("outcome") {
                known.collect()
            } else {
                others.collect()
            };
            for field in ordered {
                line(text, &format!("{name}.{field}"), &fields[field]);
            }
        }
        serde_json::Value::String(word) => {
            writeln!(text, "{name} = {word}").expect("writing to a String cannot fail")
        }
        other => writeln!(text, "{name} = {other}").expect("writing to a String cannot fail"),
    }
}
