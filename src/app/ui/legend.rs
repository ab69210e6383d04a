//! The legend of a diagnostic view, in the upper right corner: what its colours mean.

use crate::app::controls::empty_view::why_empty;
use crate::app::state::shown_picture::ShownPicture;
use crate::app::ui::layout::{Importance, Slide};
use crate::app::ui::screen::{Screen, show_placed, text_box};
use bevy::prelude::*;
use bevy_egui::{EguiPrimaryContextPass, egui};

/// Largest width of its texts, in points.
const MAX_WIDTH: f32 = 250.0;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        EguiPrimaryContextPass,
        show_legend.in_set(Importance::Legend),
    );
}

fn show_legend(mut screen: Screen, shown: Res<ShownPicture>) {
    let scene = &shown.scene;
    let view = scene.view.properties();
    let Some((context, layout)) = screen.texts().filter(|_| !view.legend.is_empty()) else {
        return;
    };
    let wish = layout.at(egui::Align2::RIGHT_TOP, Slide::Anywhere);
    show_placed(context, layout, "legend", wish, |ui| {
        text_box(8.0, 5.0).show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 2.0;
            ui.set_max_width(MAX_WIDTH);
            ui.strong(view.legend);
            for (colour, meaning) in view.swatches {
                ui.horizontal(|ui| {
                    let (rect, _) =
                        ui.allocate_exact_size(egui::vec2(22.0, 12.0), egui::Sense::hover());
                    let edge = egui::Stroke::new(1.0, egui::Color32::from_gray(90));
                    let fill = as_shown((*colour).into());
                    ui.painter()
                        .rect(rect, 1.0, fill, edge, egui::StrokeKind::Inside);
                    ui.label(*meaning);
                });
            }
            if let Some(reason) = why_empty(scene.view, scene) {
                ui.label(reason);
            }
        });
    });
}

/// The colour of a mark on the screen: its light, a little darker than white, tone-mapped as in the
/// picture. The curve is Khronos PBR neutral, whose shoulder no mark reaches.
fn as_shown(colour: Vec3) -> egui::Color32 {
    let light = lightfall_core::gpu::MARK_BRIGHTNESS as f32 * colour;
    let least = light.min_element().min(0.08);
    let offset = least - 6.25 * least * least;
    let [r, g, b] = (light - offset).to_array();
    egui::Rgba::from_rgb(r, g, b).into()
}
