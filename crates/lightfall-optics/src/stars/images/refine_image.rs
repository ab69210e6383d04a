//! An image of a star found with a tracer, by Broyden's method from a guess.
//!
//! Places are those of a picture: x and y at unit distance, so that the looking direction is (x, y,
//! 1) on the camera's axes (right, up, forward), not normalized.

use glam::{DMat2, DVec2, DVec3};

/// An image is found where the ray misses the star by less than this, in radians.
const TOLERANCE: f64 = 1e-12;

/// The place and the magnification of a star's image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefinedImage {
    /// Its place in the picture, at unit distance.
    pub place: DVec2,
    /// The solid angle at the camera over the solid angle on the sky.
    pub magnification: f64,
    /// Number of rays traced before the magnification was measured.
    pub rays: u32,
}

/// How an image is polished.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImageRefiner {
    /// Maximum length of a step, at unit distance.
    pub max_step: f64,
    /// Maximum number of rays before the magnification is measured.
    pub max_rays: u32,
    /// Half of the distance over which rays are compared for the magnification.
    pub half_step: f64,
}

impl ImageRefiner {
    /// The image of the star in the unit direction `star`, from the guess `place` and a guess of
    /// the Jacobian there: the star's tangent coordinates by the place's. `sky` is the tracer: the
    /// unit vector toward the source of a place's light, or `None` where no light of the sky
    /// arrives. `None` if the method leaves the sky or does not converge.
    pub fn image(
        &self,
        sky: &impl Fn(DVec2) -> Option<DVec3>,
        star: DVec3,
        place: DVec2,
        jacobian: DMat2,
    ) -> Option<RefinedImage> {
        let tangents = Tangents::at(star);
        let (mut place, mut jacobian) = (place, jacobian);
        let mut missed = tangents.missed(sky(place)?)?;
        for rays in 1..=self.max_rays {
            if missed.length() < TOLERANCE {
                return Some(RefinedImage {
                    place,
                    magnification: self.magnification(sky, place)?,
                    rays,
                });
            }
            let step = (jacobian.inverse() * -missed).clamp_length_max(self.max_step);
            if !step.is_finite() {
                return None;
            }
            place += step;
            let now = tangents.missed(sky(place)?)?;
            let unexplained = (now - missed - jacobian * step) / step.length_squared();
            jacobian += DMat2::from_cols(unexplained * step.x, unexplained * step.y);
            missed = now;
        }
        None
    }

    /// The solid angle at the camera over the solid angle on the sky, by central differences.
    pub fn magnification(
        &self,
        sky: &impl Fn(DVec2) -> Option<DVec3>,
        place: DVec2,
    ) -> Option<f64> {
        let h = self.half_step;
        let along = |step: DVec2| Some((sky(place + step)? - sky(place - step)?) / (2.0 * h));
        let on_sky = along(DVec2::X * h)?.cross(along(DVec2::Y * h)?).length();
        let cosine = place.extend(1.0).length_recip();
        Some(cosine.powi(3) / on_sky)
    }
}

/// Two unit vectors perpendicular to the direction of a star.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tangents {
    star: DVec3,
    first: DVec3,
    second: DVec3,
}

impl Tangents {
    /// Those of the star in this unit direction.
    pub fn at(star: DVec3) -> Self {
        let (first, second) = star.any_orthonormal_pair();
        Self {
            star,
            first,
            second,
        }
    }

    /// The components of a vector along these.
    pub fn components(&self, vector: DVec3) -> DVec2 {
        DVec2::new(vector.dot(self.first), vector.dot(self.second))
    }

    /// The miss of the star by a direction; `None` on the other half of the sky.
    pub fn missed(&self, direction: DVec3) -> Option<DVec2> {
        (direction.dot(self.star) > 0.0).then(|| self.components(direction))
    }
}
