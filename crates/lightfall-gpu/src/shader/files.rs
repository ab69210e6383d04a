//! The files that shaders are linked from, with their headers.

use lightfall_model::reason::reason;
use lightfall_model::text;
use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};
use std::fs;
use std::io;
use std::path::Path;
use std::sync::LazyLock;

/// The name and the text of every file below shaders/ when the program was built.
const BUILT_IN: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/shader_files.rs"));

/// WGSL files, with the names that each needs and gives.
#[derive(Clone, Debug)]
pub struct ShaderFiles {
    files: Vec<ShaderFile>,
    /// The places in `files` of those that give a name.
    givers: HashMap<String, Vec<usize>>,
}

/// A WGSL file.
#[derive(Clone, Debug)]
pub(super) struct ShaderFile {
    /// Its path below the folder of shaders, with `/` between the words.
    pub name: Cow<'static, str>,
    pub text: Cow<'static, str>,
    /// The names in its code that it does not introduce itself, in alphabetical order: what it needs
    /// from other files and from the constants before them, and the words of WGSL.
    pub needs: Vec<String>,
    /// The names that it gives to others.
    gives: Vec<String>,
}

impl ShaderFiles {
    /// The files as they were when the program was built.
    pub fn built_in() -> &'static Self {
        static FILES: LazyLock<ShaderFiles> = LazyLock::new(|| {
            let files = BUILT_IN.iter();
            ShaderFiles::new(files.map(|&(name, text)| ShaderFile::new(name, text)))
        });
        &FILES
    }

    /// The WGSL files of a folder, and of the folders below it.
    ///
    /// # Errors
    /// A file or a folder cannot be read; the error names it.
    pub fn read(folder: &Path) -> io::Result<Self> {
        let mut files = Vec::new();
        add_files(folder, "", &mut files)?;
        // The order of a folder's files is the system's.
        files.sort_by(|a: &ShaderFile, b| a.name.cmp(&b.name));
        Ok(Self::new(files.into_iter()))
    }

    fn new(files: impl Iterator<Item = ShaderFile>) -> Self {
        let files: Vec<_> = files.collect();
        let mut givers: HashMap<String, Vec<usize>> = HashMap::new();
        for (place, file) in files.iter().enumerate() {
            for name in &file.gives {
                givers.entry(name.clone()).or_default().push(place);
            }
        }
        Self { files, givers }
    }

    /// The files that give a name.
    pub(super) fn giving(&self, name: &str) -> impl Iterator<Item = &ShaderFile> {
        let places = self.givers.get(name).into_iter().flatten();
        places.map(|place| &self.files[*place])
    }
}

impl ShaderFile {
    fn new(name: impl Into<Cow<'static, str>>, text: impl Into<Cow<'static, str>>) -> Self {
        let text = text.into();
        Self {
            name: name.into(),
            needs: foreign_names(&text),
            gives: given_names(&text),
            text,
        }
    }

    /// The first line with this name in its code, counted from 1.
    pub(super) fn line_of(&self, name: &str) -> usize {
        let mut lines = self.text.lines();
        let line = lines.position(|line| words(code(line)).any(|(_, word, _)| word == name));
        line.unwrap_or(0) + 1
    }
}

/// The names that a header lists after `Gives`: on that line, and on indented lines below it.
fn given_names(text: &str) -> Vec<String> {
    const GIVES: &str = "// Gives: ";
    let mut lines = text.lines().skip_while(|line| !line.starts_with(GIVES));
    let first = lines.next().map(|line| &line[GIVES.len()..]);
    let further = lines.take_while(|line| line.starts_with("//     "));
    let listed = first.into_iter().chain(further).flat_map(words);
    listed.map(|(_, name, _)| name.to_owned()).collect()
}

/// The names in a text's code that it does not introduce as a declaration or a variable, nor, unless
/// it calls them, as a parameter or a field.
fn foreign_names(text: &str) -> Vec<String> {
    let [mut used, mut called, mut declared, mut typed] = [const { BTreeSet::new() }; 4];
    for line in text.lines() {
        let mut last = "";
        for (before, word, after) in words(code(line)) {
            if matches!(last, "alias" | "const" | "fn" | "let" | "struct" | "var") {
                declared.insert(word);
            } else if after.starts_with(':') {
                typed.insert(word);
            } else if after.starts_with('(') {
                called.insert(word);
            } else if !before.ends_with(['.', '@']) {
                used.insert(word);
            }
            last = word;
        }
    }
    let used = used.difference(&typed).chain(&called);
    let foreign: BTreeSet<_> = used.filter(|name| !declared.contains(*name)).collect();
    foreign.into_iter().map(|name| (*name).into()).collect()
}

/// A line without its comment.
fn code(line: &str) -> &str {
    line.split("//").next().unwrap_or_default()
}

/// The words of a line, each with what is between the last one and it, and what follows it.
fn words(line: &str) -> impl Iterator<Item = (&str, &str, &str)> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut rest = line;
    std::iter::from_fn(move || {
        let (before, word) = rest.split_at(rest.find(is_part)?);
        let length = word.find(|c| !is_part(c)).unwrap_or(word.len());
        let (word, after) = word.split_at(length);
        rest = after;
        Some((before, word, after))
    })
}

fn add_files(folder: &Path, prefix: &str, files: &mut Vec<ShaderFile>) -> io::Result<()> {
    let named = |path: &Path, error: io::Error| {
        io::Error::new(
            error.kind(),
            format!("{}: {}", path.display(), reason(&error)),
        )
    };
    for entry in fs::read_dir(folder).map_err(|error| named(folder, error))? {
        let path = entry.map_err(|error| named(folder, error))?.path();
        let own_name = path.file_name().unwrap_or_default().to_string_lossy();
        let name = format!("{prefix}{own_name}");
        if path.is_dir() {
            add_files(&path, &format!("{name}/"), files)?;
        } else if name.ends_with(".wgsl") {
            let bytes = fs::read(&path).map_err(|error| named(&path, error))?;
            let text = text::decode(bytes).map_err(|error| {
                io::Error::new(
                    io::ErrorKind::InvalidData,
                    format!("{} {error}", path.display()),
                )
            })?;
            files.push(ShaderFile::new(name, text));
        }
    }
    Ok(())
}
