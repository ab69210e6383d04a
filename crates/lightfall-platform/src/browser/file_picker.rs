//! Files that the user picks.

use js_sys::Uint8Array;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{File, HtmlInputElement};

/// Lets the user pick a file of these kinds, and hands its name and contents to `done`, or nothing
/// if the user picks none.
///
/// # Errors
/// The browser shows no dialog.
pub fn pick_file(
    kinds: &str,
    done: impl FnOnce(Option<(String, Vec<u8>)>) + 'static,
) -> Result<(), String> {
    let open = || -> Result<(), JsValue> {
        let input: HtmlInputElement = super::create("input")?;
        input.set_type("file");
        input.set_accept(kinds);
        let source = input.clone();
        let picked = Closure::once_into_js(move || {
            let file = source.files().and_then(|files| files.get(0));
            spawn_local(async move { done(read(file).await) });
        });
        let picked = picked.unchecked_into();
        input.set_onchange(Some(&picked));
        input.set_oncancel(Some(&picked));
        input.click();
        Ok(())
    };
    open().map_err(|error| super::words(&error))
}

async fn read(file: Option<File>) -> Option<(String, Vec<u8>)> {
    let file = file?;
    let contents = JsFuture::from(file.array_buffer()).await.ok()?;
    Some((file.name(), Uint8Array::new(&contents).to_vec()))
}
