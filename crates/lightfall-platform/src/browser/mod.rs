//! What the program asks of the browser that it runs in: storage, downloads, the clipboard, the
//! page's address, and files that the user picks.

mod address;
mod clipboard;
mod file_picker;
mod page_state;
mod pointer;
mod storage;

pub use address::{address_with, parameters, replace_address};
pub use clipboard::{copy, paste};
pub use file_picker::pick_file;
pub use page_state::{State, report, show_state};
pub use pointer::pointer_is_locked;
pub use storage::Storage;

use js_sys::{Array, Uint8Array};
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{Blob, Document, HtmlAnchorElement, Url, Window};

fn window() -> Result<Window, JsValue> {
    web_sys::window().ok_or_else(|| "there is no window".into())
}

fn document() -> Result<Document, JsValue> {
    window()?
        .document()
        .ok_or_else(|| "there is no page".into())
}

/// An element that can be clicked by the program.
fn create<T: JsCast>(tag: &str) -> Result<T, JsValue> {
    Ok(document()?.create_element(tag)?.unchecked_into())
}

/// Hands a file to the browser, which puts it where it puts downloads.
///
/// # Errors
/// The browser's reason.
pub fn download(name: &str, contents: &[u8]) -> Result<(), String> {
    let start = || {
        let parts = Array::of1(&Uint8Array::from(contents));
        let url = Url::create_object_url_with_blob(&Blob::new_with_u8_array_sequence(&parts)?)?;
        let link: HtmlAnchorElement = create("a")?;
        link.set_href(&url);
        link.set_download(name);
        link.click();
        Url::revoke_object_url(&url)
    };
    start().map_err(|error| words(&error))
}

/// An error of the browser in words.
fn words(error: &JsValue) -> String {
    let text = error.as_string();
    text.unwrap_or_else(|| js_sys::Object::from(error.clone()).to_string().into())
}
