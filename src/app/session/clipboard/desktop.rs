//! The desktop's clipboard. A thread of its own serves it, because the program has to hold a copied
//! text until another one replaces it, and a text to paste comes only when its owner hands it over.

use bevy::prelude::Resource;
use lightfall_platform::worker::Worker;

enum Order {
    Copy(String),
    Paste,
}

/// The thread that holds the clipboard. It answers with texts to paste, or with what could not be
/// done.
#[derive(Resource)]
pub(crate) struct Clipboard(Worker<Order, Result<String, String>>);

impl Clipboard {
    pub(super) fn start() -> Self {
        let mut clipboard = None;
        Self(Worker::serving_all(move |order, answers| {
            match serve(order, &mut clipboard) {
                Ok(Some(text)) => answers.send(Ok(text)),
                Ok(None) => {}
                Err(arboard::Error::ContentNotAvailable) => {
                    answers.send(Err("There is no text on the clipboard".into()));
                }
                Err(error) => {
                    answers.send(Err(format!("The clipboard cannot be reached: {error}")));
                }
            }
        }))
    }

    /// Puts a text on the clipboard.
    pub(crate) fn copy(&self, text: String) {
        self.0.ask(Order::Copy(text));
    }

    /// Asks for the text on the clipboard.
    pub(super) fn paste(&self) {
        self.0.ask(Order::Paste);
    }

    /// A text to paste, or what could not be done.
    pub(super) fn next_text(&self) -> Option<Result<String, String>> {
        self.0.next_answer()
    }
}

/// Serves one order. Returns the text to paste, if that was asked for.
fn serve(
    order: Order,
    clipboard: &mut Option<arboard::Clipboard>,
) -> Result<Option<String>, arboard::Error> {
    let clipboard = match clipboard {
        Some(clipboard) => clipboard,
        none => none.insert(arboard::Clipboard::new()?),
    };
    match order {
        Order::Copy(text) => clipboard.set_text(text).map(|()| None),
        Order::Paste => clipboard.get_text().map(Some),
    }
}
