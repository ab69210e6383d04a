//! What matter with depth does to an inspected ray.

use crate::light::error;
use glam::{DVec3, Vec3};
use lightfall_model::geometry::observer::Photon;
use lightfall_model::scene::Scene;
use lightfall_optics::medium::{MatterKind, Medium, Stretch, Tolerance};
use serde::Serialize;

/// How well the reference integrates the light of a ray.
const TOLERANCE: Tolerance = Tolerance {
    relative: 1e-6,
    end_depth: 20.0,
};
/// The nodes of a chunk of the reference, which halves chunks until they agree.
const NODES: usize = 8;

/// The light of a ray through matter with depth. Light is linear sRGB before exposure.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct InspectedMatter {
    /// The light of the matter, by the f64 reference, whose ray has no extent.
    pub light: [f64; 3],
    /// The optical depth of the ray's way, up to one from which nothing is seen.
    pub depth: f64,
    /// The stretches on which there is matter, from the camera on.
    pub stretches: Vec<InspectedStretch>,
    /// The GPU's answer.
    pub gpu: Option<GpuLight>,
}

/// A stretch of an inspected ray's way: see [`Stretch`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[expect(missing_docs, reason = "the fields are those of Stretch and Means")]
pub struct InspectedStretch {
    pub matter: &'static str,
    pub near_r: f64,
    pub far_r: f64,
    pub near_height: f64,
    pub far_height: f64,
    pub depth: f64,
    pub share: f64,
    pub r: Option<f64>,
    pub height: Option<f64>,
    pub g: Option<f64>,
    pub delay: Option<f64>,
}

/// What the GPU says of the light of an inspected pixel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct GpuLight {
    /// The light of the matter, as the picture filters it.
    pub light: [f32; 3],
    /// The share of the light from behind that comes through.
    pub transmission: f32,
    /// Places of the matter that the ray asked for their light.
    pub samples: u32,
    /// Change of the light with twice the samples, as a share of it.
    pub change: f32,
    /// The difference from the reference, as a share of its light; `None` for matter with structure,
    /// which the pixel filters and the reference does not.
    pub error: Option<f64>,
}

impl InspectedMatter {
    /// The matter on the way of a photon, given in the disk's frame; `None` if the scene has none.
    pub(super) fn of(scene: &Scene, photon: &Photon) -> Option<Self> {
        let medium = Medium::of(scene, NODES)?;
        let (stretches, way) = medium.stretches(photon, TOLERANCE);
        let delays = scene.camera.r > scene.kerr().horizon();
        Some(Self {
            light: way.light.to_array(),
            depth: way.depth,
            stretches: stretches
                .iter()
                .map(|stretch| InspectedStretch::new(stretch, delays))
                .collect(),
            gpu: None,
        })
    }

    /// Adds the GPU's light, transmission, samples and change of light.
    pub fn compare(
        &mut self,
        scene: &Scene,
        (light, transmission): (Vec3, f32),
        samples: u32,
        change: f32,
    ) {
        let truth = DVec3::from(self.light);
        let smooth = !scene.disk_moves();
        self.gpu = Some(GpuLight {
            light: light.to_array(),
            transmission,
            samples,
            change,
            error: smooth.then(|| error(light.as_dvec3(), truth, f64::MIN_POSITIVE)),
        });
    }
}

impl InspectedStretch {
    /// The numbers of a stretch; without delays for a camera at or inside the horizon.
    fn new(stretch: &Stretch, delays: bool) -> Self {
        let means = stretch.means;
        Self {
            matter: match stretch.kind {
                MatterKind::Disk => "disk",
                MatterKind::Jets => "jets",
                MatterKind::DiskAndJets => "disk and jets",
                MatterKind::Sheet => "thin disk",
            },
            near_r: stretch.r[0],
            far_r: stretch.r[1],
            near_height: stretch.height[0],
            far_height: stretch.height[1],
            depth: stretch.depth,
            share: stretch.share,
            r: means.map(|means| means.r),
            height: means.map(|means| means.height),
            g: means.map(|means| means.g),
            delay: means.map(|means| means.delay).filter(|_| delays),
        }
    }
}
