//! What one source file imports, names by path and defines.

use crate::tokens::{Token, tokens};
use std::collections::BTreeSet;

/// One name brought in by a `use` line, with groups taken apart.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// The full path as it is written, without the name after `as`.
    pub path: Vec<String>,
    /// The name that it has in this file; `None` for `*` and `as _`.
    pub name: Option<String>,
    /// Whether the path ends in `*`.
    pub is_glob: bool,
    /// Whether it is re-exported (`pub use`, also `pub(crate) use`).
    pub is_public: bool,
    /// Line of the path's last word.
    pub line: usize,
}

/// A path of at least two words outside `use` lines, such as `super::fields::read`.
#[derive(Clone, Debug, PartialEq)]
pub struct InlinePath {
    /// Its words.
    pub path: Vec<String>,
    /// Line of the first word.
    pub line: usize,
}

/// One source file as the import check sees it.
#[derive(Clone, Debug, Default)]
pub struct Source {
    /// Every name that `use` lines bring in, also those inside functions.
    pub imports: Vec<Import>,
    /// Every path in the code itself.
    pub paths: Vec<InlinePath>,
    /// The names of the items defined at the top of the file.
    pub definitions: BTreeSet<String>,
    /// Modules written inside the file that import something, with the line. The check reads one
    /// module per file, so it cannot follow their imports.
    pub importing_inline_modules: Vec<(String, usize)>,
    /// The words of the code outside `use` lines that can name an item.
    words: BTreeSet<String>,
}

impl Source {
    /// Reads the text of a file.
    pub fn read(text: &str) -> Self {
        let tokens = tokens(text);
        let mut source = Self::default();
        let (mut at, mut depth) = (0, 0_usize);
        let mut inline_modules: Vec<(String, usize)> = Vec::new();
        while at < tokens.len() {
            let line = tokens[at].line;
            let found = (source.imports.len(), source.paths.len());
            match word(&tokens, at) {
                "use" if word(&tokens, at + 1) != "<" => {
                    at = source.read_use(&tokens, at);
                    source.note_inline_module(&inline_modules, line, found);
                    continue;
                }
                "pub" if word(&tokens, at + 1) == "(" => {
                    at = skip_to(&tokens, at, ")");
                    continue;
                }
                "{" => depth += 1,
                "}" => {
                    depth = depth.saturating_sub(1);
                    inline_modules.retain(|(_, outside)| *outside < depth);
                }
                "mod" if word(&tokens, at + 2) == "{" => {
                    inline_modules.push((word(&tokens, at + 1).to_owned(), depth));
                }
                _ => {}
            }
            if depth == 0 {
                source.definitions.extend(definition(&tokens, at));
            }
            at = source.read_path(&tokens, at);
            source.note_inline_module(&inline_modules, line, found);
        }
        source
    }

    /// Notes the innermost of the open inline modules if there are more imports and paths than
    /// `before`.
    fn note_inline_module(
        &mut self,
        open: &[(String, usize)],
        line: usize,
        before: (usize, usize),
    ) {
        if let Some((name, _)) = open.last()
            && before != (self.imports.len(), self.paths.len())
        {
            self.importing_inline_modules.push((name.clone(), line));
        }
    }

    /// Whether code outside `use` lines refers to `name`.
    pub fn refers_to(&self, name: &str) -> bool {
        self.words.contains(name)
    }

    /// Reads the `use` line at `at` and returns where it ends.
    fn read_use(&mut self, tokens: &[Token], at: usize) -> usize {
        let is_public = at > 0 && matches!(word(tokens, at - 1), "pub" | ")");
        let first = self.imports.len();
        let mut end = self.read_tree(tokens, at + 1, &[]);
        for import in &mut self.imports[first..] {
            import.is_public = is_public;
        }
        while end < tokens.len() && word(tokens, end) != ";" {
            end += 1;
        }
        end + 1
    }

    /// Reads one branch of a `use` line, whose words so far are `prefix`, and returns its end.
    fn read_tree(&mut self, tokens: &[Token], mut at: usize, prefix: &[String]) -> usize {
        let mut path = prefix.to_vec();
        let mut line = 0;
        loop {
            match word(tokens, at) {
                "::" => at += 1,
                "{" => {
                    at += 1;
                    while at < tokens.len() && word(tokens, at) != "}" {
                        at = self.read_tree(tokens, at, &path);
                        if word(tokens, at) == "," {
                            at += 1;
                        }
                    }
                    return at + 1;
                }
                "*" => {
                    let line = tokens[at].line;
                    self.add_import(path, None, true, line);
                    return at + 1;
                }
                "self" if !prefix.is_empty() => {
                    line = tokens[at].line;
                    at += 1;
                }
                "as" => {
                    let name = word(tokens, at + 1).to_owned();
                    let name = (name != "_").then_some(name);
                    self.add_import(path, name, false, line);
                    return at + 2;
                }
                "," | ";" | "}" | "" => {
                    let name = path.last().cloned();
                    self.add_import(path, name, false, line);
                    return at;
                }
                segment => {
                    path.push(segment.to_owned());
                    line = tokens[at].line;
                    at += 1;
                }
            }
        }
    }

    fn add_import(&mut self, path: Vec<String>, name: Option<String>, is_glob: bool, line: usize) {
        self.imports.push(Import {
            path,
            name,
            is_glob,
            is_public: false,
            line,
        });
    }

    /// Reads the path or word at `at` and returns where it ends.
    fn read_path(&mut self, tokens: &[Token], at: usize) -> usize {
        if !is_identifier(word(tokens, at)) {
            return at + 1;
        }
        let mut path = vec![word(tokens, at).to_owned()];
        let mut end = at + 1;
        while word(tokens, end) == "::" && is_identifier(word(tokens, end + 1)) {
            path.push(word(tokens, end + 1).to_owned());
            end += 2;
        }
        let before = if at == 0 { "" } else { word(tokens, at - 1) };
        let is_member = matches!(before, "." | "fn" | "mod" | "let" | "mut");
        let first = &path[0];
        let names_item = first.starts_with(char::is_uppercase)
            || path.len() > 1
            || matches!(word(tokens, end), "(" | "!" | "::");
        if !is_member && names_item {
            self.words.insert(first.clone());
        }
        if path.len() > 1 {
            let line = tokens[at].line;
            self.paths.push(InlinePath { path, line });
        }
        end
    }
}

fn word(tokens: &[Token], at: usize) -> &str {
    tokens.get(at).map_or("", |token| &token.text)
}

fn is_identifier(text: &str) -> bool {
    text.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

fn skip_to(tokens: &[Token], at: usize, wanted: &str) -> usize {
    (at..tokens.len())
        .find(|&i| word(tokens, i) == wanted)
        .map_or(tokens.len(), |i| i + 1)
}

/// The name that the item beginning at `at` defines, if an item begins there.
fn definition(tokens: &[Token], at: usize) -> Option<String> {
    let name = match word(tokens, at) {
        "fn" | "struct" | "enum" | "union" | "trait" | "type" | "const" | "static" => at + 1,
        "macro_rules" => at + 2,
        _ => return None,
    };
    let name = word(tokens, name);
    let is_name = is_identifier(name) && !matches!(name, "fn" | "unsafe" | "extern" | "mut");
    is_name.then(|| name.to_owned())
}
