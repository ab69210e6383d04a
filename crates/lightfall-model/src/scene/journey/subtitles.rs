//! What a journey says, as subtitles of the video that its numbered pictures make.

use super::Journey;
use std::fmt::Write;

/// Characters that a reader takes in within a second.
const CHARACTERS_PER_SECOND: f64 = 15.0;
/// How long the words of a stop stay at least, in seconds.
const MIN_STOP_SECONDS: f64 = 2.0;

/// Rounding of times: a caption that appears in a frame, to this share of one, is seen in it.
const ROUNDING: f64 = 1e-6;

/// Does not break a line and is not seen. Between two characters it keeps them from being taken for a mark.
const WORD_JOINER: char = '\u{2060}';

crate::words! {
    /// The format of a file of subtitles.
    pub enum SubtitleFormat {
        /// SubRip, which most players and video programs read.
        Srt = "srt",
        /// WebVTT, which browsers read.
        WebVtt = "vtt",
    }
}

/// The subtitles of a journey: one after the other, none at the same time as another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Subtitles {
    cues: Vec<Cue>,
}

/// Words and when they are shown, in milliseconds after the beginning.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Cue {
    start: u64,
    end: u64,
    /// One line or several, none of them empty.
    text: String,
}

impl Journey {
    /// The captions of the journey and of its stops as subtitles. With `fps` they change with the pictures
    /// of a video of so many a second, from the first one that shows a caption's time. `words` makes the
    /// words that are read of a text.
    ///
    /// The next subtitle takes the place of one that is still shown; those of the same time become one. A
    /// stop's words stay as long as reading them takes, because a video does not wait.
    #[must_use]
    pub fn subtitles(&self, fps: Option<f64>, words: impl Fn(&str) -> String) -> Subtitles {
        let captions = self.captions.iter();
        let captions = captions.map(|caption| (caption.time, caption.seconds, &caption.text));
        let stops = self.stops.iter();
        let stops = stops.map(|stop| {
            let characters = stop.caption.chars().count() as f64;
            let seconds = (characters / CHARACTERS_PER_SECOND).max(MIN_STOP_SECONDS);
            (stop.time, seconds, &stop.caption)
        });
        let mut said: Vec<(f64, f64, &String)> = captions.chain(stops).collect();
        // The sort is stable: of the same time, a caption comes before a stop.
        said.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
        let per_second = fps.unwrap_or(1000.0);
        let tick = |seconds: f64| (seconds * per_second - ROUNDING).ceil().max(0.0) as u64;
        let mut cues: Vec<Cue> = Vec::new();
        for (time, seconds, text) in said {
            let text = without_empty_lines(&words(text));
            if text.is_empty() {
                continue;
            }
            let (start, end) = (tick(time), tick(time + seconds));
            match cues.last_mut() {
                Some(last) if last.start == start => {
                    last.text = format!("{}\n{text}", last.text);
                    last.end = last.end.max(end);
                    continue;
                }
                Some(last) => last.end = last.end.min(start),
                None => {}
            }
            let end = end.max(start + 1);
            cues.push(Cue { start, end, text });
        }
        // A tick lasts a millisecond at least, so different ticks stay different.
        let milliseconds = |tick: u64| (tick as f64 * 1000.0 / per_second).round() as u64;
        for cue in &mut cues {
            (cue.start, cue.end) = (milliseconds(cue.start), milliseconds(cue.end));
        }
        Subtitles { cues }
    }
}

impl Subtitles {
    /// The number of subtitles.
    #[must_use]
    pub fn len(&self) -> usize {
        self.cues.len()
    }

    /// Whether nothing is said.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.cues.is_empty()
    }

    /// The text of the file, in UTF-8.
    #[must_use]
    pub fn to_text(&self, format: SubtitleFormat) -> String {
        let mut file = match format {
            SubtitleFormat::Srt => String::new(),
            SubtitleFormat::WebVtt => "WEBVTT\n\n".into(),
        };
        for (index, cue) in self.cues.iter().enumerate() {
            let [start, end] = [cue.start, cue.end].map(|time| clock(time, format));
            let text = escaped(&cue.text, format);
            // Writing to a string cannot fail.
            let _ = write!(file, "{}\n{start} --> {end}\n{text}\n\n", index + 1);
        }
        file
    }
}

/// An empty line would end a subtitle.
fn without_empty_lines(text: &str) -> String {
    let lines = text.lines().map(str::trim_end);
    let lines: Vec<&str> = lines.filter(|line| !line.trim().is_empty()).collect();
    lines.join("\n")
}

/// A time as `HH:MM:SS,mmm`, in WebVTT with a point.
fn clock(milliseconds: u64, format: SubtitleFormat) -> String {
    let (seconds, rest) = (milliseconds / 1000, milliseconds % 1000);
    let (minutes, seconds) = (seconds / 60, seconds % 60);
    let (hours, minutes) = (minutes / 60, minutes % 60);
    let mark = match format {
        SubtitleFormat::Srt => ',',
        SubtitleFormat::WebVtt => '.',
    };
    format!("{hours:02}:{minutes:02}:{seconds:02}{mark}{rest:03}")
}

/// A text whose characters are all read as themselves. WebVTT has character references for the three that
/// are marks in it (W3C, WebVTT, section 4.2.2). SubRip has none: players take `<i>` and `{\an8}` for marks,
/// and a line with an arrow for a time.
fn escaped(text: &str, format: SubtitleFormat) -> String {
    match format {
        SubtitleFormat::WebVtt => text
            .replace('&', "&amp;")
            .replace('<', "&lt;")
            .replace('>', "&gt;"),
        SubtitleFormat::Srt => {
            let apart = |a: char, b: &str| format!("{a}{WORD_JOINER}{b}");
            let text = text.replace("-->", &apart('-', "->"));
            let text = text.replace("{\\", &apart('{', "\\"));
            let mut read = String::with_capacity(text.len());
            let mut characters = text.chars().peekable();
            while let Some(character) = characters.next() {
                read.push(character);
                let is_mark = |next: &char| next.is_alphabetic() || *next == '/';
                if character == '<' && characters.peek().is_some_and(is_mark) {
                    read.push(WORD_JOINER);
                }
            }
            read
        }
    }
}
