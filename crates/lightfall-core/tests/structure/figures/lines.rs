//! Lines of prose, which have at most 100 columns.

const WIDTH: usize = 100;

/// The words in lines of at most 100 columns, as far as they allow. `indent` is in front of every line
/// but the first.
pub fn wrapped<'a>(indent: &str, words: impl IntoIterator<Item = &'a str>) -> String {
    let mut text = String::new();
    let mut line = String::new();
    let mut is_empty = true;
    for word in words {
        if !is_empty && line.chars().count() + 1 + word.chars().count() > WIDTH {
            text += &line;
            text += "\n";
            line = indent.to_owned();
            is_empty = true;
        }
        if !is_empty {
            line += " ";
        }
        line += word;
        is_empty = false;
    }
    text + &line
}

/// The document with each paragraph broken anew that has a line of more than 100 columns: a figure in
/// it has grown. Tables, commands, headings, pictures and links that fill a line stay as they are.
pub fn with_short_lines(text: &str) -> String {
    let mut paragraphs: Vec<Vec<&str>> = Vec::new();
    for line in text.lines() {
        let continues = is_prose(line) && !begins_item(line);
        match paragraphs.last_mut() {
            Some(last) if continues && last.last().is_some_and(|line| is_prose(line)) => {
                last.push(line);
            }
            _ => paragraphs.push(vec![line]),
        }
    }
    let lines: Vec<String> = paragraphs.iter().map(|lines| shortened(lines)).collect();
    lines.join("\n") + "\n"
}

fn shortened(lines: &[&str]) -> String {
    let is_long = lines.iter().any(|line| line.chars().count() > WIDTH);
    if !is_prose(lines[0]) || !is_long {
        return lines.join("\n");
    }
    let indent = if begins_item(lines[0]) { "  " } else { "" };
    let words = lines.iter().flat_map(|line| line.split_whitespace());
    wrapped(indent, words)
}

fn begins_item(line: &str) -> bool {
    line.starts_with("* ")
}

fn is_prose(line: &str) -> bool {
    let is_other = ["|", "#", "    ", "<", "!["];
    !line.trim().is_empty() && !is_other.iter().any(|begin| line.starts_with(begin))
}
