//! Which overlays are open over the picture, and how the two side panels share the window.

use bevy::prelude::Resource;

/// Name of the panel at the right, which is its egui area.
pub(crate) const PANEL: &str = "panel";
/// Width of the panel at the right, in points.
pub(crate) const PANEL_WIDTH: f32 = 420.0;
/// Width of the ray inspector at the left, in points.
pub(crate) const INSPECTOR_WIDTH: f32 = 390.0;
/// Minimum width of the picture beside the panels, in points. In narrower windows the panels lie over
/// the picture.
const MIN_PICTURE_WIDTH: f32 = 150.0;

/// A side of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// The ray inspector's.
    Left,
    /// The panel's.
    Right,
}

/// What shows the ship's path ahead.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum PathShown {
    /// The map, and the line in the picture.
    #[default]
    MapAndLine,
    /// The line in the picture.
    Line,
    /// Nothing.
    Nothing,
}

impl PathShown {
    /// What the map's key chooses after this.
    pub(crate) fn next(self) -> Self {
        match self {
            Self::MapAndLine => Self::Line,
            Self::Line => Self::Nothing,
            Self::Nothing => Self::MapAndLine,
        }
    }
}

/// What is open over the picture.
#[derive(Resource, Default)]
pub(crate) struct Overlays {
    pub(crate) help: bool,
    pub(crate) panel: bool,
    pub(crate) inspector: bool,
    pub(crate) guides: bool,
    pub(crate) star_names: bool,
    /// Whether the panel, where it is open, is at its page of settings.
    pub(crate) at_settings: bool,
    /// What shows the ship's path.
    pub(crate) path: PathShown,
    /// Whether every overlay and the status bar are hidden for now.
    pub(crate) hidden: bool,
    /// The side whose panel is covered, in a window too narrow for both.
    covered: Option<Side>,
    /// The side that was opened last.
    last_opened: Option<Side>,
}

impl Overlays {
    /// Width that the inspector takes at the left, in points.
    pub(crate) fn left_width(&self) -> f32 {
        if self.shows_inspector() {
            INSPECTOR_WIDTH
        } else {
            0.0
        }
    }

    /// Width that the panel takes at the right, in points.
    pub(crate) fn right_width(&self) -> f32 {
        if self.shows_panel() { PANEL_WIDTH } else { 0.0 }
    }

    /// The left and the right end of what the panels leave free of a window of this width, in points.
    /// `None` if they leave too little.
    pub(crate) fn free_span(&self, window_width: f32) -> Option<[f32; 2]> {
        let [left, right] = [self.left_width(), window_width - self.right_width()];
        let is_free = self.left_width() + self.right_width() == 0.0;
        (is_free || right - left >= MIN_PICTURE_WIDTH).then_some([left, right])
    }

    pub(crate) fn shows_inspector(&self) -> bool {
        self.inspector && !self.hidden && self.covered != Some(Side::Left)
    }

    pub(crate) fn shows_panel(&self) -> bool {
        self.panel && !self.hidden && self.covered != Some(Side::Right)
    }

    /// Whether something is open that is read while a ship must not fly on: the help, or the settings.
    pub(crate) fn pause_flights(&self) -> bool {
        self.help && !self.hidden || self.at_settings && self.shows_panel()
    }

    pub(crate) fn shows_guides(&self) -> bool {
        self.guides && !self.hidden
    }

    pub(crate) fn shows_star_names(&self) -> bool {
        self.star_names && !self.hidden
    }

    /// Opens or closes an overlay. While everything is hidden, it is opened.
    pub(crate) fn toggle(&mut self, overlay: fn(&mut Self) -> &mut bool) {
        let is_open = !*overlay(self) || self.hidden;
        *overlay(self) = is_open;
        self.hidden &= !is_open;
    }

    /// Opens or closes the panel of a side. While everything is hidden, or while the other panel
    /// covers this one, it is brought to the front instead.
    pub(crate) fn toggle_side(&mut self, side: Side) {
        let (hidden, covered) = (self.hidden, self.covered == Some(side));
        let panel = match side {
            Side::Left => &mut self.inspector,
            Side::Right => &mut self.panel,
        };
        if hidden || !covered {
            *panel = !*panel || hidden;
        }
        if *panel {
            self.hidden = false;
            self.last_opened = Some(side);
        }
    }

    /// Closes the side panel that was opened last. Returns whether one was open.
    pub(crate) fn close_side(&mut self) -> bool {
        let side = match (self.inspector, self.panel) {
            (false, false) => return false,
            (true, true) => self.last_opened,
            (true, false) => Some(Side::Left),
            (false, true) => Some(Side::Right),
        };
        match side {
            Some(Side::Left) => self.inspector = false,
            _ => self.panel = false,
        }
        true
    }

    /// Opens or closes the panel of a side. One that is opened comes to the front.
    pub(crate) fn show_side(&mut self, side: Side, is_open: bool) {
        let panel = match side {
            Side::Left => &mut self.inspector,
            Side::Right => &mut self.panel,
        };
        if is_open && !*panel {
            self.last_opened = Some(side);
        }
        *panel = is_open;
    }

    /// Opens the panel, if it is not open.
    pub(crate) fn open_panel(&mut self) {
        (self.panel, self.hidden) = (true, false);
        self.last_opened = Some(Side::Right);
    }

    /// Gives the picture to a flight that begins with words of its own: closes the ray inspector, and ends
    /// the photo mode.
    pub(crate) fn clear_picture(&mut self) {
        (self.inspector, self.hidden) = (false, false);
    }

    /// Shares a window of this width, in points: where both panels are open and do not fit beside the
    /// picture, the one that was opened last covers the other.
    pub(crate) fn share(&mut self, window_width: f32) {
        let narrow = window_width < PANEL_WIDTH + INSPECTOR_WIDTH + MIN_PICTURE_WIDTH;
        let other = if self.last_opened == Some(Side::Left) {
            Side::Right
        } else {
            Side::Left
        };
        self.covered = Some(other).filter(|_| self.panel && self.inspector && narrow);
    }
}
