//! A text in TOML as tokens, which tell where texts, values and remarks begin and end.

use crate::numbers::number_with_comma;
use std::ops::Range;
use toml_parser::Source;
use toml_parser::lexer::{Token, TokenKind};

/// A text and its tokens.
pub(super) struct Tokens<'a> {
    text: &'a str,
    tokens: Vec<Token>,
}

/// Words of a value, or of what stands where a value should stand.
pub(super) struct Run<'a> {
    pub(super) words: &'a str,
    /// What stands before them.
    pub(super) before: Option<TokenKind>,
}

impl<'a> Tokens<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            text,
            tokens: Source::new(text).lex().collect(),
        }
    }

    /// Where the first text begins that is not closed, and its quotes.
    pub(super) fn unclosed_text(&self) -> Option<(usize, &'static str)> {
        self.tokens.iter().find_map(|token| {
            let quotes = quotes(token.kind())?;
            let is_open = !is_closed(self.words(token), quotes);
            is_open.then(|| (token.span().start(), quotes))
        })
    }

    /// The text in quotes that has this place inside.
    pub(super) fn text_around(&self, at: usize) -> Option<&'a str> {
        let is_around = |token: &&Token| {
            let span = token.span();
            quotes(token.kind()).is_some() && span.start() < at && at < span.end()
        };
        let around = self.tokens.iter().find(is_around)?;
        Some(self.words(around))
    }

    /// Where the last text of several lines begins that ends before this place.
    pub(super) fn long_text_before(&self, at: usize) -> Option<Range<usize>> {
        let is_before = |token: &&Token| {
            let is_long = quotes(token.kind()).is_some_and(|quotes| quotes.len() == 3);
            is_long && token.span().end() <= at
        };
        let last = self.tokens.iter().rfind(is_before)?;
        Some(last.span().start()..last.span().end())
    }

    /// Where the first bracket of a value stands that is not closed, or that one of another kind closes.
    pub(super) fn unclosed_bracket(&self) -> Option<usize> {
        self.bracket_around(self.text.len())
    }

    /// Where the first bracket stands that is open at this place, or that one of another kind closes before.
    pub(super) fn bracket_around(&self, at: usize) -> Option<usize> {
        let mut open: Vec<&Token> = Vec::new();
        let mut in_value = false;
        let before = self.tokens.iter();
        for token in before.take_while(|token| token.span().start() < at) {
            let opening = match token.kind() {
                TokenKind::RightSquareBracket => TokenKind::LeftSquareBracket,
                TokenKind::RightCurlyBracket => TokenKind::LeftCurlyBracket,
                TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket if in_value => {
                    open.push(token);
                    continue;
                }
                TokenKind::Equals => {
                    in_value = true;
                    continue;
                }
                TokenKind::Newline if open.is_empty() => {
                    in_value = false;
                    continue;
                }
                _ => continue,
            };
            if let Some(last) = open.pop()
                && last.kind() != opening
            {
                return Some(last.span().start());
            }
        }
        open.first().map(|token| token.span().start())
    }

    /// The places of a line.
    pub(super) fn line_range(&self, at: usize) -> Range<usize> {
        let (before, behind) = self.text.split_at(at);
        let start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let end = behind.find('\n').map_or(self.text.len(), |end| at + end);
        start..end
    }

    /// A line without the remark at its end.
    pub(super) fn line(&self, at: usize) -> &'a str {
        let Range { start, end } = self.line_range(at);
        let is_remark = |token: &&Token| {
            token.kind() == TokenKind::Comment && (start..end).contains(&token.span().start())
        };
        let remark = self.tokens.iter().find(is_remark);
        let end = remark.map_or(end, |remark| remark.span().start());
        self.text[start..end].trim()
    }

    /// The first number of a line that has a comma in place of its point, and what was meant.
    pub(super) fn number_with_comma(&self, at: usize) -> Option<(&'a str, String)> {
        let line = self.line_range(at);
        let tokens = self.tokens.iter();
        let here: Vec<&Token> = tokens
            .filter(|token| line.contains(&token.span().start()))
            .collect();
        let mut equals = (0..here.len()).filter(|index| here[*index].kind() == TokenKind::Equals);
        equals.find_map(|equals| {
            let is_space = |token: &&&Token| token.kind() == TokenKind::Whitespace;
            let is_part = |token: &&&Token| {
                let kind = token.kind();
                [TokenKind::Atom, TokenKind::Dot, TokenKind::Comma].contains(&kind)
            };
            let behind = here[equals + 1..].iter().skip_while(is_space);
            let parts: Vec<&&Token> = behind.take_while(is_part).collect();
            let (first, last) = (parts.first()?, parts.last()?);
            let given = self.text.get(first.span().start()..last.span().end())?;
            let given = given.trim_end_matches(',');
            Some((given, number_with_comma(given, |_| true)?))
        })
    }

    /// The words at a place, without those in quotes.
    pub(super) fn run(&self, at: usize) -> Option<Run<'a>> {
        let is_part = |index: usize| {
            let kind = self.tokens.get(index).map(Token::kind);
            matches!(
                kind,
                Some(TokenKind::Atom | TokenKind::Dot | TokenKind::Whitespace)
            )
        };
        let mut tokens = self.tokens.iter();
        let here = tokens.position(|token| at < token.span().end());
        let here = here.unwrap_or(self.tokens.len());
        let mut near = [Some(here), here.checked_sub(1)].into_iter().flatten();
        let middle = near.find(|index| is_part(*index))?;
        let first = (0..=middle)
            .rev()
            .take_while(|index| is_part(*index))
            .last()?;
        let last = (middle..self.tokens.len())
            .take_while(|index| is_part(*index))
            .last()?;
        let [start, end] = [first, last].map(|index| self.tokens[index].span());
        let before = first.checked_sub(1)?;
        Some(Run {
            words: self.text.get(start.start()..end.end())?.trim(),
            before: self.tokens.get(before).map(Token::kind),
        })
    }

    fn words(&self, token: &Token) -> &'a str {
        let span = token.span();
        self.text.get(span.start()..span.end()).unwrap_or_default()
    }
}

/// The quotes of a text.
fn quotes(kind: TokenKind) -> Option<&'static str> {
    match kind {
        TokenKind::BasicString => Some("\""),
        TokenKind::LiteralString => Some("'"),
        TokenKind::MlBasicString => Some("\"\"\""),
        TokenKind::MlLiteralString => Some("'''"),
        _ => None,
    }
}

/// Whether a text ends with its quotes. A backslash makes a quote a part of the text.
fn is_closed(token: &str, quotes: &str) -> bool {
    let behind = token.strip_prefix(quotes);
    behind
        .and_then(|behind| behind.strip_suffix(quotes))
        .is_some_and(|inside| {
            let backslashes = inside.len() - inside.trim_end_matches('\\').len();
            quotes.starts_with('\'') || backslashes % 2 == 0
        })
}
