//! Links a shader: finds the files that give what its entry points need.

use super::fault::ShaderFault;
use super::files::{ShaderFile, ShaderFiles};
use std::collections::HashSet;

/// A file that a shader chooses among several that give the same name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Choice {
    /// Its name below shaders/. It is not joined if nothing needs it.
    pub file: String,
    /// A function of the file that is renamed, and its new name.
    pub renamed: Option<(&'static str, &'static str)>,
}

impl Choice {
    /// The file of this name.
    pub(crate) fn of(file: impl Into<String>) -> Self {
        Self {
            file: file.into(),
            renamed: None,
        }
    }

    /// The file with its function `own` renamed to `other`, so that another file can define `own`
    /// and call it.
    pub(super) fn renaming(self, own: &'static str, other: &'static str) -> Self {
        Self {
            renamed: Some((own, other)),
            ..self
        }
    }
}

/// The files of a shader: those that give its entry points, and the files that these need, each
/// after those that it needs.
///
/// A constant before the files takes precedence over them. Of several files that give a name, the
/// linker takes the one among the choices, or the one that is linked for another name.
///
/// An entry point without such a file, and a name for which there are several, are faults. A name
/// that no file gives is WGSL's own, or the compiler says that nothing declares it.
pub(super) fn link<'a>(
    files: &'a ShaderFiles,
    entries: &[&str],
    choices: &[Choice],
    is_constant: impl Fn(&str) -> bool,
) -> (Vec<&'a ShaderFile>, Option<ShaderFault>) {
    let mut linker = Linker {
        files,
        choices,
        is_constant,
        seen: HashSet::new(),
        linked: Vec::new(),
        open: Vec::new(),
        fault: None,
    };
    for entry in entries {
        linker.add_giver_of(entry, None);
    }
    for (name, needing) in std::mem::take(&mut linker.open) {
        let count = linker.givers(name).filter(|file| linker.has(file)).count();
        if count != 1 {
            linker.fail(name, needing);
        }
    }
    (linker.linked, linker.fault)
}

struct Linker<'a, 'b, F> {
    files: &'a ShaderFiles,
    choices: &'b [Choice],
    is_constant: F,
    /// The names of the files that are linked or about to be.
    seen: HashSet<&'a str>,
    linked: Vec<&'a ShaderFile>,
    /// Names that several files give, of which none is a choice, and the files that need them.
    open: Vec<(&'b str, Option<&'a ShaderFile>)>,
    fault: Option<ShaderFault>,
}

impl<'a: 'b, 'b, F: Fn(&str) -> bool> Linker<'a, 'b, F> {
    /// Links the file that gives a name to `needing`, which is `None` for an entry point.
    fn add_giver_of(&mut self, name: &'b str, needing: Option<&'a ShaderFile>) {
        let givers: Vec<_> = self.givers(name).collect();
        if (self.is_constant)(name) || givers.is_empty() && needing.is_some() {
            return;
        }
        let chosen: Vec<_> = givers
            .iter()
            .copied()
            .filter(|file| self.choice(file).is_some())
            .collect();
        match (&givers[..], &chosen[..]) {
            ([file], _) | (_, [file]) => self.add(file),
            ([], _) | (_, [_, _, ..]) => self.fail(name, needing),
            (_, []) => self.open.push((name, needing)),
        }
    }

    fn add(&mut self, file: &'a ShaderFile) {
        if !self.seen.insert(&file.name) {
            return;
        }
        for name in &file.needs {
            self.add_giver_of(name, Some(file));
        }
        self.linked.push(file);
    }

    /// The files that give a name, after renaming.
    fn givers(&self, name: &str) -> impl Iterator<Item = &'a ShaderFile> {
        let own_name = |choice: &Choice| choice.renamed.filter(|(_, other)| *other == name);
        let own_name = self.choices.iter().find_map(own_name).map(|(own, _)| own);
        let files = self.files.giving(own_name.unwrap_or(name));
        files.filter(move |file| {
            let renamed = self.choice(file).and_then(|choice| choice.renamed);
            match own_name {
                Some(_) => renamed.is_some(),
                None => renamed.is_none_or(|(own, _)| own != name),
            }
        })
    }

    fn choice(&self, file: &ShaderFile) -> Option<&'b Choice> {
        self.choices.iter().find(|choice| choice.file == file.name)
    }

    fn has(&self, file: &ShaderFile) -> bool {
        self.seen.contains(&*file.name)
    }

    /// Records the fault of a name that no file gives, or several.
    fn fail(&mut self, name: &str, needing: Option<&ShaderFile>) {
        let givers: Vec<&str> = self.givers(name).map(|file| &*file.name).collect();
        let reason = match &givers[..] {
            [] => format!("needs `{name}`, which no file gives"),
            several => format!(
                "needs `{name}`, which {} give; the shader must choose one of them",
                several.join(", ")
            ),
        };
        self.fault.get_or_insert_with(|| ShaderFault {
            file: needing.map_or("the entry point", |file| &file.name).into(),
            line: needing.map_or(1, |file| file.line_of(name)),
            reason,
        });
    }
}
