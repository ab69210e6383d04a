//! The variants that find the images of stars, and their parts.

use super::text::{Part, part};
use super::{Entry, Tracer, Variant};
use crate::scene::Scene;

impl Variant {
    /// The shader that finds the images of stars, which [`crate::gpu::stars`] describes. It is the
    /// same for all scenes with the same effects.
    pub fn stars(scene: &Scene) -> Self {
        let tracer = if scene.effects.lensing {
            Tracer::Closed
        } else {
            Tracer::Straight
        };
        Self {
            entry: Entry::Stars,
            tracer,
            spinning: false,
            near_horizon: false,
            disk: false,
            ..Self::hidden_stars(scene)
        }
    }

    /// The shader that traces the mesh by which images of stars are found without an inversion.
    pub fn star_mesh(scene: &Scene) -> Self {
        Self {
            entry: Entry::StarMesh,
            disk: false,
            ..Self::hidden_stars(scene)
        }
    }

    /// The shader that finds the images of candidates where the mesh alone gives them.
    pub fn star_interpolation(scene: &Scene) -> Self {
        Self {
            entry: Entry::StarInterpolation,
            ..Self::star_mesh(scene)
        }
    }

    /// The shader that finds the images of the other candidates by following rays.
    pub fn star_polish(scene: &Scene) -> Self {
        Self {
            entry: Entry::StarPolish,
            ..Self::star_mesh(scene)
        }
    }

    /// Whether the images of the scene's stars are found by a mesh of rays. Rays in closed form
    /// without spin and straight ones are inverted instead.
    #[must_use]
    pub fn uses_star_mesh(scene: &Scene) -> bool {
        !matches!(Tracer::of(scene), Tracer::Closed | Tracer::Straight)
    }

    /// The scene's shaders among those that find the images of stars, in their order.
    #[must_use]
    pub fn star_kernels(scene: &Scene) -> Vec<Self> {
        let mut kernels = if Self::uses_star_mesh(scene) {
            vec![
                Self::star_mesh(scene),
                Self::star_interpolation(scene),
                Self::star_polish(scene),
            ]
        } else {
            vec![Self::stars(scene)]
        };
        if scene.disk.enabled {
            kernels.push(Self::hidden_stars(scene));
        }
        kernels
    }

    /// The shader that dims the images of stars behind the scene's disk.
    pub fn hidden_stars(scene: &Scene) -> Self {
        Self {
            entry: Entry::HiddenStars,
            effects: scene.effects,
            max_hits: 2,
            follow_beyond_hits: true,
            ..Self::tracing_only(scene)
        }
    }

    /// The parts that find images by inversion, beside those that take a direction to a photon.
    pub(super) fn solving_parts(self) -> Vec<Part> {
        vec![
            part!("spectrum.wgsl"),
            part!("stars/stars.wgsl"),
            part!("stars/list.wgsl"),
            part!("stars/pinhole.wgsl"),
            part!("stars/add_image.wgsl"),
            if self.effects.lensing {
                part!("stars/closed.wgsl")
            } else {
                part!("stars/straight.wgsl")
            },
            part!("stars/solve.wgsl"),
        ]
    }

    /// The parts that trace the mesh, beside those that trace a ray.
    pub(super) fn mesh_parts(self) -> Vec<Part> {
        vec![
            part!("stars/stars.wgsl"),
            part!("stars/pinhole.wgsl"),
            part!("stars/mesh_points.wgsl"),
            part!("stars/mesh.wgsl"),
        ]
    }

    /// The parts that find candidates' images, by the mesh alone or by rays, beside those that take a
    /// direction to a photon, and those that trace a ray.
    pub(super) fn candidate_parts(self) -> Vec<Part> {
        let by_mesh = self.entry == Entry::StarInterpolation;
        vec![
            part!("spectrum.wgsl"),
            part!("stars/stars.wgsl"),
            part!("stars/list.wgsl"),
            part!("stars/pinhole.wgsl"),
            part!("stars/add_image.wgsl"),
            part!("stars/mesh_points.wgsl"),
            part!("stars/mesh_cells.wgsl"),
            part!("stars/candidates.wgsl"),
            part!("stars/proposed.wgsl"),
            part!("stars/tangent_plane.wgsl"),
            part!("stars/bicubic.wgsl"),
            if by_mesh {
                part!("stars/interpolate.wgsl")
            } else {
                part!("stars/polish.wgsl")
            },
        ]
    }

    /// The parts that dim images behind the disk, beside those that trace a ray.
    pub(super) fn hiding_parts(self) -> Vec<Part> {
        vec![
            part!("disk/cover.wgsl"),
            part!("stars/stars.wgsl"),
            part!("stars/hide.wgsl"),
        ]
    }
}
