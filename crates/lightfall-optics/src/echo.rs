//! The light echo: the images of the hot spot that a scene's camera sees now, and the times of
//! their emission.
//!
//! The camera sees a spot directly, then by light that has swept more than a half-turn about the
//! hole, then more than a whole turn, and so on, each time as it was at a time of its own. The
//! image of order n is where a backward ray's crossing number n of the disk's plane, counted from
//! 0, meets the spot at the time of that crossing.
//!
//! Two numbers give a ray: its angle from the direction of the hole, and the azimuth of the line in
//! which its plane would meet the disk's plane without frame dragging. A larger angle moves the
//! crossing outward, and another azimuth turns it about the axis. So two nested root searches find
//! the ray, without a first guess and at any spin.

use crate::camera_rays::{CameraRays, camera_in_disk_frame};
use crate::delay::Lag;
use crate::hot_spot::HotSpot;
use crate::reference::{HoleAndDisk, Reference, time_to_plane};
use crate::shift::Shift;
use crate::trace::{Hit, Outcome};
use glam::{DVec2, DVec3};
use lightfall_model::geometry::mino::PhotonConstants;
use lightfall_model::geometry::observer::{ObserverError, ObserverKind, ObserverMatrix, Photon};
use lightfall_model::geometry::sphere::wrap_angle;
use lightfall_model::scene::Scene;
use std::f64::consts::PI;

/// Number of images to find. Next to the shadow's edge each is e^pi = 23 times as thin as the
/// previous one.
pub const ORDERS: u32 = 3;

/// Largest errors: of an azimuth, in radians, and of 1 - r_s/r.
const AZIMUTH_TOLERANCE: f64 = 1e-11;
const RADIUS_TOLERANCE: f64 = 1e-13;
/// Step of the search for an azimuth, in radians. For a camera close to the disk's plane the
/// crossing turns by up to ten times as much.
const STEP: f64 = 0.2;
/// Maximum number of steps for either root. Both take about ten.
const MAX_STEPS: u32 = 100;

/// An image of the hot spot's middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Image {
    /// The number of whole half-turns about the hole that its light has swept.
    pub order: u32,
    /// Where it is seen: a unit vector on the observer's axes.
    pub direction: DVec3,
    /// The same in the scene's picture, in pixels from its upper left corner. It may lie outside
    /// the picture; `None` for an image behind the camera.
    pub pixel: Option<DVec2>,
    /// The emission: where the spot was, the frequency ratio, and the delay.
    pub hit: Hit,
    /// Time between emission and arrival, in r_s/c.
    pub delay: f64,
}

/// The images of the scene's hot spot at its `disk.time` that exist, in the order of their numbers.
/// There are none if the scene has no spot, if the camera is in the disk's plane and would see the
/// spot from its edge, or if it is at or inside the horizon. A picture may not show an image:
/// something may lie in front of it, and it may be the third crossing of the disk around a spinning
/// hole.
///
/// # Errors
/// If the scene's observer cannot exist.
pub fn echo(scene: &Scene) -> Result<Vec<Image>, ObserverError> {
    let rays = CameraRays::in_disk_frame(scene)?;
    let kerr = scene.kerr();
    let (r, n) = (scene.camera.r, camera_in_disk_frame(scene));
    let spot = match HotSpot::new(scene) {
        Some(spot) if r > kerr.horizon() && n.z != 0.0 => spot,
        _ => return Ok(Vec::new()),
    };
    if !scene.effects.lensing {
        return Ok(straight_image(scene, &rays, &spot)?.into_iter().collect());
    }
    let disk_from_hole = scene.disk.hole_from_disk().transpose();
    let axes = disk_from_hole * scene.camera.tetrad();
    let search = Search {
        spot,
        hole: HoleAndDisk {
            kerr,
            // A ray matters as far in as the spot, and no crossing counts as a hit.
            annulus: Some([spot.r(); 2]),
        },
        zamo: scene
            .observer_at_camera(ObserverKind::Zamo, [0.0; 3])?
            .turned(disk_from_hole),
        r,
        n,
        tangents: [axes.y_axis, axes.z_axis],
        time: scene.disk.time,
    };
    let shift = Shift::new(scene);
    let image = |order| {
        let direction = rays.matrix.direction_of(&search.image(order)?, n)?;
        let photon = rays.photon(direction);
        let mut hit = search.crossing(&photon, order, true).hit()?;
        hit.g = shift.of_disk(hit.g, hit.r, search.lambda(&photon));
        image_of(scene, order, direction, hit)
    };
    Ok((0..ORDERS).filter_map(image).collect())
}

/// The search for a hot spot's images.
struct Search {
    spot: HotSpot,
    hole: HoleAndDisk,
    /// The camera: the rows of an observer without angular momentum there, and its place.
    zamo: ObserverMatrix,
    r: f64,
    n: DVec3,
    /// The unit vectors toward growing theta and growing phi there, in the disk's frame.
    tangents: [DVec3; 2],
    time: f64,
}

/// Where a ray crosses the disk's plane.
enum Crossing {
    /// The ray is captured first. This counts as inside the horizon.
    Captured,
    /// The ray escapes first. This counts as beyond infinity.
    Escaped,
    At(Hit),
    Unknown,
}

impl Crossing {
    fn hit(self) -> Option<Hit> {
        match self {
            Self::At(hit) => Some(hit),
            _ => None,
        }
    }
}

impl Search {
    /// The photon of an image, up to a factor.
    fn image(&self, order: u32) -> Option<Photon> {
        let photon = |node: f64| Some(self.photon(order, node, self.angle(order, node)?));
        // The lead of the crossing of the spot's orbit over the spot, as seen now. It grows with
        // the node, because the spot moves more slowly than light.
        let ahead = |node: f64| {
            let hit = self.crossing(&photon(node)?, order, true).hit()?;
            Some(wrap_angle(
                hit.phi - self.spot.azimuth(self.time - hit.delay?),
            ))
        };
        let guess = self.spot.azimuth(self.time - self.r);
        let mut node = guess - ahead(guess)?;
        let mut error = ahead(node)?;
        let step = -STEP * error.signum();
        for _ in 0..MAX_STEPS {
            let (next, next_error) = (node + step, ahead(node + step)?);
            // A change of sign is a root, unless it is a jump by a whole turn.
            if error * next_error <= 0.0 && (next_error - error).abs() < PI {
                let ends = [node.min(next), node.max(next)];
                return photon(bracketed_root(ends, AZIMUTH_TOLERANCE, ahead)?);
            }
            (node, error) = (next, next_error);
        }
        None
    }

    /// The photon whose backward ray leaves at this angle from the direction of the hole, and would
    /// cross the disk's plane at azimuth `node` without frame dragging: on that side first, and for
    /// an odd order on the other side.
    fn photon(&self, order: u32, node: f64, angle: f64) -> Photon {
        let (sin_node, cos_node) = node.sin_cos();
        let toward = DVec3::new(cos_node, sin_node, 0.0).reject_from_normalized(self.n);
        let side = if order.is_multiple_of(2) { 1.0 } else { -1.0 };
        let toward = side * toward.normalize_or_zero();
        let (sin, cos) = angle.sin_cos();
        let [theta, phi] = self.tangents.map(|tangent| sin * toward.dot(tangent));
        self.zamo.photon(DVec3::new(-cos, theta, phi))
    }

    /// The angle at which the crossing lies on the spot's orbit.
    fn angle(&self, order: u32, node: f64) -> Option<f64> {
        bracketed_root([0.0, PI], RADIUS_TOLERANCE, |angle| {
            match self.crossing(&self.photon(order, node, angle), order, false) {
                Crossing::Captured => Some(1.0 - self.spot.r() / self.hole.kerr.horizon()),
                Crossing::Escaped => Some(1.0),
                Crossing::At(hit) => Some(1.0 - self.spot.r() / hit.r),
                Crossing::Unknown => None,
            }
        })
    }

    /// A ray's crossing number `order` of the disk's plane, with the delay if asked for.
    fn crossing(&self, photon: &Photon, order: u32, delayed: bool) -> Crossing {
        let (constants, start) = PhotonConstants::of_photon(self.hole.kerr, photon, self.r, self.n);
        let mut lag = Lag::new(self.hole.kerr, &constants, &start);
        let (mut count, mut found) = (0, None);
        let trace = self.hole.follow(&constants, start, |step| {
            if count > order {
                return;
            }
            let end = step.expansion.at(step.length);
            if let Some(time) = time_to_plane(step.expansion, end.n.z, step.length) {
                if count == order {
                    let delay = delayed.then(|| lag.at(step, time));
                    found = Some((step.expansion.at(time), delay));
                }
                count += 1;
            }
            if delayed && found.is_none() {
                lag.add(step);
            }
        });
        match (found, trace.outcome) {
            // No matter orbits inside the photon orbit; the spot is farther out.
            (Some((state, delay)), _) => match self.hole.hit(&constants, &state) {
                Some(hit) => Crossing::At(Hit { delay, ..hit }),
                None => Crossing::Captured,
            },
            (None, Outcome::Sky) => Crossing::Escaped,
            (None, Outcome::Captured) => Crossing::Captured,
            (None, Outcome::Unfinished) => Crossing::Unknown,
        }
    }

    fn lambda(&self, photon: &Photon) -> f64 {
        self.r * self.n.cross(photon.w).z / photon.energy
    }
}

/// The image along straight rays, of which there is one at most.
fn straight_image(
    scene: &Scene,
    rays: &CameraRays,
    spot: &HotSpot,
) -> Result<Option<Image>, ObserverError> {
    let n = camera_in_disk_frame(scene);
    let start = scene.camera.r * n;
    let mut delay = scene.camera.r;
    let mut way = DVec3::ZERO;
    // Each step divides the error by at least 1.4, which is c over the spot's speed.
    for _ in 0..MAX_STEPS {
        let (sin, cos) = spot.azimuth(scene.disk.time - delay).sin_cos();
        way = spot.r() * DVec3::new(cos, sin, 0.0) - start;
        delay = way.length();
    }
    let toward = way / delay;
    let photon = Photon {
        energy: Shift::new(scene).camera().lapse,
        radial: -toward.dot(n),
        w: -toward.reject_from_normalized(n),
    };
    let reference = Reference::new(scene)?;
    Ok(rays.matrix.direction_of(&photon, n).and_then(|direction| {
        // None if the hole is in front of the spot.
        let hit = reference.trace_with_delays(direction).hits[0]?;
        image_of(scene, 0, direction, hit)
    }))
}

fn image_of(scene: &Scene, order: u32, direction: DVec3, hit: Hit) -> Option<Image> {
    let looking = scene.camera.tetrad_from_camera().transpose() * direction;
    Some(Image {
        order,
        direction,
        pixel: scene
            .camera
            .pixel_of(looking, scene.picture.size().as_dvec2()),
        hit,
        delay: hit.delay?,
    })
}

/// A root of a growing function between two places, by Ridders' method (1979), which keeps the root
/// between its last two places. It ends where the function is below the tolerance, or the places
/// are next to each other. `None` where the function is not known.
fn bracketed_root(
    [mut low, mut high]: [f64; 2],
    tolerance: f64,
    f: impl Fn(f64) -> Option<f64>,
) -> Option<f64> {
    let (mut below, mut above) = (f(low)?, f(high)?);
    if below > 0.0 || above < 0.0 {
        return None;
    }
    for _ in 0..MAX_STEPS {
        let middle = 0.5 * (low + high);
        let at_middle = f(middle)?;
        let straight = (at_middle * at_middle - below * above).sqrt();
        let share = if straight > 0.0 {
            at_middle / straight
        } else {
            0.0
        };
        let place = middle - (middle - low) * share;
        let value = f(place)?;
        if value.abs() < tolerance || high - low <= f64::EPSILON * high.abs() {
            return Some(place);
        }
        for (place, value) in [(middle, at_middle), (place, value)] {
            if value < 0.0 && place > low {
                (low, below) = (place, value);
            } else if value >= 0.0 && place < high {
                (high, above) = (place, value);
            }
        }
    }
    None
}
