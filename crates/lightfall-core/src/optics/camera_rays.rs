//! The camera's photons as a scene's effects have them.

use crate::geometry::kerr::Kerr;
use crate::geometry::observer::{ObserverError, ObserverMatrix, Photon, observer_matrix};
use crate::geometry::sphere::celestial_frame;
use crate::optics::shift::RestFrame;
use crate::scene::{ObserverKind, Scene};
use glam::{DVec3, DVec4};

/// From a looking direction to a photon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraRays {
    /// The observer's matrix. Without aberration it is that of the observer with zero angular
    /// momentum at the camera's place. Without lensing its photons are those of flat space:
    /// `radial` and `w` are the direction of the light for that observer times its frequency, and
    /// `energy` that frequency times the lapse.
    pub matrix: ObserverMatrix,
    /// Takes (1, d) to the frequency that the camera measures of the matrix's photon: 1 but without
    /// aberration, where it is gamma (1 + v.d) for a camera with velocity v. The photon is divided
    /// by it.
    pub frequency: [f64; 4],
}

impl CameraRays {
    /// Of the scene's camera.
    ///
    /// # ErrorSummary
    /// If the scene's observer cannot exist, or is inside the horizon without some effect that
    /// needs one outside.
    pub fn new(scene: &Scene) -> Result<Self, ObserverError> {
        let (camera, observer, effects) = (&scene.camera, &scene.observer, scene.effects);
        let (theta, phi) = (camera.theta_deg.to_radians(), camera.phi_deg.to_radians());
        let of =
            |kind, velocity| observer_matrix(scene.hole.spin, kind, velocity, camera.r, theta, phi);
        let matrix = of(observer.kind, observer.velocity)?;
        let whole = Self {
            matrix,
            frequency: [1.0, 0.0, 0.0, 0.0],
        };
        let horizon = Kerr {
            spin: scene.hole.spin,
        }
        .horizon();
        let parted = !(effects.lensing
            && effects.aberration
            && effects.doppler
            && effects.gravitational_shift);
        if camera.r <= horizon && parted {
            return Err(ObserverError::Inside {
                r: camera.r,
                horizon,
            });
        }
        if effects.lensing && effects.aberration {
            return Ok(whole);
        }
        let rest = of(ObserverKind::Zamo, [0.0; 3])?;
        let [n, theta_hat, phi_hat] = celestial_frame(theta, phi);
        let boost = boost_from(&rest, &matrix, theta_hat, phi_hat);
        // The boost takes (1, d) of the camera to the rest frame's; the inverse has the opposite
        // velocity, -v.
        let frequency = if effects.aberration {
            whole.frequency
        } else {
            [boost[0].x, -boost[1].x, -boost[2].x, -boost[3].x]
        };
        if effects.lensing {
            return Ok(Self {
                matrix: rest,
                frequency,
            });
        }
        let [one, r, theta, phi] = if effects.aberration {
            boost
        } else {
            DVec4::AXES
        };
        let w = |axis: usize| -(theta * theta_hat[axis] + phi * phi_hat[axis]);
        let lapse = RestFrame::at(
            Kerr {
                spin: scene.hole.spin,
            },
            camera.r,
            n.z,
        )
        .lapse;
        let rows = [lapse * one, -r, w(0), w(1), w(2)].map(|row| row.to_array());
        Ok(Self {
            matrix: ObserverMatrix { rows },
            frequency,
        })
    }

    /// The photon that arrives from the unit looking direction `direction`, on the observer's axes,
    /// per unit frequency for the camera.
    #[must_use]
    pub fn photon(&self, direction: DVec3) -> Photon {
        let Photon { energy, radial, w } = self.matrix.photon(direction);
        let frequency = DVec4::from_array(self.frequency).dot(DVec4::from((1.0, direction)));
        Photon {
            energy: energy / frequency,
            radial: radial / frequency,
            w: w / frequency,
        }
    }
}

/// The rows of the boost that takes (1, d) of an observer to the zero-angular-momentum frame's
/// (frequency, frequency times direction): the frame's own matrix, solved for it.
fn boost_from(
    rest: &ObserverMatrix,
    observer: &ObserverMatrix,
    theta_hat: DVec3,
    phi_hat: DVec3,
) -> [DVec4; 4] {
    let row = |matrix: &ObserverMatrix, i: usize| DVec4::from_array(matrix.rows[i]);
    let along = |matrix: &ObserverMatrix, hat: DVec3| {
        hat.x * row(matrix, 2) + hat.y * row(matrix, 3) + hat.z * row(matrix, 4)
    };
    let r = row(observer, 1) / row(rest, 1).y;
    let theta = along(observer, theta_hat) / along(rest, theta_hat).z;
    let phi = along(observer, phi_hat) / along(rest, phi_hat).w;
    let energy = row(rest, 0);
    [
        (row(observer, 0) - energy.w * phi) / energy.x,
        r,
        theta,
        phi,
    ]
}
