//! The key to the guides: the meaning of each line, whether it is traced through bent light, and a
//! scale bar.

use super::place::Placement;
use super::style::{Style, meaning, name, short_meaning};
use crate::app::ui::layout::{Layout, Slide};
use crate::app::ui::number;
use crate::app::ui::screen::{show_placed, text_box};
use bevy_egui::egui::{self, Color32, RichText, Stroke, vec2};
use lightfall_core::numbers::in_words;
use lightfall_core::optics::guides::{Guide, bar_across_hole};
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::Scene;

const SIZE: f32 = 12.5;
const WIDTH: f32 = 292.0;
const SHORT_WIDTH: f32 = 178.0;
/// Maximum length of the scale bar, in points.
const LONGEST_BAR: f64 = 200.0;
/// Room inside the edges of the key, in points.
const MARGIN: f32 = 8.0;
const TEXT: Color32 = Color32::from_gray(238);
const WEAK: Color32 = Color32::from_gray(198);

/// What the key says about the guides as a whole.
#[derive(Clone, Copy)]
pub(super) struct Tracing {
    /// Whether some of them are still being traced.
    pub(super) waiting: bool,
    /// Whether they belong to the right side of a comparison only.
    pub(super) right_side: bool,
}

/// How much the key says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Length {
    /// Names, meanings and notes.
    Full,
    /// Meanings alone, with the name where a meaning is a mere length.
    Short,
}

impl Length {
    /// The name of the key's place.
    fn name(self) -> &'static str {
        match self {
            Self::Full => "key to the guides",
            Self::Short => "short key to the guides",
        }
    }

    /// The width of the key, in points.
    fn width(self) -> f32 {
        match self {
            Self::Full => WIDTH,
            Self::Short => SHORT_WIDTH,
        }
    }
}

/// What a key is about.
#[derive(Clone, Copy)]
pub(super) struct Key<'a> {
    pub(super) scene: &'a Scene,
    pub(super) guides: &'a [Guide],
    pub(super) placement: &'a Placement,
    pub(super) units: Units,
    pub(super) mass: HoleMass,
    pub(super) tracing: Tracing,
}

/// Shows the key in the upper right corner, below the legend of a view. Where there is no room for all
/// of it, a shorter one takes its place.
pub(super) fn show_key((context, layout): (&egui::Context, &mut Layout), key: Key) {
    let wish = layout.at(egui::Align2::RIGHT_TOP, Slide::Anywhere);
    for length in [Length::Full, Length::Short] {
        let show = |ui: &mut egui::Ui| {
            text_box(MARGIN, 5.0).show(ui, |ui| key.show(ui, length));
        };
        if show_placed(context, layout, length.name(), wish, show).is_some() {
            break;
        }
    }
}

impl Key<'_> {
    fn show(&self, ui: &mut egui::Ui, length: Length) {
        ui.set_width(length.width());
        ui.spacing_mut().item_spacing = vec2(8.0, 3.0);
        let full = length == Length::Full;
        let lensing = self.scene.effects.lensing;
        if full {
            let title = if self.tracing.right_side {
                "Guides for the right side"
            } else {
                "Guides"
            };
            ui.label(RichText::new(title).size(13.5).strong().color(TEXT));
        }
        let [traced, flat]: [Vec<&Guide>; 2] = [false, true].map(|flat| {
            let guides = self.guides.iter();
            guides.filter(|guide| guide.flat == flat).collect()
        });
        if lensing {
            heading(ui, "Traced through bent light");
            traced.iter().for_each(|guide| self.row(ui, guide, length));
            if self.tracing.waiting {
                note(ui, "tracing…");
            }
        }
        if !flat.is_empty() {
            heading(
                ui,
                match (lensing, full) {
                    (false, _) => "Lensing is off: every line is flat",
                    (true, true) => "Flat: where it would be without bending",
                    (true, false) => "Flat, without bending",
                },
            );
            flat.iter().for_each(|guide| self.row(ui, guide, length));
        }
        if lensing && full {
            let shadow = if self.scene.disk.enabled {
                "Every line of sight inside the shadow, traced back, ends at the horizon, unless the disk is in front."
            } else {
                "Every line of sight inside the shadow, traced back, ends at the horizon."
            };
            note(ui, shadow);
        }
        self.show_scale(ui, length);
    }

    fn row(&self, ui: &mut egui::Ui, guide: &Guide, length: Length) {
        let (style, kerr) = (Style::of(guide), self.scene.kerr());
        ui.horizontal_top(|ui| {
            let (rect, _) = ui.allocate_exact_size(vec2(28.0, 16.0), egui::Sense::hover());
            let ends = [rect.left_center(), rect.right_center()];
            let stroke = Stroke::new(style.width, style.colour);
            ui.painter().extend(style.dashed(&ends, stroke));
            ui.vertical(|ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                if length == Length::Full {
                    let name = RichText::new(name(guide, kerr)).size(SIZE);
                    ui.label(name.color(style.colour));
                }
                let meaning = match length {
                    Length::Full => meaning(guide, kerr, self.units),
                    Length::Short => short_meaning(guide, kerr, self.units),
                };
                ui.label(RichText::new(meaning).size(SIZE).color(TEXT));
            });
        });
    }

    /// Shows a bar that is as long as a round length at the hole's distance.
    fn show_scale(&self, ui: &mut egui::Ui, length: Length) {
        // Short enough for the picture's perspective not to matter.
        let short = 1e-3 * self.scene.camera.r;
        let Some([left, right]) = bar_across_hole(self.scene, short) else {
            return;
        };
        ui.add_space(4.0);
        let (Some(left), Some(right)) = (self.placement.of(left), self.placement.of(right)) else {
            note(ui, "Scale: the hole's centre is out of view.");
            return;
        };
        let points_per_length = f64::from(left.distance(right)) / short;
        let longest = LONGEST_BAR * f64::from(length.width() / WIDTH) / points_per_length;
        let Some((bar, in_units)) = number::scale_bar(longest, self.units) else {
            return;
        };
        let width = (bar * points_per_length) as f32;
        let (rect, _) = ui.allocate_exact_size(vec2(length.width(), 10.0), egui::Sense::hover());
        let stroke = Stroke::new(2.0, TEXT);
        let (start, y) = (rect.left() + 1.0, rect.center().y);
        ui.painter().hline(start..=start + width, y, stroke);
        for x in [start, start + width] {
            ui.painter().vline(x, rect.y_range(), stroke);
        }
        let suns = in_words(self.mass.suns);
        let text = match (length, self.units) {
            (Length::Short, _) => in_units,
            (Length::Full, Units::Hole) => {
                let everyday = Units::Everyday(self.mass).length(bar, in_words);
                format!("{in_units} at the hole's distance, flat: {everyday} for {suns} suns")
            }
            (Length::Full, Units::Everyday(_)) => {
                format!("{in_units} at the hole's distance, flat, for {suns} suns")
            }
        };
        ui.label(RichText::new(text).size(SIZE).color(TEXT));
    }
}

fn heading(ui: &mut egui::Ui, text: &str) {
    ui.add_space(3.0);
    note(ui, text);
}

fn note(ui: &mut egui::Ui, text: &str) {
    ui.label(RichText::new(text).size(SIZE).color(WEAK));
}
