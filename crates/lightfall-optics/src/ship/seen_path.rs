//! The path ahead as the pilot sees it: where light from its points arrives, as from a wire at rest.

use super::aim::Eye;
use super::path::{Apsis, path_ahead};
use super::pose::{BoardError, Mount, board};
use crate::guides::Sky;
use glam::{DMat3, DVec3};
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::scene::Scene;

/// Maximum number of points: half a turn.
const MAX_POINTS: usize = 64;
/// A wire is not followed farther after so many points in a row that are not seen.
const MAX_UNSEEN: u32 = 6;

/// The path ahead on the observer's sky.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SeenPath {
    /// Unit directions on the observer's axes (outward, toward growing theta, toward growing phi), from
    /// the observer on. `None` for a point that is not seen.
    pub points: Vec<Option<DVec3>>,
    /// The turning points, with their directions.
    pub apsides: Vec<(Apsis, DVec3)>,
}

/// The path of the scene's observer from now on if it only falls, as its primary image is seen in bent
/// light: of half a turn at most, since then the image is on the other side of the hole. Inside the
/// horizon nothing of it is seen. Without lensing the lines of sight are straight.
///
/// # Errors
/// The scene's observer does not exist, or is where no flight is followed.
pub fn seen_path(scene: &Scene) -> Result<SeenPath, BoardError> {
    let ship = board(scene, &Mount::NOSE)?;
    let horizon = scene.kerr().horizon();
    if scene.camera.r <= horizon {
        return Ok(SeenPath::default());
    }
    // The first point is the ship's own place.
    let path = path_ahead(&ship, MAX_POINTS + 1).into_iter().skip(1);
    let path: Vec<_> = path
        .take_while(|point| point.place.length() > horizon)
        .collect();
    let places: Vec<_> = path.iter().map(|point| point.place).collect();
    let points = seen_wire(scene, &places)?;
    let apsides = path
        .iter()
        .zip(&points)
        .filter_map(|(point, seen)| Some((point.apsis?, (*seen)?)))
        .collect();
    Ok(SeenPath { points, apsides })
}

/// The directions, on the observer's axes, in which a wire at rest is seen that begins near the observer:
/// its primary image. `places` are points of it, each r times the direction of theta and Kerr's ingoing
/// azimuth, outside the horizon. `None` for points that are not seen; what comes after six in a row is
/// left out.
///
/// # Errors
/// The scene's observer does not exist outside the horizon.
pub fn seen_wire(scene: &Scene, places: &[DVec3]) -> Result<Vec<Option<DVec3>>, ObserverError> {
    let kerr = scene.kerr();
    let sky = Sky::of_zamo(scene)?;
    let eye = Eye {
        kerr,
        r: sky.r,
        n: sky.n,
        frame: sky.frame,
    };
    let mut seen = Vec::with_capacity(places.len());
    // The last two directions in which points were found.
    let (mut last, mut before): (Option<DVec3>, Option<DVec3>) = (None, None);
    let mut unseen = 0;
    for place in places {
        let lead = kerr.ingoing_azimuth_lead(place.length());
        let place = DMat3::from_rotation_z(-lead) * *place;
        let straight = (sky.axes.transpose() * (place - sky.r * sky.n)).try_normalize();
        let found = if scene.effects.lensing {
            let guess = match (last, before) {
                (Some(last), Some(before)) => (2.0 * last - before).try_normalize(),
                (Some(last), None) => Some(last),
                (None, _) => straight,
            };
            guess.and_then(|guess| eye.aim_at_place(guess, place))
        } else {
            straight
        };
        seen.push(found.and_then(|direction| sky.seen(direction)));
        if found.is_some() {
            (before, last, unseen) = (last, found, 0);
        } else {
            (before, unseen) = (None, unseen + 1);
        }
        if unseen == MAX_UNSEEN {
            break;
        }
    }
    Ok(seen)
}
