//! The documents: every file, link and heading that they name exists.

use crate::root;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Folders at the top that a path in backticks may begin with.
const TOP: [&str; 9] = [
    "src",
    "crates",
    "shaders",
    "tests",
    "docs",
    "assets",
    "scripts",
    "packaging",
    ".github",
];
/// The sources of crates and modules, by the name that a path in the documents may begin with.
const SOURCES: [(&str, &str); 10] = [
    ("geometry", "crates/lightfall-model/src/geometry"),
    ("scene", "crates/lightfall-model/src/scene"),
    ("optics", "crates/lightfall-optics/src"),
    ("gpu", "crates/lightfall-gpu/src"),
    ("accuracy", "crates/lightfall-accuracy/src"),
    ("lab", "crates/lightfall-lab/src"),
    ("galaxy", "crates/lightfall-galaxy/src"),
    ("platform", "crates/lightfall-platform/src"),
    ("render", "crates/lightfall-render/src"),
    ("picture", "crates/lightfall-picture/src"),
];

#[test]
fn every_file_that_the_documents_name_exists() {
    let mut faults = Vec::new();
    for (file, text) in documents() {
        for (number, line) in text.lines().enumerate() {
            for path in line.split('`').skip(1).step_by(2) {
                if is_missing(path) {
                    faults.push(format!("{}:{}: {path}", file.display(), number + 1));
                }
            }
        }
    }
    assert!(faults.is_empty(), "no such file:\n{}", faults.join("\n"));
}

#[test]
fn every_link_of_the_documents_leads_to_a_file_and_a_heading() {
    let documents = documents();
    let mut faults = Vec::new();
    let mut links = 0;
    for (file, text) in &documents {
        for (number, line) in text.lines().enumerate() {
            for rest in line.split("](").skip(1) {
                let link = rest.split(')').next().unwrap_or_default();
                links += usize::from(!link.is_empty());
                if !link.starts_with("https://") && !leads_somewhere(&documents, file, link) {
                    faults.push(format!("{}:{}: {link}", file.display(), number + 1));
                }
            }
        }
    }
    assert!(links > 30, "{links} links found");
    assert!(faults.is_empty(), "dead links:\n{}", faults.join("\n"));
}

/// The Markdown files at the top, in docs/ and in docs/physics/, by their path from the top.
fn documents() -> BTreeMap<PathBuf, String> {
    let mut found = BTreeMap::new();
    for folder in ["", "docs", "docs/physics"] {
        for entry in fs::read_dir(root().join(folder)).expect("the folder can be read") {
            let path = entry.expect("the folder can be listed").path();
            if path.extension().is_some_and(|extension| extension == "md") {
                let text = fs::read_to_string(&path).expect("a document is UTF-8");
                let name = path.file_name().expect("a file has a name");
                found.insert(Path::new(folder).join(name), text);
            }
        }
    }
    found
}

/// Whether text in backticks is a path to nothing. Patterns and commands are not paths. Of a
/// path with the placeholder NAME the folder must exist.
fn is_missing(text: &str) -> bool {
    let text = text.split("NAME").next().unwrap_or_default();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
    let Some((top, rest)) = text.split_once('/') else {
        return false;
    };
    let folder = match SOURCES.iter().find(|(name, _)| *name == top) {
        Some((_, folder)) => folder,
        None if TOP.contains(&top) => top,
        None => return false,
    };
    text.chars().all(is_plain) && !root().join(folder).join(rest).exists()
}

fn leads_somewhere(documents: &BTreeMap<PathBuf, String>, from: &Path, link: &str) -> bool {
    let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
    let target = if path.is_empty() {
        from.to_owned()
    } else {
        let folder = from.parent().unwrap_or(Path::new(""));
        normal(&folder.join(path))
    };
    if anchor.is_empty() {
        return root().join(target).exists();
    }
    documents.get(&target).is_some_and(|text| {
        text.lines()
            .any(|line| heading_anchor(line) == Some(anchor.into()))
    })
}

/// The path without `..`.
fn normal(path: &Path) -> PathBuf {
    let mut result = PathBuf::new();
    for part in path {
        if part == ".." {
            result.pop();
        } else {
            result.push(part);
        }
    }
    result
}

/// The anchor that hosts of Markdown give a heading: its words in lower case, joined by hyphens.
fn heading_anchor(line: &str) -> Option<String> {
    let title = line.strip_prefix('#')?.trim_start_matches('#').trim();
    let kept = |c: &char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_');
    let anchor: String = title.to_lowercase().chars().filter(kept).collect();
    Some(anchor.replace(' ', "-"))
}

#[test]
fn a_path_to_nothing_is_missing_and_a_command_is_not() {
    assert!(is_missing("src/nowhere.rs"));
    assert!(is_missing("geometry/nowhere.rs"));
    assert!(!is_missing("geometry/kerr.rs"));
    assert!(!is_missing("src/main.rs"));
    assert!(!is_missing("tests/*.rs"));
    assert!(!is_missing("shaders/view/NAME.wgsl"));
    assert!(is_missing("shaders/views/NAME.wgsl"));
    assert!(!is_missing("lightfall presets show NAME"));
}

#[test]
fn a_heading_has_the_anchor_that_hosts_of_markdown_give_it() {
    let anchor = heading_anchor("## The window (F1), and `more`");
    assert_eq!(anchor.as_deref(), Some("the-window-f1-and-more"));
    assert_eq!(heading_anchor("text"), None);
}
