//! A document whose figures are rendered: its tables, and the numbers in its sentences.

use std::ops::Range;

/// What a document states.
#[derive(Default)]
pub struct Figures {
    /// Name and Markdown of each table.
    pub tables: Vec<(&'static str, String)>,
    /// The sentences.
    pub claims: Vec<Claim>,
}

/// A sentence, or a part of one, with `{}` in place of each number, and the numbers.
pub struct Claim {
    sentence: &'static str,
    values: Vec<String>,
}

/// A [`Claim`]. The sentence begins with a word.
pub fn claim(sentence: &'static str, values: impl IntoIterator<Item = String>) -> Claim {
    let values: Vec<String> = values.into_iter().collect();
    assert_eq!(
        sentence.matches("{}").count(),
        values.len(),
        "the sentence has a place for each number: {sentence}"
    );
    Claim { sentence, values }
}

/// A document with the right figures.
pub struct Applied {
    pub text: String,
    /// Each figure that the document stated otherwise.
    pub differences: Vec<String>,
    /// What cannot be written: sentences and tables that the document does not have, or has twice.
    pub faults: Vec<String>,
}

/// Puts the figures into a document. `source` renders the line about a CSV file.
pub fn apply(
    name: &str,
    text: &str,
    figures: &Figures,
    source: impl Fn(&str) -> Option<String>,
) -> Applied {
    let mut applied = Applied {
        text: String::new(),
        differences: Vec::new(),
        faults: Vec::new(),
    };
    applied.text = applied.put_blocks(name, text, figures, source);
    for claim in &figures.claims {
        applied.put_claim(name, claim);
    }
    applied
}

const OPEN: &str = "<!-- ";
const CLOSE: &str = " -->";
const END: &str = "<!-- end -->";

impl Applied {
    /// The text with every block rendered.
    fn put_blocks(
        &mut self,
        name: &str,
        text: &str,
        figures: &Figures,
        source: impl Fn(&str) -> Option<String>,
    ) -> String {
        let mut result = String::new();
        let mut put = Vec::new();
        let mut rest = text;
        while let Some((before, kind, block, inside, after)) = next_block(rest) {
            let rendered = match kind {
                "table" => {
                    let table = figures.tables.iter().find(|(table, _)| *table == block);
                    table.map(|(_, markdown)| markdown.clone())
                }
                _ => source(block),
            };
            put.push(block);
            let Some(rendered) = rendered else {
                self.faults
                    .push(format!("{name}: nothing renders {kind} {block}"));
                result += &rest[..rest.len() - after.len()];
                rest = after;
                continue;
            };
            let rendered = format!("\n{}\n", rendered.trim());
            if let Some((stated, right)) = first_difference(inside, &rendered) {
                self.differences.push(format!(
                    "{name}: {kind} {block} says\n    {stated}\nand docs/bench says\n    {right}"
                ));
            }
            result += &format!("{before}{OPEN}{kind} {block}{CLOSE}{rendered}{END}");
            rest = after;
        }
        for (table, _) in &figures.tables {
            if put.iter().filter(|block| *block == table).count() != 1 {
                self.faults
                    .push(format!("{name}: there must be one table {table}"));
            }
        }
        result + rest
    }

    fn put_claim(&mut self, name: &str, claim: &Claim) {
        let found = find(&self.text, claim);
        let [places] = found.as_slice() else {
            let count = found.len();
            self.faults.push(format!(
                "{name}: this sentence stands {count} times in it, not once: {}",
                claim.sentence
            ));
            return;
        };
        for (place, right) in places.iter().zip(&claim.values).rev() {
            let stated = &self.text[place.clone()];
            if stated.split_whitespace().ne(right.split_whitespace()) {
                self.differences.push(format!(
                    "{name}: {stated} should be {right} in: {}",
                    claim.sentence
                ));
                self.text.replace_range(place.clone(), right);
            }
        }
    }
}

/// The next block: the text before it, its kind, its name, what is inside, and the text after it.
fn next_block(text: &str) -> Option<(&str, &str, &str, &str, &str)> {
    let mut from = 0;
    loop {
        let start = from + text[from..].find(OPEN)?;
        let (head, rest) = text[start + OPEN.len()..].split_once(CLOSE)?;
        if let Some((kind @ ("table" | "source"), name)) = head.split_once(' ') {
            let (inside, after) = rest.split_once(END)?;
            return Some((&text[..start], kind, name, inside, after));
        }
        from = start + OPEN.len();
    }
}

/// The first line in which two texts differ.
fn first_difference<'a>(stated: &'a str, right: &'a str) -> Option<(&'a str, &'a str)> {
    let (mut stated, mut right) = (stated.trim().lines(), right.trim().lines());
    loop {
        match (stated.next(), right.next()) {
            (None, None) => return None,
            (stated, right) if stated == right => {}
            (stated, right) => {
                return Some((stated.unwrap_or("nothing"), right.unwrap_or("nothing")));
            }
        }
    }
}

/// Where the sentence stands in the text: for each place, the ranges of its numbers.
fn find(text: &str, claim: &Claim) -> Vec<Vec<Range<usize>>> {
    let words: Vec<&str> = claim.sentence.split("{}").collect();
    let starts = text.char_indices().map(|(at, _)| at);
    starts
        .filter(|at| !text[..*at].ends_with(|c: char| c.is_alphanumeric() || ".-".contains(c)))
        .filter_map(|at| {
            let mut at = after_words(text, at, words[0])?;
            let mut places = Vec::new();
            for (words, value) in words[1..].iter().zip(&claim.values) {
                let end = after_number(text, at, value.contains(' '))?;
                places.push(at..end);
                at = after_words(text, end, words)?;
            }
            Some(places)
        })
        .collect()
}

/// Where the text goes on after these words, which begin at `at`. Lines may break anywhere.
fn after_words(text: &str, mut at: usize, words: &str) -> Option<usize> {
    for piece in words.split_inclusive(char::is_whitespace) {
        let word = piece.trim_end();
        at += text[at..].strip_prefix(word).map(|_| word.len())?;
        if word.len() < piece.len() {
            let spaces = text[at..].len() - text[at..].trim_start().len();
            if spaces == 0 {
                return None;
            }
            at += spaces;
        }
    }
    Some(at)
}

/// Where the number that begins at `at` ends. Its thousands may be set apart by spaces.
fn after_number(text: &str, at: usize, grouped: bool) -> Option<usize> {
    let digits = |from: usize| {
        let rest = &text[from..];
        from + rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len()
    };
    let start = at + usize::from(text[at..].starts_with('-'));
    let mut end = digits(start);
    if end == start {
        return None;
    }
    while grouped && text[end..].starts_with(char::is_whitespace) && digits(end + 1) == end + 4 {
        end += 4;
    }
    if text[end..].starts_with('.') && digits(end + 1) > end + 1 {
        end = digits(end + 1);
    }
    if text[end..].starts_with('e') {
        let exponent = end + 1 + usize::from(text[end + 1..].starts_with('-'));
        if digits(exponent) > exponent {
            end = digits(exponent);
        }
    }
    Some(end)
}
