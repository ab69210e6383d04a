//! The limits of a scene: each field inside its range, and the rules that tie one field to another.

use std::ops::Bound::{self, Excluded, Included};

use super::error::{Because, Refusal};
use super::field::Field;
use super::fields::FIELDS;
use super::matter::{MAX_THICKNESS, MIN_THICKNESS, THICKNESS_PIVOT};
use super::range::{Kind, Range, number};
use super::tables::{EDGE, POLAR};
use super::{DiskModel, Effects, HotSpotKind, MAX_FILE_PIXELS, MAX_PICTURE_SIDE, Scene};
use crate::geometry::kerr::Kerr;
use crate::geometry::observer::{Limit, min_infall_radius};
use crate::geometry::sphere::polar_sin_cos;

impl Scene {
    /// Checks every field against its range and against the fields it depends on.
    ///
    /// A circular orbit off the disk's plane passes: it can be loaded and then moved into the
    /// plane. It is refused where the observer's matrix is made, and so it cannot be drawn.
    ///
    /// # Errors
    /// The first field, in the order of the table, whose value is not allowed.
    pub fn check(&self) -> Result<(), Refusal> {
        for field in FIELDS.iter() {
            let value = field.get(self);
            field.check_kind(&value)?;
            let (range, because) = self.range(field);
            if value.number().is_some_and(|number| !range.contains(number)) {
                return Err(Refusal {
                    key: field.key,
                    given: value.quoted(),
                    allowed: field.allowed_in(range),
                    because,
                    blamed: None,
                });
            }
        }
        Ok(())
    }

    /// The range that the other fields of this scene leave a field, and which of them narrow it.
    /// Fields that are not numbers have no range of their own: [`Range::FINITE`].
    pub fn range(&self, field: &Field) -> (Range, Option<Because>) {
        let (Kind::Float(range) | Kind::Integer(range)) = field.kind else {
            return (Range::FINITE, None);
        };
        let because = |keys: &[&'static str], reason: String| {
            let keys = keys.to_vec();
            Some(Because { keys, reason })
        };
        let spin = number(self.hole.spin);
        match field.key {
            "camera.r" => {
                let (low, because) = self.min_camera_radius();
                (Range { low, ..range }, Some(because))
            }
            // The edge follows the innermost stable orbit otherwise, whatever disk.inner says.
            // An outer edge that is refused itself limits nothing.
            "disk.inner" if !self.disk.follow_isco && self.has_outer_edge() => {
                let high = Excluded(self.disk.outer);
                let reason = format!("disk.outer is {}", number(self.disk.outer));
                let keys = ["disk.outer", "disk.follow_isco"];
                (Range { high, ..range }, because(&keys, reason))
            }
            "disk.outer" if self.disk.enabled => {
                let low = Excluded(self.kerr().isco());
                let reason = format!("the innermost stable circular orbit at hole.spin = {spin}");
                let keys = ["hole.spin", "disk.enabled"];
                (Range { low, ..range }, because(&keys, reason))
            }
            "disk.tilt_deg" if self.hole.spin != 0.0 => {
                let reason = format!(
                    "a thin disk around a hole that spins, here with hole.spin = {spin}, is steady in the equator only"
                );
                (Range::closed(0.0, 0.0), because(&["hole.spin"], reason))
            }
            "disk.thickness" if self.disk.thickness > 0.0 => {
                let low = Included(MIN_THICKNESS);
                let reason = "0 for a sheet without thickness".into();
                (Range { low, ..range }, because(&[], reason))
            }
            "disk.flare" if self.has_thick_disk() && self.has_outer_edge() => {
                let keys = [
                    "disk.thickness",
                    "disk.inner",
                    "disk.outer",
                    "disk.follow_isco",
                ];
                let reason = format!(
                    "with disk.thickness = {} the disk would be higher than {MAX_THICKNESS} of the radius at an edge",
                    number(self.disk.thickness)
                );
                (self.flares(), because(&keys, reason))
            }
            "hot_spot.r" if self.disk.enabled && self.hot_spot.kind != HotSpotKind::None => {
                let keys = [
                    "disk.inner",
                    "disk.outer",
                    "disk.follow_isco",
                    "disk.enabled",
                    "hole.spin",
                    "hot_spot.kind",
                ];
                let range = Range::closed(self.inner_edge(), self.disk.outer);
                (
                    range,
                    because(&keys, "between the edges of the disk".into()),
                )
            }
            "disk.period" if self.disk.period > 0.0 => {
                let low = Included(MIN_PERIOD);
                let reason = "0 for a structure that never repeats".into();
                (Range { low, ..range }, because(&[], reason))
            }
            "picture.height" => {
                let most = f64::from(MAX_FILE_PIXELS / self.picture.width.max(1));
                let reason = format!("picture.width is {}", self.picture.width);
                match range.high {
                    Included(high) if most < high => {
                        let high = Included(most);
                        (Range { high, ..range }, because(&["picture.width"], reason))
                    }
                    _ => (range, None),
                }
            }
            "picture.grid_width" => grid_range("picture.width", self.picture.width),
            "picture.grid_height" => grid_range("picture.height", self.picture.height),
            _ => (range, None),
        }
    }

    /// Whether the disk's outer edge is allowed, whatever the inner one is.
    fn has_outer_edge(&self) -> bool {
        let outer = self.disk.outer;
        EDGE.contains(outer) && (!self.disk.enabled || outer > self.kerr().isco())
    }

    /// The disk's inner edge: `disk.inner`, or the innermost stable circular orbit where that lies
    /// farther out or `disk.follow_isco` asks for it.
    pub fn inner_edge(&self) -> f64 {
        let isco = self.kerr().isco();
        if self.disk.follow_isco {
            isco
        } else {
            self.disk.inner.max(isco)
        }
    }

    /// Whether the disk's flux counts the light that gravity bends back to the disk. It is known for
    /// relativistic disks that begin at the innermost stable orbit, and without bending there is
    /// none.
    pub fn has_returning_light(&self) -> bool {
        self.disk.returning
            && self.disk.model == DiskModel::PageThorne
            && self.effects.lensing
            && self.begins_at_isco()
    }

    /// Whether the disk begins at the innermost stable circular orbit.
    pub(super) fn begins_at_isco(&self) -> bool {
        self.inner_edge() <= self.kerr().isco()
    }

    /// The flares with which the height over the radius is at most [`MAX_THICKNESS`] at both edges.
    fn flares(&self) -> Range {
        let growth = (MAX_THICKNESS / self.disk.thickness).max(1.0).ln();
        let inner = self.inner_edge();
        let pivot = THICKNESS_PIVOT * inner;
        let at_edge = |ratio: f64| growth / ratio.max(1.0 + 1e-9).ln();
        Range {
            low: Included((-at_edge(pivot / inner)).max(-1.0)),
            high: Included(at_edge(self.disk.outer / pivot).min(1.0)),
        }
    }

    /// How near to the hole the camera may be: as near as its observer exists
    /// ([`ObserverKind`](super::ObserverKind) knows where), and as near as motion leads.
    fn min_camera_radius(&self) -> (Bound<f64>, Because) {
        let (kerr, theta_deg) = (self.kerr(), self.camera.theta_deg);
        let at_spin = format!("at hole.spin = {}", number(self.hole.spin));
        let mut keys = vec!["hole.spin", "observer.kind"];
        let limit = match self.observer.kind.properties().limit {
            // Without spin there is no ergosphere, and without an angle its size is not known.
            Limit::StaticLimit if self.hole.spin == 0.0 || !POLAR.contains(theta_deg) => {
                Limit::Horizon
            }
            limit => limit,
        };
        let low = Excluded(limit.radius(kerr, polar_sin_cos(theta_deg.to_radians()).1));
        let (low, reason) = match limit {
            Limit::StaticLimit => {
                keys.push("camera.theta_deg");
                let theta_deg = number(theta_deg);
                let reason = format!(
                    "nothing is at rest in the ergosphere, which reaches this far {at_spin} and camera.theta_deg = {theta_deg}; \
                     observers zamo and rain go deeper"
                );
                (low, reason)
            }
            Limit::Horizon => (
                low,
                format!("outside the horizon {at_spin}; observer rain goes on inside"),
            ),
            Limit::PhotonOrbit => (low, format!("outside the prograde photon orbit {at_spin}")),
            Limit::InnerHorizon => match self.effects.missing_inside() {
                missing if missing.is_empty() => {
                    let reason = format!("nine tenths of the way between the horizons {at_spin}");
                    (Included(min_infall_radius(kerr)), reason)
                }
                missing => {
                    let off = missing.join(", ");
                    keys.extend(missing);
                    let reason = format!("outside the horizon {at_spin}, where {off} is false");
                    (Excluded(kerr.horizon()), reason)
                }
            },
        };
        (low, Because { keys, reason })
    }

    /// The geometry of the scene's hole.
    #[must_use]
    pub fn kerr(&self) -> Kerr {
        Kerr {
            spin: self.hole.spin,
        }
    }
}

/// The shortest period of a disk's structure, in r_s/c. Without a period no filament lives for
/// less: the shortest orbit takes 6.3 r_s/c, and the shortest life is a quarter of an orbit.
const MIN_PERIOD: f64 = 2.0;

/// Largest number of pixels of the HDR picture that a presentation cell averages along each axis.
/// It bounds the loops of presentation.wgsl.
pub const MAX_PIXELS_PER_CELL: u32 = 64;

/// The range of a side of the presentation grid. A cell is at least one pixel of the HDR picture,
/// so that the reduction averages and never invents.
fn grid_range(key: &'static str, side: u32) -> (Range, Option<Because>) {
    let min = f64::from(side.div_ceil(MAX_PIXELS_PER_CELL)).max(1.0);
    let because = Because {
        keys: vec![key],
        reason: format!("{key} is {side}"),
    };
    let max = f64::from(side.min(MAX_PICTURE_SIDE));
    (Range::closed(min, max), Some(because))
}

impl Effects {
    /// The keys of the effects that are off and that only an observer outside the horizon can tell
    /// apart from the others.
    fn missing_inside(&self) -> Vec<&'static str> {
        let needed = [
            ("effects.lensing", self.lensing),
            ("effects.doppler", self.doppler),
            ("effects.gravitational_shift", self.gravitational_shift),
            ("effects.aberration", self.aberration),
        ];
        needed
            .into_iter()
            .filter(|(_, on)| !on)
            .map(|(key, _)| key)
            .collect()
    }
}
