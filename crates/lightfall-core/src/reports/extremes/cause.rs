//! Why a ray's error is beyond the tolerance: the GPU knows the scene in f32 only, and some answers
//! change much when the scene changes by a rounding.

use crate::accuracy::Truth;
use crate::optics::reference::Reference;
use crate::scene::Scene;

/// A rounding of an input explains errors up to this many times its own effect, because a method
/// rounds other numbers too.
const ROUNDINGS: f64 = 4.0;

/// Half a unit in the last place of f32, as a relative error.
const HALF_UNIT: f64 = 1.0 / (1_u32 << 24) as f64;

/// The input whose rounding to f32 explains an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cause {
    /// Key of the field.
    pub input: &'static str,
    /// The backward error, in radians, of the reference in the scene with this field changed by
    /// half a unit in f32's last place.
    pub backward: f64,
}

impl Cause {
    /// The input whose rounding changes the true answer to ray number `ray` most, if that explains
    /// the backward error of a method's answer.
    pub(super) fn of(scene: &Scene, truth: &Truth, ray: usize, backward: f64) -> Option<Self> {
        let inputs: [(&'static str, fn(&mut Scene) -> &mut f64); 3] = [
            ("hole.spin", |scene| &mut scene.hole.spin),
            ("camera.r", |scene| &mut scene.camera.r),
            ("camera.theta_deg", |scene| &mut scene.camera.theta_deg),
        ];
        let changed = |(input, field): (&'static str, fn(&mut Scene) -> &mut f64), side: f64| {
            let mut changed = scene.clone();
            *field(&mut changed) *= 1.0 + side * HALF_UNIT;
            // At the limit of a field one of the two changed scenes may be impossible.
            let reference = Reference::new(&changed).ok()?;
            Some(Self {
                input,
                backward: truth.error_of(ray, &reference),
            })
        };
        let all = inputs
            .into_iter()
            .flat_map(|input| [-1.0, 1.0].map(|side| changed(input, side)))
            .flatten();
        let worst = all
            .filter(|cause| cause.backward.is_finite())
            .max_by(|a, b| a.backward.total_cmp(&b.backward))?;
        (backward <= ROUNDINGS * worst.backward).then_some(worst)
    }
}
