//! The order in which places are given, and what is taken before anything has one.

use super::{HOLE, Layout};
use crate::app::state::hole_in_view::HoleInView;
use crate::app::state::menu::Menu;
use crate::app::state::overlays::Overlays;
use crate::app::ui::help::HELP;
use crate::app::ui::menu::menu_frame;
use crate::app::ui::picture_in_window::PictureInWindow;
use crate::app::ui::screen::MARGIN;
use bevy::prelude::*;
use bevy_egui::egui::{self, Rect};
use bevy_egui::{EguiContexts, EguiPrimaryContextPass};

/// Maximum size of the part of the hole that is kept free, as a share of the free part of the window. A
/// larger hole leaves room for texts at the edges.
const MAX_HOLE: f32 = 0.5;

/// The order in which places are given.
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Importance {
    /// Finds the free part of the window.
    Room,
    /// The buttons for fingers.
    TouchBar,
    /// The read-outs or, at the ship's controls, its instruments and its map. They come before every text
    /// that comes and goes, so that none moves them.
    Instruments,
    /// The card at the end of a flight, and notices.
    Cards,
    /// A journey's words.
    Words,
    Message,
    /// What is switched off.
    Warning,
    /// What the sides of a comparison are.
    Sides,
    Legend,
    /// The map beside the card at the end of a mission.
    Map,
    /// The arrow to the hole, or its ring.
    Compass,
    Title,
    Guides,
    KeyHints,
    StarNames,
}

pub(crate) fn plugin(app: &mut App) {
    use Importance::{
        Cards, Compass, Guides, Instruments, KeyHints, Legend, Map, Message, Room, Sides,
        StarNames, Title, TouchBar, Warning, Words,
    };
    let order = (
        (
            Room,
            TouchBar,
            Instruments,
            Cards,
            Words,
            Message,
            Warning,
            Sides,
        )
            .chain(),
        (Legend, Map, Compass, Title, Guides, KeyHints, StarNames).chain(),
    );
    app.init_resource::<Layout>()
        .configure_sets(EguiPrimaryContextPass, order.chain())
        .add_systems(EguiPrimaryContextPass, begin_layout.in_set(Room));
}

/// Begins a frame's layout: the panels, the help, the menu and the middle of the hole are taken.
fn begin_layout(
    mut contexts: EguiContexts,
    (overlays, menu): (Res<Overlays>, Res<Menu>),
    hole: Res<HoleInView>,
    picture: PictureInWindow,
    mut layout: ResMut<Layout>,
) -> Result {
    let context = contexts.ctx_mut()?;
    let screen = context.content_rect();
    let bounds = overlays
        .free_span(screen.width())
        .map_or(Rect::NOTHING, |[left, right]| {
            Rect::from_x_y_ranges(left..=right, screen.y_range()).shrink(MARGIN)
        });
    *layout = Layout::within(bounds);
    if menu.is_open() {
        layout.take("menu", menu_frame(screen, &menu));
    }
    let help = context.memory(|memory| memory.area_rect(egui::Id::new(HELP)));
    if let Some(help) = help.filter(|_| overlays.help && !overlays.hidden) {
        layout.take("help", help);
    }
    let middle = Rect::from_center_size(bounds.center(), MAX_HOLE * bounds.size());
    let holes = hole.0.map(|hole| picture.holes(context, &hole));
    for hole in holes.unwrap_or_default() {
        let kept = hole.intersect(middle);
        if kept.is_positive() {
            layout.take(HOLE, kept);
        }
    }
    Ok(())
}
