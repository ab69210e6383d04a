//! Counts the frames that a window shows, so that a test waits for frames and not for a time in
//! which a busy machine may have drawn none. The X server reports what is drawn (its extension
//! DAMAGE, protocol 1.1).

use std::cell::Cell;
use std::io::IoSlice;
use x11rb::connection::{Connection, RequestConnection};
use x11rb::protocol::Event;
use x11rb::rust_connection::RustConnection;

/// The count, on a connection of its own.
pub struct Frames {
    connection: RustConnection,
    notify: u8,
    shown: Cell<usize>,
}

impl Frames {
    /// Counts from now on. The requests are written out, for x11rb has this extension only under a
    /// feature that would have half of the program's crates compiled once more.
    pub fn of(display: &str, window: u32) -> Self {
        let (connection, _) = x11rb::connect(Some(display)).unwrap();
        let extension = connection
            .extension_information("DAMAGE")
            .unwrap()
            .expect("Xvfb has DAMAGE");
        let request = |minor: u8, fields: [u32; 3], count: usize| {
            let mut bytes = vec![extension.major_opcode, minor];
            bytes.extend_from_slice(&(1 + count as u16).to_ne_bytes());
            bytes.extend(fields[..count].iter().flat_map(|field| field.to_ne_bytes()));
            bytes
        };
        const QUERY_VERSION: u8 = 0;
        const CREATE: u8 = 1;
        const RAW_RECTANGLES: u32 = 0;
        let version = request(QUERY_VERSION, [1, 1, 0], 2);
        let answer = connection
            .send_request_with_reply::<u8>(&[IoSlice::new(&version)], vec![])
            .unwrap();
        answer.reply().unwrap();
        let damage = connection.generate_id().unwrap();
        let create = request(CREATE, [damage, window, RAW_RECTANGLES], 3);
        connection
            .send_request_without_reply(&[IoSlice::new(&create)], vec![])
            .unwrap()
            .check()
            .unwrap();
        Self {
            connection,
            notify: extension.first_event,
            shown: Cell::new(0),
        }
    }

    /// Frames shown so far. A frame may come in strips; the one at the top counts.
    pub fn shown(&self) -> usize {
        while let Some(event) = self.connection.poll_for_event().unwrap() {
            if let Event::Unknown(bytes) = event
                && bytes[0] & 0x7f == self.notify
                && bytes[18..20] == [0, 0]
            {
                self.shown.set(self.shown.get() + 1);
            }
        }
        self.shown.get()
    }
}
