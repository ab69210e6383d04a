//! What is drawn over the picture.

pub(crate) mod compass;
pub(crate) mod dock;
pub(crate) mod end_card;
pub(crate) mod glyphs;
pub(crate) mod guides;
pub(crate) mod help;
pub(crate) mod hud;
pub(crate) mod inspector;
pub(crate) mod layout;
pub(crate) mod legend;
pub(crate) mod menu;
pub(crate) mod notice;
pub(crate) mod number;
pub(crate) mod panel;
pub(crate) mod photo_mode;
pub(crate) mod picture_in_window;
pub(crate) mod screen;
pub(crate) mod ship_help;
pub(crate) mod star_names;
pub(crate) mod theme;
pub(crate) mod touch_bar;
