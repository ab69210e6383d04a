//! Splits Rust source into words and signs, without comments, strings and numbers' meaning.

/// One word or sign of a source text.
#[derive(Clone, Debug, PartialEq)]
pub struct Token {
    /// An identifier, a number, `::`, or a single sign.
    pub text: String,
    /// The line that it stands on, counted from 1.
    pub line: usize,
}

/// The tokens of `source`. Comments, strings, characters and lifetimes are left out.
pub fn tokens(source: &str) -> Vec<Token> {
    let chars: Vec<char> = source.chars().collect();
    let mut found = Vec::new();
    let (mut at, mut line) = (0, 1);
    while at < chars.len() {
        let end = token_end(&chars, at);
        let text: String = chars[at..end].iter().collect();
        if is_kept(&text) {
            let text = text.strip_prefix("r#").unwrap_or(&text).to_owned();
            found.push(Token { text, line });
        }
        line += chars[at..end].iter().filter(|&&c| c == '\n').count();
        at = end;
    }
    found
}

fn is_kept(text: &str) -> bool {
    let is_comment = text.starts_with("//") || text.starts_with("/*");
    !is_comment && !text.contains('"') && !text.starts_with('\'') && !text.trim().is_empty()
}

/// Where the token, comment or literal that begins at `at` ends.
fn token_end(chars: &[char], at: usize) -> usize {
    let next = |ahead: usize| chars.get(at + ahead).copied().unwrap_or('\0');
    match (chars[at], next(1)) {
        ('/', '/') => position(chars, at, '\n'),
        ('/', '*') => comment_end(chars, at),
        ('"', _) => string_end(chars, at + 1),
        ('\'', _) => quote_end(chars, at),
        (':', ':') => at + 2,
        (c, _) if is_word(c) => {
            let end = (at..chars.len())
                .find(|&i| !is_word(chars[i]))
                .unwrap_or(chars.len());
            let prefix: String = chars[at..end].iter().collect();
            literal_end(chars, &prefix, end).unwrap_or(end)
        }
        _ => at + 1,
    }
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn position(chars: &[char], from: usize, wanted: char) -> usize {
    (from..chars.len())
        .find(|&i| chars[i] == wanted)
        .unwrap_or(chars.len())
}

/// The end of a string or raw identifier whose prefix (`r`, `b`, `br`, `c`, `cr`) ends at `end`.
fn literal_end(chars: &[char], prefix: &str, end: usize) -> Option<usize> {
    let raw = matches!(prefix, "r" | "br" | "cr");
    if !raw && !matches!(prefix, "b" | "c") {
        return None;
    }
    let hashes = chars[end..].iter().take_while(|&&c| c == '#').count();
    match chars.get(end + hashes) {
        Some('"') if raw => {
            let close: Vec<char> = std::iter::once('"')
                .chain(std::iter::repeat_n('#', hashes))
                .collect();
            let body = end + hashes + 1;
            let length = chars[body..]
                .windows(close.len())
                .position(|window| window == close)?;
            Some(body + length + close.len())
        }
        Some('"') if hashes == 0 => Some(string_end(chars, end + 1)),
        Some('\'') if hashes == 0 && prefix == "b" => Some(quote_end(chars, end)),
        Some(&c) if raw && hashes == 1 && is_word(c) => (end + 1..chars.len())
            .find(|&i| !is_word(chars[i]))
            .or(Some(chars.len())),
        _ => None,
    }
}

/// Comments of this form may contain each other.
fn comment_end(chars: &[char], at: usize) -> usize {
    let (mut depth, mut i) = (0, at);
    while i + 1 < chars.len() {
        match (chars[i], chars[i + 1]) {
            ('/', '*') => (depth, i) = (depth + 1, i + 2),
            ('*', '/') => (depth, i) = (depth - 1, i + 2),
            _ => i += 1,
        }
        if depth == 0 {
            return i;
        }
    }
    chars.len()
}

fn string_end(chars: &[char], body: usize) -> usize {
    let mut i = body;
    while i < chars.len() && chars[i] != '"' {
        i += if chars[i] == '\\' { 2 } else { 1 };
    }
    (i + 1).min(chars.len())
}

/// The end of a character, or of a lifetime's name.
fn quote_end(chars: &[char], at: usize) -> usize {
    if chars.get(at + 1) == Some(&'\\') {
        return (position(chars, at + 3, '\'') + 1).min(chars.len());
    }
    if chars.get(at + 2) == Some(&'\'') {
        return at + 3;
    }
    (at + 1..chars.len())
        .find(|&i| !is_word(chars[i]))
        .unwrap_or(chars.len())
}
