//! The images of stars in a picture with spin, in f64: polished from the cells of a mesh of
//! reference rays, as the kernels in shaders/stars/ do with the picture's tracer.

use super::StarImage;
use super::mesh_layout::MeshLayout;
use super::refine_image::{ImageRefiner, Tangents};
use crate::path::Path;
use crate::reference::Reference;
use crate::shift::Shift;
use glam::{DMat2, DVec2, DVec3, UVec2};
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::scene::{Camera, Scene};
use rayon::prelude::*;

/// Cells whose corners lie farther apart on the sky span the edge of the shadow.
const MAX_SPAN: f64 = 1.2;
/// The margin about a triangle in which a star is searched for, as a share of the triangle.
const MARGIN: f64 = 0.25;
/// Largest ratio of the areas of a cell's corner triangles where the map to the sky does not fold.
const MAX_AREA_RATIO: f64 = 2.0;
/// Where it folds, stars up to this share of the cell's radius are searched for from the middle.
const FOLD_REACH: f64 = 1.3;

/// The rays of a mesh through a scene's picture, without the disk.
#[derive(Clone, Debug)]
pub struct RayMesh {
    reference: Reference,
    camera: Camera,
    shift: Shift,
    layout: MeshLayout,
    size: DVec2,
    /// The directions of the sky that the rays come from, row by row; `None` for other outcomes.
    skies: Vec<Option<DVec3>>,
}

impl RayMesh {
    /// Traces the rays of about `cells` cells.
    ///
    /// # Errors
    /// The scene's observer does not exist.
    pub fn new(scene: &Scene, cells: f64) -> Result<Self, ObserverError> {
        let mut scene = scene.clone();
        scene.disk.enabled = false;
        let size = scene.picture.size();
        let layout = MeshLayout::new(size, cells, 0.0);
        let mut mesh = Self {
            reference: Reference::new(&scene)?,
            camera: scene.camera,
            shift: Shift::new(&scene),
            layout,
            size: size.as_dvec2(),
            skies: Vec::new(),
        };
        let columns = layout.points.x;
        mesh.skies = (0..layout.point_count())
            .into_par_iter()
            .map(|i| mesh.sky(layout.place(UVec2::new(i % columns, i / columns))))
            .collect();
        Ok(mesh)
    }

    /// The direction of the sky that the light of a place in the picture, in pixels, comes from.
    fn sky(&self, place: DVec2) -> Option<DVec3> {
        self.reference.trace(self.direction(place)).sky
    }

    /// The looking direction of a place, on the observer's axes.
    fn direction(&self, place: DVec2) -> DVec3 {
        self.camera.tetrad_from_camera() * self.camera.looking(place, self.size)
    }

    /// All images of the star in the unit direction `star` of the hole's frame, as the mesh finds
    /// them: those that are squeezed within a cell of the edge of the shadow are left out.
    pub fn images(&self, star: DVec3) -> Vec<StarImage> {
        let columns = self.layout.points.x - 1;
        let cells = (0..self.layout.cell_count()).map(|i| UVec2::new(i % columns, i / columns));
        cells
            .flat_map(|cell| self.images_in(cell, star))
            .filter_map(|(place, magnification)| self.image(place, magnification))
            .collect()
    }

    /// The places of the images in a cell, in pixels, and their magnifications.
    fn images_in(&self, cell: UVec2, star: DVec3) -> Vec<(DVec2, f64)> {
        let Some(corners) = self.corners(cell) else {
            return Vec::new();
        };
        let spacing = self.layout.spacing;
        let first = self.layout.place(cell);
        let tangents = Tangents::at(star);
        // The sky at unit distance is what `ImageRefiner` knows: x to the right, y up.
        let pixel = self.camera.pixel_angle(self.size);
        let scale = DVec2::new(pixel, -pixel);
        let sky = |place: DVec2| self.sky(place / scale + 0.5 * self.size);
        let refine_image = ImageRefiner {
            max_step: 2.0 * spacing * pixel,
            max_rays: 20,
            half_step: 1e-4,
        };
        let mut found: Vec<(DVec2, f64)> = Vec::new();
        for (start, [along_x, along_y]) in starts(&corners, star) {
            let guess = (first + spacing * start - 0.5 * self.size) * scale;
            let rate = |along: DVec3, scale: f64| tangents.components(along) / (spacing * scale);
            let jacobian = DMat2::from_cols(rate(along_x, scale.x), rate(along_y, scale.y));
            let Some(image) = refine_image.image(&sky, star, guess, jacobian) else {
                continue;
            };
            let place = image.place / scale + 0.5 * self.size;
            let within = (place - first) / spacing;
            let is_new = |(other, _): &(DVec2, f64)| place.distance(*other) > 0.01 * spacing;
            if within.cmpge(DVec2::ZERO).all()
                && within.cmplt(DVec2::ONE).all()
                && found.iter().all(is_new)
            {
                found.push((place, image.magnification));
            }
        }
        found
    }

    /// Where the rays through a cell's corners come from: at (0, 0), (1, 0), (0, 1) and (1, 1);
    /// `None` unless all see the sky, in one image of it.
    fn corners(&self, cell: UVec2) -> Option<[DVec3; 4]> {
        let first = (cell.y * self.layout.points.x + cell.x) as usize;
        let below = first + self.layout.points.x as usize;
        let sky = |point: usize| self.skies[point];
        let corners = [sky(first)?, sky(first + 1)?, sky(below)?, sky(below + 1)?];
        let [a, b, c, d] = corners;
        (a.distance(d).max(b.distance(c)) < MAX_SPAN).then_some(corners)
    }

    /// The image at a place, with its shift and order.
    fn image(&self, place: DVec2, magnification: f64) -> Option<StarImage> {
        let direction = self.direction(place);
        let (trace, path) = Path::of(&self.reference, direction, 1.0);
        let photon = self.reference.photon(direction);
        let (r, n) = self.reference.camera();
        let lambda = r * n.cross(photon.w).z / photon.energy;
        let shift = self.shift.of_sky(1.0 / photon.energy, lambda);
        Some(StarImage {
            direction,
            order: path.order(&trace)?,
            magnification,
            shift,
            gain: magnification * self.shift.beaming_factor(shift),
        })
    }
}

/// The starts of the search in a cell, in cells, each with the derivatives of the sky along x and
/// y.
fn starts(corners: &[DVec3; 4], star: DVec3) -> Vec<(DVec2, [DVec3; 2])> {
    let [first, right, down, last] = *corners;
    let middle = (first + right + down + last).normalize();
    let radius = corners.map(|corner| corner.distance(middle));
    let radius = radius.into_iter().fold(0.0, f64::max);
    if star.distance(middle) > 2.0 * radius {
        return Vec::new();
    }
    let (top, bottom, left, far) = (right - first, last - down, down - first, last - right);
    let areas = [(top, left), (top, far), (bottom, left), (bottom, far)]
        .map(|(side, next)| middle.dot(side.cross(next)));
    let smallest = areas.into_iter().fold(f64::INFINITY, f64::min);
    let largest = areas.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let ratio = (largest / smallest).max(smallest / largest);
    let folds = !(0.0..=MAX_AREA_RATIO).contains(&ratio) || ratio < 1.0;
    let triangles = [[top, far], [bottom, left]];
    let mut starts = Vec::new();
    for ([along_x, along_y], is_above) in triangles.into_iter().zip([true, false]) {
        let normal = along_x.cross(along_y);
        let offset = star * (first.dot(normal) / star.dot(normal)) - first;
        let x = offset.dot(along_y.cross(normal)) / normal.length_squared();
        let y = offset.dot(normal.cross(along_x)) / normal.length_squared();
        let within = if is_above {
            (1.0 - x).min(x - y).min(y)
        } else {
            (1.0 - y).min(y - x).min(x)
        };
        if within >= -MARGIN {
            starts.push((DVec2::new(x, y), [along_x, along_y]));
        }
    }
    if folds && star.distance(middle) < FOLD_REACH * radius {
        starts.push((DVec2::splat(0.5), triangles[0]));
    }
    starts
}
