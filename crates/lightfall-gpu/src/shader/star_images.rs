//! The variants that find the images of stars.

use super::{Entry, Tracer, Variant};
use crate::stars::StarKernel;
use lightfall_model::scene::{Method, Projection, Scene, View};

impl Variant {
    /// The shader of a kernel of stars, unless it is the same for all scenes.
    pub(crate) fn of_kernel(kernel: StarKernel, scene: &Scene) -> Option<Self> {
        let through_disk = Self {
            entry: Entry::Star(kernel),
            effects: scene.effects,
            max_hits: 2,
            follow_beyond_hits: true,
            ..Self::tracing_only(scene)
        };
        let to_sky = Self {
            disk: false,
            ..through_disk
        };
        match kernel {
            StarKernel::Dim if scene.has_thick_disk() => {
                let picture = Self::picture(&Scene {
                    view: View::Colour,
                    ..scene.clone()
                });
                Some(Self {
                    medium_nodes: picture.medium_nodes,
                    structure: picture.structure,
                    repeats: picture.repeats,
                    delay_nodes: picture.delay_nodes,
                    throat: picture.throat,
                    ..through_disk
                })
            }
            StarKernel::Dim => Some(through_disk),
            StarKernel::TraceMesh | StarKernel::Interpolate | StarKernel::RefineImage => {
                Some(Self {
                    projection: Projection::Perspective,
                    on_sides: to_sky.projection != Projection::Perspective,
                    ..to_sky
                })
            }
            // The inversion is the same for all scenes with the same effects.
            StarKernel::Solve => Some(Self {
                tracer: if scene.effects.lensing {
                    Tracer::Method(Method::Closed)
                } else {
                    Tracer::Straight
                },
                spinning: false,
                near_horizon: false,
                ..to_sky
            }),
            _ => None,
        }
    }

    /// Whether a mesh of rays finds the images of the scene's stars. Rays in closed form without
    /// spin and straight ones are inverted instead, and those around such a hole that pass through
    /// matter.
    pub fn uses_star_mesh(scene: &Scene) -> bool {
        let inverted = match Tracer::of(scene) {
            Tracer::Method(Method::Closed) | Tracer::Straight => true,
            _ => scene.has_medium() && scene.hole.spin == 0.0,
        };
        !inverted
    }

    /// The scene's shaders among those that find the images of stars, in their order.
    pub fn star_kernels(scene: &Scene) -> Vec<Self> {
        let kernels = StarKernel::of(scene);
        kernels
            .filter_map(|kernel| Self::of_kernel(kernel, scene))
            .collect()
    }
}
