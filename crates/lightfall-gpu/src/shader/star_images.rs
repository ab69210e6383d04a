//! The variants that find the images of stars.

use super::{Entry, Tracer, Variant};
use crate::stars::StarKernel;
use lightfall_model::scene::{Method, Scene};

impl Variant {
    /// The shader that finds the images of stars by inversion. It is the same for all scenes with
    /// the same effects.
    pub fn stars(scene: &Scene) -> Self {
        let tracer = if scene.effects.lensing {
            Tracer::Method(Method::Closed)
        } else {
            Tracer::Straight
        };
        Self {
            entry: Entry::Stars,
            tracer,
            spinning: false,
            near_horizon: false,
            disk: false,
            ..Self::star_dimming(scene)
        }
    }

    /// The shader that traces the mesh for images of stars without an inversion.
    pub fn star_mesh(scene: &Scene) -> Self {
        Self {
            entry: Entry::StarMesh,
            disk: false,
            ..Self::star_dimming(scene)
        }
    }

    /// The shader that finds the images of candidates in smooth cells by interpolation.
    pub fn star_interpolation(scene: &Scene) -> Self {
        Self {
            entry: Entry::StarInterpolation,
            ..Self::star_mesh(scene)
        }
    }

    /// The shader that finds the images of the other candidates by following rays.
    pub fn star_refinement(scene: &Scene) -> Self {
        Self {
            entry: Entry::StarRefinement,
            ..Self::star_mesh(scene)
        }
    }

    /// Whether a mesh of rays finds the images of the scene's stars. Rays in closed form without
    /// spin and straight ones are inverted instead.
    pub fn uses_star_mesh(scene: &Scene) -> bool {
        !matches!(
            Tracer::of(scene),
            Tracer::Method(Method::Closed) | Tracer::Straight
        )
    }

    /// The scene's shaders among those that find the images of stars, in their order.
    pub fn star_kernels(scene: &Scene) -> Vec<Self> {
        let kernels = StarKernel::of(scene);
        kernels.filter_map(|kernel| kernel.variant(scene)).collect()
    }

    /// The shader that dims the images of stars behind the scene's disk.
    pub fn star_dimming(scene: &Scene) -> Self {
        Self {
            entry: Entry::StarDimming,
            effects: scene.effects,
            max_hits: 2,
            follow_beyond_hits: true,
            ..Self::tracing_only(scene)
        }
    }
}
