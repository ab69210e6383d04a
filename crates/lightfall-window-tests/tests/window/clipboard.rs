//! The text on the clipboard, read as any other program would read it.

use crate::desktop::Desktop;
use std::time::{Duration, Instant};
use x11rb::connection::Connection;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{AtomEnum, ConnectionExt, CreateWindowAux, WindowClass};

impl Desktop {
    /// The text on the clipboard; none while it holds no text.
    pub fn clipboard(&self) -> Option<String> {
        let connection = &self.connection;
        let atom = |name: &str| {
            connection
                .intern_atom(false, name.as_bytes())
                .unwrap()
                .reply()
                .unwrap()
                .atom
        };
        let [clipboard, text, property] = ["CLIPBOARD", "UTF8_STRING", "LIGHTFALL_TEST"].map(atom);
        let window = connection.generate_id().unwrap();
        let aux = CreateWindowAux::new();
        connection
            .create_window(
                0,
                window,
                self.root,
                0,
                0,
                1,
                1,
                0,
                WindowClass::INPUT_ONLY,
                0,
                &aux,
            )
            .unwrap();
        connection
            .convert_selection(window, clipboard, text, property, x11rb::CURRENT_TIME)
            .unwrap();
        connection.flush().unwrap();
        let start = Instant::now();
        let given = loop {
            match connection.poll_for_event().unwrap() {
                Some(Event::SelectionNotify(notify)) => break notify.property != x11rb::NONE,
                _ if start.elapsed() > Duration::from_secs(5) => break false,
                _ => std::thread::sleep(Duration::from_millis(5)),
            }
        };
        let bytes = given.then(|| {
            let reply = connection
                .get_property(true, window, property, AtomEnum::ANY, 0, 1 << 20)
                .unwrap();
            reply.reply().unwrap().value
        });
        connection.destroy_window(window).unwrap();
        bytes.map(|bytes| String::from_utf8(bytes).unwrap())
    }
}
