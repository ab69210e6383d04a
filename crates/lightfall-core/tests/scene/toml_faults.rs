//! Slips in TOML: each is one plain sentence with its line, in presets, journeys and missions alike.

use lightfall_core::scene::journey::{self, is_journey};
use lightfall_core::scene::load;
use lightfall_core::scene::mission::{self, MISSIONS, is_mission};

/// What the readers of presets, journeys and missions say of a text.
fn said(text: &str) -> [String; 3] {
    [
        load("my.toml", text, &[]).unwrap_err().to_string(),
        journey::load("my.toml", text).unwrap_err().to_string(),
        mission::load("my.toml", text).unwrap_err().to_string(),
    ]
}

/// Texts behind two lines without a fault, with the line of the fault and what is said of it.
#[track_caller]
fn check(slips: &[(&str, usize, &str)]) {
    for (slip, line, expected) in slips {
        for sentence in said(&format!("schema = 1\n# mine\n{slip}\n")) {
            assert_eq!(sentence, format!("my.toml: line {line}: {expected}"));
        }
    }
}

#[test]
fn heads_of_tables_with_too_few_brackets_lead_to_the_right_ones() {
    check(&[
        (
            "[stop]\nat = 5\n[stop]\nat = 6",
            3,
            "`[stop]` is one table; stops are a list, written `[[stop]]`",
        ),
        (
            "[goal]\nhold = 5\n\n[[goal]]\nhold = 6",
            3,
            "`[goal]` is one table; goals are a list, written `[[goal]]`",
        ),
        (
            "[[keyframe]]\ntime = 1\n[[stop]\nat = 5",
            5,
            "`[[stop]` is no head of a table: write `[[stop]]`",
        ),
        (
            "[camera\nr = 3",
            3,
            "`[camera` is no head of a table: write `[camera]`",
        ),
        (
            "[camera]\nr = 20\n[camera]",
            5,
            "`[camera]` is given twice: a table stands once, with all of its fields",
        ),
        (
            "[camera] r = 3",
            3,
            "`[camera] r = 3` is no head of a table: that is a name of letters, digits, _ and - between brackets, \
             such as `[camera]`, alone in its line",
        ),
    ]);
}

#[test]
fn numbers_that_toml_does_not_read_lead_to_those_that_were_meant() {
    let unit = |given: &str, value: &str| {
        format!(
            "`{given}` is neither a number nor a text in quotes: write the number without its unit, in the unit of the \
             field, or the text as `\"{value}\"`"
        )
    };
    let [kilometres, seconds, degrees] = [
        unit("time = 20 km", "20 km"),
        unit("time = 20 s", "20 s"),
        unit("yaw_deg = -7.5°", "-7.5°"),
    ];
    check(&[
        ("time = 20 km", 3, kilometres.as_str()),
        ("[[stop]]\ntime = 20 s  # later", 4, seconds.as_str()),
        ("yaw_deg = -7.5°", 3, degrees.as_str()),
        (
            "r = 1,5",
            3,
            "`1,5` has a comma where a number has a point: did you mean 1.5?",
        ),
        (
            "question = { answer = 0,5, tolerance = 1 }",
            3,
            "`0,5` has a comma where a number has a point: did you mean 0.5?",
        ),
        (
            "r = .5",
            3,
            "`r = .5` is no number as it is written here: did you mean 0.5?",
        ),
        (
            "r = 10 000",
            3,
            "`r = 10 000` is no number as it is written here: did you mean 10000?",
        ),
    ]);
}

#[test]
fn texts_with_wrong_quotes_or_none_lead_to_the_right_ones() {
    let unclosed = |line: &str, quote: &str| {
        format!(
            "`{line}` has no closing quote: write `{quote}` at the end of the text, and a text of several lines \
             between `\"\"\"` and `\"\"\"`"
        )
    };
    let [double, single] = [
        unclosed("title = \"The shadow", "\""),
        unclosed("title = 'The shadow", "'"),
    ];
    check(&[
        ("title = \"The shadow\nr = 3", 3, double.as_str()),
        ("r = 3\ntitle = 'The shadow", 4, single.as_str()),
        (
            "caption = \"\"\"\nLook\nat = 5",
            3,
            "`caption = \"\"\"` begins a text that nothing ends: write `\"\"\"` behind its last line",
        ),
        (
            "caption = \"\"\"\nLook\n[[stop]]\ncaption = \"\"\"\nAgain\n\"\"\"",
            3,
            "the text that begins here ends at the `\"\"\"` of line 6, before the words of line 7: each text of several \
             lines needs `\"\"\"` at its beginning and at its end",
        ),
        (
            "title = What is it",
            3,
            "`title = What is it` is a text without quotes, or with one only: write `title = \"What is it\"`",
        ),
        (
            "title = shadow\"",
            3,
            "`title = shadow\"` is a text without quotes, or with one only: write `title = \"shadow\"`",
        ),
        (
            "title = “Light”",
            3,
            "`title = “Light”` has the quotes of printed texts: write straight ones, `title = \"Light\"`",
        ),
        (
            "title = \"a \"b\" c\"",
            3,
            "`b\" c\"` stands behind a text that ends before it: a quote inside a text is written `\\\"`",
        ),
        (
            "title = 'It's here'",
            3,
            "`s here'` stands behind a text that ends before it: put a text with an apostrophe between `\"` and `\"`",
        ),
        (
            "title = \"C:\\Users\"",
            3,
            "a backslash in a text between `\"` begins a sign such as `\\n`: write `\\\\` for a backslash, or put the \
             text between `'`",
        ),
    ]);
}

#[test]
fn switches_and_lines_that_are_no_fields_lead_to_what_was_meant() {
    check(&[
        (
            "guides = True",
            3,
            "`guides = True` is refused: write true or false, in small letters; did you mean `true`?",
        ),
        (
            "guides = no",
            3,
            "`guides = no` is refused: write true or false, in small letters; did you mean `false`?",
        ),
        (
            "time: 20",
            3,
            "`time: 20` has no equals sign: write `time = 20`",
        ),
        ("r =", 3, "`r =` has no value behind the equals sign"),
        (
            "r = = 3",
            3,
            "`r = = 3` has two equals signs: a field has one, `name = value`",
        ),
        (
            "r = 3 fov_deg = 90",
            3,
            "`r = 3 fov_deg = 90` has more than one field: each stands in a line of its own",
        ),
        (
            "r = 3 // near",
            3,
            "`r = 3 // near` is refused: a remark begins with `#`",
        ),
        (
            "title = \"a\" x",
            3,
            "`x` stands behind a value: a line has one field, and a remark begins with `#`",
        ),
        (
            "velocity = [0, 0, 1\nr = 3",
            3,
            "`velocity = [0, 0, 1` opens a bracket `[` that nothing closes: write `]`",
        ),
        (
            "velocity = [0 0 1]",
            3,
            "`0 0 1` has no commas: they stand between the values of a list",
        ),
        (
            "keys = [\n\"fly.left\"\n\"fly.right\",\n]",
            5,
            "`\"fly.right\",` has no comma before it: commas stand between the values of the list that begins in line 3",
        ),
        (
            "inspector = { at = [0.5, 0.5 }",
            3,
            "`inspector = { at = [0.5, 0.5 }` opens a bracket `[` that nothing closes: write `]`",
        ),
        (
            "r = 3\nr = 4",
            4,
            "`r` is given twice: a table has each field once",
        ),
        (
            "# Fine\nLook here",
            4,
            "`Look here` is no field, which is written `name = value`; a remark begins with `#`",
        ),
    ]);
}

#[test]
fn another_version_of_the_format_has_its_line_too() {
    for sentence in said("title = \"a\"\nschema = 2\n") {
        let start = "my.toml: line 2: schema = 2 is another version";
        assert!(sentence.starts_with(start), "{sentence}");
    }
}

/// What is TOML may still have a single table where there must be a list, and names that no field has.
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

/// A mission is read by its types, whose words reach nobody either.
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
