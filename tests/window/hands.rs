//! What a user's hands do: keys and the mouse, by xdotool.

use crate::desktop::{Desktop, FRAMES};
use std::time::Duration;

impl Desktop {
    /// Moves the pointer to a place of the window.
    pub fn point(&self, x: i32, y: i32) {
        self.xdotool(&["mousemove", &x.to_string(), &y.to_string()]);
    }

    /// Clicks with the left button at a place of the window. The program sees the pointer before it
    /// sees the button, as from a hand, and what the click leads to before anything else comes.
    pub fn click(&self, [x, y]: [i32; 2]) {
        self.point(x, y);
        self.frames(FRAMES);
        self.xdotool(&["click", "1"]);
        self.frames(FRAMES);
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

    /// Presses and lets go of a key, named as X names it.
    pub fn press(&self, key: &str) {
        self.xdotool(&["key", "--delay", "60", key]);
    }

    /// Presses a key while another one is held: the program has frames in which both are.
    pub fn chord(&self, held: &str, key: &str) {
        self.xdotool(&["keydown", held]);
        self.frames(FRAMES);
        self.xdotool(&["key", key]);
        self.frames(FRAMES);
        self.xdotool(&["keyup", held]);
        self.frames(FRAMES);
    }

    /// Holds a key down for a while.
    pub fn hold(&self, key: &str, time: Duration) {
        self.xdotool(&["keydown", key]);
        std::thread::sleep(time);
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
