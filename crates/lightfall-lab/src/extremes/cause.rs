//! The cause of an error beyond the tolerance: the GPU has the scene and the ray's photon in f32,
//! and some answers change much when one of these numbers changes by a rounding.

use glam::DVec3;
use lightfall_accuracy::{ThoroughSearch, Truth, TurnBounds, is_same_class};
use lightfall_model::geometry::observer::Photon;
use lightfall_model::geometry::sphere::celestial_frame;
use lightfall_model::scene::Scene;
use lightfall_optics::reference::Reference;
use lightfall_optics::trace::Trace;
use rayon::prelude::*;

/// The roundings of numbers explain errors up to this many times the sum of their effects, if the
/// method takes no steps. Each constant of the photon is a sum of four products, which rounds the
/// four products, three sums and an entry of the matrix.
const ROUNDINGS_BEFORE_STEPS: f64 = 8.0;

/// Share of an error below which the effect of a rounding is not measured.
const NEGLIGIBLE: f64 = 0.01;

/// Half a unit in the last place of f32, as a relative error.
const HALF_UNIT: f64 = 1.0 / (1_u32 << 24) as f64;

/// A number may be rounded up or down.
const SIDES: [f64; 2] = [-1.0, 1.0];

/// Why an error is beyond the tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// The roundings of numbers to f32 explain the error.
    Roundings {
        /// The number with the largest effect: key of a field of the scene, or the name of a
        /// constant of the photon.
        input: &'static str,
        /// The number of further inputs that are needed to explain the error.
        others: usize,
        /// The sum of the backward errors, in radians, of the reference with each of these numbers
        /// changed by half a unit in f32's last place.
        backward: f64,
    },
    /// The answer's sky is right, and f32 cannot tell whether the ray meets the ring: it is too
    /// narrow.
    NarrowRing,
}

struct Rounded {
    /// Key of a field of the scene, or the name of a constant of the photon.
    input: &'static str,
    /// The reference's answer to the rounded number.
    answer: Trace,
    /// The turn of the ray that leads to a photon with the rounded constant, in radians. A field of
    /// the scene has no such turn.
    turn: Option<f64>,
}

impl Cause {
    /// The numbers whose roundings explain the backward error of a method's answer `given` to a
    /// ray, the one with the largest effect first. The GPU holds the scene's numbers in f32, and
    /// the constants of each photon between the observer's matrix and the tracer.
    pub(super) fn of_roundings(
        scene: &Scene,
        truth: &Truth,
        thorough: &ThoroughSearch,
        (ray, given): (usize, &Trace),
        error: f64,
    ) -> Option<Self> {
        // No rounding explains an answer that no turn of the ray explains.
        if !error.is_finite() {
            return None;
        }
        // Where the class differs, the turn counts: most roundings leave a captured ray captured,
        // with the same answer.
        let crosses = !is_same_class(&truth.traces[ray], given);
        let target = NEGLIGIBLE * error;
        let turn = |rounded: &Rounded| rounded.turn.filter(|_| crosses);
        let with_effect = |rounded: Rounded| {
            let search = || truth.error_of(ray, &rounded.answer, target);
            let effect = turn(&rounded).unwrap_or_else(search);
            (rounded, effect)
        };
        let numbers: Vec<Rounded> = fields(scene, truth, ray)
            .chain(constants(scene, truth, ray))
            .collect();
        let mut effects: Vec<(Rounded, f64)> = numbers.into_par_iter().map(with_effect).collect();
        effects.sort_by(|(_, a), (_, b)| b.total_cmp(a));
        let mut inputs: Vec<&'static str> = Vec::new();
        let mut sum = 0.0;
        for (rounded, upper_bound) in effects {
            // A number is rounded up or down.
            if inputs.contains(&rounded.input) {
                continue;
            }
            // The usual search may overstate an effect as it may overstate an error.
            let search = || {
                thorough.judge(
                    &rounded.answer,
                    TurnBounds {
                        target,
                        upper_bound,
                    },
                )
            };
            let effect = turn(&rounded).unwrap_or_else(search);
            if effect.is_finite() {
                inputs.push(rounded.input);
                sum += effect;
            }
            if roundings(given.steps) * sum >= error {
                return Some(Self::Roundings {
                    input: inputs.first()?,
                    others: inputs.len() - 1,
                    backward: sum,
                });
            }
        }
        None
    }
}

/// The effective number of roundings of each number. Each step rounds the place and the momentum of
/// the ray once more, and the roundings of n steps add up like a random walk (Higham 2002, section
/// 2.8).
fn roundings(steps: u32) -> f64 {
    ROUNDINGS_BEFORE_STEPS + f64::from(steps).sqrt()
}

/// The true answers to ray number `ray` with each of the scene's numbers rounded.
fn fields(scene: &Scene, truth: &Truth, ray: usize) -> impl Iterator<Item = Rounded> {
    let inputs: [(&'static str, fn(&mut Scene) -> &mut f64); 3] = [
        ("hole.spin", |scene| &mut scene.hole.spin),
        ("camera.r", |scene| &mut scene.camera.r),
        ("camera.theta_deg", |scene| &mut scene.camera.theta_deg),
    ];
    // On the axis and in the plane of the disk the sine and the cosine of theta are exact.
    let is_exact = scene.camera.theta_deg % 90.0 == 0.0;
    let rounded = if is_exact { 2 } else { 3 };
    let changed = move |(input, field): (&'static str, fn(&mut Scene) -> &mut f64), side: f64| {
        let mut changed = scene.clone();
        *field(&mut changed) *= 1.0 + side * HALF_UNIT;
        // At the limit of a field one of the two changed scenes may be impossible.
        let reference = Reference::new(&changed).ok()?;
        Some(Rounded {
            input,
            answer: truth.trace_by(ray, &reference),
            turn: None,
        })
    };
    inputs
        .into_iter()
        .take(rounded)
        .flat_map(move |input| SIDES.map(|side| changed(input, side)))
        .flatten()
}

/// The true answers to ray number `ray` with each of the photon's constants rounded. The radial
/// momentum follows from the others.
fn constants(scene: &Scene, truth: &Truth, ray: usize) -> impl Iterator<Item = Rounded> {
    let camera = &scene.camera;
    let [_, theta_hat, phi_hat] =
        celestial_frame(camera.theta_deg.to_radians(), camera.phi_deg.to_radians());
    let inputs: [(&'static str, f64, DVec3); 3] = [
        ("the photon's energy", 1.0, DVec3::ZERO),
        ("the photon's momentum along theta", 0.0, theta_hat),
        ("the photon's momentum along phi", 0.0, phi_hat),
    ];
    let changed = move |(input, of_energy, axis): (&'static str, f64, DVec3), side: f64| {
        let change = |photon: &mut Photon| {
            photon.energy *= 1.0 + of_energy * side * HALF_UNIT;
            photon.w += side * HALF_UNIT * photon.w.length() * axis;
        };
        let (answer, turn) = truth.trace_changed(ray, change)?;
        Some(Rounded {
            input,
            answer,
            turn: Some(turn),
        })
    };
    inputs
        .into_iter()
        .flat_map(move |input| SIDES.map(|side| changed(input, side)))
        .flatten()
}
