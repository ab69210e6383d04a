//! Guides: curves on a camera's sky that mark places around the hole, as a figure of a textbook
//! would. They are exact for every observer that the scene can have.
//!
//! Most guides are traced through bent light: they are at the directions from which the light of a
//! place arrives. The others are *flat*, as the place would be seen without bending, for
//! comparison. Without lensing all guides are flat, like the picture.

mod bent;
mod flat;
mod outline;
mod sky;

use glam::DVec3;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::scene::Scene;
pub(crate) use sky::Sky;

/// What a guide marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Landmark {
    /// The edge of the shadow.
    ShadowEdge,
    /// The innermost stable orbit of matter that turns with the disk: its first image.
    StableOrbit,
    /// The second image of the same orbit, of light that passes below the hole.
    StableOrbitAgain,
    /// The outline of the ergosphere.
    Ergosphere,
    /// The outline of the horizon.
    Horizon,
    /// The outline of the photon sphere; with spin, of its innermost and its outermost shell.
    PhotonSphere,
}

/// A guide.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// What it marks.
    pub landmark: Landmark,
    /// Whether it shows the place as without bending.
    pub flat: bool,
    /// Closed curves of unit directions on the observer's axes (outward, toward growing theta,
    /// toward growing phi).
    pub curves: Vec<Vec<DVec3>>,
}

/// The guides that take less than a millisecond: the edge of the shadow, and all flat ones.
///
/// # Errors
/// If the scene's observer does not exist.
pub fn quick_guides(scene: &Scene) -> Result<Vec<Guide>, ObserverError> {
    let kerr = scene.kerr();
    let mut guides = Vec::new();
    let mut add = |landmark, flat, curves: Vec<Vec<DVec3>>| {
        if curves.iter().any(|curve| !curve.is_empty()) {
            guides.push(Guide {
                landmark,
                flat,
                curves,
            });
        }
    };
    if scene.effects.lensing {
        add(Landmark::ShadowEdge, false, vec![bent::shadow_edge(scene)?]);
    }
    // Inside the horizon there is nothing to compare with.
    if let Ok(sky) = Sky::flat(scene) {
        let spheres = |radii: &[f64]| -> Vec<_> {
            let outlines = radii
                .iter()
                .filter_map(|radius| flat::sphere(&sky, *radius));
            outlines.collect()
        };
        add(Landmark::Horizon, true, spheres(&[kerr.horizon()]));
        add(Landmark::PhotonSphere, true, spheres(&photon_shells(kerr)));
        if !scene.effects.lensing {
            add(
                Landmark::StableOrbit,
                true,
                vec![flat::orbit(&sky, &scene.disk, kerr.isco())],
            );
            let ergosphere = flat::ergosphere(&sky, kerr);
            add(Landmark::Ergosphere, true, ergosphere.into_iter().collect());
        }
    }
    Ok(guides)
}

/// The guides that need traced rays, in some tens of milliseconds: the images of the innermost
/// stable orbit, and the ergosphere. None without lensing.
///
/// # Errors
/// If the scene's observer does not exist.
pub fn traced_guides(scene: &Scene) -> Result<Vec<Guide>, ObserverError> {
    if !scene.effects.lensing {
        return Ok(Vec::new());
    }
    let radius = scene.kerr().isco();
    let found = [
        (Landmark::StableOrbit, bent::orbit_image(scene, radius, 1)?),
        (
            Landmark::StableOrbitAgain,
            bent::orbit_image(scene, radius, 2)?,
        ),
        (Landmark::Ergosphere, bent::ergosphere(scene)?),
    ];
    let guide = |(landmark, curve): (Landmark, Option<Vec<DVec3>>)| {
        Some(Guide {
            landmark,
            flat: false,
            curves: vec![curve?],
        })
    };
    Ok(found.into_iter().filter_map(guide).collect())
}

/// The radii of the photon sphere, or with spin of its innermost and outermost shell, in r_s.
pub fn photon_shells(kerr: Kerr) -> Vec<f64> {
    if kerr.spin == 0.0 {
        return vec![kerr.photon_orbit_prograde()];
    }
    let mut radii = vec![kerr.photon_orbit_prograde(), kerr.photon_orbit_retrograde()];
    radii.sort_by(f64::total_cmp);
    radii
}

/// The directions, on the observer's axes, of the two ends of a bar of this length (r_s) across the
/// hole's centre, toward growing phi, if light is not bent. `None` inside the horizon.
pub fn bar_across_hole(scene: &Scene, length: f64) -> Option<[DVec3; 2]> {
    let sky = Sky::flat(scene).ok()?;
    let end = |half: f64| sky.seen(DVec3::new(-sky.r, 0.0, half).normalize());
    Some([end(-0.5 * length)?, end(0.5 * length)?])
}
