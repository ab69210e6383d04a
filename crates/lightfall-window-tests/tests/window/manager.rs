//! What happens to a window from outside: the window manager, the monitor, a machine that sleeps.

use crate::desktop::Desktop;
use std::process::Command;
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{
    AtomEnum, ConnectionExt, EventMask, PROPERTY_NOTIFY_EVENT, PropMode, Property,
    PropertyNotifyEvent,
};
use x11rb::wrapper::ConnectionExt as _;

impl Desktop {
    /// Gives it another size, in pixels.
    pub fn resize(&self, width: i32, height: i32) {
        self.xdotool(&[
            "windowsize",
            &self.window,
            &width.to_string(),
            &height.to_string(),
        ]);
    }

    /// Takes the window from the screen, or puts it back.
    pub fn minimise(&self, away: bool) {
        self.xdotool(&[
            if away { "windowunmap" } else { "windowmap" },
            "--sync",
            &self.window,
        ]);
        if !away {
            self.xdotool(&["windowfocus", "--sync", &self.window]);
        }
    }

    /// Sends the program to sleep, as a machine that is suspended does, or wakes it up.
    pub fn suspend(&self, asleep: bool) {
        let signal = if asleep { "-STOP" } else { "-CONT" };
        let command = format!("kill {signal} {}", self.program.id());
        let sent = Command::new("sh").args(["-c", &command]).status().unwrap();
        assert!(sent.success());
    }

    /// Tells the program how many points an inch of its monitor has, as desktops do when it comes
    /// to be another one.
    pub fn dots_per_inch(&self, dpi: u32) {
        let (connection, text) = (&self.connection, format!("Xft.dpi:\t{dpi}\n"));
        let (atom, window) = (
            AtomEnum::RESOURCE_MANAGER.into(),
            self.window.parse().unwrap(),
        );
        connection
            .change_property8(
                PropMode::REPLACE,
                self.root,
                atom,
                AtomEnum::STRING,
                text.as_bytes(),
            )
            .unwrap();
        let changed = PropertyNotifyEvent {
            response_type: PROPERTY_NOTIFY_EVENT,
            sequence: 0,
            window,
            atom,
            time: x11rb::CURRENT_TIME,
            state: Property::NEW_VALUE,
        };
        connection
            .send_event(false, window, EventMask::PROPERTY_CHANGE, changed)
            .unwrap();
        connection.flush().unwrap();
    }

    /// Size of the window, in pixels.
    pub fn size(&self) -> (usize, usize) {
        let window = self.window.parse().unwrap();
        let geometry = self
            .connection
            .get_geometry(window)
            .unwrap()
            .reply()
            .unwrap();
        (geometry.width.into(), geometry.height.into())
    }
}
