//! The heads of tables, `[camera]` and `[[stop]]`.

use super::{Located, TomlFault, line_number, shown};

/// The tables of which a journey or a mission has several.
const LISTS: [&str; 9] = [
    "keyframe", "caption", "stop", "goal", "fail", "hint", "question", "par", "solution",
];

/// What is said of a single table where there must be a list of them.
pub(in crate::scene) fn one_table(name: &str) -> String {
    format!("`[{name}]` is one table; {name}s are a list, written `[[{name}]]`")
}

/// What is said of a list of tables where there must be one.
pub(super) fn several_tables(name: &str) -> String {
    format!("`[[{name}]]` is a list of tables; `{name}` is one table, written `[{name}]`")
}

/// The name in the head of a table, and whether it is the head of a list.
pub(super) fn name_in_head(line: &str) -> Option<(&str, bool)> {
    let is_list = line.starts_with("[[");
    let name = line.trim_matches(['[', ']', ' ', '\t']);
    let is_part = |c: char| c.is_alphanumeric() || "_-.".contains(c);
    let is_name = !name.is_empty() && name.chars().all(is_part);
    (line.starts_with('[') && is_name).then_some((name, is_list))
}

/// What is wrong with a line that begins as the head of a table does. None if it is none, or has no fault.
pub(super) fn told(
    text: &str,
    (at, line): (usize, &str),
    is_given_twice: bool,
) -> Option<TomlFault> {
    let fault = |said| Some(TomlFault::at(text, at, said));
    let Some((name, is_list)) = name_in_head(line) else {
        let (head, _) = line.split_once(']').filter(|_| line.starts_with('['))?;
        let inside = head.trim_start_matches(['[', ' ', '\t']);
        return inside.starts_with(char::is_alphabetic).then(|| {
            let said = format!(
                "{} is no head of a table: that is a name of letters, digits, _ and - between brackets, such as \
                 `[camera]`, alone in its line",
                shown(line)
            );
            TomlFault::at(text, at, said)
        });
    };
    let is_one_of_several = LISTS.contains(&name);
    if is_given_twice && is_one_of_several {
        let single = format!("[{name}]");
        let is_single = |line: &str| line.trim_start().starts_with(&single);
        let first = text.lines().position(is_single);
        return Some(TomlFault(Located {
            line: Some(first.map_or_else(|| line_number(text, at), |before| before + 1)),
            what: one_table(name),
        }));
    }
    if is_given_twice {
        let head = shown(line);
        return fault(format!(
            "{head} is given twice: a table stands once, with all of its fields"
        ));
    }
    let meant = if is_list || is_one_of_several {
        format!("[[{name}]]")
    } else {
        format!("[{name}]")
    };
    if line == meant {
        return None;
    }
    let given = shown(line);
    fault(format!("{given} is no head of a table: write `{meant}`"))
}
