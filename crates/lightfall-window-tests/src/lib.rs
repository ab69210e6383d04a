//! What a test of the window and the watched program tell each other: the program writes down its
//! [`State`] after every frame, and the test gives [`Order`]s, one in a line of standard input.

mod order;
mod state;

pub use order::{Order, Pad, Stroke};
pub use state::{Answer, Place, ShipState, State, Text, fields_of};

/// The variable that names the file for the state. Without it the program is not watched.
pub const STATE_FILE: &str = "LIGHTFALL_STATE_FILE";

/// The argument that makes the program hold the clipboard with the text after it, in place of
/// opening a window.
pub const HOLD_CLIPBOARD: &str = "hold-clipboard";
