//! Why a ray's error is beyond the tolerance: the GPU knows the scene and the ray's photon in f32
//! only, and some answers change much when one of these numbers changes by a rounding.

use crate::accuracy::Truth;
use crate::geometry::observer::Photon;
use crate::geometry::sphere::celestial_frame;
use crate::optics::reference::Reference;
use crate::optics::trace::Trace;
use crate::scene::Scene;
use glam::DVec3;

/// A rounding of a number explains errors up to this many times its own effect, because a method
/// rounds other numbers too.
const ROUNDINGS: f64 = 4.0;

/// Half a unit in the last place of f32, as a relative error.
const HALF_UNIT: f64 = 1.0 / (1_u32 << 24) as f64;

/// A number may be rounded up or down.
const SIDES: [f64; 2] = [-1.0, 1.0];

/// The number whose rounding to f32 explains an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cause {
    /// Key of a field of the scene, or the name of a constant of the photon.
    pub input: &'static str,
    /// The backward error, in radians, of the reference with this number changed by half a unit in
    /// f32's last place.
    pub backward: f64,
}

impl Cause {
    /// The number whose rounding explains the backward error of a method's answer to ray number
    /// `ray`: the one that changes the true answer most. The GPU holds the scene's numbers in f32,
    /// and the constants of each photon between the observer's matrix and the tracer.
    pub(super) fn of(scene: &Scene, truth: &Truth, ray: usize, backward: f64) -> Option<Self> {
        let least = backward / ROUNDINGS;
        let mut causes: Vec<(Self, Trace)> = fields(scene, truth, ray)
            .chain(constants(scene, truth, ray))
            .map(|(input, answer)| {
                let backward = truth.error_of(ray, &answer);
                (Self { input, backward }, answer)
            })
            .filter(|(cause, _)| cause.backward.is_finite() && cause.backward >= least)
            .collect();
        causes.sort_by(|(a, _), (b, _)| b.backward.total_cmp(&a.backward));
        // The usual search may overstate an effect as it may overstate an error.
        causes
            .into_iter()
            .map(|(cause, answer)| Self {
                backward: truth.judge_thoroughly(ray, &answer, [least, cause.backward]),
                ..cause
            })
            .find(|cause| cause.backward >= least)
    }
}

/// The true answers to ray number `ray` with each of the scene's numbers rounded.
fn fields(scene: &Scene, truth: &Truth, ray: usize) -> impl Iterator<Item = (&'static str, Trace)> {
    let inputs: [(&'static str, fn(&mut Scene) -> &mut f64); 3] = [
        ("hole.spin", |scene| &mut scene.hole.spin),
        ("camera.r", |scene| &mut scene.camera.r),
        ("camera.theta_deg", |scene| &mut scene.camera.theta_deg),
    ];
    let changed = move |(input, field): (&'static str, fn(&mut Scene) -> &mut f64), side: f64| {
        let mut changed = scene.clone();
        *field(&mut changed) *= 1.0 + side * HALF_UNIT;
        // At the limit of a field one of the two changed scenes may be impossible.
        let reference = Reference::new(&changed).ok()?;
        Some((input, truth.trace_by(ray, &reference)))
    };
    inputs
        .into_iter()
        .flat_map(move |input| SIDES.map(|side| changed(input, side)))
        .flatten()
}

/// The true answers to ray number `ray` with each of the photon's constants rounded. The radial
/// momentum follows from the others.
fn constants(
    scene: &Scene,
    truth: &Truth,
    ray: usize,
) -> impl Iterator<Item = (&'static str, Trace)> {
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
        Some((input, truth.trace_changed(ray, change)?))
    };
    inputs
        .into_iter()
        .flat_map(move |input| SIDES.map(|side| changed(input, side)))
        .flatten()
}
