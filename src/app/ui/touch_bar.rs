//! The bar that a tap on the picture opens, for hands without a keyboard. It goes away when one of its
//! buttons is used or the picture is tapped again.

use crate::app::controls::control::AppCommand;
use crate::app::input::touch::{Fingers, read_fingers};
use crate::app::motion::free_fall::FreeFall;
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::state::menu::Menu;
use crate::app::state::overlays::Overlays;
use crate::app::ui::screen::{MARGIN, free_room, text_box};
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// Smallest size of a button, in points: that of a finger.
const BUTTON: egui::Vec2 = egui::vec2(56.0, 44.0);
/// Size of its text, in points.
const TEXT: f32 = 15.0;
/// Room between buttons and around them, in points.
const GAP: f32 = 6.0;

/// Whether the bar is shown.
#[derive(Resource, Default)]
pub(crate) struct TouchBar {
    open: bool,
}

impl TouchBar {
    pub(crate) fn is_open(&self) -> bool {
        self.open
    }
}

/// What a button does.
#[derive(Clone, Copy)]
enum Use {
    Command(AppCommand),
    /// Open the menu at its list of places.
    Places,
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<TouchBar>()
        .add_systems(Update, open_touch_bar.after(read_fingers))
        .add_systems(EguiPrimaryContextPass, show_touch_bar);
}

/// Opens the bar where the picture is tapped, and closes it where it is tapped again. While the ray
/// inspector is open, a tap chooses a pixel.
fn open_touch_bar(
    fingers: Res<Fingers>,
    overlays: Res<Overlays>,
    menu: Res<Menu>,
    mut bar: ResMut<TouchBar>,
) {
    if fingers.tap.is_some() && (bar.open || !overlays.shows_inspector()) {
        bar.open = !bar.open;
    }
    if bar.open && menu.is_open() {
        bar.open = false;
    }
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
        (if falls { "Hold" } else { "Fall" }, Use::Command(LetGo)),
        (
            if travels { "Stop" } else { "Journey" },
            Use::Command(Journey),
        ),
        ("Photo", Use::Command(Hide)),
    ]
}

fn show_touch_bar(
    mut contexts: EguiContexts,
    overlays: Res<Overlays>,
    (free_fall, player): (Res<FreeFall>, Res<JourneyPlayer>),
    mut bar: ResMut<TouchBar>,
    mut menu: ResMut<Menu>,
    mut commands: MessageWriter<AppCommand>,
) -> Result {
    if !bar.open {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let buttons = buttons(&overlays, free_fall.is_moving(), player.is_playing());
    let mut room = free_room(context, &overlays);
    // Between the panels or, if they leave too little room, over them.
    if room.width() < buttons.len() as f32 * (BUTTON.x + GAP) + GAP {
        room = context.content_rect().shrink(MARGIN);
    }
    let mut used = None;
    egui::Area::new("touch bar".into())
        .pivot(egui::Align2::CENTER_BOTTOM)
        .fixed_pos(room.center_bottom())
        .order(egui::Order::Foreground)
        .show(context, |ui| {
            ui.set_max_width(room.width());
            text_box(GAP, 8.0).show(ui, |ui| {
                ui.spacing_mut().item_spacing = egui::Vec2::splat(GAP);
                ui.horizontal_wrapped(|ui| {
                    for (text, does) in buttons {
                        let text = egui::RichText::new(text).size(TEXT);
                        if ui.add(egui::Button::new(text).min_size(BUTTON)).clicked() {
                            used = Some(does);
                        }
                    }
                });
            });
        });
    let Some(used) = used else {
        return Ok(());
    };
    bar.open = false;
    match used {
        Use::Command(command) => {
            commands.write(command);
        }
        Use::Places => {
            menu.open();
            menu.show_places();
        }
    }
    Ok(())
}
