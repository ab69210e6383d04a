//! The two panels at the sides of the window, and the help: opening and closing them, and drawing a
//! panel's frame.

use crate::app::controls::control::AppCommand;
use crate::app::input::pointer::locate_pointer;
use crate::app::state::overlays::{Overlays, Side};
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

/// Room inside a panel, in points.
const MARGIN: f32 = 8.0;

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Overlays>().add_systems(
        Update,
        (apply_overlay_commands, divide_window_width)
            .chain()
            .before(locate_pointer),
    );
}

pub(crate) fn apply_overlay_commands(
    mut commands: MessageReader<AppCommand>,
    mut overlays: ResMut<Overlays>,
    mut toast: ResMut<Toast>,
) {
    for command in commands.read() {
        match command {
            AppCommand::Hide => overlays.hidden = !overlays.hidden,
            AppCommand::Help => {
                overlays.toggle_help();
                if !overlays.help {
                    toast.say("Help: closed");
                }
            }
            AppCommand::Panel => {
                overlays.toggle_side(Side::Right);
                toast.say(opened("Panel", overlays.panel));
            }
            AppCommand::Inspector => {
                overlays.toggle_side(Side::Left);
                toast.say(if overlays.inspector {
                    "Ray inspector: click a pixel"
                } else {
                    "Ray inspector: closed"
                });
            }
            _ => {}
        }
    }
}

fn opened(what: &str, open: bool) -> String {
    format!("{what}: {}", if open { "open" } else { "closed" })
}

fn divide_window_width(mut contexts: EguiContexts, mut overlays: ResMut<Overlays>) {
    if let Ok(context) = contexts.ctx_mut() {
        overlays.share(context.content_rect().width());
    }
}

/// Shows a panel as high as the window. It is an egui area of its own, so that the mouse over it
/// does nothing to the picture.
pub(crate) fn docked(
    context: &egui::Context,
    name: &'static str,
    side: Side,
    width: f32,
    contents: impl FnOnce(&mut egui::Ui),
) {
    let screen = context.content_rect();
    let width = width.min(screen.width());
    let left = match side {
        Side::Left => screen.left(),
        Side::Right => screen.right() - width,
    };
    let area = egui::Area::new(egui::Id::new(name))
        .fixed_pos([left, screen.top()])
        .movable(false)
        .constrain(false);
    area.order(egui::Order::Middle).show(context, |ui| {
        let frame = egui::Frame::new()
            .fill(context.global_style().visuals.window_fill)
            .inner_margin(MARGIN);
        frame.show(ui, |ui| {
            let inside = egui::vec2(width, screen.height()) - egui::Vec2::splat(2.0 * MARGIN);
            ui.set_min_size(inside);
            ui.set_max_size(inside);
            contents(ui);
        });
    });
}
