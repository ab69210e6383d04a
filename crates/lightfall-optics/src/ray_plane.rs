//! A ray in its own plane, as textbooks draw light that passes a mass: r against the angle swept
//! about the hole, the directions of the light at both ends, and the angle between them.
//!
//! Without spin every ray lies in a plane through the hole, the camera and the looking direction,
//! and this is the ray in that plane. With spin it is not a plane curve; r against the angle swept
//! along it is then the curve unrolled into a plane.

use crate::path::Path;
use crate::reference::Reference;
use crate::trace::{Hit, Outcome, Trace};
use glam::{DVec2, DVec3};
use lightfall_model::geometry::observer::{ObserverKind, Photon};
use lightfall_model::geometry::sphere::angle_between;
use lightfall_model::scene::Scene;
use std::f64::consts::PI;

/// Hits count as a crossing of the drawn path if their radii agree to this share: the path has
/// some hundred points.
const HIT_TOLERANCE: f64 = 0.05;
/// Below this sine of the angle between the ray's plane and the disk's, both count as the same.
const SAME_PLANE: f64 = 1e-6;

/// A ray as a plane curve. The hole is at the origin, the camera is on the x axis, and the backward
/// ray leaves it toward positive y. Lengths in r_s.
#[derive(Clone, Debug, PartialEq)]
pub struct RayPlane {
    /// The path from the camera on, to its end.
    pub points: Vec<DVec2>,
    /// Unit vector at the camera, toward where an observer with zero angular momentum (without
    /// spin: at rest) sees the light come from. `None` inside the horizon.
    pub looking: Option<DVec2>,
    /// Polar angle of the source at infinity, in radians, counted along the path: more than a full
    /// turn for a ray that winds. `None` unless light from the sky arrives without a hit.
    pub source: Option<f64>,
    /// The disk's hits: the number of points of the path before each, and its place.
    pub hits: [Option<(usize, DVec2)>; 2],
    /// The point of the path nearest to the hole. `None` if that is an end.
    pub closest: Option<DVec2>,
    /// The intersection with the disk's plane. `None` with spin.
    pub disk: Option<DiskSection>,
    /// The angle, in radians, by which gravity turns the light on its way from infinity to the
    /// camera: from the direction in which it comes in at infinity to the one in which the observer
    /// of [`looking`](Self::looking) receives it. Without spin turns are counted: the swept angle
    /// less that of a straight line (Ishihara et al. 2016, Phys. Rev. D 94, 084015, eq. 3). With
    /// spin it is the angle between both directions, from 0 to pi. `None` unless lensed light from
    /// the sky arrives without a hit.
    pub deflection: Option<f64>,
}

/// How the disk's plane cuts the plane of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DiskSection {
    /// In a straight line through the hole, at this polar angle in radians.
    Line(f64),
    /// They are the same plane.
    Plane,
}

impl RayPlane {
    /// The ray of `scene` that arrives from the unit direction `direction`, given on the observer's
    /// axes, with its trace and its path.
    pub fn of(
        scene: &Scene,
        reference: &Reference,
        direction: DVec3,
        trace: &Trace,
        path: &Path,
    ) -> Self {
        // The path is in the disk's frame, the sky and what the observer sees in the hole's.
        let (_, n_for_disk) = reference.camera();
        let n = scene.camera.direction();
        let swept = swept_angles(&path.points);
        let points: Vec<DVec2> = swept
            .iter()
            .zip(&path.points)
            .map(|(angle, place)| place.length() * DVec2::from_angle(*angle))
            .collect();
        // Without lensing the photon is that of flat space, whose direction is simply its own.
        let lensed = reference.lensing();
        let photon = reference.photon(direction.normalize());
        let photon = Photon {
            w: scene.disk.hole_from_disk() * photon.w,
            ..photon
        };
        let received = if lensed {
            received_direction(scene, &photon)
        } else {
            Some((-photon.radial * n - photon.w).normalize())
        };
        let looking = received.map(|toward| {
            let outward = toward.dot(n);
            DVec2::new(outward, (1.0 - outward * outward).max(0.0).sqrt())
        });
        let spins = scene.hole.spin != 0.0;
        let sky = trace.sky.filter(|_| trace.hits[0].is_none());
        let source = sky.map(|sky| {
            let drawn = || {
                let last = path.points[path.points.len() - 1];
                swept[swept.len() - 1] + angle_between(last.normalize(), sky)
            };
            if spins { drawn() } else { path.swept_angle }
        });
        let deflection = if spins {
            sky.zip(received)
                .map(|(sky, toward)| angle_between(sky, toward))
        } else {
            // A straight line in the looking direction sweeps the angle from the camera's own
            // direction to that one.
            source
                .zip(looking)
                .map(|(source, toward)| source - toward.to_angle())
        };
        Self {
            closest: closest(&points, path.closest_r, trace),
            hits: hits(path, &swept, trace),
            disk: (!spins).then(|| disk_section(n_for_disk, &path.points)),
            deflection: deflection.filter(|_| lensed),
            points,
            looking,
            source,
        }
    }
}

/// The angle swept about the hole at each point, from 0 at the first.
fn swept_angles(points: &[DVec3]) -> Vec<f64> {
    let mut angle = 0.0;
    let mut angles = vec![0.0; points.len()];
    for (i, pair) in points.windows(2).enumerate() {
        angle += angle_between(pair[0].normalize_or_zero(), pair[1].normalize_or_zero());
        angles[i + 1] = angle;
    }
    angles
}

/// The unit vector toward where the observer with zero angular momentum at the camera's place sees
/// a photon come from, in the hole's frame. `None` inside the horizon, where there is no such
/// observer.
fn received_direction(scene: &Scene, photon: &Photon) -> Option<DVec3> {
    let zamo = scene
        .observer_at_camera(ObserverKind::Zamo, [0.0; 3])
        .ok()?;
    let direction = zamo.direction_of(photon, scene.camera.direction())?;
    Some(scene.camera.tetrad() * direction)
}

/// The place of the smallest radius, if the path turns there and its light is seen.
fn closest(points: &[DVec2], closest_r: f64, trace: &Trace) -> Option<DVec2> {
    let seen = trace.outcome == Outcome::Sky && trace.hits[0].is_none();
    let nearest = (0..points.len())
        .min_by(|a, b| points[*a].length().total_cmp(&points[*b].length()))
        .filter(|place| seen && *place > 0 && *place + 1 < points.len())?;
    points[nearest]
        .try_normalize()
        .map(|toward| closest_r * toward)
}

/// The hits along the path: where it crosses the disk's plane at their radii.
fn hits(path: &Path, swept: &[f64], trace: &Trace) -> [Option<(usize, DVec2)>; 2] {
    let mut crossings = path.points.windows(2).enumerate().filter_map(|(i, pair)| {
        let (before, after) = (pair[0].z, pair[1].z);
        let crosses = before * after < 0.0 || after == 0.0 && before != 0.0;
        let share = before / (before - after);
        crosses.then(|| {
            let r = pair[0].length() + share * (pair[1].length() - pair[0].length());
            (i + 1, r, swept[i] + share * (swept[i + 1] - swept[i]))
        })
    });
    trace.hits.map(|hit| {
        let Hit { r: radius, .. } = hit?;
        crossings
            .find(|(_, r, _)| (r - radius).abs() < HIT_TOLERANCE * radius)
            .map(|(before, _, angle)| (before, radius * DVec2::from_angle(angle)))
    })
}

/// Where the disk's plane cuts the plane of the points, which begin at the camera's unit vector
/// `n`.
fn disk_section(n: DVec3, points: &[DVec3]) -> DiskSection {
    let aside = points
        .iter()
        .map(|place| place.reject_from_normalized(n))
        .find(|aside| aside.length() > 1e-9)
        .map_or(DVec3::ZERO, DVec3::normalize);
    let node = n.cross(aside).cross(DVec3::Z);
    if aside == DVec3::ZERO {
        // A radial ray lies in many planes; the one through the axis shows the disk best.
        return DiskSection::Line(0.5 * PI - n.z.clamp(-1.0, 1.0).acos());
    }
    if node.length() < SAME_PLANE {
        return DiskSection::Plane;
    }
    DiskSection::Line(node.dot(aside).atan2(node.dot(n)))
}
