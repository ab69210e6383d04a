//! The file of the answers to the questions of lessons.

use lightfall::app::{LessonAnswer, time_in_utc};
use std::fs;
use std::time::Duration;

/// The right answer of a pupil at the second try.
fn right_answer() -> LessonAnswer {
    LessonAnswer {
        lesson: "Light".into(),
        question: 1,
        answer: 2.6,
        is_right: true,
        tries: 2,
        time: "2026-03-01T09:05:00Z".into(),
        pupil: "Ada".into(),
    }
}

#[test]
fn answers_are_rows_of_a_file_and_titles_with_commas_are_one_cell() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("new folder").join("lesson-results.csv");
    let answer = LessonAnswer {
        lesson: "Heavy, \"dark\" matter".into(),
        answer: 0.0625,
        pupil: "Lovelace, Ada".into(),
        ..right_answer()
    };
    answer.keep(&file).unwrap();
    let wrong = LessonAnswer {
        lesson: "Light".into(),
        answer: 6.6e-12,
        is_right: false,
        pupil: String::new(),
        ..answer
    };
    wrong.keep(&file).unwrap();
    assert_eq!(
        fs::read_to_string(&file).unwrap(),
        "lesson,question,answer,is_right,tries,time,pupil\n\
         \"Heavy, \"\"dark\"\" matter\",1,0.0625,true,2,2026-03-01T09:05:00Z,\"Lovelace, Ada\"\n\
         Light,1,6.6e-12,false,2,2026-03-01T09:05:00Z,\n"
    );
}

/// A name may be anything that a pupil types. Whatever it is, it stays one cell of one row.
#[test]
fn names_in_a_file_of_answers_are_one_cell_and_no_formula() {
    let folder = tempfile::tempdir().unwrap();
    for (number, (pupil, cell)) in [
        ("Ada", "Ada"),
        ("Ada, \"the\" Countess", "Ada, \"the\" Countess"),
        ("Ada\r\nLovelace", "Ada  Lovelace"),
        ("=HYPERLINK(\"a\")", "'=HYPERLINK(\"a\")"),
        ("+1", "'+1"),
        ("-1", "'-1"),
        (" @SUM(A1)", "'@SUM(A1)"),
        ("＝1+1", "'＝1+1"),
        ("Ada;=1+1", "Ada; '=1+1"),
    ]
    .into_iter()
    .enumerate()
    {
        let file = folder.path().join(format!("{number}.csv"));
        let answer = LessonAnswer {
            lesson: pupil.into(),
            pupil: pupil.into(),
            ..right_answer()
        };
        answer.keep(&file).unwrap();
        let mut rows = csv::Reader::from_path(&file).unwrap();
        let rows: Vec<csv::StringRecord> = rows.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 1, "{pupil:?}");
        // The title of a lesson is written by somebody, too.
        assert_eq!([&rows[0][0], &rows[0][6]], [cell, cell], "{pupil:?}");
    }
}

/// A class goes on with the file of an earlier version: its rows stay, and its header gets the new columns.
#[test]
fn answers_go_on_in_a_file_with_the_header_of_an_earlier_version() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("lesson-results.csv");
    let old = "lesson,question,answer,is_right,tries\nLight,1,2.5,false,1\n";
    fs::write(&file, old).unwrap();
    right_answer().keep(&file).unwrap();
    assert_eq!(
        fs::read_to_string(&file).unwrap(),
        "lesson,question,answer,is_right,tries,time,pupil\nLight,1,2.5,false,1\n\
         Light,1,2.6,true,2,2026-03-01T09:05:00Z,Ada\n"
    );
}

#[test]
fn a_time_in_utc_is_written_to_the_second() {
    for (seconds, expected) in [
        (0, "1970-01-01T00:00:00Z"),
        // The last second of a leap day, and one in the afternoon.
        (951_868_799, "2000-02-29T23:59:59Z"),
        (1_772_355_905, "2026-03-01T09:05:05Z"),
    ] {
        assert_eq!(time_in_utc(Duration::from_secs(seconds)), expected);
    }
}
