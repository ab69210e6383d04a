//! The header of every WGSL file: the names that it gives to others.

use crate::shaders::other_shaders;
use crate::variants::every_variant;
use lightfall_core::gpu::{ShaderText, Variant};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

type Names = BTreeSet<String>;

/// A file's text, or that of the constants in front of the files.
struct Part {
    /// The names that it declares outside of functions and structs.
    declared: Names,
    /// Its entry points.
    entry_points: Names,
    /// Every other name in it.
    mentioned: Names,
}

impl Part {
    fn new(text: &str) -> Self {
        let (mut declared, mut entry_points) = (Names::new(), Names::new());
        let mut mentioned = Names::new();
        let mut attribute = String::new();
        for line in text.lines() {
            let code = line.split("//").next().unwrap_or("");
            if let Some(name) = declaration(code) {
                let is_entry = ["@vertex", "@fragment", "@compute"]
                    .iter()
                    .any(|stage| attribute.starts_with(stage));
                if is_entry {
                    entry_points.insert(name.clone());
                }
                declared.insert(name);
            }
            attribute = code.into();
            mentioned.extend(names_in(code));
        }
        mentioned.retain(|name| !declared.contains(name));
        Self {
            declared,
            entry_points,
            mentioned,
        }
    }
}

/// The name that a line declares, if it is a declaration that is not indented.
fn declaration(line: &str) -> Option<String> {
    let line = match line.split_once("var<") {
        Some((attributes, rest)) if attributes.is_empty() || attributes.starts_with('@') => {
            rest.split_once("> ")?.1
        }
        _ => ["fn ", "struct ", "const ", "alias "]
            .iter()
            .find_map(|keyword| line.strip_prefix(keyword))?,
    };
    names_in(line).next()
}

/// The identifiers of a line, without those of members (after a dot).
fn names_in(line: &str) -> impl Iterator<Item = String> {
    let mut names = Vec::new();
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut before = ' ';
    let mut rest = line;
    while let Some(first) = rest.chars().next() {
        let length = rest.find(|c| !is_part(c)).unwrap_or(rest.len()).max(1);
        let (word, after) = rest.split_at(length);
        if (first.is_ascii_alphabetic() || first == '_') && before != '.' {
            names.push(word.to_string());
        }
        before = word.chars().last().unwrap_or(' ');
        rest = after;
    }
    names.into_iter()
}

const GIVES: &str = "// Gives:";

/// The names that a header lists.
fn header(text: &str) -> Option<Names> {
    let mut lines = text
        .lines()
        .take_while(|line| line.starts_with("//"))
        .skip_while(|line| !line.starts_with(GIVES));
    let mut list = lines.next()?.strip_prefix(GIVES)?.to_string();
    for line in lines.take_while(|line| line.starts_with("//     ")) {
        list += line.trim_start_matches('/');
    }
    let list = list.strip_suffix('.')?;
    let names = list.split(',').map(|name| name.trim().to_string());
    Some(names.collect())
}

/// A header's list, as it should be.
fn expected(names: &Names) -> String {
    let mut text = GIVES.to_string();
    let mut width = text.len();
    for (i, name) in names.iter().enumerate() {
        let end = if i + 1 == names.len() { "." } else { "," };
        if width + name.len() + 2 > 100 {
            text += "\n//    ";
            width = 6;
        }
        text += &format!(" {name}{end}");
        width += name.len() + 2;
    }
    text
}

/// Every set of files that is joined, once.
fn joined_texts() -> Vec<ShaderText> {
    let mut seen = BTreeSet::new();
    let variants = every_variant()
        .into_iter()
        .filter(|variant| seen.insert(variant.files()));
    let mut texts: Vec<ShaderText> = variants.map(Variant::text).collect();
    texts.extend(other_shaders().into_iter().map(|(text, _)| text));
    texts
}

#[test]
fn every_file_is_in_a_shader_and_states_what_it_gives() {
    // A file that is joined under another name for one of its functions, its header included, is a
    // text of its own.
    let mut gives: BTreeMap<(String, String), Names> = BTreeMap::new();
    for text in joined_texts() {
        let parts: Vec<_> = text
            .files()
            .map(|(file, text)| ((file.to_owned(), text.to_owned()), Part::new(text)))
            .collect();
        for (file, part) in &parts {
            let given = gives.entry(file.clone()).or_default();
            given.extend(part.entry_points.clone());
            for (_, other) in parts.iter().filter(|(other, _)| other != file) {
                given.extend(part.declared.intersection(&other.mentioned).cloned());
            }
        }
    }
    let mut unused = files_below_shaders();
    unused.retain(|file| !gives.keys().any(|(used, _)| used == file));
    assert!(unused.is_empty(), "no shader needs {unused:?}");
    let wrong: Vec<String> = gives
        .into_iter()
        .filter(|((_, text), given)| header(text).as_ref() != Some(given))
        .map(|((name, _), given)| format!("{name}:\n{}", expected(&given)))
        .collect();
    assert!(
        wrong.is_empty(),
        "the header of these files should be:\n{}",
        wrong.join("\n")
    );
}

/// The paths of all files below shaders/.
fn files_below_shaders() -> Vec<String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shaders");
    let (mut files, mut folders) = (Vec::new(), vec![PathBuf::from(folder)]);
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let below = path.strip_prefix(folder).unwrap();
                let words: Vec<_> = below.iter().map(|word| word.to_string_lossy()).collect();
                files.push(words.join("/"));
            }
        }
    }
    files
}
