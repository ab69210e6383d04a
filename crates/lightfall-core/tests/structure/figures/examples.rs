//! The check itself, on small made-up documents: it finds each wrong figure, and writes the right one.

use super::document::{Applied, Claim, Figures, apply, claim};
use super::lines::with_short_lines;
use super::measured::described;
use super::render::{at_most, count, table};
use lightfall_core::reports::import::{Head, Report};
use lightfall_core::reports::sources::Sources;
use serde::de::IgnoredAny;

fn applied(text: &str, claims: Vec<Claim>, tables: Vec<(&'static str, String)>) -> Applied {
    let source = |file: &str| (file == "known").then(|| "measured by a machine".into());
    apply("made-up.md", text, &Figures { tables, claims }, source)
}

fn words(values: &[&str]) -> Vec<String> {
    values.iter().map(|value| (*value).to_owned()).collect()
}

#[test]
fn a_right_figure_stays_however_its_sentence_is_broken_into_lines() {
    let text = "It takes 0.10 to\n  0.14 ms\nfor 11 525\nrays, within 5.3e-7.";
    let sentence = "takes {} to {} ms for {} rays, within {}.";
    let values = words(&["0.10", "0.14", "11 525", "5.3e-7"]);
    let found = applied(text, vec![claim(sentence, values)], vec![]);
    assert_eq!((found.faults.len(), found.differences.len()), (0, 0));
    assert_eq!(found.text, text);
}

#[test]
fn a_wrong_figure_is_reported_with_its_document_its_sentence_and_both_values() {
    let text = "Each takes 0.10 ms, all\ntake 4e-7 s.";
    let claims = || {
        vec![claim(
            "takes {} ms, all take {} s",
            words(&["0.30", "5e-7"]),
        )]
    };
    let found = applied(text, claims(), vec![]);
    assert_eq!(found.faults.len(), 0);
    let place = "in: takes {} ms, all take {} s";
    assert_eq!(
        found.differences,
        [
            format!("made-up.md: 4e-7 should be 5e-7 {place}"),
            format!("made-up.md: 0.10 should be 0.30 {place}"),
        ]
    );
    assert_eq!(found.text, "Each takes 0.30 ms, all\ntake 5e-7 s.");
    assert_eq!(applied(&found.text, claims(), vec![]).differences.len(), 0);
}

#[test]
fn a_sentence_that_is_not_there_or_there_twice_is_a_fault_that_names_it() {
    for text in ["It takes many ms.", "It takes 2 ms, and that takes 3 ms."] {
        let found = applied(text, vec![claim("takes {} ms", words(&["2"]))], vec![]);
        let [fault] = found.faults.as_slice() else {
            panic!("{text}: {:?}", found.faults)
        };
        assert!(fault.contains("takes {} ms"), "{fault}");
        assert_eq!(found.text, text);
    }
}

#[test]
fn a_table_and_the_line_about_its_source_are_written_between_their_marks() {
    let text = "Before\n\n<!-- table one -->\n<!-- end -->\n\n<!-- source known -->\nold\n<!-- end -->\nafter\n";
    let tables = || vec![("one", table("a | b", [words(&["1", "2"])]))];
    let found = applied(text, vec![], tables());
    assert_eq!((found.faults.len(), found.differences.len()), (0, 2));
    assert_eq!(
        found.text,
        "Before\n\n<!-- table one -->\n| a | b |\n|---|---|\n| 1 | 2 |\n<!-- end -->\n\n\
         <!-- source known -->\nmeasured by a machine\n<!-- end -->\nafter\n"
    );
    let again = applied(&found.text, vec![], tables());
    assert_eq!((again.text, again.differences.len()), (found.text, 0));
}

#[test]
fn a_mark_that_nothing_renders_and_a_table_without_a_mark_are_faults() {
    let text = "<!-- table other -->\n1\n<!-- end -->\n<!-- source lost -->\n<!-- end -->";
    let found = applied(text, vec![], vec![("one", String::new())]);
    assert_eq!(
        found.faults,
        [
            "made-up.md: nothing renders table other",
            "made-up.md: nothing renders source lost",
            "made-up.md: there must be one table one",
        ]
    );
    assert_eq!(found.text, text);
}

fn head(lines: &str) -> Head {
    let report = Report::<IgnoredAny>::read(&format!("{lines}scene\n"));
    report.expect("a head and a header").head
}

#[test]
fn a_file_older_than_its_sources_says_so_and_another_does_not() {
    let current = Sources::of("bench").expect("bench is a report").fingerprint;
    let stale = "measured before the last change of its shaders or its report";
    for (sources, is_stale) in [
        (String::new(), true),
        ("# sources: 00000000\n".into(), true),
        (format!("# sources: {current}\n"), false),
    ] {
        let head = head(&format!("# adapter: a card\n# date: 2026-02-28\n{sources}"));
        let text = described("machine/bench-two", &head).expect("bench is a report");
        assert!(
            text.contains("a card") && text.contains("2026-02-28"),
            "{text}"
        );
        assert_eq!(text.contains(stale), is_stale, "{text}");
    }
    assert_eq!(described("machine/nonsense", &head("")), None);
}

#[test]
fn a_paragraph_with_a_line_that_has_grown_is_broken_anew_and_nothing_else_is() {
    let long = "word ".repeat(30);
    let table = format!("| {long}|\n    {long}");
    let text = format!("{table}\n\n* {long}\n  end\n* short\n");
    let lines = with_short_lines(&text);
    assert!(lines.starts_with(&table), "{lines}");
    let (head, tail) = ("word ".repeat(19), "word ".repeat(11));
    let item = format!("* {}\n  {} end\n* short\n", head.trim(), tail.trim());
    assert!(lines.ends_with(&item), "{lines}");
    assert_eq!(with_short_lines(&lines), lines);
}

#[test]
fn thousands_are_set_apart_from_ten_thousand_on_and_bounds_are_rounded_up() {
    assert_eq!(
        [0, 9999, 11_525, 900_000].map(count),
        ["0", "9999", "11 525", "900 000"]
    );
    assert_eq!(
        [8.84e-4, 8.8e-4, 0.12345, 0.05].map(at_most),
        ["8.9e-4", "8.8e-4", "0.124", "0.0500"]
    );
}
