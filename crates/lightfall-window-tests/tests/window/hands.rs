//! What a user's hands do: keys and the mouse, by xdotool.

use crate::desktop::Desktop;
use watched::State;

/// Frames within which the program has seen the pointer, and what a click leads to is shown.
const FRAMES: u32 = 4;

impl Desktop {
    /// Moves the pointer to a place of the window.
    pub fn point(&self, x: i32, y: i32) {
        self.xdotool(&["mousemove", &x.to_string(), &y.to_string()]);
    }

    /// Clicks with the left button at a place of the picture. The program sees the pointer before it
    /// sees the button, as from a hand, and what the click leads to before anything else comes.
    #[track_caller]
    pub fn click_at(&self, [x, y]: [i32; 2]) {
        self.point(x, y);
        self.later(FRAMES);
        self.xdotool(&["click", "1"]);
        self.later(FRAMES);
    }

    /// Clicks on the text that begins so, once it is there and stands still.
    #[track_caller]
    pub fn click(&self, text: &str) {
        self.click_where(text, |state| state.place_of(text));
    }

    /// Clicks into the field with this label, once it is there and stands still.
    #[track_caller]
    pub fn click_field(&self, label: &str) {
        self.click_where(label, |state| state.field_of(label));
    }

    /// Clicks at a place once it is there and stands still: a section that folds moves what is below.
    #[track_caller]
    fn click_where(&self, what: &str, place: impl Fn(&State) -> Option<[f32; 2]>) {
        let mut last = None;
        loop {
            let now = place(&self.wait_for(what, |state| place(state).is_some()));
            if now == last {
                break;
            }
            last = now;
            self.later(FRAMES);
        }
        self.click_at(last.unwrap().map(|at| at as i32));
    }

    /// Clicks, and does not wait for the program.
    pub fn click_at_once(&self, x: i32, y: i32) {
        self.point(x, y);
        self.xdotool(&["click", "1"]);
    }

    /// Types a text.
    pub fn type_text(&self, text: &str) {
        self.xdotool(&["type", "--delay", "60", text]);
    }

    /// Presses and lets go of a key, and does not wait for the program.
    pub fn press_at_once(&self, key: &str) {
        self.xdotool(&["key", "--delay", "60", key]);
    }

    /// Presses a key while another one is held: the program has frames in which both are.
    #[track_caller]
    pub fn chord(&self, held: &str, key: &str) {
        self.hold(held);
        self.press(key);
        self.let_go(held);
        self.later(FRAMES);
    }

    /// Presses a key, and waits until the program has seen it.
    #[track_caller]
    pub fn hold(&self, key: &str) {
        let before = self.state().keys;
        self.xdotool(&["keydown", key]);
        self.wait_for(key, |state| state.keys > before);
    }

    /// Lets go of a key.
    pub fn let_go(&self, key: &str) {
        self.xdotool(&["keyup", key]);
    }

    pub fn look(&self, right: i32, down: i32) {
        self.xdotool(&[
            "mousemove_relative",
            "--",
            &right.to_string(),
            &down.to_string(),
        ]);
    }

    /// Turns the mouse wheel away from the hand by one notch.
    pub fn wheel(&self) {
        self.xdotool(&["click", "4"]);
    }
}
