//! The textbook figure: a ray in its own plane, with the closest approach, the impact parameter and
//! the angle by which gravity deflects the light.

use super::colours::{CAMERA, DISK, HORIZON, PHOTON_ORBITS, path_colour};
use super::labels::Labels;
use super::numbers::{turned_by, without_rounding};
use bevy_egui::egui::{self, Color32, Pos2, Rect, Stroke};
use glam::DVec2;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::geometry::schwarzschild::CRITICAL_IMPACT;
use lightfall_core::numbers::four_digits;
use lightfall_core::optics::ray_plane::{DiskSection, RayPlane};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::Scene;
use std::f64::consts::TAU;

const GUIDE: Color32 = Color32::from_gray(150);
const ANGLE: Color32 = Color32::from_rgb(255, 225, 120);
const IMPACT: Color32 = Color32::from_rgb(140, 225, 175);
/// A camera farther away than this, in r_s, is left outside the figure.
const FAR: f64 = 40.0;
/// Points of the screen between two arrow heads.
const ARROW_SPACING: f32 = 90.0;
/// Angles below this, in radians, are too small for an arc.
const MIN_ARC: f64 = 0.004;

/// Draws the rays on `rect`, the first one with everything about it. Returns the scale in points for
/// one r_s. `half_width` in r_s replaces the scale that fits the camera in.
pub(super) fn draw(
    painter: &egui::Painter,
    rect: Rect,
    scene: &Scene,
    rays: &[Inspected],
    units: Units,
    half_width: Option<f64>,
) -> f64 {
    let Some(first) = rays.first() else {
        return 1.0;
    };
    let (hole, scale) = match half_width {
        Some(half_width) => {
            let half_size = 0.5 * rect.size().min_elem();
            (rect.center(), f64::from(half_size) / half_width)
        }
        None => fitting_scale(rect, scene.camera.r, &first.plane),
    };
    let mut figure = Figure {
        painter: painter.clone(),
        rect,
        hole,
        scale,
        units,
        labels: Labels::within(painter, rect),
    };
    figure.draw_hole(scene, first);
    for ray in &rays[1..] {
        let stroke = Stroke::new(1.0, path_colour(ray).gamma_multiply(0.5));
        painter.line(figure.line(&ray.plane.points), stroke);
    }
    figure.draw_directions(first);
    figure.draw_path(first);
    figure.draw_marks(scene, first);
    scale
}

/// The hole's place and the scale that show the camera if it is near, the hole, and some room beyond.
fn fitting_scale(rect: Rect, camera: f64, plane: &RayPlane) -> (Pos2, f64) {
    let size = rect.size();
    let closest = plane.closest.map_or(1.5, DVec2::length);
    let before = if camera > FAR {
        (2.5 * closest).clamp(8.0, FAR)
    } else {
        1.12 * camera.max(2.0)
    };
    let behind = (0.42 * before).max(1.6 * closest).max(2.5);
    let above = (1.5 * closest).max(2.5);
    let scale = (f64::from(size.x) / (before + behind)).min(f64::from(size.y) / (2.0 * above));
    let spare = f64::from(size.x) / scale - before - behind;
    let right = ((before + 0.5 * spare) * scale) as f32;
    (rect.min + egui::vec2(right, 0.56 * size.y), scale)
}

/// The figure of one ray's plane, with the camera's side on the left.
struct Figure {
    painter: egui::Painter,
    rect: Rect,
    /// Place of the hole's centre on the screen.
    hole: Pos2,
    /// Points of the screen for one r_s.
    scale: f64,
    /// The units of lengths in labels.
    units: Units,
    labels: Labels,
}

impl Figure {
    fn point(&self, place: DVec2) -> Pos2 {
        let far = |length: f64| (length * self.scale).clamp(-1e5, 1e5) as f32;
        Pos2::new(self.hole.x - far(place.x), self.hole.y - far(place.y))
    }

    fn line(&self, places: &[DVec2]) -> Vec<Pos2> {
        places.iter().map(|place| self.point(*place)).collect()
    }

    fn length(&self, length: f64) -> f32 {
        (length * self.scale).clamp(0.0, 1e5) as f32
    }

    /// A length in r_s that reaches across the figure from anywhere in it.
    fn across(&self) -> f64 {
        f64::from(self.rect.size().length()) / self.scale
    }

    /// A length in words.
    fn in_words(&self, length: f64) -> String {
        self.units.length(length, four_digits)
    }

    /// Writes a label next to a place.
    fn label(&mut self, place: DVec2, text: &str, colour: Color32) {
        self.labels.write(self.point(place), text, colour);
    }

    /// Draws a straight line, which no label covers.
    fn segment(&mut self, ends: [DVec2; 2], stroke: Stroke) {
        let ends = ends.map(|end| self.point(end));
        self.painter.line_segment(ends, stroke);
        self.labels.avoid_line(ends);
    }

    /// Draws a straight dashed line, which no label covers.
    fn dashed(&mut self, ends: [DVec2; 2]) {
        let ends = ends.map(|end| self.point(end));
        let shapes = egui::Shape::dashed_line(&ends, Stroke::new(1.0, GUIDE), 6.0, 5.0);
        self.painter.extend(shapes);
        self.labels.avoid_line(ends);
    }

    fn draw_hole(&mut self, scene: &Scene, first: &Inspected) {
        let kerr = scene.kerr();
        let (inner, outer) = (scene.inner_edge(), scene.disk.outer);
        match first.plane.disk.filter(|_| scene.disk.enabled) {
            Some(DiskSection::Plane) => {
                let stroke = Stroke::new(self.length(outer - inner), DISK.gamma_multiply(0.22));
                let middle = self.length(0.5 * (inner + outer));
                self.painter.circle_stroke(self.hole, middle, stroke);
            }
            Some(DiskSection::Line(angle)) => {
                let toward = DVec2::from_angle(angle);
                for side in [toward, -toward] {
                    let stroke = Stroke::new(3.0, DISK.gamma_multiply(0.75));
                    self.segment([inner * side, outer * side], stroke);
                }
            }
            None => {}
        }
        let horizon = kerr.horizon();
        let fill = if scene.camera.r < horizon {
            Color32::TRANSPARENT
        } else {
            Color32::BLACK
        };
        let stroke = Stroke::new(1.5, HORIZON);
        self.painter
            .circle(self.hole, self.length(horizon), fill, stroke);
        for r in [kerr.photon_orbit_prograde(), kerr.photon_orbit_retrograde()] {
            let circle = (0..=60).map(|i| r * DVec2::from_angle(TAU * f64::from(i % 60) / 60.0));
            let circle = self.line(&circle.collect::<Vec<_>>());
            let stroke = Stroke::new(1.0, PHOTON_ORBITS);
            self.painter
                .add(egui::Shape::dashed_line(&circle, stroke, 3.0, 3.0));
            if scene.hole.spin == 0.0 {
                break;
            }
        }
        let outer = egui::Vec2::splat(2.0 * self.length(kerr.photon_orbit_retrograde()));
        self.labels
            .keep_free(Rect::from_center_size(self.hole, outer));
    }

    /// Draws the straight lines of the looking direction and of the incoming light, the angle between
    /// them, and the impact parameter.
    fn draw_directions(&mut self, ray: &Inspected) {
        let plane = &ray.plane;
        let (Some(looking), Some(&camera)) = (plane.looking, plane.points.first()) else {
            return;
        };
        let far = camera.length() + 2.0 * self.across();
        let (Some(source), Some(b)) = (plane.source, ray.numbers.impact_parameter) else {
            return self.dashed([camera, camera + far * looking]);
        };
        let Some(deflection) = plane.disk.and(plane.deflection) else {
            return;
        };
        self.dashed([camera, camera + far * looking]);
        let toward = DVec2::from_angle(source);
        let foot = -b * toward.perp();
        let back = 0.6 * self.across();
        self.dashed([foot - back * toward, foot + far * toward]);
        // The impact parameter, and a right angle at its end.
        self.segment([DVec2::ZERO, foot], Stroke::new(1.5, IMPACT));
        let corner = f64::from(6.0_f32.min(0.3 * self.length(b))) / self.scale;
        let inward = -foot.normalize_or_zero() * corner;
        let along = corner * toward;
        let corners = [foot + inward, foot + inward + along, foot + along];
        self.painter
            .line(self.line(&corners), Stroke::new(1.0, IMPACT));
        if deflection > MIN_ARC {
            self.draw_angle([camera, foot], [looking, toward], deflection);
        }
        let b = without_rounding(b, camera.length());
        let text = format!("b = {}", self.in_words(b));
        self.label(0.62 * foot, &text, IMPACT);
    }

    /// Draws the arc from the looking direction to the direction of the source, at the crossing of
    /// their lines. `points` are a point on each line, and `directions` their directions.
    fn draw_angle(&mut self, points: [DVec2; 2], directions: [DVec2; 2], deflection: f64) {
        let ([camera, foot], [looking, toward]) = (points, directions);
        let turn = looking.perp_dot(toward);
        let crossing = camera + looking * ((foot - camera).perp_dot(toward) / turn);
        let inner = self.rect.shrink(0.12 * self.rect.size().min_elem());
        let at_crossing = turn.abs() > 1e-6 && inner.contains(self.point(crossing));
        let vertex = if at_crossing { crossing } else { DVec2::ZERO };
        // A small angle needs a large arc to be visible.
        let room = 0.5 * f64::from(self.rect.right() - self.point(vertex).x).max(60.0);
        let radius = (22.0 / deflection).clamp(34.0, room.max(34.0)) / self.scale;
        let start = looking.to_angle();
        let arc = (0..=96).map(|i| {
            let angle = deflection * f64::from(i) / 96.0;
            // A spiral, so that turns do not overlap.
            vertex + radius * (1.0 + 0.12 * angle / TAU) * DVec2::from_angle(start + angle)
        });
        let arc: Vec<DVec2> = arc.collect();
        if !at_crossing {
            for direction in directions {
                let ends = [vertex, vertex + 1.25 * radius * direction].map(|end| self.point(end));
                self.painter
                    .line_segment(ends, Stroke::new(1.0, ANGLE.gamma_multiply(0.5)));
            }
        }
        let line = self.line(&arc);
        self.labels.avoid(line.iter().copied());
        self.painter.line(line, Stroke::new(1.8, ANGLE));
        let text = format!("deflection {}", turned_by(deflection));
        self.label(arc[48], &text, ANGLE);
    }

    /// Draws the part of the path whose light is seen, with arrows toward the camera, and faintly the
    /// part beyond. A ray that ends at the horizon has no arrows, because no light comes along it.
    fn draw_path(&mut self, ray: &Inspected) {
        let plane = &ray.plane;
        let colour = path_colour(ray);
        let (seen, hidden) = match plane.hits[0] {
            Some((before, hit)) => {
                let before = before.min(plane.points.len());
                let (near, far) = plane.points.split_at(before);
                ([near, &[hit]].concat(), [&[hit], far].concat())
            }
            None => (plane.points.clone(), Vec::new()),
        };
        let beyond = self.line(&hidden);
        let faint = Stroke::new(1.0, colour.gamma_multiply(0.45));
        self.painter
            .add(egui::Shape::dashed_line(&beyond, faint, 3.0, 4.0));
        let line = self.line(&seen);
        self.labels.avoid(line.iter().copied());
        for pair in line.windows(2) {
            if pair[0].distance(pair[1]) < 400.0 {
                self.labels
                    .avoid([pair[0].lerp(pair[1], 0.33), pair[0].lerp(pair[1], 0.67)]);
            }
        }
        if ray.trace.outcome != Outcome::Captured || plane.hits[0].is_some() {
            self.draw_arrows(&line, colour);
        }
        self.painter.line(line, Stroke::new(2.2, colour));
    }

    /// Draws arrow heads along a line, against its direction: the light comes toward the camera.
    fn draw_arrows(&self, line: &[Pos2], colour: Color32) {
        let mut walked = 0.5 * ARROW_SPACING;
        for pair in line.windows(2) {
            let step = pair[0].distance(pair[1]);
            walked += step;
            let inside = self.rect.contains(pair[0]) && self.rect.contains(pair[1]);
            if walked < ARROW_SPACING || step <= 0.0 || !inside {
                continue;
            }
            walked = 0.0;
            let along = (pair[0] - pair[1]) / step;
            let tip = pair[1] + 5.0 * along;
            let [left, right] =
                [along.rot90(), -along.rot90()].map(|side| tip - 9.0 * along + 4.5 * side);
            let head = vec![tip, left, right];
            self.painter
                .add(egui::Shape::convex_polygon(head, colour, Stroke::NONE));
        }
    }

    /// Marks the closest approach, the hits, the end at the horizon and the camera.
    fn draw_marks(&mut self, scene: &Scene, ray: &Inspected) {
        let (plane, colour) = (&ray.plane, path_colour(ray));
        if let Some(closest) = plane.closest {
            let ends = [DVec2::ZERO, closest].map(|end| self.point(end));
            self.painter
                .line_segment(ends, Stroke::new(1.0, colour.gamma_multiply(0.7)));
            self.painter.circle_filled(ends[1], 3.5, colour);
            let text = format!("closest r = {}", self.in_words(closest.length()));
            self.label(closest, &text, colour);
        }
        for (place, hit) in plane.hits.into_iter().zip(ray.trace.hits) {
            if let (Some((_, place)), Some(hit)) = (place, hit) {
                self.painter.circle_filled(self.point(place), 4.0, DISK);
                let (r, g) = (self.in_words(place.length()), four_digits(hit.g));
                self.label(place, &format!("r = {r}, g = {g}"), DISK);
            }
        }
        if let (Outcome::Captured, None, Some(end)) =
            (ray.trace.outcome, plane.hits[0], plane.points.last())
        {
            self.label(*end, "traced backward: ends at the horizon", colour);
        }
        let r = self.in_words(scene.camera.r);
        let mut points = plane.points.iter().copied();
        let is_inside = |point: DVec2| self.rect.contains(self.point(point));
        match points.next() {
            Some(camera) if is_inside(camera) => {
                self.painter.circle_filled(self.point(camera), 4.0, CAMERA);
                self.label(camera, &format!("camera, r = {r}"), CAMERA);
            }
            _ => {
                // The point where the path comes in from the camera.
                if let Some(edge) = points.find(|point| is_inside(*point)) {
                    self.label(edge, &format!("camera this way, at r = {r}"), CAMERA);
                }
            }
        }
    }
}

/// Why no light comes along a captured ray.
fn captured(scene: &Scene, ray: &Inspected, units: Units) -> String {
    let b = ray.numbers.impact_parameter.filter(|b| *b >= 0.0);
    let outside = scene.hole.spin == 0.0 && scene.camera.r > 1.5;
    match b.filter(|_| outside && scene.effects.lensing) {
        Some(b) => {
            let b = without_rounding(b, scene.camera.r);
            let [b, critical] =
                [b, CRITICAL_IMPACT].map(|length| units.length(length, four_digits));
            format!(
                "Captured: b = {b} is below {critical}, so no light from outside comes along this ray."
            )
        }
        None => "Captured: followed backward, this ray ends in the hole.".into(),
    }
}

/// What the figure shows, in a sentence or two.
pub(super) fn explanation(scene: &Scene, ray: &Inspected, units: Units) -> String {
    let spins = scene.hole.spin != 0.0;
    let mut said = match (ray.trace.outcome, ray.plane.deflection.map(turned_by)) {
        _ if ray.trace.hits[0].is_some() => "Light from the disk.".to_owned(),
        (Outcome::Sky, Some(angle)) if spins => {
            format!("Light from the sky. Its direction has turned by {angle}.")
        }
        (Outcome::Sky, Some(angle)) => format!("Light from the sky, turned by {angle}."),
        (Outcome::Sky, None) => "Light from the sky.".into(),
        (Outcome::Captured, _) => captured(scene, ray, units),
        (Outcome::Unfinished, _) => "The reference gave up on this ray.".into(),
    };
    if !scene.effects.lensing {
        said += " Lensing is off: light runs straight.";
    } else if spins {
        said +=
            " Around a spinning hole a ray leaves its plane: drawn is r against the angle swept.";
    }
    said
}
