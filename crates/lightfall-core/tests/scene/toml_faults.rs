//! Slips in TOML: each is one plain sentence with its line, in presets, journeys and missions alike.

use lightfall_core::scene::{journey, load, mission};

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
