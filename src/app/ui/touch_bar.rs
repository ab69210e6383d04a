//! The bar that a tap on the picture opens, for hands without a keyboard. It goes away when one of its
//! buttons is used or the picture is tapped again.

use crate::app::controls::control::AppCommand;
use crate::app::input::touch::{Fingers, read_fingers};
use crate::app::motion::free_fall::FreeFall;
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::motion::ship::ShipFlight;
use crate::app::state::helm::{CommandSender, FingerPushes};
use crate::app::state::kiosk::Kiosk;
use crate::app::state::menu::Menu;
use crate::app::state::overlays::Overlays;
use crate::app::ui::layout::{GAP, Importance, Layout, Slide};
use crate::app::ui::screen::{MARGIN, text_box};
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// Smallest size of a button, in points: that of a finger.
const BUTTON: egui::Vec2 = egui::vec2(56.0, 44.0);
/// Size of its text, in points.
const TEXT: f32 = 15.0;
/// Name of the bar, which is its egui area.
const NAME: &str = "touch bar";

/// Whether the bar is shown.
#[derive(Resource, Default)]
pub(crate) struct TouchBar {
    open: bool,
}

/// What a button does.
#[derive(Clone, Copy)]
enum Use {
    Command(AppCommand),
    /// Open the menu at its list of places.
    Places,
    /// Push the ship along its nose while the button is held.
    Push,
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<TouchBar>()
        .add_systems(Update, open_touch_bar.after(read_fingers))
        .add_systems(
            EguiPrimaryContextPass,
            show_touch_bar.in_set(Importance::TouchBar),
        );
}

/// Opens the bar where the picture is tapped, and closes it where it is tapped again. While the ray
/// inspector is open, a tap chooses a pixel.
fn open_touch_bar(
    fingers: Res<Fingers>,
    overlays: Res<Overlays>,
    (menu, kiosk): (Res<Menu>, Res<Kiosk>),
    mut bar: ResMut<TouchBar>,
) {
    if fingers.tap.is_some() && (bar.open || !overlays.shows_inspector()) {
        bar.open = !bar.open;
    }
    if bar.open && (menu.is_open() || kiosk.is_deserted()) {
        bar.open = false;
    }
}

/// The buttons that visitors may use. They leave the ship by a button of its own, because they have no
/// menu.
fn for_visitors(
    buttons: Vec<(&'static str, Use)>,
    at_helm: bool,
    kiosk: &Kiosk,
) -> Vec<(&'static str, Use)> {
    let leave = ("Leave", Use::Command(AppCommand::TakeControls));
    let allowed = |does: Use| match does {
        Use::Push => true,
        Use::Places => false,
        Use::Command(command) => kiosk.offers(command),
    };
    let allowed = buttons.into_iter().filter(|(_, does)| allowed(*does));
    allowed.chain(at_helm.then_some(leave)).collect()
}

/// The buttons, with what is on them.
fn buttons(overlays: &Overlays, falls: bool, travels: bool) -> Vec<(&'static str, Use)> {
    use AppCommand::{Escape, Hide, Journey, LetGo, Screenshot};
    if overlays.hidden {
        return vec![
            ("Save picture", Use::Command(Screenshot)),
            ("End photo mode", Use::Command(Hide)),
        ];
    }
    let covered = overlays.help || overlays.panel || overlays.inspector;
    vec![
        (if covered { "Close" } else { "Menu" }, Use::Command(Escape)),
        ("Places", Use::Places),
        ("Ship", Use::Command(AppCommand::TakeControls)),
        (if falls { "Hold" } else { "Fall" }, Use::Command(LetGo)),
        (
            if travels { "Stop" } else { "Journey" },
            Use::Command(Journey),
        ),
        ("Photo", Use::Command(Hide)),
    ]
}

/// The buttons at the ship's controls, with what is on them. The bar stays while they are used.
const AT_HELM: [(&str, Use); 8] = [
    ("Push", Use::Push),
    ("Nose", Use::Command(AppCommand::Face)),
    ("Orbit", Use::Command(AppCommand::OrbitCamera)),
    ("Still", Use::Command(AppCommand::Hover)),
    ("Engine off", Use::Command(AppCommand::LetGo)),
    ("Slower", Use::Command(AppCommand::SlowerTime)),
    ("Faster", Use::Command(AppCommand::FasterTime)),
    ("Menu", Use::Command(AppCommand::Escape)),
];

/// What the bar says in place of what needs an engine.
fn lack_of_push(ship: &ShipFlight) -> Option<&'static str> {
    if ship.can_push() {
        None
    } else if ship.has_engine() {
        Some("The tank is empty")
    } else {
        Some("The ship has no engine")
    }
}

/// The buttons at the controls of this ship: where the engine cannot push, those that need it give way to
/// the one that goes back.
fn helm_buttons(ship: &ShipFlight) -> Vec<(&'static str, Use)> {
    use AppCommand::{Hover, LetGo, OrbitCamera, Undo};
    if ship.can_push() {
        return AT_HELM.to_vec();
    }
    let needs_engine =
        |does: Use| matches!(does, Use::Push | Use::Command(OrbitCamera | Hover | LetGo));
    let others = AT_HELM.into_iter().filter(|(_, does)| !needs_engine(*does));
    others.chain([("Back", Use::Command(Undo))]).collect()
}

fn show_touch_bar(
    mut contexts: EguiContexts,
    mut layout: ResMut<Layout>,
    overlays: Res<Overlays>,
    (free_fall, player, ship): (Res<FreeFall>, Res<JourneyPlayer>, Res<ShipFlight>),
    mut bar: ResMut<TouchBar>,
    mut menu: ResMut<Menu>,
    mut commands: CommandSender,
    mut finger_pushes: ResMut<FingerPushes>,
) -> Result {
    finger_pushes.0 = false;
    if !bar.open {
        return Ok(());
    }
    let at_helm = commands.helm.has_ship() && !overlays.hidden;
    let context = contexts.ctx_mut()?;
    let buttons = if at_helm {
        helm_buttons(&ship)
    } else {
        buttons(&overlays, free_fall.is_moving(), player.is_playing())
    };
    let buttons = match commands.kiosk.is_on() {
        true => for_visitors(buttons, at_helm, &commands.kiosk),
        false => buttons,
    };
    let remark = lack_of_push(&ship).filter(|_| at_helm);
    // Between the panels or, if they leave too little room, over them.
    let mut room = layout.bounds();
    if room.width() < buttons.len() as f32 * (BUTTON.x + GAP) + GAP {
        room = context.content_rect().shrink(MARGIN);
    }
    // egui knows the size after the bar's first frame.
    let size = context
        .memory(|memory| memory.area_rect(NAME))
        .map_or(BUTTON, |shown| shown.size());
    let wish = layout.at(egui::Align2::CENTER_BOTTOM, Slide::Anywhere);
    let place = layout
        .wished(size, wish)
        .unwrap_or_else(|| egui::Align2::CENTER_BOTTOM.anchor_size(room.center_bottom(), size));
    layout.take(NAME, place);
    let mut used = None;
    egui::Area::new(NAME.into())
        .fixed_pos(place.min)
        .order(egui::Order::Foreground)
        .show(context, |ui| {
            ui.set_max_width(room.width());
            text_box(GAP, 8.0).show(ui, |ui| {
                ui.spacing_mut().item_spacing = egui::Vec2::splat(GAP);
                ui.horizontal_wrapped(|ui| {
                    if let Some(remark) = remark {
                        ui.label(egui::RichText::new(remark).size(TEXT));
                    }
                    for (text, does) in buttons {
                        let text = egui::RichText::new(text).size(TEXT);
                        let button = ui.add(egui::Button::new(text).min_size(BUTTON));
                        match does {
                            Use::Push => finger_pushes.0 = button.is_pointer_button_down_on(),
                            _ if button.clicked() => used = Some(does),
                            _ => {}
                        }
                    }
                });
            });
        });
    let Some(used) = used else {
        return Ok(());
    };
    bar.open = at_helm;
    match used {
        Use::Push => {}
        Use::Command(command) => commands.send(command),
        Use::Places => {
            menu.open();
            menu.show_places();
        }
    }
    Ok(())
}
