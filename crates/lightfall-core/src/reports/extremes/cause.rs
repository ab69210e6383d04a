//! Why a ray is beyond its bar: how well its answer is known at all, where its scene is known in
//! f32.

use crate::accuracy::Truth;
use crate::optics::reference::Reference;
use crate::scene::Scene;

/// A method rounds more than its inputs: so many times the error of one such rounding is explained
/// by it.
const ROUNDINGS: f64 = 4.0;

/// Half a unit in the last place of f32, relative.
const HALF_UNIT: f64 = 1.0 / (1_u32 << 24) as f64;

/// The input whose rounding to f32 explains an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cause {
    /// The field.
    pub input: &'static str,
    /// The backward error of the reference's own answer in the scene with that field moved by half
    /// a unit in f32's last place, in radians.
    pub backward: f64,
}

impl Cause {
    /// What explains the backward error of the ray's answer, if anything does: the input to whose
    /// rounding the true answer is most sensitive, in the same measure.
    pub(super) fn of(scene: &Scene, truth: &Truth, ray: usize, backward: f64) -> Option<Self> {
        let inputs: [(&'static str, fn(&mut Scene) -> &mut f64); 3] = [
            ("hole.spin", |scene| &mut scene.hole.spin),
            ("camera.r", |scene| &mut scene.camera.r),
            ("camera.theta_deg", |scene| &mut scene.camera.theta_deg),
        ];
        let moved = |(input, field): (&'static str, fn(&mut Scene) -> &mut f64), side: f64| {
            let mut moved = scene.clone();
            *field(&mut moved) *= 1.0 + side * HALF_UNIT;
            // Next to a limit one of the two sides may be beyond it.
            let reference = Reference::new(&moved).ok()?;
            Some(Self {
                input,
                backward: truth.error_of(ray, &reference),
            })
        };
        let all = inputs
            .into_iter()
            .flat_map(|input| [-1.0, 1.0].map(|side| moved(input, side)))
            .flatten();
        let most = all
            .filter(|cause| cause.backward.is_finite())
            .max_by(|a, b| a.backward.total_cmp(&b.backward))?;
        (backward <= ROUNDINGS * most.backward).then_some(most)
    }
}
