//! The texts and widgets that egui shows.

use bevy_egui::{EguiContext, EguiFullOutput, egui};
use watched::{Place, Text};

/// Texts fainter than this are not seen.
const MIN_OPACITY: f32 = 0.2;

/// The texts that can be seen.
pub fn texts<'a>(outputs: impl IntoIterator<Item = &'a EguiFullOutput>) -> Vec<Text> {
    let mut texts = Vec::new();
    for output in outputs.into_iter().filter_map(|output| output.0.as_ref()) {
        for clipped in &output.shapes {
            collect(&clipped.shape, clipped.clip_rect, &mut texts);
        }
    }
    texts
}

fn collect(shape: &egui::Shape, clip: egui::Rect, texts: &mut Vec<Text>) {
    match shape {
        egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, clip, texts)),
        egui::Shape::Text(text) if text.opacity_factor > MIN_OPACITY => {
            let letters = text.galley.mesh_bounds.translate(text.pos.to_vec2());
            let words = text.galley.text().replace('\n', " ");
            if !words.trim().is_empty() && clip.intersects(letters) {
                texts.push(Text {
                    words,
                    // Of a text that scrolls, a part is seen.
                    place: place(letters.intersect(clip)),
                    opacity: text.opacity_factor,
                });
            }
        }
        _ => {}
    }
}

/// Where the mouse can click or drag something.
pub fn widgets(context: &mut EguiContext) -> Vec<Place> {
    context.get_mut().viewport(|viewport| {
        let layers = viewport.prev_pass.widgets.layers();
        let widgets = layers.flat_map(|(_, widgets)| widgets);
        let live = widgets.filter(|widget| widget.enabled && widget.sense.interactive());
        live.map(|widget| place(widget.interact_rect)).collect()
    })
}

/// A rectangle of egui.
pub fn place(rect: egui::Rect) -> Place {
    Place {
        min: rect.min.into(),
        max: rect.max.into(),
    }
}
