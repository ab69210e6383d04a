//! The clipboard, which the browser reads and writes in its own time.

use wasm_bindgen::JsValue;
use wasm_bindgen_futures::{JsFuture, spawn_local};

/// Puts a text on the clipboard, then tells `done` of a failure.
pub fn copy(text: String, done: impl FnOnce(Result<(), String>) + 'static) {
    spawn_local(async move {
        let copied = async {
            let clipboard = super::window()?.navigator().clipboard();
            JsFuture::from(clipboard.write_text(&text)).await
        };
        let copied: Result<_, JsValue> = copied.await;
        done(copied.map(drop).map_err(|error| super::words(&error)));
    });
}

/// Hands the text on the clipboard to `done`. The browser may ask the user first.
pub fn paste(done: impl FnOnce(Result<String, String>) + 'static) {
    spawn_local(async move {
        let pasted = async {
            let clipboard = super::window()?.navigator().clipboard();
            JsFuture::from(clipboard.read_text()).await
        };
        let pasted: Result<_, JsValue> = pasted.await;
        let text = pasted.map(|text| text.as_string().unwrap_or_default());
        done(text.map_err(|error| super::words(&error)));
    });
}
