//! Opens and closes what is drawn over the picture, and draws the frames of the two side panels.

use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::input::pointer::locate_pointer;
use crate::app::state::helm::Helm;
use crate::app::state::overlays::{Overlays, PathShown, Side};
use crate::app::state::toast::Toast;
use crate::app::ui::star_names::has_stars;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};
use lightfall_render::CurrentScene;

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
    (scene, helm): (Res<CurrentScene>, Res<Helm>),
    bindings: Res<Bindings>,
) {
    for command in commands.read() {
        let (is_open, [open, closed]) = match command {
            AppCommand::Hide => {
                overlays.hidden = !overlays.hidden;
                continue;
            }
            AppCommand::Help => {
                overlays.toggle(|open| &mut open.help);
                // An open help needs no words.
                (overlays.help, ["", "Help: closed"])
            }
            AppCommand::Panel => {
                overlays.toggle_side(Side::Right);
                (overlays.panel, ["Panel: open", "Panel: closed"])
            }
            AppCommand::Inspector => {
                overlays.toggle_side(Side::Left);
                let open = "Ray inspector: click a pixel";
                (overlays.inspector, [open, "Ray inspector: closed"])
            }
            AppCommand::Guides => {
                overlays.toggle(|open| &mut open.guides);
                (overlays.guides, ["Guides: on", "Guides: off"])
            }
            AppCommand::StarNames => {
                overlays.toggle(|open| &mut open.star_names);
                let on = if has_stars(&scene) {
                    "Star names: on"
                } else {
                    "Star names: on, but the sky shows no real stars"
                };
                (overlays.star_names, [on, "Star names: off"])
            }
            AppCommand::Map if !helm.has_ship() => {
                toast.say(format!(
                    "The map shows the ship's path: {} takes its controls",
                    bindings.label("ship.fly")
                ));
                continue;
            }
            AppCommand::Map => {
                overlays.path = overlays.path.next();
                toast.say(match overlays.path {
                    PathShown::MapAndLine => "Map: shown",
                    PathShown::Line => "Map: hidden; the path stays in the picture",
                    PathShown::Nothing => "Map and path: hidden",
                });
                continue;
            }
            _ => continue,
        };
        let says = if is_open { open } else { closed };
        if !says.is_empty() {
            toast.say(says);
        }
    }
}

fn divide_window_width(mut contexts: EguiContexts, mut overlays: ResMut<Overlays>) {
    if let Ok(context) = contexts.ctx_mut() {
        overlays.share(context.content_rect().width());
    }
}

/// Shows a side panel as high as the window. It is an egui area of its own, so that the mouse over it
/// does not act on the picture.
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
