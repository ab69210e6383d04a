//! The page's address, whose parameters carry a scene.

use js_sys::Array;
use wasm_bindgen::JsValue;
use web_sys::UrlSearchParams;

/// The parameters of the page's address, in their order.
#[must_use]
pub fn parameters() -> Vec<(String, String)> {
    let read = || -> Result<Vec<_>, JsValue> {
        let search = super::window()?.location().search()?;
        let entries = UrlSearchParams::new_with_str(&search)?.entries();
        let pairs = entries.into_iter().map(|entry| {
            let pair = Array::from(&entry?);
            let text = |index| pair.get(index).as_string().unwrap_or_default();
            Ok((text(0), text(1)))
        });
        pairs.collect()
    };
    read().unwrap_or_default()
}

/// The page's address with other parameters.
///
/// # Errors
/// The browser's reason.
pub fn address_with(parameters: &[(String, String)]) -> Result<String, String> {
    let write = || -> Result<String, JsValue> {
        let location = super::window()?.location();
        let list = UrlSearchParams::new()?;
        for (key, value) in parameters {
            list.append(key, value);
        }
        let page = location.origin()? + &location.pathname()?;
        let query = String::from(list.to_string());
        Ok(if query.is_empty() {
            page
        } else {
            format!("{page}?{query}")
        })
    };
    write().map_err(|error| super::words(&error))
}

/// Shows another address of the same page, without loading it.
///
/// # Errors
/// The browser's reason: some allow few changes in a short time.
pub fn replace_address(address: &str) -> Result<(), String> {
    let replace = || {
        let history = super::window()?.history()?;
        history.replace_state_with_url(&JsValue::NULL, "", Some(address))
    };
    replace().map_err(|error: JsValue| super::words(&error))
}
