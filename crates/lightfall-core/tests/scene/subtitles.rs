//! The captions of journeys and lessons as subtitles.

use lightfall_core::scene::journey::{self, FLIGHTS, Journey, LESSONS, SubtitleFormat};

fn load(text: &str) -> Journey {
    journey::load("j.toml", text).unwrap()
}

fn text(journey: &Journey, fps: Option<f64>, format: SubtitleFormat) -> String {
    journey.subtitles(fps, str::to_owned).to_text(format)
}

/// A flight of an hour, whose first keyframe is at 10 s.
const CAPTIONS: &str = r#"
[[keyframe]]
time = 10
[[keyframe]]
time = 4000
[[caption]]
time = 11.0104
text = "Light & <i>shadow</i>"
[[caption]]
time = 14.5
seconds = 2
text = "α → ω"
[[caption]]
time = 3735.5
seconds = 1.2345
text = "-->"
"#;

#[test]
fn captions_are_subtitles_of_whole_milliseconds_until_the_next_one() {
    let journey = load(CAPTIONS);
    assert_eq!(
        text(&journey, None, SubtitleFormat::WebVtt),
        "WEBVTT\n\n\
         1\n00:00:01.011 --> 00:00:04.500\nLight &amp; &lt;i&gt;shadow&lt;/i&gt;\n\n\
         2\n00:00:04.500 --> 00:00:06.500\nα → ω\n\n\
         3\n01:02:05.500 --> 01:02:06.735\n--&gt;\n\n"
    );
    // SubRip has no references: a word joiner, which is not seen, keeps marks from being read as marks.
    assert_eq!(
        text(&journey, None, SubtitleFormat::Srt),
        "1\n00:00:01,011 --> 00:00:04,500\nLight & <\u{2060}i>shadow<\u{2060}/i>\n\n\
         2\n00:00:04,500 --> 00:00:06,500\nα → ω\n\n\
         3\n01:02:05,500 --> 01:02:06,735\n-\u{2060}->\n\n"
    );
}

/// At 24 frames a second frame 25 is the first one after 1.0104 s, and frame 108 is at 4.5 s.
#[test]
fn at_a_frame_rate_subtitles_change_with_the_frames_that_show_their_times() {
    let journey = load(CAPTIONS);
    let times = |fps| -> Vec<String> {
        let srt = text(&journey, Some(fps), SubtitleFormat::Srt);
        let times = srt.lines().filter(|line| line.contains(" --> "));
        times.map(str::to_owned).collect()
    };
    assert_eq!(
        times(24.0),
        [
            "00:00:01,042 --> 00:00:04,500",
            "00:00:04,500 --> 00:00:06,500",
            "01:02:05,500 --> 01:02:06,750"
        ]
    );
    // With a frame every two seconds, each of the first two captions has one of its own.
    assert_eq!(
        times(0.5),
        [
            "00:00:02,000 --> 00:00:06,000",
            "00:00:06,000 --> 00:00:08,000",
            "01:02:06,000 --> 01:02:08,000"
        ]
    );
}

#[test]
fn a_frame_has_the_words_that_the_window_shows_at_its_time() {
    let journey = load(CAPTIONS);
    for fps in [10.0, 25.0, 29.97] {
        let srt = text(&journey, Some(fps), SubtitleFormat::Srt);
        let shown = cues(&srt);
        for frame in 0..400_u32 {
            let time = f64::from(frame) / fps;
            // The middle of the frame, so that the rounding to milliseconds does not count.
            let middle = (1000.0 * (time + 0.5 / fps)) as u64;
            let seen = shown
                .iter()
                .any(|(start, end, _)| (*start..*end).contains(&middle));
            assert_eq!(seen, journey.caption_at(time).is_some(), "{fps} {frame}");
        }
    }
}

const LESSON: &str = r#"
[[keyframe]]
time = 0
[[keyframe]]
time = 20
[[caption]]
time = 5
seconds = 60
text = "On the way"
[[stop]]
at = 5
caption = """
Left: as it is.

{window.inspector}: g {\\an8}
"""
[[stop]]
at = 6
[[stop]]
at = 20
caption = "Which side is brighter now, and by how much would it be, if nothing moved?"
"#;

#[test]
fn a_lessons_stops_are_subtitles_for_as_long_as_reading_them_takes() {
    let journey = load(LESSON);
    let words = |text: &str| text.replace("{window.inspector}", "I");
    let srt = journey.subtitles(None, words).to_text(SubtitleFormat::Srt);
    // 74 characters at 15 a second are 4.934 s. What is said at the same time is one subtitle.
    assert_eq!(
        srt,
        "1\n00:00:05,000 --> 00:00:20,000\nOn the way\nLeft: as it is.\nI: g {\u{2060}\\an8}\n\n\
         2\n00:00:20,000 --> 00:00:24,934\nWhich side is brighter now, and by how much would it be, if nothing moved?\n\n"
    );
}

#[test]
fn a_journey_that_says_nothing_has_no_subtitles() {
    let silent = load("[[keyframe]]\ntime = 0\n[[keyframe]]\ntime = 1\n[[stop]]\nat = 1\n");
    assert!(silent.subtitles(None, str::to_owned).is_empty());
    assert_eq!(load(CAPTIONS).subtitles(Some(30.0), str::to_owned).len(), 3);
}

fn milliseconds(clock: &str) -> u64 {
    let numbers: Vec<u64> = clock
        .split([':', ',', '.'])
        .map(|part| part.parse().unwrap())
        .collect();
    let [hours, minutes, seconds, rest] = numbers[..] else {
        panic!("{clock}");
    };
    assert!(minutes < 60 && seconds < 60 && rest < 1000);
    ((hours * 60 + minutes) * 60 + seconds) * 1000 + rest
}

/// Start, end and words of the subtitles in a file, as players read it: blocks between empty lines.
fn cues(file: &str) -> Vec<(u64, u64, String)> {
    let blocks = file.trim_start_matches("WEBVTT\n\n").split("\n\n");
    let blocks = blocks.filter(|block| !block.trim().is_empty());
    blocks
        .enumerate()
        .map(|(index, block)| {
            let mut lines = block.lines();
            assert_eq!(lines.next(), Some((index + 1).to_string().as_str()));
            let (start, end) = lines.next().unwrap().split_once(" --> ").unwrap();
            let words: Vec<&str> = lines.collect();
            assert!(!words.is_empty() && words.iter().all(|line| !line.contains("-->")));
            (milliseconds(start), milliseconds(end), words.join("\n"))
        })
        .collect()
}

#[test]
fn no_subtitle_overlaps_another_at_any_rate() {
    let default = journey::load("the built-in journey", journey::DEFAULT).unwrap();
    let names = LESSONS.iter().chain(&FLIGHTS).map(|(name, _)| *name);
    let built_in = names.map(|name| journey::built_in(name).unwrap());
    let mut count = 0;
    for journey in built_in.chain([default, load(CAPTIONS), load(LESSON)]) {
        for fps in [
            None,
            Some(0.01),
            Some(0.5),
            Some(23.976),
            Some(30.0),
            Some(1000.0),
        ] {
            for format in SubtitleFormat::ALL {
                let cues = cues(&text(&journey, fps, format));
                assert!(cues.iter().all(|(start, end, _)| start < end));
                assert!(
                    cues.windows(2).all(|pair| pair[0].1 <= pair[1].0),
                    "{cues:?}"
                );
                count += cues.len();
            }
        }
    }
    assert!(count > 300, "{count}");
}
