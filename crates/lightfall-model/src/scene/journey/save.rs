//! From a journey to its text, which `load` reads back as the same journey.

use super::ease::Ease;
use super::keyframe::{Keyframe, Values};
use super::read_stop::TWO_PICTURES;
use super::stop::{InspectorView, SideBySide};
use super::{Caption, Journey, Stop};
use crate::scene::presets::Preset;
use crate::scene::{Question, SCHEMA, Value};
use toml::Value as Toml;

/// What the text of a journey says.
pub(super) struct Said<'a> {
    pub(super) title: &'a str,
    pub(super) teaches: &'a str,
    pub(super) ending: &'a str,
    pub(super) preset: Option<&'static Preset>,
    pub(super) keyframes: &'a [Keyframe],
    pub(super) captions: &'a [Caption],
    pub(super) stops: &'a [Stop],
}

impl Journey {
    /// The journey as TOML: keyframes, captions and stops in the order of their times.
    pub fn to_toml(&self) -> String {
        Said {
            title: &self.title,
            teaches: &self.teaches,
            ending: &self.ending,
            preset: self.preset,
            keyframes: &self.keyframes,
            captions: &self.captions,
            stops: &self.stops,
        }
        .to_toml()
    }
}

impl Said<'_> {
    pub(super) fn to_toml(&self) -> String {
        let mut text = format!("schema = {SCHEMA}\n");
        let texts = [
            ("title", self.title),
            ("teaches", self.teaches),
            ("ending", self.ending),
        ];
        for (key, line) in texts.into_iter().filter(|(_, line)| !line.is_empty()) {
            text += &pair(key, line.to_owned());
        }
        if let Some(preset) = self.preset {
            text += &pair("preset", preset.name.to_owned());
        }
        let frames = self.keyframes.iter();
        let frames = frames.map(|frame| (frame.time, keyframe_text(frame)));
        let captions = self.captions.iter();
        let captions = captions.map(|caption| (caption.at, caption_text(caption)));
        let stops = self.stops.iter().map(|stop| (stop.at, stop_text(stop)));
        let mut tables: Vec<(f64, String)> = frames.chain(captions).chain(stops).collect();
        // Of the same time, a keyframe comes first and a stop last.
        tables.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        tables
            .into_iter()
            .fold(text, |text, (_, table)| text + "\n" + &table)
    }
}

/// A line `key = value`.
fn pair(key: &str, value: impl Into<Toml>) -> String {
    format!("{key} = {}\n", value.into())
}

fn keyframe_text(frame: &Keyframe) -> String {
    let values = |prefix: &str, values: &Values| -> String {
        let lines = values.iter();
        lines
            .map(|(name, value)| pair(&format!("{prefix}{name}"), value.clone()))
            .collect()
    };
    let time = pair("time", frame.time);
    let ease = match frame.ease {
        Ease::Smooth => String::new(),
        ease => pair("ease", ease.word()),
    };
    let set = values("set.", &frame.set);
    let in_rain = values("rain.", &frame.in_rain);
    format!(
        "[[keyframe]]\n{time}{ease}{}{set}{in_rain}",
        values("", &frame.values)
    )
}

fn caption_text(caption: &Caption) -> String {
    let [time, seconds] = [("time", caption.at), ("seconds", caption.seconds)];
    let [time, seconds] = [time, seconds].map(|(key, value)| pair(key, value));
    let text = pair("text", caption.text.clone());
    format!("[[caption]]\n{time}{seconds}{text}")
}

fn stop_text(stop: &Stop) -> String {
    let mut text = format!("[[stop]]\n{}", pair("at", stop.at));
    text += &pair("caption", stop.caption.clone());
    for (key, value) in &stop.fields {
        text += &pair(key, Value::clone(value));
    }
    if let Some(on) = stop.guides {
        text += &pair("guides", on);
    }
    if let Some(compares) = stop.side_by_side {
        let value: Toml = match compares {
            SideBySide::Off => false.into(),
            SideBySide::Divided => true.into(),
            SideBySide::TwoPictures => TWO_PICTURES.into(),
        };
        text += &pair("side_by_side", value);
    }
    if let Some(inspected) = stop.inspector {
        text += &pair("inspector", inspector_value(inspected));
    }
    if let Some(question) = &stop.question {
        text += &question_text(question);
    }
    text
}

fn inspector_value(inspected: InspectorView) -> Toml {
    let table = |key: &str, numbers: &[f64]| {
        let numbers = numbers.iter().copied().map(Toml::Float);
        Toml::Table(
            [(key.to_owned(), Toml::Array(numbers.collect()))]
                .into_iter()
                .collect(),
        )
    };
    match inspected {
        InspectorView::Closed => Toml::Boolean(false),
        InspectorView::Open => Toml::Boolean(true),
        InspectorView::Place(place) => table("at", &place),
        InspectorView::Toward(direction) => table("toward", &direction),
    }
}

fn question_text(question: &Question) -> String {
    let optional = |key: &str, text: &String| match text.as_str() {
        "" => String::new(),
        _ => pair(key, text.clone()),
    };
    [
        pair("question.text", question.text.clone()),
        pair("question.answer", question.answer),
        pair("question.tolerance", question.tolerance),
        optional("question.unit", &question.unit),
        optional("question.hint", &question.hint),
    ]
    .concat()
}
