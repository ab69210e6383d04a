//! The key to the guides: the meaning of each line, whether it is traced through bent light, and a
//! scale bar.

use super::place::Placement;
use super::style::{Style, meaning, name};
use crate::app::ui::layout::{Layout, Slide};
use crate::app::ui::number;
use crate::app::ui::screen::{show_placed, text_box};
use bevy_egui::egui::{self, Color32, RichText, Stroke, vec2};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::numbers::in_words;
use lightfall_core::optics::guides::{Guide, bar_across_hole};
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::Scene;

const SIZE: f32 = 12.5;
const WIDTH: f32 = 292.0;
/// Maximum length of the scale bar, in points.
const LONGEST_BAR: f64 = 200.0;
/// Room inside the edges of the key, in points.
const MARGIN: f32 = 8.0;
const TEXT: Color32 = Color32::from_gray(238);
const WEAK: Color32 = Color32::from_gray(198);

/// What the key says about the guides as a whole.
pub(super) struct Tracing {
    /// Whether some of them are still being traced.
    pub(super) waiting: bool,
    /// Whether they belong to the right side of a comparison only.
    pub(super) right_side: bool,
}

/// Shows the key in the upper right corner, below the legend of a view.
pub(super) fn show_key(
    (context, layout): (&egui::Context, &mut Layout),
    scene: &Scene,
    guides: &[Guide],
    placement: &Placement,
    (units, mass): (Units, HoleMass),
    tracing: Tracing,
) {
    let kerr = scene.kerr();
    let wish = layout.at(egui::Align2::RIGHT_TOP, Slide::Anywhere);
    show_placed(context, layout, "key to the guides", wish, |ui| {
        text_box(MARGIN, 5.0).show(ui, |ui| {
            ui.set_width(WIDTH);
            ui.spacing_mut().item_spacing = vec2(8.0, 3.0);
            let title = if tracing.right_side {
                "Guides for the right side"
            } else {
                "Guides"
            };
            ui.label(RichText::new(title).size(13.5).strong().color(TEXT));
            let [traced, flat]: [Vec<&Guide>; 2] = [false, true]
                .map(|flat| guides.iter().filter(|guide| guide.flat == flat).collect());
            if scene.effects.lensing {
                heading(ui, "Traced through bent light");
                traced.iter().for_each(|guide| row(ui, guide, kerr, units));
                if tracing.waiting {
                    note(ui, "tracing…");
                }
            }
            if !flat.is_empty() {
                let title = if scene.effects.lensing {
                    "Flat: where it would be without bending"
                } else {
                    "Lensing is off: every line is flat"
                };
                heading(ui, title);
                flat.iter().for_each(|guide| row(ui, guide, kerr, units));
            }
            if scene.effects.lensing {
                let shadow =
                    "Every line of sight inside the shadow, traced back, ends at the horizon.";
                note(ui, shadow);
            }
            show_scale(ui, scene, placement, units, mass);
        });
    });
}

fn heading(ui: &mut egui::Ui, text: &str) {
    ui.add_space(3.0);
    note(ui, text);
}

fn note(ui: &mut egui::Ui, text: &str) {
    ui.label(RichText::new(text).size(SIZE).color(WEAK));
}

fn row(ui: &mut egui::Ui, guide: &Guide, kerr: Kerr, units: Units) {
    let style = Style::of(guide);
    ui.horizontal_top(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(28.0, 16.0), egui::Sense::hover());
        let ends = [rect.left_center(), rect.right_center()];
        let stroke = Stroke::new(style.width, style.colour);
        ui.painter().extend(style.dashed(&ends, stroke));
        ui.vertical(|ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let name = RichText::new(name(guide, kerr)).size(SIZE);
            ui.label(name.color(style.colour));
            let meaning = meaning(guide, kerr, units);
            ui.label(RichText::new(meaning).size(SIZE).color(TEXT));
        });
    });
}

/// Shows a bar that is as long as a round length at the hole's distance.
fn show_scale(
    ui: &mut egui::Ui,
    scene: &Scene,
    placement: &Placement,
    units: Units,
    mass: HoleMass,
) {
    // Short enough for the picture's perspective not to matter.
    let short = 1e-3 * scene.camera.r;
    let Some([left, right]) = bar_across_hole(scene, short) else {
        return;
    };
    ui.add_space(4.0);
    let (Some(left), Some(right)) = (placement.of(left), placement.of(right)) else {
        note(ui, "Scale: the hole is out of view.");
        return;
    };
    let points_per_length = f64::from(left.distance(right)) / short;
    let longest = LONGEST_BAR / points_per_length;
    let Some((length, in_units)) = number::scale_bar(longest, units) else {
        return;
    };
    let width = (length * points_per_length) as f32;
    let (rect, _) = ui.allocate_exact_size(vec2(WIDTH, 10.0), egui::Sense::hover());
    let stroke = Stroke::new(2.0, TEXT);
    let (start, y) = (rect.left() + 1.0, rect.center().y);
    ui.painter().hline(start..=start + width, y, stroke);
    for x in [start, start + width] {
        ui.painter().vline(x, rect.y_range(), stroke);
    }
    let suns = in_words(mass.suns);
    let text = match units {
        Units::Hole => {
            let everyday = Units::Everyday(mass).length(length, in_words);
            format!("{in_units} at the hole's distance, flat: {everyday} for {suns} suns")
        }
        Units::Everyday(_) => format!("{in_units} at the hole's distance, flat, for {suns} suns"),
    };
    ui.label(RichText::new(text).size(SIZE).color(TEXT));
}
