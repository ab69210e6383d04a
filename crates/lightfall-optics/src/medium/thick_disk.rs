//! A disk with thickness: its shape, its matter and its smooth light. The twin in WGSL is
//! shaders/medium/thick_disk.wgsl.

use super::source::{emission_scale, scattering_source};
use lightfall_model::geometry::kerr::{Kerr, MASS};
use lightfall_model::scene::{LimbDarkening, Scene, THICKNESS_PIVOT};

/// The share of the height that remains at the edges, where the depth vanishes. Without it, tips of
/// the disk would be thinner than any pixel.
const EDGE_HEIGHT: f64 = 0.3;
/// Half of the disk's opening in units of its root mean square height.
const HALF_OPENING: f64 = 3.0;
/// The least -(g_tt + 2 g_tphi Omega + g_phiphi Omega^2) of the matter: beside the photon orbit no
/// matter can rotate like this, and its light is all but gone.
const MIN_CLOCK: f64 = 1e-6;

/// The numbers of a disk's shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Inner and outer edge, in r_s.
    pub edges: [f64; 2],
    /// Width of the fade at the two edges, as shares of their radii.
    pub tapers: [f64; 2],
    /// H/r: the root mean square height over the radius, at four times the inner edge.
    pub thickness: f64,
    /// The power of the radius with which H/r grows.
    pub flare: f64,
    /// Optical depth along the disk's normal.
    pub depth: f64,
}

/// A disk with thickness around a hole.
///
/// Its density falls as (1 - zeta^2)^3 of the height zeta in units of its half opening: the
/// polytrope with n = 3 of a disk that radiation holds up. It ends at zeta = 1, and is a polynomial,
/// so that few nodes give its integral.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThickDisk {
    /// The hole.
    pub kerr: Kerr,
    /// The shape.
    pub shape: Shape,
    /// How the brightness depends on the angle at which the disk is seen.
    pub limb: LimbDarkening,
    /// The scale of the source of a scattering disk.
    emission_scale: f64,
}

impl ThickDisk {
    /// The disk of this shape around a hole.
    pub fn new(kerr: Kerr, shape: Shape, limb: LimbDarkening) -> Self {
        Self {
            kerr,
            shape,
            limb,
            emission_scale: match limb {
                LimbDarkening::None => 1.0,
                LimbDarkening::ElectronScattering => emission_scale(shape.depth),
            },
        }
    }

    /// The disk of a scene; `None` if it has no thickness.
    pub fn of(scene: &Scene) -> Option<Self> {
        let disk = &scene.disk;
        let shape = Shape {
            edges: [scene.inner_edge(), disk.outer],
            tapers: [disk.edge_taper, disk.outer_taper],
            thickness: disk.thickness,
            flare: disk.flare,
            depth: disk.depth,
        };
        scene
            .has_thick_disk()
            .then(|| Self::new(scene.kerr(), shape, disk.limb))
    }

    /// The scale of the source of a scattering disk; 1 for one that is equally bright from
    /// everywhere.
    pub fn emission_scale(&self) -> f64 {
        self.emission_scale
    }

    /// The radius at which the thickness is that of the shape.
    pub fn pivot(&self) -> f64 {
        THICKNESS_PIVOT * self.shape.edges[0]
    }

    /// The half opening at the pivot, without the edges' fades.
    pub fn pivot_half_opening(&self) -> f64 {
        HALF_OPENING * self.shape.thickness
    }

    /// The radii where the fades of the edges begin and end, in growing order: between two of them
    /// the disk is smooth.
    pub fn radii(&self) -> [f64; 4] {
        let ([inner, outer], [in_taper, out_taper]) = (self.shape.edges, self.shape.tapers);
        let ends = [inner * (1.0 + in_taper), outer * (1.0 - out_taper)];
        [inner, ends[0].min(ends[1]), ends[0].max(ends[1]), outer]
    }

    /// The fade at the inner and at the outer edge.
    fn fades(&self, r: f64) -> [f64; 2] {
        let ([inner, outer], [in_taper, out_taper]) = (self.shape.edges, self.shape.tapers);
        [
            fade((r - inner) / (in_taper * inner).max(1e-6)),
            fade((outer - r) / (out_taper * outer).max(1e-6)),
        ]
    }

    /// Half of the disk's opening at radius `r`, as the cosine of the angle from the normal; zero
    /// outside the edges.
    pub fn half_opening(&self, r: f64) -> f64 {
        let [inner, outer] = self.shape.edges;
        if !(r > inner && r < outer) {
            return 0.0;
        }
        let [_, out] = self.fades(r);
        let torque = 1.0 - (inner / r).powf(1.5);
        let height = EDGE_HEIGHT + (1.0 - EDGE_HEIGHT) * torque * out;
        let flare = (r / self.pivot()).powf(self.shape.flare);
        self.pivot_half_opening() * height * flare
    }

    /// The largest half opening of any radius, at most.
    pub fn max_half_opening(&self) -> f64 {
        let flares = self
            .shape
            .edges
            .map(|r| (r / self.pivot()).powf(self.shape.flare));
        self.pivot_half_opening() * flares[0].max(flares[1])
    }

    /// Optical depth along the normal at radius `r`.
    pub fn vertical_depth(&self, r: f64) -> f64 {
        let [inner, out] = self.fades(r);
        self.shape.depth * inner * out
    }

    /// kappa rho, in 1/r_s: the optical depth for each r_s of the way in the matter's frame.
    pub fn opacity(&self, r: f64, cos_theta: f64) -> f64 {
        let opening = self.half_opening(r);
        let rest = 1.0 - (cos_theta / opening.max(1e-30)).powi(2);
        if !(opening > 0.0 && rest > 0.0) {
            return 0.0;
        }
        // 35/32 makes the integral of (1 - zeta^2)^3 from -1 to 1 one.
        35.0 / 32.0 * self.vertical_depth(r) / (r * opening) * rest.powi(3)
    }

    /// The source function over that of an opaque disk without limb darkening, F/pi.
    pub fn source(&self, r: f64, cos_theta: f64) -> f64 {
        match self.limb {
            LimbDarkening::None => 1.0,
            LimbDarkening::ElectronScattering => {
                let zeta = cos_theta / self.half_opening(r).max(1e-30);
                // The share of the column between the middle and zeta, twice: the integral of the
                // density.
                let squared = zeta * zeta;
                let column =
                    35.0 / 16.0 * zeta * (1.0 - squared * (1.0 - squared * (0.6 - squared / 7.0)));
                let from_face = 0.25 * self.vertical_depth(r) * (1.0 - column * column);
                self.emission_scale * scattering_source(from_face, self.shape.depth)
            }
        }
    }

    /// Omega and u^t of the matter at radius `r` and height cos(theta): it turns as the circular
    /// orbit at the same distance from the axis does.
    pub fn rotation(&self, r: f64, cos_theta: f64) -> [f64; 2] {
        let a = self.kerr.a();
        let sin2 = 1.0 - cos_theta * cos_theta;
        let axial = r * sin2.max(1e-12).sqrt();
        let omega = MASS.sqrt() / (axial * axial.sqrt() + a * MASS.sqrt());
        let sigma = self.kerr.sigma(r, cos_theta);
        // g_tt, g_tphi and g_phiphi (Misner, Thorne & Wheeler 1973 eq. 33.2, 2M = 1).
        let [tt, t_phi] = [r / sigma - 1.0, -a * r * sin2 / sigma];
        let phi_phi = (r * r + a * a + a * a * r * sin2 / sigma) * sin2;
        let clock = -(tt + omega * (2.0 * t_phi + omega * phi_phi));
        [omega, clock.max(MIN_CLOCK).sqrt().recip()]
    }
}

/// Smoothstep.
fn fade(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
