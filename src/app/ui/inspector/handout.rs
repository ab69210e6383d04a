//! The handout: the inspector's figure on white paper with its caption and numbers, as SVG. Text is
//! text, so that it can be searched, translated and edited.

use super::drawing::{Sketch, Viewpoint};
use super::svg::{FONTS, elements, escaped};
use super::{numbers, plane_figure};
use crate::app::ui::hud::physics_off;
use bevy_egui::egui::{self, Rect, pos2, vec2};
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::Scene;
use std::fmt::Write;

/// Width of the page and height of the figure, in points, and the width in millimetres when printed.
const WIDTH: f32 = 680.0;
const FIGURE: f32 = 400.0;
const WIDTH_MM: f32 = 180.0;
/// Room around everything, in points.
const MARGIN: f32 = 16.0;
/// Size of the text and height of its lines, in points, and letters that fit into a line.
const TEXT: f32 = 13.0;
const LINE: f32 = 18.0;
const LETTERS: usize = 96;
/// Columns of numbers, the place of values in them, in points, and the letters that fit into a value's
/// line: digits, the widest of the usual letters, take 0.556 of the text's size.
const COLUMNS: usize = 2;
const VALUE: f32 = 130.0;
const VALUE_LETTERS: usize = 26;

/// The handout of these rays in their plane, as the inspector writes it where nothing else was chosen.
/// None without a ray.
#[must_use]
pub fn plane_handout(scene: &Scene, rays: &[Inspected], units: Units) -> Option<String> {
    handout(title(scene), scene, rays, &Sketch::default(), units)
}

/// The handout of the rays of a click, whose first one has the numbers.
pub(super) fn handout(
    title: &str,
    scene: &Scene,
    rays: &[Inspected],
    sketch: &Sketch,
    units: Units,
) -> Option<String> {
    let first = rays.first()?;
    let mut page = Page::new(title);
    let figure = Rect::from_min_size(pos2(MARGIN, page.y), vec2(WIDTH - 2.0 * MARGIN, FIGURE));
    page.add_figure(figure, |painter| {
        sketch.paint(painter, figure, scene, rays, units)
    });
    for line in caption(scene, first, sketch.viewpoint, units) {
        page.add_line(&line, "");
    }
    page.y += 0.5 * LINE;
    page.add_numbers(&numbers::rows(first, scene, units));
    let method = scene.resolved_method().word();
    page.y += 0.5 * LINE;
    if let Some(off) = physics_off(scene) {
        page.add_line(&off, "");
    }
    page.add_line(
        &format!(
            "Lightfall {}, f64 reference; the picture's method is {method}.",
            env!("CARGO_PKG_VERSION")
        ),
        " font-style=\"italic\"",
    );
    Some(page.finish())
}

/// The title of the scene, or its name.
pub(super) fn title(scene: &Scene) -> &str {
    match scene.title.trim() {
        "" => &scene.name,
        title => title,
    }
}

/// What the figure shows and what its lines are, in lines.
fn caption(scene: &Scene, first: &Inspected, viewpoint: Viewpoint, units: Units) -> Vec<String> {
    let mut said = plane_figure::explanation(scene, first, units);
    said += match viewpoint {
        Viewpoint::Plane if scene.camera.r < scene.kerr().horizon() => " Full circle: the horizon.",
        _ => " Black disk: the hole up to its horizon.",
    };
    said += match viewpoint {
        Viewpoint::Plane => " Dashed circles: circular orbits of light.",
        _ => {
            " Circles around it: circular orbits of light, and the innermost stable one of matter."
        }
    };
    if scene.disk.enabled {
        said += " Grey: the disk.";
    }
    said += " Arrows point as the light goes, toward the camera.";
    wrapped(&said, LETTERS)
}

/// A text in lines of so many letters at most, unless a word is longer.
fn wrapped(text: &str, letters: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let length = word.chars().count();
        let fits = |line: &&mut String| line.chars().count() + length < letters;
        match lines.last_mut().filter(fits) {
            Some(line) => *line += &format!(" {word}"),
            None => lines.push(word.to_owned()),
        }
    }
    lines
}

/// A page that grows downward.
struct Page {
    svg: String,
    /// Where the next line begins.
    y: f32,
}

impl Page {
    fn new(title: &str) -> Self {
        let mut page = Self {
            svg: String::new(),
            y: MARGIN,
        };
        page.add_line(title, " font-weight=\"bold\"");
        page.y += 0.5 * LINE;
        page
    }

    fn text(&mut self, x: f32, y: f32, text: &str, style: &str) {
        let _ = writeln!(
            self.svg,
            "<text x=\"{x:.2}\" y=\"{y:.2}\" font-size=\"{TEXT}\"{style}>{}</text>",
            escaped(text)
        );
    }

    fn add_line(&mut self, text: &str, style: &str) {
        self.y += LINE;
        self.text(MARGIN, self.y - 0.3 * LINE, text, style);
    }

    fn add_figure(&mut self, place: Rect, draw: impl FnOnce(&egui::Painter)) {
        let context = egui::Context::default();
        context.begin_pass(egui::RawInput {
            screen_rect: Some(place.expand(MARGIN)),
            ..Default::default()
        });
        draw(
            &context
                .layer_painter(egui::LayerId::background())
                .with_clip_rect(place),
        );
        let shapes = context.end_pass().shapes;
        let (Rect { min, .. }, size) = (place, place.size());
        let _ = writeln!(
            self.svg,
            "<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" viewBox=\"{0} {1} {2} {3}\">\n{4}</svg>\n\
             <rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.7\"/>",
            min.x,
            min.y,
            size.x,
            size.y,
            elements(&shapes)
        );
        self.y = place.bottom() + 0.3 * LINE;
    }

    /// The numbers in columns, downward. A long value takes several lines of its column.
    fn add_numbers(&mut self, rows: &[(String, String)]) {
        let rows = rows
            .iter()
            .map(|(name, value)| (name.trim(), wrapped(value, VALUE_LETTERS)));
        let rows: Vec<(&str, Vec<String>)> = rows.collect();
        let lines: usize = rows.iter().map(|(_, value)| value.len()).sum();
        let (per_column, top) = (lines.div_ceil(COLUMNS), self.y);
        let width = (WIDTH - 2.0 * MARGIN) / COLUMNS as f32;
        let (mut column, mut line, mut most) = (0, 0, 0);
        for (name, value) in rows {
            if line >= per_column && column + 1 < COLUMNS {
                (column, line) = (column + 1, 0);
            }
            let x = MARGIN + column as f32 * width;
            let y = |line: usize| top + (line + 1) as f32 * LINE;
            self.text(x, y(line), name, "");
            for words in &value {
                self.text(x + VALUE, y(line), words, "");
                line += 1;
            }
            most = most.max(line);
        }
        self.y = top + most as f32 * LINE + 0.3 * LINE;
    }

    fn finish(self) -> String {
        let height = self.y + MARGIN;
        let height_mm = height * WIDTH_MM / WIDTH;
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH_MM}mm\" height=\"{height_mm:.2}mm\" \
             viewBox=\"0 0 {WIDTH} {height:.2}\" font-family=\"{FONTS}\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{}</svg>\n",
            self.svg
        )
    }
}
