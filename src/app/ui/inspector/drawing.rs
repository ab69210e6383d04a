//! The drawing of light paths: each in its own plane, or all around the hole, seen from the side, from
//! the top, or from any direction.

use super::colours::{CAMERA, DISK, ERGOSPHERE, HORIZON, ISCO, PHOTON_ORBITS, path_colour};
use super::plane_figure;
use super::projection::Projection;
use crate::app::ui::number::{four_decimals, scale_bar};
use bevy_egui::egui::{self, Color32, Rect, Stroke};
use glam::{DMat3, DVec3};
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::optics::camera_rays::camera_in_disk_frame;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::Scene;
use std::f64::consts::{PI, TAU};

/// What is drawn, and the direction from which it is seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Viewpoint {
    /// Each ray in its own plane, the camera to the left.
    #[default]
    Plane,
    /// The axis upright, the camera to the left.
    Side,
    /// From above, the camera to the left.
    Top,
    /// From a direction that the mouse drags.
    Orbit,
}

/// The viewpoint and the scale.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sketch {
    pub(super) viewpoint: Viewpoint,
    /// Half of the width that is shown, in r_s. None fits the camera in.
    pub(super) half_width: Option<f64>,
    /// Turn about the axis and tilt of the orbit viewpoint, in radians.
    turn: [f64; 2],
}

impl Default for Sketch {
    fn default() -> Self {
        Self {
            viewpoint: Viewpoint::default(),
            half_width: None,
            turn: [0.5, 0.5],
        }
    }
}

/// The range of the half width, in r_s.
const HALF_WIDTHS: [f64; 2] = [0.8, 1e5];
/// Segments of a circle.
const SEGMENTS: usize = 96;

/// The colours of what is drawn, and what they mean.
pub(super) fn legend(viewpoint: Viewpoint, scene: &Scene, units: Units) -> Vec<(Color32, String)> {
    let (plane, spins) = (viewpoint == Viewpoint::Plane, scene.hole.spin != 0.0);
    let photon_orbits = if plane && !spins {
        format!("photon sphere, {}", units.length(1.5, four_decimals))
    } else {
        "photon orbits".into()
    };
    let all = [
        (true, HORIZON, "horizon".into()),
        (!plane && spins, ERGOSPHERE, "ergosphere".into()),
        (true, PHOTON_ORBITS, photon_orbits),
        (!plane, ISCO, "innermost stable orbit".into()),
        (scene.disk.enabled && !(plane && spins), DISK, "disk".into()),
    ];
    let drawn = all.into_iter().filter(|(drawn, ..)| *drawn);
    drawn.map(|(_, colour, name)| (colour, name)).collect()
}

impl Sketch {
    /// Draws on an area of this size in points, where the mouse turns and zooms the drawing.
    pub(super) fn show(
        &mut self,
        ui: &mut egui::Ui,
        scene: &Scene,
        rays: &[Inspected],
        units: Units,
        size: egui::Vec2,
    ) {
        let plane = self.viewpoint == Viewpoint::Plane;
        // In the plane the mouse only zooms.
        let sense = if plane {
            egui::Sense::hover()
        } else {
            egui::Sense::drag()
        };
        let (response, painter) = ui.allocate_painter(size, sense);
        let rect = response.rect;
        painter.rect_filled(rect, 4.0, Color32::from_gray(26));
        let half_width = self.half_width.unwrap_or_else(|| fitting_half_width(scene));
        if response.hovered() {
            let scroll = ui.input(|input| input.smooth_scroll_delta.y);
            if scroll != 0.0 {
                let [min, max] = HALF_WIDTHS;
                self.half_width =
                    Some((half_width * f64::from(-0.004 * scroll).exp()).clamp(min, max));
            }
        }
        if !plane && response.dragged() {
            self.viewpoint = Viewpoint::Orbit;
            let drag = response.drag_delta();
            self.turn[0] += f64::from(drag.x) * 0.01;
            self.turn[1] = (self.turn[1] + f64::from(drag.y) * 0.01).clamp(-PI / 2.0, PI / 2.0);
        }
        self.paint(&painter, rect, scene, rays, units);
    }

    /// Paints the drawing within `rect`.
    pub(super) fn paint(
        &self,
        painter: &egui::Painter,
        rect: Rect,
        scene: &Scene,
        rays: &[Inspected],
        units: Units,
    ) {
        if self.viewpoint == Viewpoint::Plane {
            let scale = plane_figure::draw(painter, rect, scene, rays, units, self.half_width);
            return draw_scale(painter, rect, scale, units);
        }
        let half_width = self.half_width.unwrap_or_else(|| fitting_half_width(scene));
        let horizon = scene.kerr().horizon();
        let projection = Projection {
            painter: painter.clone(),
            axes: self.axes(scene),
            centre: rect.center(),
            points_per_length: f64::from(0.5 * rect.size().min_elem()) / half_width,
            horizon,
            inside: scene.camera.r < horizon,
        };
        draw_hole(&projection, scene);
        // The first ray lies over the others.
        for (i, ray) in rays.iter().enumerate().rev() {
            draw_path(&projection, ray, i == 0);
        }
        let camera = projection.point(camera_in_disk_frame(scene) * scene.camera.r);
        painter.circle_filled(camera, 3.5, CAMERA);
        draw_scale(painter, rect, projection.points_per_length, units);
    }

    /// Rows: right, up, toward the viewer, in the disk's frame. The camera's azimuth points left.
    fn axes(&self, scene: &Scene) -> DMat3 {
        let azimuth = if scene.disk.is_tilted() {
            let place = camera_in_disk_frame(scene);
            place.y.atan2(place.x)
        } else {
            scene.camera.phi_deg.to_radians()
        };
        let (sin, cos) = azimuth.sin_cos();
        let (left, growing_phi) = (DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0));
        let rows = match self.viewpoint {
            Viewpoint::Plane | Viewpoint::Side => [-left, DVec3::Z, growing_phi],
            Viewpoint::Top => [-left, -growing_phi, DVec3::Z],
            Viewpoint::Orbit => {
                let turned = DMat3::from_rotation_z(self.turn[0]);
                let (right, toward) = (turned * -left, turned * growing_phi);
                let (sin, cos) = self.turn[1].sin_cos();
                [
                    right,
                    cos * DVec3::Z - sin * toward,
                    cos * toward + sin * DVec3::Z,
                ]
            }
        };
        DMat3::from_cols(rows[0], rows[1], rows[2]).transpose()
    }
}

/// A half width that shows the camera, or only the hole's surroundings if the camera is far away.
fn fitting_half_width(scene: &Scene) -> f64 {
    const FAR: f64 = 60.0;
    if scene.camera.r > FAR {
        16.0
    } else {
        1.15 * scene.camera.r.max(3.0)
    }
}

fn circle(radius: f64) -> impl Iterator<Item = DVec3> {
    (0..=SEGMENTS).map(move |i| {
        let (sin, cos) = (TAU * i as f64 / SEGMENTS as f64).sin_cos();
        DVec3::new(radius * cos, radius * sin, 0.0)
    })
}

fn draw_hole(projection: &Projection, scene: &Scene) {
    let kerr = scene.kerr();
    let radius = (projection.horizon * projection.points_per_length) as f32;
    let thin = |colour: Color32| Stroke::new(1.0, colour);
    let fill = if projection.inside {
        Color32::TRANSPARENT
    } else {
        Color32::BLACK
    };
    let painter = &projection.painter;
    painter.circle(projection.centre, radius, fill, thin(HORIZON));
    if scene.disk.enabled {
        let (inner, outer) = (scene.inner_edge(), scene.disk.outer);
        let rings = 14;
        for ring in 0..=rings {
            let is_edge = ring == 0 || ring == rings;
            let opacity = if is_edge { 1.0 } else { 0.28 };
            let r = inner + (outer - inner) * f64::from(ring) / f64::from(rings);
            projection.line(circle(r), thin(DISK.gamma_multiply(opacity)));
        }
    }
    projection.line(circle(kerr.isco()), thin(ISCO));
    for r in [kerr.photon_orbit_prograde(), kerr.photon_orbit_retrograde()] {
        projection.line(circle(r), thin(PHOTON_ORBITS));
    }
    if scene.hole.spin != 0.0 {
        // The static limit: its equator, and its outline from this viewpoint.
        let equator = circle(kerr.static_limit(0.0));
        projection.line(equator, thin(ERGOSPHERE.gamma_multiply(0.7)));
        let toward = projection.axes.transpose() * DVec3::Z;
        let across = projection.axes.transpose() * DVec3::X;
        let upright = if toward.z.abs() > 0.999 {
            DVec3::ZERO
        } else {
            (DVec3::Z - toward * toward.z).normalize()
        };
        let outline = circle(1.0).map(|place| {
            let direction = (across * place.y + upright * place.x).normalize_or_zero();
            direction * kerr.static_limit(direction.z)
        });
        projection.line(outline, thin(ERGOSPHERE));
    }
}

fn draw_path(projection: &Projection, inspected: &Inspected, first: bool) {
    let colour = path_colour(inspected);
    let (stroke, radius) = if first {
        (Stroke::new(2.0, colour), 3.0)
    } else {
        (Stroke::new(1.0, colour.gamma_multiply(0.6)), 1.5)
    };
    projection.line(inspected.path.points.iter().copied(), stroke);
    for hit in inspected.trace.hits.iter().flatten() {
        let place = DVec3::new(hit.r * hit.phi.cos(), hit.r * hit.phi.sin(), 0.0);
        if !projection.hidden(place) {
            let point = projection.point(place);
            projection.painter.circle_filled(point, radius, colour);
        }
    }
}

/// Draws a bar of a round length.
fn draw_scale(painter: &egui::Painter, rect: Rect, points_per_length: f64, units: Units) {
    let wanted = 0.25 * f64::from(rect.width()) / points_per_length;
    let Some((length, text)) = scale_bar(wanted, units) else {
        return;
    };
    let start = rect.left_bottom() + egui::vec2(10.0, -10.0);
    let end = start + egui::vec2((length * points_per_length) as f32, 0.0);
    let colour = Color32::from_gray(200);
    painter.line_segment([start, end], Stroke::new(1.5, colour));
    painter.text(
        start - egui::vec2(0.0, 3.0),
        egui::Align2::LEFT_BOTTOM,
        text,
        egui::FontId::proportional(12.0),
        colour,
    );
}
