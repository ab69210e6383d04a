//! The textbook figure: a ray in its own plane, with the closest approach, the impact parameter and
//! the angle by which gravity turns the light.

use super::colours::{CAMERA, DISK, HORIZON, PHOTON_ORBITS, path_colour};
use super::labels::Labels;
use bevy_egui::egui::{self, Color32, Pos2, Rect, Stroke};
use glam::DVec2;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::schwarzschild::CRITICAL_IMPACT;
use lightfall_core::numbers::four_digits;
use lightfall_core::optics::disk;
use lightfall_core::optics::ray_plane::{DiskSection, RayPlane};
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

/// From the plane of a ray to the screen. The camera's side is on the left.
struct Place {
    rect: Rect,
    hole: Pos2,
    points_per_length: f64,
}

impl Place {
    /// Shows the camera if it is near, the hole, and some room beyond. `half_width` in r_s replaces
    /// the fitting scale.
    fn fitting(rect: Rect, scene: &Scene, plane: &RayPlane, half_width: Option<f64>) -> Self {
        let size = rect.size();
        if let Some(half_width) = half_width {
            return Self {
                rect,
                hole: rect.center(),
                points_per_length: f64::from(0.5 * size.min_elem()) / half_width,
            };
        }
        let closest = plane.closest.map_or(1.5, DVec2::length);
        let camera = scene.camera.r;
        let before = if camera > FAR {
            (2.5 * closest).clamp(8.0, FAR)
        } else {
            1.12 * camera.max(2.0)
        };
        let behind = (0.42 * before).max(1.6 * closest).max(2.5);
        let above = (1.5 * closest).max(2.5);
        let scale = (f64::from(size.x) / (before + behind)).min(f64::from(size.y) / (2.0 * above));
        let spare = f64::from(size.x) / scale - before - behind;
        Self {
            rect,
            hole: Pos2::new(
                rect.left() + ((before + 0.5 * spare) * scale) as f32,
                rect.top() + 0.56 * size.y,
            ),
            points_per_length: scale,
        }
    }

    fn point(&self, place: DVec2) -> Pos2 {
        let far = |length: f64| (length * self.points_per_length).clamp(-1e5, 1e5) as f32;
        Pos2::new(self.hole.x - far(place.x), self.hole.y - far(place.y))
    }

    fn length(&self, length: f64) -> f32 {
        (length * self.points_per_length).clamp(0.0, 1e5) as f32
    }

    /// A length in r_s that reaches across the figure from anywhere in it.
    fn across(&self) -> f64 {
        f64::from(self.rect.size().length()) / self.points_per_length
    }
}

/// Draws the rays on `rect`, the first one with everything about it.
pub(super) fn draw(
    painter: &egui::Painter,
    rect: Rect,
    scene: &Scene,
    rays: &[Inspected],
    half_width: Option<f64>,
) -> f64 {
    let Some(first) = rays.first() else {
        return 1.0;
    };
    let place = Place::fitting(rect, scene, &first.plane, half_width);
    let mut labels = Labels::within(rect);
    draw_hole(painter, &place, scene, first, &mut labels);
    for ray in &rays[1..] {
        let stroke = Stroke::new(1.0, path_colour(ray).gamma_multiply(0.5));
        painter.line(line_of(&place, &ray.plane.points), stroke);
    }
    draw_directions(painter, &place, first, &mut labels);
    draw_path(painter, &place, first, &mut labels);
    draw_marks(painter, &place, scene, first, &mut labels);
    place.points_per_length
}

fn line_of(place: &Place, points: &[DVec2]) -> Vec<Pos2> {
    points.iter().map(|point| place.point(*point)).collect()
}

fn draw_hole(
    painter: &egui::Painter,
    place: &Place,
    scene: &Scene,
    first: &Inspected,
    labels: &mut Labels,
) {
    let kerr = Kerr {
        spin: scene.hole.spin,
    };
    if scene.disk.enabled {
        let (inner, outer) = (disk::inner_edge(scene), scene.disk.outer);
        match first.plane.disk {
            Some(DiskSection::Plane) => {
                let stroke = Stroke::new(place.length(outer - inner), DISK.gamma_multiply(0.22));
                painter.circle_stroke(place.hole, place.length(0.5 * (inner + outer)), stroke);
            }
            Some(DiskSection::Line(angle)) => {
                let toward = DVec2::from_angle(angle);
                for side in [toward, -toward] {
                    let ends = [inner, outer].map(|r| place.point(r * side));
                    painter.line_segment(ends, Stroke::new(3.0, DISK.gamma_multiply(0.75)));
                    labels.avoid_line(ends);
                }
            }
            None => {}
        }
    }
    let horizon = kerr.horizon();
    let fill = if scene.camera.r < horizon {
        Color32::TRANSPARENT
    } else {
        Color32::BLACK
    };
    let radius = place.length(horizon);
    painter.circle(place.hole, radius, fill, Stroke::new(1.5, HORIZON));
    for r in [kerr.photon_orbit_prograde(), kerr.photon_orbit_retrograde()] {
        let dots = (0..60).map(|i| {
            let angle = TAU * f64::from(i) / 60.0;
            place.point(r * DVec2::from_angle(angle))
        });
        let dots: Vec<_> = dots.chain([place.point(DVec2::new(r, 0.0))]).collect();
        painter.add(egui::Shape::dashed_line(
            &dots,
            Stroke::new(1.0, PHOTON_ORBITS),
            3.0,
            3.0,
        ));
        if scene.hole.spin == 0.0 {
            break;
        }
    }
    let outer = place.length(kerr.photon_orbit_retrograde());
    labels.keep_free(Rect::from_center_size(
        place.hole,
        egui::Vec2::splat(2.0 * outer),
    ));
}

/// The straight lines of the looking direction and of the incoming light, the angle between them,
/// and the impact parameter.
fn draw_directions(painter: &egui::Painter, place: &Place, ray: &Inspected, labels: &mut Labels) {
    let plane = &ray.plane;
    let (Some(looking), Some(&camera)) = (plane.looking, plane.points.first()) else {
        return;
    };
    let mut dashed = |ends: [DVec2; 2]| {
        let ends = ends.map(|end| place.point(end));
        let shape = egui::Shape::dashed_line(&ends, Stroke::new(1.0, GUIDE), 6.0, 5.0);
        painter.add(shape);
        labels.avoid_line(ends);
    };
    let far = camera.length() + 2.0 * place.across();
    let (Some(source), Some(b)) = (plane.source, ray.numbers.impact_parameter) else {
        return dashed([camera, camera + far * looking]);
    };
    let Some(deflection) = plane.disk.and(plane.deflection) else {
        return;
    };
    dashed([camera, camera + far * looking]);
    let toward = DVec2::from_angle(source);
    let foot = -b * toward.perp();
    let back = 0.6 * place.across();
    dashed([foot - back * toward, foot + far * toward]);
    // The impact parameter, and a right angle at its end.
    let stroke = Stroke::new(1.5, IMPACT);
    let ends = [DVec2::ZERO, foot].map(|end| place.point(end));
    painter.line_segment(ends, stroke);
    labels.avoid_line(ends);
    let corner = f64::from(6.0_f32.min(0.3 * place.length(b))) / place.points_per_length;
    let inward = -foot.normalize_or_zero() * corner;
    let corners = [
        foot + inward,
        foot + inward + corner * toward,
        foot + corner * toward,
    ];
    painter.line(line_of(place, &corners), Stroke::new(1.0, IMPACT));
    if deflection > MIN_ARC {
        draw_angle(
            painter,
            place,
            camera,
            looking,
            [toward, foot],
            deflection,
            labels,
        );
    }
    let text = format!("b = {} r_s", four_digits(b));
    labels.write(painter, place.point(0.62 * foot), &text, IMPACT);
}

/// The arc from the looking direction to the direction of the source, at the crossing of both
/// lines. `source` is that direction and a point of its line.
fn draw_angle(
    painter: &egui::Painter,
    place: &Place,
    camera: DVec2,
    looking: DVec2,
    [toward, foot]: [DVec2; 2],
    deflection: f64,
    labels: &mut Labels,
) {
    let turn = looking.perp_dot(toward);
    let crossing = camera + looking * ((foot - camera).perp_dot(toward) / turn);
    let inner = place.rect.shrink(0.12 * place.rect.size().min_elem());
    let at_crossing = turn.abs() > 1e-6 && inner.contains(place.point(crossing));
    let vertex = if at_crossing { crossing } else { DVec2::ZERO };
    // A small angle needs a large arc to be seen.
    let room = 0.5 * f64::from(place.rect.right() - place.point(vertex).x).max(60.0);
    let radius = (22.0 / deflection).clamp(34.0, room.max(34.0)) / place.points_per_length;
    let start = looking.to_angle();
    let arc: Vec<DVec2> = (0..=96)
        .map(|i| {
            let angle = deflection * f64::from(i) / 96.0;
            // A spiral, so that turns do not lie on each other.
            vertex + radius * (1.0 + 0.12 * angle / TAU) * DVec2::from_angle(start + angle)
        })
        .collect();
    if !at_crossing {
        for direction in [looking, toward] {
            let ends = [vertex, vertex + 1.25 * radius * direction].map(|end| place.point(end));
            painter.line_segment(ends, Stroke::new(1.0, ANGLE.gamma_multiply(0.5)));
        }
    }
    let line = line_of(place, &arc);
    labels.avoid(line.iter().copied());
    let middle = line[48];
    painter.line(line, Stroke::new(1.8, ANGLE));
    let text = format!("deflection {}°", four_digits(deflection.to_degrees()));
    labels.write(painter, middle, &text, ANGLE);
}

/// The path as far as its light is seen, and faintly beyond, with arrows toward the camera. A ray
/// that ends at the horizon has no arrows, because no light comes along it.
fn draw_path(painter: &egui::Painter, place: &Place, ray: &Inspected, labels: &mut Labels) {
    let plane = &ray.plane;
    let colour = path_colour(ray);
    let (seen, hidden) = match plane.hits[0] {
        Some((before, hit)) => {
            let before = before.min(plane.points.len());
            let (near, far) = plane.points.split_at(before);
            let seen: Vec<_> = near.iter().copied().chain([hit]).collect();
            (seen, [&[hit], far].concat())
        }
        None => (plane.points.clone(), Vec::new()),
    };
    let beyond = line_of(place, &hidden);
    let faint = Stroke::new(1.0, colour.gamma_multiply(0.45));
    painter.add(egui::Shape::dashed_line(&beyond, faint, 3.0, 4.0));
    let line = line_of(place, &seen);
    labels.avoid(line.iter().copied());
    for pair in line.windows(2) {
        if pair[0].distance(pair[1]) < 400.0 {
            labels.avoid([pair[0].lerp(pair[1], 0.33), pair[0].lerp(pair[1], 0.67)]);
        }
    }
    if ray.trace.outcome != Outcome::Captured || plane.hits[0].is_some() {
        draw_arrows(painter, place.rect, &line, colour);
    }
    painter.line(line, Stroke::new(2.2, colour));
}

/// Arrow heads along a line, against its direction: the light comes toward the camera.
fn draw_arrows(painter: &egui::Painter, rect: Rect, line: &[Pos2], colour: Color32) {
    let mut walked = 0.5 * ARROW_SPACING;
    for pair in line.windows(2) {
        let step = pair[0].distance(pair[1]);
        walked += step;
        let inside = rect.contains(pair[0]) && rect.contains(pair[1]);
        if walked < ARROW_SPACING || step <= 0.0 || !inside {
            continue;
        }
        walked = 0.0;
        let along = (pair[0] - pair[1]) / step;
        let tip = pair[1] + 5.0 * along;
        let wings = [along.rot90(), -along.rot90()].map(|side| tip - 9.0 * along + 4.5 * side);
        painter.add(egui::Shape::convex_polygon(
            vec![tip, wings[0], wings[1]],
            colour,
            Stroke::NONE,
        ));
    }
}

fn draw_marks(
    painter: &egui::Painter,
    place: &Place,
    scene: &Scene,
    ray: &Inspected,
    labels: &mut Labels,
) {
    let (plane, colour) = (&ray.plane, path_colour(ray));
    if let Some(closest) = plane.closest {
        let ends = [DVec2::ZERO, closest].map(|end| place.point(end));
        painter.line_segment(ends, Stroke::new(1.0, colour.gamma_multiply(0.7)));
        painter.circle_filled(ends[1], 3.5, colour);
        let text = format!("closest r = {} r_s", four_digits(closest.length()));
        labels.write(painter, ends[1], &text, colour);
    }
    let cpu = &ray.numbers.cpu;
    let shifts = [cpu.hit1_g, cpu.hit2_g];
    for (place_of_hit, g) in plane.hits.iter().zip(shifts) {
        if let (Some((_, hit)), Some(g)) = (place_of_hit, g) {
            let point = place.point(*hit);
            painter.circle_filled(point, 4.0, DISK);
            let text = format!(
                "r = {} r_s, g = {}",
                four_digits(hit.length()),
                four_digits(g)
            );
            labels.write(painter, point, &text, DISK);
        }
    }
    if let (Outcome::Captured, None, Some(end)) =
        (ray.trace.outcome, plane.hits[0], plane.points.last())
    {
        let text = "traced backward: ends at the horizon";
        labels.write(painter, place.point(*end), text, colour);
    }
    if let Some(camera) = plane.points.first() {
        let point = place.point(*camera);
        if place.rect.contains(point) {
            painter.circle_filled(point, 4.0, CAMERA);
            let text = format!("camera, r = {} r_s", four_digits(scene.camera.r));
            labels.write(painter, point, &text, CAMERA);
        } else {
            // Where the path comes in from the camera.
            let inside = plane.points.iter().map(|point| place.point(*point));
            if let Some(edge) = inside.into_iter().find(|point| place.rect.contains(*point)) {
                let text = format!(
                    "camera this way, at r = {} r_s",
                    four_digits(scene.camera.r)
                );
                labels.write(painter, edge, &text, CAMERA);
            }
        }
    }
}

/// Why no light comes along a captured ray.
fn captured(scene: &Scene, ray: &Inspected) -> String {
    let b = ray.numbers.impact_parameter.filter(|b| *b >= 0.0);
    let outside = scene.hole.spin == 0.0 && scene.camera.r > 1.5;
    match b.filter(|_| outside && scene.effects.lensing) {
        Some(b) => format!(
            "Captured: b = {} r_s is below {} r_s, so no light from outside comes along this ray.",
            four_digits(b),
            four_digits(CRITICAL_IMPACT)
        ),
        None => "Captured: followed backward, this ray ends in the hole.".into(),
    }
}

/// What the figure shows, in a sentence or two.
pub(super) fn explanation(scene: &Scene, ray: &Inspected) -> String {
    let angle = |radians: f64| format!("{}°", four_digits(radians.to_degrees()));
    let spins = scene.hole.spin != 0.0;
    let mut said = match (ray.trace.outcome, ray.plane.deflection) {
        _ if ray.trace.hits[0].is_some() => "Light from the disk.".to_owned(),
        (Outcome::Sky, Some(deflection)) if spins => format!(
            "Light from the sky. Its direction has turned by {}.",
            angle(deflection)
        ),
        (Outcome::Sky, Some(deflection)) => {
            format!("Light from the sky, turned by {}.", angle(deflection))
        }
        (Outcome::Sky, None) => "Light from the sky.".into(),
        (Outcome::Captured, _) => captured(scene, ray),
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
