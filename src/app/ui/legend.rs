//! The legend of a diagnostic view, in the upper right corner: what its colours mean.

use crate::app::state::overlays::Overlays;
use crate::app::state::shown_picture::ShownPicture;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use lightfall_core::scene::{Scene, View};

/// A colour of a view as its shader has it (linear sRGB), and its meaning.
pub type Swatch = (Vec3, &'static str);

const MAGENTA: Vec3 = Vec3::new(1.0, 0.0, 1.0);
const BLACK: Vec3 = Vec3::ZERO;

const UNFINISHED: &[Swatch] = &[(MAGENTA, "unfinished: out of steps, or not a number")];

const CLASSES: &[Swatch] = &[
    (Vec3::new(0.0, 0.02, 0.16), "from the sky"),
    (
        Vec3::new(0.02, 0.20, 0.75),
        "from the sky, meets the disk once",
    ),
    (Vec3::new(0.30, 0.75, 1.0), "from the sky, meets it twice"),
    (Vec3::new(0.06, 0.02, 0.0), "ends at the horizon"),
    (
        Vec3::new(0.60, 0.15, 0.0),
        "ends at the horizon, meets it once",
    ),
    (
        Vec3::new(1.0, 0.65, 0.05),
        "ends at the horizon, meets it twice",
    ),
    (MAGENTA, "unfinished"),
];

const ORDERS: &[Swatch] = &[
    (Vec3::splat(0.20), "0: direct light"),
    (Vec3::new(0.79, 0.35, 0.0), "1: a half-turn about the hole"),
    (Vec3::new(0.0, 0.17, 0.45), "2 half-turns"),
    (Vec3::splat(0.95), "3 or more"),
    (BLACK, "no light: the ray ends at the horizon"),
    (MAGENTA, "unfinished"),
];

const SHIFTS: &[Swatch] = &[
    (Vec3::new(0.01, 0.04, 0.40), "g = 2 or more"),
    (Vec3::new(0.10, 0.40, 0.95), "g = 1.41, blueshifted"),
    (Vec3::splat(0.90), "g = 1"),
    (Vec3::new(0.90, 0.30, 0.03), "g = 0.71, redshifted"),
    (Vec3::new(0.25, 0.01, 0.01), "g = 0.5 or less"),
    (BLACK, "no light: the ray ends at the horizon"),
];

const RESIDUALS: &[Swatch] = &[
    (BLACK, "1e-8 or less"),
    (Vec3::new(0.10, 0.01, 0.25), "1e-6"),
    (Vec3::new(0.75, 0.12, 0.04), "1e-4"),
    (Vec3::new(0.95, 0.65, 0.02), "1e-2"),
    (Vec3::ONE, "1 or more"),
];

const DELAYS: &[Swatch] = &[
    (
        Vec3::new(0.9969, 0.8660, 0.4176),
        "10 r_s/c less, or even less",
    ),
    (
        Vec3::new(0.8501, 0.3482, 0.2012),
        "as long as from beside the hole",
    ),
    (Vec3::new(0.4797, 0.1187, 0.1321), "10 r_s/c more"),
    (Vec3::new(0.1521, 0.0360, 0.1154), "20 r_s/c more"),
    (
        Vec3::new(0.0093, 0.0010, 0.1150),
        "30 r_s/c more, or even more",
    ),
    (BLACK, "no disk"),
    (MAGENTA, "unfinished"),
];

const STEPS: &[Swatch] = &[
    (BLACK, "none"),
    (Vec3::new(0.0200, 0.0029, 0.0729), "4 or fewer"),
    (Vec3::new(0.1139, 0.0127, 0.0927), "8"),
    (Vec3::new(0.2946, 0.0343, 0.1159), "16"),
    (Vec3::new(0.5366, 0.0914, 0.1450), "32"),
    (Vec3::new(0.7844, 0.2188, 0.1857), "64"),
    (Vec3::new(0.9592, 0.4607, 0.2474), "128"),
    (Vec3::new(0.9642, 0.8686, 0.3441), "256 or more"),
    (MAGENTA, "unfinished"),
];

const ERRORS: &[Swatch] = &[
    (Vec3::new(0.0273, 0.0090, 0.1511), "1e-4 px or less"),
    (Vec3::new(0.0080, 0.1104, 0.2716), "1e-3 px"),
    (Vec3::new(0.0246, 0.3181, 0.3356), "1e-2 px"),
    (Vec3::new(0.2431, 0.6151, 0.2757), "0.1 px"),
    (Vec3::new(0.9615, 0.9322, 0.0480), "1 px or more"),
    (MAGENTA, "too large to measure"),
    (BLACK, "nothing seen: the hole"),
    (Vec3::splat(0.05), "not known yet"),
];

/// What a view shows, and its colours. None for the light itself.
#[must_use]
pub fn legend(view: View) -> Option<(&'static str, &'static [Swatch])> {
    Some(match view {
        View::Colour => return None,
        View::Unfinished => ("Rays left unfinished", UNFINISHED),
        View::Classes => (
            "Where each ray comes from, and how often it meets the disk between its edges",
            CLASSES,
        ),
        View::Order => (
            "Order of the image; the sky is darker than the disk",
            ORDERS,
        ),
        View::Delay => (
            "How long the light of the disk was under way; a band every 2 r_s/c",
            DELAYS,
        ),
        View::Redshift => ("g = observed / emitted frequency, of disk or sky", SHIFTS),
        View::Residual => ("Residual of the null constraint (not the error)", RESIDUALS),
        View::Steps => ("Steps of the method along each ray", STEPS),
        View::Error => (
            "Backward error: the rotation that would explain a ray's error; one ray per block",
            ERRORS,
        ),
    })
}

/// Name of the legend's area.
pub(crate) const LEGEND: &str = "legend";
/// Largest width of its texts, in points.
const MAX_WIDTH: f32 = 250.0;
/// Room around the legend, in points.
const MARGIN: f32 = 12.0;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show_legend);
}

fn show_legend(
    mut contexts: EguiContexts,
    shown: Res<ShownPicture>,
    overlays: Res<Overlays>,
) -> Result {
    let scene = &shown.scene;
    let Some((title, swatches)) = legend(scene.view).filter(|_| !overlays.hidden) else {
        return Ok(());
    };
    egui::Area::new(LEGEND.into())
        .anchor(
            egui::Align2::RIGHT_TOP,
            [-overlays.right_width() - MARGIN, MARGIN],
        )
        .interactable(false)
        .order(egui::Order::Background)
        .show(contexts.ctx_mut()?, |ui| {
            let frame = egui::Frame::new()
                .fill(egui::Color32::from_black_alpha(240))
                .inner_margin(8)
                .corner_radius(5);
            frame.show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 2.0;
                ui.set_max_width(MAX_WIDTH);
                ui.label(egui::RichText::new(title).size(13.0).strong());
                for (colour, meaning) in swatches {
                    ui.horizontal(|ui| {
                        let (rect, _) =
                            ui.allocate_exact_size(egui::vec2(22.0, 12.0), egui::Sense::hover());
                        let edge = egui::Stroke::new(1.0, egui::Color32::from_gray(90));
                        ui.painter().rect(
                            rect,
                            1.0,
                            as_shown(*colour),
                            edge,
                            egui::StrokeKind::Inside,
                        );
                        ui.label(egui::RichText::new(*meaning).size(13.0));
                    });
                }
                if let Some(reason) = why_empty(scene) {
                    ui.label(egui::RichText::new(reason).size(13.0));
                }
            });
        });
    Ok(())
}

/// Why a view has nothing to show with the scene's method.
fn why_empty(scene: &Scene) -> Option<&'static str> {
    let method = scene.method.resolved().properties();
    let straight = !scene.effects.lensing;
    match scene.view {
        View::Unfinished if straight || method.answers_every_ray => {
            Some("This method finishes every ray.")
        }
        View::Residual if straight || !method.steps => {
            Some("This method solves for rays instead of stepping along them: it has no residual.")
        }
        View::Delay if !scene.disk.enabled => Some("The disk is off: no light to time."),
        View::Steps if straight || !method.steps => {
            Some("This method solves for rays instead of stepping along them: no ray takes a step.")
        }
        _ => None,
    }
}

/// The colour of a mark on the screen: its light, a little darker than white, tone-mapped like the
/// picture (Khronos PBR neutral; no mark is bright enough to reach the shoulder of the curve).
fn as_shown(colour: Vec3) -> egui::Color32 {
    let light = lightfall_core::gpu::MARK_BRIGHTNESS as f32 * colour;
    let least = light.min_element();
    let offset = if least < 0.08 {
        least - 6.25 * least * least
    } else {
        0.04
    };
    let [r, g, b] = (light - offset).to_array();
    egui::Rgba::from_rgb(r, g, b).into()
}
