//! The captions of a journey: sentences that appear at their time and stay for some seconds.

use super::error::Fault;
use super::format::{CAPTION_SECONDS, MAX_CAPTION_CHARS, MAX_CAPTIONS};
use super::load::{noted, without};
use crate::scene::from_toml::{float, given};
use crate::scene::value::shortened;
use toml::Table;

/// A sentence about what is seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Caption {
    /// When it appears, in seconds after the journey's beginning.
    pub time: f64,
    /// The same as its file says it, on the clock of the keyframes.
    pub(super) at: f64,
    /// How long it stays, in seconds, unless the next caption appears before.
    pub seconds: f64,
    /// The sentence, on one line.
    pub text: String,
}

/// Reads the captions of a journey whose keyframes last from `span[0]` to `span[1]` seconds.
pub(super) fn read_captions(
    tables: Vec<Table>,
    span: [f64; 2],
) -> Result<Vec<Caption>, Vec<Fault>> {
    if tables.len() > MAX_CAPTIONS {
        let count = tables.len();
        return Err(vec![Fault::CaptionCount { count }]);
    }
    let mut faults = Vec::new();
    let mut captions: Vec<Caption> = Vec::with_capacity(tables.len());
    for (index, table) in tables.into_iter().enumerate() {
        let before = captions.last().map(|last| last.at);
        captions.extend(noted(read(index + 1, table, before, span), &mut faults));
    }
    without(faults, captions)
}

/// Reads the caption of this number, counted from 1, after one at the time `before`.
fn read(
    number: usize,
    mut table: Table,
    before: Option<f64>,
    [start, end]: [f64; 2],
) -> Result<Caption, Fault> {
    let refused = |key, value: Option<&toml::Value>, allowed: String| Fault::Value {
        table: "caption",
        number,
        key,
        given: value.map(given),
        allowed,
    };
    let [time, seconds, text] = ["time", "seconds", "text"].map(|key| table.remove(key));
    if let Some(key) = table.keys().next() {
        let key = shortened(key);
        return Err(Fault::CaptionKey { number, key });
    }
    let appears = time
        .as_ref()
        .and_then(float)
        .filter(|time| (start..=end).contains(time))
        .ok_or_else(|| {
            let allowed = format!("a number of seconds from {start} to {end}, within the journey");
            refused("time", time.as_ref(), allowed)
        })?;
    if let Some(last) = before.filter(|last| appears <= *last) {
        let allowed = format!("above {last}, the time of the caption before");
        return Err(refused("time", time.as_ref(), allowed));
    }
    let stays = match &seconds {
        None => CAPTION_SECONDS,
        Some(value) => float(value)
            .filter(|seconds| (1.0..=60.0).contains(seconds))
            .ok_or_else(|| {
                let allowed = "a number of seconds from 1 to 60".into();
                refused("seconds", Some(value), allowed)
            })?,
    };
    let line = text
        .as_ref()
        .and_then(line)
        .ok_or_else(|| refused("text", text.as_ref(), allowed_line()))?;
    Ok(Caption {
        time: appears - start,
        at: appears,
        seconds: stays,
        text: line,
    })
}

/// The line of text that a caption or a journey's ending may be.
pub(super) fn line(value: &toml::Value) -> Option<String> {
    let text = value.as_str()?.trim();
    let fits = !text.is_empty()
        && text.chars().count() <= MAX_CAPTION_CHARS
        && !text.chars().any(char::is_control);
    fits.then(|| text.to_owned())
}

/// What [`line`] accepts, in words.
pub(super) fn allowed_line() -> String {
    format!("one line of text, from 1 to {MAX_CAPTION_CHARS} characters long")
}
