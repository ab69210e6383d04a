//! Texts that are no TOML.

use super::tokens::{Run, Tokens};
use super::{TomlFault, head, line_number, scalar, shown};
use toml::de::Error;
use toml_parser::lexer::TokenKind;

/// What is wrong with a text that cannot be read with this error.
pub(super) fn told(text: &str, error: &Error) -> TomlFault {
    let at = error.span().map_or(0, |span| span.start);
    let at = text.floor_char_boundary(at);
    let tokens = Tokens::new(text);
    let unclosed = tokens.unclosed_text().filter(|(start, _)| *start <= at);
    if let Some((start, quotes)) = unclosed {
        return unclosed_text(text, tokens.line(start), (start, quotes));
    }
    if let Some(inside) = tokens.text_around(at) {
        return TomlFault::at(text, at, inside_text(inside).into());
    }
    // What follows a bracket that is not closed is read as a part of its value.
    let bracket = tokens.unclosed_bracket();
    let line_start = tokens.line_range(at).start;
    if let Some(bracket) = bracket.filter(|bracket| *bracket < line_start) {
        return unclosed_bracket(text, &tokens, bracket);
    }
    let line = tokens.line(at);
    let message = error.message();
    let is_given_twice = message.starts_with("duplicate key");
    if let Some(fault) = head::told(text, (at, line), is_given_twice) {
        return fault;
    }
    let key = error.span().and_then(|span| text.get(span));
    let key = key.unwrap_or_default();
    if is_given_twice {
        let said = format!("{} is given twice: a table has each field once", shown(key));
        return TomlFault::at(text, at, said);
    }
    if message.starts_with("cannot extend") {
        let said = format!(
            "{} has a value already, and cannot be a table of fields as well",
            shown(key)
        );
        return TomlFault::at(text, at, said);
    }
    if let Some(fault) = early_end(text, &tokens, (at, line)) {
        return fault;
    }
    // A line inside a list or a table of several lines.
    if let Some(bracket) = tokens.bracket_around(at).filter(|it| *it < line_start)
        && message.starts_with("missing comma")
    {
        let said = format!(
            "{} has no comma before it: commas stand between the values of the list that begins in line {}",
            shown(line),
            line_number(text, bracket)
        );
        return TomlFault::at(text, at, said);
    }
    let said = no_field(line)
        .or_else(|| with_comma(&tokens, at))
        .or_else(|| value(line))
        .or_else(|| tokens.run(at).and_then(|run| words(&run)));
    if let Some(said) = said {
        return TomlFault::at(text, at, said);
    }
    match bracket {
        Some(bracket) if bracket <= at => unclosed_bracket(text, &tokens, bracket),
        _ => TomlFault::at(text, at, unknown(line)),
    }
}

/// What is said of a line of which no more is known.
fn unknown(line: &str) -> String {
    format!(
        "{} cannot be read: a line is a field such as `r = 20`, the head of a table such as `[camera]`, or a remark \
         behind `#`",
        shown(line)
    )
}

fn unclosed_text(text: &str, line: &str, (start, quotes): (usize, &str)) -> TomlFault {
    let line = shown(line);
    let said = match quotes.len() {
        1 => format!(
            "{line} has no closing quote: write `{quotes}` at the end of the text, and a text of several lines \
             between `\"\"\"` and `\"\"\"`"
        ),
        _ => {
            format!("{line} begins a text that nothing ends: write `{quotes}` behind its last line")
        }
    };
    TomlFault::at(text, start, said)
}

/// What is wrong inside a text that is closed.
fn inside_text(inside: &str) -> &'static str {
    if inside.starts_with('"') && inside.contains('\\') {
        "a backslash in a text between `\"` begins a sign such as `\\n`: write `\\\\` for a backslash, or put the \
         text between `'`"
    } else {
        "a text has a character that is not printed and not allowed: delete it"
    }
}

fn unclosed_bracket(text: &str, tokens: &Tokens<'_>, bracket: usize) -> TomlFault {
    let (open, close) = match text[bracket..].starts_with('{') {
        true => ('{', '}'),
        false => ('[', ']'),
    };
    let line = shown(tokens.line(bracket));
    let said = format!("{line} opens a bracket `{open}` that nothing closes: write `{close}`");
    TomlFault::at(text, bracket, said)
}

/// A text of several lines that ends where the next one should begin: its own end is missing.
fn early_end(text: &str, tokens: &Tokens<'_>, (at, line): (usize, &str)) -> Option<TomlFault> {
    let long = tokens.long_text_before(at)?;
    let line_start = tokens.line_range(at).start;
    // Behind its end there are words, in the same line or in the next one.
    let gap = text.get(long.end..line_start.max(long.end))?;
    let is_field = line.contains('=') || with_colon(line).is_some();
    let are_words = long.end > line_start || !(is_field || line.is_empty());
    let [first, last] = [long.start, long.end].map(|at| line_number(text, at));
    (gap.trim().is_empty() && are_words && first < last).then(|| {
        let quotes = &text[long.start..long.start + 3];
        let said = format!(
            "the text that begins here ends at the `{quotes}` of line {last}, before the words of line {}: each text of \
             several lines needs `{quotes}` at its beginning and at its end",
            line_number(text, at)
        );
        TomlFault::at(text, long.start, said)
    })
}

/// The name and the value of a line with a colon in place of the equals sign.
fn with_colon(line: &str) -> Option<(&str, &str)> {
    let (name, value) = line.split_once(':')?;
    let (name, value) = (name.trim(), value.trim());
    let is_part = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || "_.".contains(c);
    (!name.is_empty() && name.chars().all(is_part)).then_some((name, value))
}

/// What is wrong with a line without an equals sign, or with nothing behind it.
fn no_field(line: &str) -> Option<String> {
    let given = shown(line);
    let Some((name, value)) = line.split_once('=') else {
        return match with_colon(line) {
            Some((name, value)) => Some(format!(
                "{given} has no equals sign: write {}",
                shown(&format!("{name} = {value}"))
            )),
            // A line that ends or goes on with a list has no equals sign of its own.
            None if line.is_empty() || line.starts_with(['[', ']', '{', '}', ',']) => None,
            None => Some(format!(
                "{given} is no field, which is written `name = value`; a remark begins with `#`"
            )),
        };
    };
    let value = value.trim();
    if name.trim().is_empty() {
        return Some(format!(
            "{given} has no name: a field is written `name = value`"
        ));
    }
    if value.is_empty() {
        return Some(format!("{given} has no value behind the equals sign"));
    }
    value
        .starts_with('=')
        .then(|| format!("{given} has two equals signs: a field has one, `name = value`"))
}

fn with_comma(tokens: &Tokens<'_>, at: usize) -> Option<String> {
    let (given, meant) = tokens.number_with_comma(at)?;
    Some(format!(
        "{} has a comma where a number has a point: did you mean {meant}?",
        shown(given)
    ))
}

/// What is wrong with the value of a line, unless that begins with quotes or brackets.
fn value(line: &str) -> Option<String> {
    let (name, value) = line.split_once('=')?;
    let value = value.trim();
    if value.starts_with(['"', '\'', '[', '{']) {
        return None;
    }
    if value.contains('=') {
        let given = shown(line);
        return Some(format!(
            "{given} has more than one field: each stands in a line of its own"
        ));
    }
    scalar::told(Some(name.trim()), value)
}

/// What is wrong with words inside a line.
fn words(run: &Run<'_>) -> Option<String> {
    if run.words.is_empty() {
        return None;
    }
    let given = shown(run.words);
    let mut parts = run.words.split_whitespace();
    let are_numbers = parts.all(|part| part.parse::<f64>().is_ok());
    let is_word = run.words.starts_with(char::is_alphabetic);
    match run.before? {
        TokenKind::BasicString if run.words.contains('"') => Some(format!(
            "{given} stands behind a text that ends before it: a quote inside a text is written `\\\"`"
        )),
        TokenKind::LiteralString => Some(format!(
            "{given} stands behind a text that ends before it: put a text with an apostrophe between `\"` and `\"`"
        )),
        TokenKind::BasicString
        | TokenKind::MlBasicString
        | TokenKind::MlLiteralString
        | TokenKind::RightSquareBracket
        | TokenKind::RightCurlyBracket => Some(format!(
            "{given} stands behind a value: a line has one field, and a remark begins with `#`"
        )),
        TokenKind::LeftSquareBracket | TokenKind::Comma
            if are_numbers && run.words.contains(' ') =>
        {
            Some(format!(
                "{given} has no commas: they stand between the values of a list"
            ))
        }
        TokenKind::Equals | TokenKind::LeftSquareBracket => scalar::told(None, run.words),
        // In a table between braces the name of a field may be meant.
        TokenKind::Comma | TokenKind::LeftCurlyBracket
            if !is_word || scalar::switch(run.words).is_some() =>
        {
            scalar::told(None, run.words)
        }
        _ => None,
    }
}
