//! Everything about one ray, as numbers that can be read, copied and compared: the contents of the
//! ray inspector.

mod matter;

pub use matter::{GpuLight, InspectedMatter, InspectedStretch};

use crate::rays::Record;
use crate::{Ray, Truth, greater};
use glam::DVec3;
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::scene::Scene;
use lightfall_optics::disk;
use lightfall_optics::disk::Profile;
use lightfall_optics::path::Path;
use lightfall_optics::ray_plane::RayPlane;
use lightfall_optics::reference::Reference;
use lightfall_optics::shift::Shift;
use lightfall_optics::trace::{Hit, Trace};
use serde::Serialize;
use serde_json::Value;
use std::f64::consts::PI;

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
    /// Observed over emitted frequency of light from the sky that the ray comes from, without the
    /// share of effects that are switched off.
    pub sky_g: Option<f64>,
    /// The difference between the GPU's answer and the reference's.
    pub difference: Option<Difference>,
    /// What matter with depth does to the ray: [`Inspected::add_matter`].
    pub matter: Option<InspectedMatter>,
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
            sky_g: cpu.sky.map(|_| {
                let lambda = path.constants.map_or(0.0, |constants| constants.lambda);
                let g = 1.0 / reference.photon(direction).energy;
                Shift::new(scene).of_sky(g, lambda)
            }),
            difference: None,
            matter: None,
        };
        Ok(Self {
            numbers,
            path,
            plane,
            trace: cpu,
        })
    }

    /// Adds what the scene's matter with depth does to the ray, if it has any. This takes longer than all
    /// the rest.
    ///
    /// # Errors
    /// The scene's observer cannot exist.
    pub fn add_matter(&mut self, scene: &Scene) -> Result<(), ObserverError> {
        let Inspection {
            er, etheta, ephi, ..
        } = self.numbers;
        let photon = Reference::new(scene)?.photon(DVec3::new(er, etheta, ephi));
        self.numbers.matter = InspectedMatter::of(scene, &photon);
        Ok(())
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

    /// As lines `name = value`: the ray's own numbers, and the records, whose names begin with `cpu.`,
    /// `gpu.` and so on, and with `matter.stretches.1.` for the first stretch. Missing values are left
    /// out.
    pub fn to_text(&self) -> String {
        let value = serde_json::to_value(self).expect("numbers and words only");
        let mut text = String::new();
        add_lines(&mut text, "", &value);
        text
    }
}

/// Adds the lines of a value with this name: those of an object after the ones with numbers and words.
fn add_lines(text: &mut String, name: &str, value: &Value) {
    let within = |part: &str| {
        let dot = if name.is_empty() { "" } else { "." };
        format!("{name}{dot}{part}")
    };
    match value {
        Value::Null => {}
        Value::String(word) => *text += &format!("{name} = {word}\n"),
        Value::Object(fields) => {
            let (records, numbers): (Vec<_>, Vec<_>) =
                fields.iter().partition(|(_, value)| is_record(value));
            for (part, value) in numbers.into_iter().chain(records) {
                add_lines(text, &within(part), value);
            }
        }
        Value::Array(records) if records.iter().all(is_record) => {
            for (index, record) in records.iter().enumerate() {
                add_lines(text, &within(&(index + 1).to_string()), record);
            }
        }
        other => *text += &format!("{name} = {other}\n"),
    }
}

/// Whether a value has lines of its own names.
fn is_record(value: &Value) -> bool {
    match value {
        Value::Object(_) => true,
        Value::Array(values) => values.iter().all(Value::is_object),
        _ => false,
    }
}
