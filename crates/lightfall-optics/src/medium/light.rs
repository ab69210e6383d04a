//! The light of a scene's matter with depth.

use super::disk_matter::{DiskMatter, Matter, Place};
use super::emission::{Emission, Emitter};
use super::jet::{FieldPlace, Jet, JetMatter, JetPlace, Knots};
use super::nodes::Nodes;
use super::passage::Passage;
use super::sheet::Sheet;
use super::stretches::{MatterKind, Stretch, stretches};
use super::thick_disk::ThickDisk;
use super::transfer::{Filling, Piece, Tolerance};
use crate::camera_rays::camera_in_disk_frame;
use crate::disk::{Profile, lit, temperature};
use crate::photometry::DISK_HDR_SCALE;
use crate::reference::HoleAndDisk;
use crate::shift::Shift;
use crate::structure::{Covariance, Event, Structure};
use crate::{spectrum, synchrotron};
use glam::DVec3;
use lightfall_model::geometry::mino::PhotonConstants;
use lightfall_model::geometry::observer::Photon;
use lightfall_model::scene::{Disk, DiskStructure, Scene};

/// The matter with depth of a scene, and how it shines for the scene's camera.
#[derive(Clone, Debug)]
pub struct Medium {
    disk: Option<ThickDisk>,
    jet: Option<Jet>,
    knots: Option<Knots>,
    /// A disk without thickness, between the jets.
    sheet: Option<Sheet>,
    nodes: Nodes,
    profile: Profile,
    lit: Disk,
    jet_scale: f64,
    shift: Shift,
    structure: Option<Structure>,
    /// Standard deviations of the logarithms of the flux and of the density.
    spread: [f64; 2],
    way: HoleAndDisk,
    r: f64,
    n: DVec3,
}

impl Medium {
    /// The medium of a scene, integrated with so many nodes in a chunk; `None` if it has none.
    pub fn of(scene: &Scene, nodes: usize) -> Option<Self> {
        let structure = Structure::new(scene, None).filter(|_| scene.has_thick_disk());
        let spread = structure
            .as_ref()
            .map_or([0.0; 2], |structure| structure.spread(&scene.disk));
        let (disk, jet) = (ThickDisk::of(scene), Jet::of(scene));
        // The radii between which a ray must be followed.
        let mut radii: Vec<f64> = Vec::new();
        radii.extend(
            jet.iter()
                .flat_map(|jet| [jet.shape.base, jet.shape.length]),
        );
        if scene.disk.enabled {
            radii.extend([scene.inner_edge(), scene.disk.outer]);
        }
        let inner = radii.iter().copied().fold(f64::INFINITY, f64::min);
        let outer = radii.iter().copied().fold(0.0, f64::max);
        scene.has_medium().then(|| Self {
            structure,
            spread,
            disk,
            jet,
            knots: Knots::of(scene),
            sheet: Sheet::of(scene),
            nodes: Nodes::new(nodes),
            profile: Profile::new(scene),
            lit: lit(scene),
            jet_scale: scene.jet.brightness * DISK_HDR_SCALE,
            shift: Shift::new(scene),
            way: HoleAndDisk {
                kerr: scene.kerr(),
                annulus: Some([inner, outer]),
            },
            r: scene.camera.r,
            n: camera_in_disk_frame(scene),
        })
    }

    /// As [`Self::of`], without the disk's structure and the jets' knots.
    pub fn smooth(scene: &Scene, nodes: usize) -> Option<Self> {
        let mut smooth = scene.clone();
        smooth.disk.structure = DiskStructure::None;
        smooth.jet.knots = 0.0;
        Self::of(&smooth, nodes)
    }

    /// The light in linear sRGB that reaches the camera as this photon, given in the disk's frame,
    /// and the optical depth of its way.
    pub fn seen(&self, photon: &Photon, tolerance: Tolerance) -> Passage {
        self.passage(photon, tolerance, false)
    }

    /// As [`Self::seen`], with the means of where the light comes from.
    pub fn seen_with_means(&self, photon: &Photon, tolerance: Tolerance) -> Passage {
        self.passage(photon, tolerance, true)
    }

    fn passage(&self, photon: &Photon, tolerance: Tolerance, with_means: bool) -> Passage {
        let mut passage = Passage::default();
        self.follow(photon, tolerance, with_means, |piece| {
            passage = passage.followed_by(piece.passage);
        });
        passage
    }

    /// The stretches of the ray's way on which there is matter, from the camera on, and what
    /// [`Self::seen_with_means`] says of the whole way.
    pub fn stretches(&self, photon: &Photon, tolerance: Tolerance) -> (Vec<Stretch>, Passage) {
        let mut kinds = Vec::new();
        kinds.extend(self.disk.as_ref().map(|_| MatterKind::Disk));
        kinds.extend(self.jet.as_ref().map(|_| MatterKind::Jets));
        let mut pieces = Vec::new();
        self.follow(photon, tolerance, true, |piece| pieces.push(piece));
        stretches(pieces, &kinds)
    }

    /// Follows the ray of a photon, piece by piece.
    fn follow(
        &self,
        photon: &Photon,
        tolerance: Tolerance,
        with_means: bool,
        meet: impl FnMut(Piece),
    ) {
        let (constants, start) = PhotonConstants::of_photon(self.way.kerr, photon, self.r, self.n);
        let lambda = constants.angular_momentum / constants.energy;
        let disk = self.disk.as_ref().map(|disk| DiskMatter {
            disk,
            matter: |place: &Place, emission: &Emission| {
                let [flux, density] = self.factors(place, emission);
                Matter {
                    density,
                    light: self.body_light(place, lambda, flux),
                }
            },
        });
        let jet = self.jet.as_ref().map(|jet| JetMatter {
            jet,
            light: |place: &JetPlace, emission: &Emission| {
                self.jet_light(jet, place, emission, lambda)
            },
        });
        let sheet = self.sheet.as_ref();
        let sheet = sheet.map(|sheet| |emission: &Emission| sheet.crossed(photon, emission));
        let mut emitters: Vec<&dyn Emitter> = Vec::new();
        emitters.extend(disk.iter().map(|disk| disk as &dyn Emitter));
        emitters.extend(jet.iter().map(|jet| jet as &dyn Emitter));
        let filling = Filling {
            way: self.way,
            emitters,
            sheet: sheet.as_ref().map(|sheet| sheet as _),
            with_means,
        };
        filling.follow(&constants, start, &self.nodes, tolerance, meet);
    }

    /// The factors by which the structure multiplies the flux and the density.
    fn factors(&self, place: &Place, emission: &Emission) -> [f64; 2] {
        let Some(structure) = &self.structure else {
            return [1.0; 2];
        };
        let event = Event {
            r: place.r,
            phi: emission.azimuth(),
            cos_theta: place.cos_theta,
            time: self.lit.time - emission.lag(),
        };
        let field = structure.field(&event, Covariance::POINT);
        self.spread.map(|sigma| field.factor(sigma))
    }

    /// The radiance of an opaque body in the place of the matter, as the camera sees it, with the flux
    /// multiplied by a factor.
    fn body_light(&self, place: &Place, lambda: f64, factor: f64) -> DVec3 {
        let g = self.shift_at(place.g, [place.r, place.cos_theta], lambda);
        let flux = self.profile.flux(place.r) * factor;
        // As pictures have it: colours between the ends of the table, and none with negative light.
        let seen = (g * temperature(&self.lit, flux)).clamp(
            spectrum::TABLE_MIN_TEMPERATURE,
            spectrum::TABLE_MAX_TEMPERATURE,
        );
        let colour = DVec3::from(spectrum::colour(seen)).max(DVec3::ZERO);
        colour * flux * self.shift.beaming_factor(g) * self.lit.brightness * DISK_HDR_SCALE
    }

    /// What the camera sees for each unit of the smooth jets' emission.
    fn jet_light(&self, jet: &Jet, place: &JetPlace, emission: &Emission, lambda: f64) -> DVec3 {
        let g = self.shift_at(place.g, [place.r, place.cos_theta], lambda);
        let factor = self.knots.as_ref().map_or(1.0, |knots| {
            knots.factor(&FieldPlace {
                r: place.r,
                cos_theta: place.cos_theta,
                phi: emission.azimuth(),
                time: self.lit.time - emission.lag(),
            })
        });
        let colour = DVec3::from(synchrotron::colour(g * jet.frequency(place.r, factor)));
        colour * factor * self.shift.beaming_factor(g) * self.jet_scale
    }

    /// The shift without the effects that are off, where `g` is the whole one.
    fn shift_at(&self, g: f64, [r, cos_theta]: [f64; 2], lambda: f64) -> f64 {
        let theta = cos_theta.clamp(-1.0, 1.0).acos();
        self.shift.of_matter(g, (r, theta), lambda)
    }
}
