//! Drawings as SVG on white paper: lines and letters are black, and what lies behind letters is white,
//! so that a copy in black and white loses nothing.

use super::colours::DISK;
use bevy_egui::egui::epaint::{ClippedShape, ColorMode, PathShape, TextShape};
use bevy_egui::egui::{Color32, Pos2, Shape, Stroke};
use std::fmt::Write;

/// The least opacity of ink: fainter lines are lost in copies.
const MIN_OPACITY: f32 = 0.45;
/// The ink of the disk, which is the one wide line, and of everything else.
const GREY: &str = "#888";
const BLACK: &str = "#000";
/// Fonts that look like the window's, the nearest first.
pub(super) const FONTS: &str = "Ubuntu, Helvetica, Arial, sans-serif";

/// A text with the characters that mean something in XML replaced.
pub(super) fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => safe += "&amp;",
            '<' => safe += "&lt;",
            '>' => safe += "&gt;",
            '"' => safe += "&quot;",
            c if c.is_control() => safe.push(' '),
            c => safe.push(c),
        }
    }
    safe
}

/// The elements of a drawing.
pub(super) fn elements(shapes: &[ClippedShape]) -> String {
    let mut svg = String::new();
    for shape in shapes {
        add(&mut svg, &shape.shape);
    }
    svg
}

fn add(svg: &mut String, shape: &Shape) {
    match shape {
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| add(svg, shape)),
        Shape::LineSegment { points, stroke } => {
            if let Some(ink) = stroke_of(stroke) {
                add_line(svg, points, &format!("fill=\"none\" {ink}"), "");
            }
        }
        Shape::Path(path) => add_path(svg, path),
        Shape::Circle(circle) => {
            let fill = fill_of(circle.fill);
            let stroke = stroke_of(&circle.stroke).unwrap_or_default();
            let Pos2 { x, y } = circle.center;
            let r = circle.radius;
            let _ = writeln!(
                svg,
                "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{r:.2}\" {fill} {stroke}/>"
            );
        }
        // What lies behind a label.
        Shape::Rect(rect) => {
            let (place, size) = (rect.rect.min, rect.rect.size());
            let _ = writeln!(
                svg,
                "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{:.2}\" fill=\"#fff\" fill-opacity=\"0.85\"/>",
                place.x, place.y, size.x, size.y
            );
        }
        Shape::Text(text) => add_text(svg, text),
        // No drawing of the inspector has others.
        _ => {}
    }
}

fn add_path(svg: &mut String, path: &PathShape) {
    let ColorMode::Solid(colour) = path.stroke.color else {
        return;
    };
    let stroke = stroke_of(&Stroke::new(path.stroke.width, colour)).unwrap_or_default();
    let fill = fill_of(path.fill);
    let end = if path.closed { "Z" } else { "" };
    add_line(svg, &path.points, &format!("{fill} {stroke}"), end);
}

fn add_line(svg: &mut String, points: &[Pos2], ink: &str, end: &str) {
    let mut line = String::new();
    for (i, point) in points.iter().enumerate() {
        let step = if i == 0 { 'M' } else { 'L' };
        let _ = write!(line, "{step}{:.2} {:.2}", point.x, point.y);
    }
    if !line.is_empty() {
        let _ = writeln!(svg, "<path d=\"{line}{end}\" {ink}/>");
    }
}

/// Each row of a text, as text.
fn add_text(svg: &mut String, text: &TextShape) {
    let size = text.galley.job.sections.first();
    let size = size.map_or(12.0, |section| section.format.font_id.size);
    for row in &text.galley.rows {
        let (Some(first), Some(last)) = (row.glyphs.first(), row.glyphs.last()) else {
            continue;
        };
        let words: String = row.glyphs.iter().map(|glyph| glyph.chr).collect();
        let place = text.pos + row.pos.to_vec2() + first.pos.to_vec2();
        let width = last.pos.x + last.advance_width - first.pos.x;
        let _ = writeln!(
            svg,
            "<text x=\"{:.2}\" y=\"{:.2}\" font-size=\"{size}\" textLength=\"{width:.2}\" \
             lengthAdjust=\"spacingAndGlyphs\">{}</text>",
            place.x,
            place.y,
            escaped(&words)
        );
    }
}

fn stroke_of(stroke: &Stroke) -> Option<String> {
    let (ink, opacity) = ink(stroke.color)?;
    let width = stroke.width;
    (width > 0.0).then(|| {
        format!("stroke=\"{ink}\" stroke-opacity=\"{opacity:.2}\" stroke-width=\"{width:.2}\"")
    })
}

fn fill_of(colour: Color32) -> String {
    match ink(colour) {
        Some((ink, opacity)) => format!("fill=\"{ink}\" fill-opacity=\"{opacity:.2}\""),
        None => "fill=\"none\"".into(),
    }
}

/// The ink that stands for a colour of the window, and its opacity. None for a transparent one.
fn ink(colour: Color32) -> Option<(&'static str, f32)> {
    let [rgb @ .., alpha] = colour.to_srgba_unmultiplied();
    let [disk @ .., _] = DISK.to_srgba_unmultiplied();
    // Premultiplied colours are rounded.
    let is_disk = rgb.iter().zip(disk).all(|(a, b)| a.abs_diff(b) < 8);
    let opacity = (f32::from(alpha) / 255.0).max(MIN_OPACITY);
    (alpha > 0).then_some((if is_disk { GREY } else { BLACK }, opacity))
}
