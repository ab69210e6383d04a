//! The scenes with matter with depth that measurements share, and the light of their rays against
//! the f64 twin's.

use lightfall_accuracy::{LightErrors, Ray, light_floor, true_passages};
use lightfall_gpu::passages::{GpuPassage, PassageKernel};
use lightfall_gpu::{Gpu, GpuError, Variant};
use lightfall_model::scene::{ObserverKind, Scene, SkyMode};
use lightfall_optics::medium::Passage;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// The largest difference between a chunk of the twin and its halves, as a share of its light. Its own
/// error is far smaller, because a chunk has eight nodes.
const TRUE_TO: f64 = 1e-5;

/// A scene with a disk with thickness around a hole of this spin, and nothing behind it: the camera is
/// at rest at a radius in r_s and an angle from the disk's normal in degrees.
pub fn thick_scene(spin: f64, [r, theta_deg]: [f64; 2], thickness: f64, depth: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.fov_deg) = (r, theta_deg, 50.0);
    scene.observer.kind = ObserverKind::Static;
    scene.disk.follow_isco = true;
    (scene.disk.thickness, scene.disk.depth) = (thickness, depth);
    (scene.disk.outer, scene.disk.edge_taper) = (11.0, 0.2);
    scene.sky.mode = SkyMode::Off;
    scene
}

/// A scene with jets and a disk without thickness around a hole of this spin, and nothing behind them,
/// from a place as in [`thick_scene`]. The jets are about as bright as the disk, so that the error is
/// that of both.
pub fn jet_scene(spin: f64, place: [f64; 2]) -> Scene {
    let mut scene = thick_scene(spin, place, 0.0, 1.0);
    scene.camera.fov_deg = 66.0;
    (scene.jet.enabled, scene.jet.brightness) = (true, 3.0);
    scene
}

/// What the twin says of rays through a scene.
pub(super) struct TrueLight {
    passages: Vec<Passage>,
    floor: f64,
}

impl TrueLight {
    /// The true light of `rays`. Their floor is that of the brighter of two pictures, these rays and those
    /// of `picture`. `None` if the scene has no matter with depth.
    pub(super) fn of(scene: &Scene, rays: &[Ray], picture: &[Ray]) -> Option<Self> {
        let floor_of = |passages: &[Passage]| light_floor(passages.iter().map(|seen| seen.light));
        let passages = true_passages(scene, rays, TRUE_TO)?;
        let mut floor = floor_of(&passages);
        if rays != picture {
            floor = floor.max(floor_of(&true_passages(scene, picture, TRUE_TO)?));
        }
        Some(Self { passages, floor })
    }

    /// The errors of what the GPU has found along the same rays.
    pub(super) fn errors(&self, found: &[GpuPassage]) -> LightErrors {
        let found: Vec<_> = found.iter().map(|passage| passage.light).collect();
        let truth: Vec<_> = self.passages.iter().map(|seen| seen.light).collect();
        LightErrors::between(&found, &truth, self.floor)
    }
}

/// Compiled shaders, by variant.
#[derive(Default)]
pub(super) struct PassageKernels(HashMap<Variant, PassageKernel>);

impl PassageKernels {
    /// What the GPU finds along these rays.
    pub(super) fn passages(
        &mut self,
        gpu: &Gpu,
        scene: &Scene,
        rays: &[Ray],
    ) -> Result<Vec<GpuPassage>, GpuError> {
        let given = rays.iter().map(Ray::given);
        let kernel = match self.0.entry(Variant::passages(scene, false)) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(new) => new.insert(PassageKernel::new(gpu, scene)?),
        };
        kernel.passages(gpu, scene, given)
    }
}

/// Counts of rays whose answer is no light, of rays that were given up, and the mean number of samples
/// of a ray that has any; zero if none has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Soundness {
    pub(super) not_finite: usize,
    pub(super) unfinished: usize,
    pub(super) samples: f64,
}

impl Soundness {
    pub(super) fn of(found: &[GpuPassage]) -> Self {
        let count = |is: fn(&GpuPassage) -> bool| found.iter().filter(|seen| is(seen)).count();
        let samples: u32 = found.iter().map(|seen| seen.samples).sum();
        Self {
            not_finite: count(|seen| !seen.is_finite()),
            unfinished: count(GpuPassage::is_unfinished),
            samples: f64::from(samples) / count(|seen| seen.samples > 0).max(1) as f64,
        }
    }
}
