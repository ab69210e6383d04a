//! Which file uses which: every import followed through renames and re-exports to the file that
//! defines the name.

use crate::source::{Import, Source};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// A module's path, beginning with its crate: `["lightfall_core", "scene", "limits"]`.
pub type Module = Vec<String>;

/// One file that uses another, and the line that says so.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Use {
    /// The module that imports.
    pub from: Module,
    /// The module whose file defines what is imported.
    pub to: Module,
    /// Line of the import in `from`'s file.
    pub line: usize,
    /// The path as it is written.
    pub path: String,
}

/// The source files of several crates.
#[derive(Default)]
pub struct Graph {
    files: BTreeMap<Module, (String, Source)>,
}

/// What a path leads to: a module, or an item in a module's file.
enum Target {
    Module(Module),
    Item(Module),
}

impl Graph {
    /// Adds one file: its place below the crate's `src` folder, its name in messages, its text.
    /// `main.rs` is a crate of its own, as Cargo has it.
    pub fn add(&mut self, crate_name: &str, place: &str, shown: &str, text: &str) {
        let stem = place.strip_suffix(".rs").unwrap_or(place);
        let mut module = vec![crate_name.to_owned()];
        match stem {
            "lib" => {}
            "main" => module = vec!["main".to_owned()],
            _ => module.extend(stem.split('/').map(str::to_owned)),
        }
        if module.last().is_some_and(|last| last == "mod") {
            module.pop();
        }
        self.files
            .insert(module, (shown.to_owned(), Source::read(text)));
    }

    /// Adds every Rust file below `folder`, which is named from `root` in messages.
    pub fn add_folder(&mut self, crate_name: &str, root: &Path, folder: &str) {
        let mut folders = vec![root.join(folder)];
        while let Some(open) = folders.pop() {
            for entry in std::fs::read_dir(&open).expect("the source folder can be read") {
                let path = entry.expect("the source folder can be listed").path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|extension| extension == "rs") {
                    let text = std::fs::read_to_string(&path).expect("a source file is UTF-8");
                    let below = |base: &Path| {
                        let place = path.strip_prefix(base).expect("the file is below it");
                        place.to_string_lossy().replace('\\', "/")
                    };
                    self.add(crate_name, &below(&root.join(folder)), &below(root), &text);
                }
            }
        }
    }

    /// Every module that has a file.
    pub fn modules(&self) -> impl Iterator<Item = &Module> {
        self.files.keys()
    }

    /// The name of a module's file, as messages show it.
    pub fn file(&self, module: &Module) -> &str {
        self.files.get(module).map_or("", |(shown, _)| shown)
    }

    /// Imports of modules that are written inside a file, one sentence for each.
    pub fn inline_imports(&self) -> Vec<String> {
        let mut found = Vec::new();
        for (shown, source) in self.files.values() {
            for (name, line) in &source.importing_inline_modules {
                found.push(format!(
                    "{shown}:{line}: the module {name} imports something and has no file of its own"
                ));
            }
        }
        found
    }

    /// Every use of one file by another, in order. A parent that only re-exports what a module
    /// below it defines does not use that module.
    pub fn uses(&self) -> Vec<Use> {
        let mut found = BTreeSet::new();
        for (from, (_, source)) in &self.files {
            let mut add = |to: Module, path: &[String], line| {
                if to != *from {
                    let (from, path) = (from.clone(), path.join("::"));
                    found.insert(Use {
                        from,
                        to,
                        line,
                        path,
                    });
                }
            };
            for import in &source.imports {
                if let Some(to) = self.defining_module(from, &import.path)
                    && !is_mere_reexport(from, &to, import, source)
                {
                    add(to, &import.path, import.line);
                }
            }
            for inline in &source.paths {
                if let Some(to) = self.defining_module(from, &inline.path) {
                    add(to, &inline.path, inline.line);
                }
            }
        }
        found.into_iter().collect()
    }

    /// The module whose file defines what `path`, written in `from`, names; `None` outside the
    /// crates.
    fn defining_module(&self, from: &Module, path: &[String]) -> Option<Module> {
        match self.resolve(from, path, &mut BTreeSet::new())? {
            Target::Module(module) | Target::Item(module) => Some(module),
        }
    }

    fn resolve(
        &self,
        from: &Module,
        path: &[String],
        seen: &mut BTreeSet<(Module, String)>,
    ) -> Option<Target> {
        let (first, mut rest) = path.split_first()?;
        let mut target = match first.as_str() {
            "crate" => Target::Module(vec![from[0].clone()]),
            "self" => Target::Module(from.clone()),
            "super" => Target::Module(parent(from)?),
            name if self.files.contains_key([name.to_owned()].as_slice()) => {
                Target::Module(vec![name.to_owned()])
            }
            name => self.member(from, name, seen)?,
        };
        while let (Target::Module(module), Some((name, after))) = (&target, rest.split_first()) {
            target = match name.as_str() {
                "super" => Target::Module(parent(module)?),
                // What a macro defines is not seen by name; it is in the module's own file.
                name => self
                    .member(module, name, seen)
                    .unwrap_or_else(|| Target::Item(module.clone())),
            };
            rest = after;
        }
        Some(target)
    }

    /// What `name` means inside `module`: a module below it, an import, or an item of its own.
    fn member(
        &self,
        module: &Module,
        name: &str,
        seen: &mut BTreeSet<(Module, String)>,
    ) -> Option<Target> {
        let mut below = module.clone();
        below.push(name.to_owned());
        if self.files.contains_key(&below) {
            return Some(Target::Module(below));
        }
        let (_, source) = self.files.get(module)?;
        if source.definitions.contains(name) {
            return Some(Target::Item(module.clone()));
        }
        if !seen.insert((module.clone(), name.to_owned())) {
            return None;
        }
        let by_name = |import: &&Import| import.name.as_deref() == Some(name);
        for import in source.imports.iter().filter(by_name) {
            if let Some(target) = self.resolve(module, &import.path, seen) {
                return Some(target);
            }
        }
        for import in source.imports.iter().filter(|import| import.is_glob) {
            if let Some(Target::Module(inside)) = self.resolve(module, &import.path, seen)
                && let Some(target) = self.member(&inside, name, seen)
            {
                return Some(target);
            }
        }
        None
    }
}

fn parent(module: &Module) -> Option<Module> {
    (module.len() > 1).then(|| module[..module.len() - 1].to_vec())
}

fn is_mere_reexport(from: &Module, to: &Module, import: &Import, source: &Source) -> bool {
    let names_it = |name: &String| source.refers_to(name);
    import.is_public && to.starts_with(from) && !import.name.as_ref().is_some_and(names_it)
}
