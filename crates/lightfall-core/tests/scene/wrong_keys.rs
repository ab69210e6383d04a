//! What is TOML and no journey or mission: single tables in place of lists, keys that no table has, and values
//! of the wrong kind.

use lightfall_core::scene::journey::{self, is_journey};
use lightfall_core::scene::mission::{self, MISSIONS, is_mission};

#[test]
fn a_journey_with_a_single_table_or_an_unknown_key_leads_to_what_was_meant() {
    let frames = "[[keyframe]]\ntime = 0\n[[keyframe]]\ntime = 9\n";
    let first = |text: &str| journey::load("my.toml", text).unwrap_err().to_string();
    let single = "[stop]\nat = 5";
    assert_eq!(
        first(&format!("{frames}{single}")),
        "my.toml: line 5: `[stop]` is one table; stops are a list, written `[[stop]]`"
    );
    let single = "\n[keyframe]\ntime = 0";
    assert_eq!(
        first(single),
        "my.toml: line 2: `[keyframe]` is one table; keyframes are a list, written `[[keyframe]]`"
    );
    assert!(is_journey(single) && is_journey("[[stop]\nat = 5"));
    for (text, start) in [
        (
            "theta = 90",
            "line 5: keyframe 2: there is no theta; did you mean theta_deg?; a keyframe has",
        ),
        (
            "fov = 90",
            "line 5: keyframe 2: there is no fov; did you mean fov_deg?; a keyframe has",
        ),
        (
            "[[caption]]\ntime = 3\ntekst = \"a\"",
            "line 7: caption 1: there is no tekst; did you mean text?; a caption has",
        ),
        (
            "[[stop]]\nat = 3\ncapton = \"a\"",
            "line 7: stop 1: there is no capton; did you mean caption?; a stop has",
        ),
        (
            "[[stop]]\nat = 3\nquestion = { text = \"a\", answer = 1, tolerence = 1, tolerance = 1 }",
            "line 7: stop 1: there is no question.tolerence; did you mean question.tolerance?; a stop has",
        ),
    ] {
        let said = first(&format!("{frames}{text}"));
        assert!(said.starts_with(&format!("my.toml: {start}")), "{said}");
    }
    let titel = first(&format!("titel = \"a\"\n{frames}"));
    let start = "my.toml: line 1: titel = \"a\" is refused: did you mean title?; a journey has";
    assert!(titel.starts_with(start), "{titel}");
    // Keyframes have a time, and a stop says when it is with another word.
    let at = journey::load("my.toml", &format!("{frames}[[stop]]\ntime = 3")).unwrap_err();
    let has_hint = |said: &String| said.contains("there is no time; did you mean at?");
    assert!(at.sentences().iter().any(has_hint), "{at}");
}

/// A mission is read by its types, whose own messages nobody sees.
#[test]
fn a_mission_with_a_wrong_value_has_its_line_its_field_and_what_is_allowed() {
    let (name, text) = MISSIONS[3];
    assert_eq!(name, "graze");
    for (from, to, expected) in [
        (
            "face = \"hole\"",
            "face = \"hole\", theta = 90",
            "line 11: unknown field `theta`; did you mean `theta_deg`?",
        ),
        (
            "mass_suns = 6.5e9",
            "mass_suns = 6.5e9, colour = 1",
            "line 9: unknown field `colour`; known are spin, mass_suns",
        ),
        (
            "mass_suns = 6.5e9",
            "mass_suns = 99999999999999999999",
            "line 9: hole.mass_suns = 99999999999999999999 is refused: it must be a smaller number",
        ),
        (
            "exhaust = 1.0",
            "exhaust = 1.5",
            "line 10: ship.exhaust = 1.5 is refused: it must be above 0 and at most 1",
        ),
        (
            "title = \"Graze the photon sphere\"\n",
            "",
            "the field `title` is missing",
        ),
    ] {
        assert!(text.contains(from), "{from}");
        let said = mission::load(name, &text.replacen(from, to, 1)).unwrap_err();
        assert_eq!(said.to_string(), format!("graze: {expected}"));
    }
    for (from, to, expected) in [
        (
            "[[par]]",
            "[par]",
            "`[par]` is one table; pars are a list, written `[[par]]`",
        ),
        (
            "[ending]",
            "[[ending]]",
            "`[[ending]]` is a list of tables; `ending` is one table, written `[ending]`",
        ),
        (
            "value = 1.09",
            "value = \"1.09\"",
            "par 1: value = \"1.09\" is refused: it must be a number",
        ),
        (
            "after = 1",
            "after = 1.5",
            "hint 1: after = 1.5 is refused: it must be a whole number",
        ),
        (
            "thrust = [0.0, 0.0, 1.0]",
            "thrust = 5",
            "solution 3: thrust = 5 is refused: it must be one of hole, outward, prograde, retrograde, or three",
        ),
        (
            "a = 0.05",
            "a = -1",
            "solution 3: a = -1 is refused: it must be a finite number, not",
        ),
    ] {
        let before = text.find(from).unwrap();
        let line = 1 + text[..before].matches('\n').count();
        let said = mission::load(name, &text.replacen(from, to, 1))
            .unwrap_err()
            .to_string();
        assert!(
            said.starts_with(&format!("graze: line {line}: {expected}")),
            "{said}"
        );
    }
    let lacking = mission::load(name, &text.replacen("value = 1.09\n", "", 1)).unwrap_err();
    let head = 1 + text[..text.find("[[par]]").unwrap()].matches('\n').count();
    let expected = format!("graze: line {head}: par 1 has no field `value`");
    assert_eq!(lacking.to_string(), expected);
    assert!(is_mission("[goal]\nhold = 1") && is_mission("[[solution]\na = 1"));
}
