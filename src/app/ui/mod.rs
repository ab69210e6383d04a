//! What is drawn over the picture.

pub(crate) mod dock;
pub(crate) mod end_card;
pub(crate) mod help;
pub(crate) mod inspector;
pub(crate) mod legend;
pub(crate) mod number;
pub(crate) mod panel;
pub(crate) mod status_bar;
pub(crate) mod theme;
