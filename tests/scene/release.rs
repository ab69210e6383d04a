//! The workflow that makes the downloads, and the texts that lie in them or beside them: every file and
//! command that they name exists, and `lightfall` understands every command line in them.

use lightfall::commands::cli::{self, Command};
use lightfall::commands::presets;
use saphyr::{LoadableYamlNode, Yaml};
use std::fs;
use std::path::{Path, PathBuf};

/// Folders at the top that the workflow makes. Everything else that it names is in the tree.
const MADE: [&str; 8] = [
    "target",
    "built",
    "downloads",
    "pictures",
    "butler",
    "windows",
    "linux",
    "macos",
];

/// What a workflow names, and what is wrong with it.
#[derive(Default)]
struct Findings {
    /// Commands of the tree that it runs.
    scripts: Vec<String>,
    /// Command lines of the program.
    lines: Vec<String>,
    faults: Vec<String>,
}

#[test]
fn every_file_and_command_of_the_release_workflow_exists() {
    let findings = examine(&workflow());
    assert_eq!(findings.faults, [""; 0]);
    for script in [
        "packaging/archive",
        "packaging/linux/try",
        "packaging/web/build",
    ] {
        assert!(findings.scripts.contains(&script.into()), "{script}");
    }
    for command in ["doctor", "render"] {
        let count = |line: &&String| line.split(' ').any(|word| word == command);
        assert!(
            findings.lines.iter().filter(count).count() >= 2,
            "{command}"
        );
    }
}

#[test]
fn a_fault_of_the_release_workflow_is_found() {
    let workflow = workflow();
    for (right, wrong) in [
        ("packaging/archive aarch64", "packaging/pack aarch64"),
        ("packaging/web/build", "pakaging/web/build"),
        ("packaging/linux/try", "packaging/linux/README.txt"),
        ("path: pictures/*", "path: picture/*"),
        ("lightfall.exe doctor", "lightfall.exe docter"),
        ("--size 640x360 -o macos.png", "--size 640 -o macos.png"),
        ("--preset 2 --size", "--preset \"2 --size"),
        ("needs: pack", "needs: packs"),
        ("actions/checkout@v4", "actions/checkout"),
        ("    name: linux", "  name: linux"),
    ] {
        assert!(workflow.contains(right), "{right}");
        let broken = workflow.replace(right, wrong);
        assert_ne!(
            examine(&broken).faults,
            examine(&workflow).faults,
            "{wrong} is no fault"
        );
    }
}

#[test]
fn the_readmes_of_the_downloads_hold_command_lines_that_the_program_understands() {
    for system in ["windows", "linux", "macos"] {
        let text = read(&format!("packaging/{system}/README.txt"));
        let lines: Vec<_> = text.lines().filter_map(program_line).collect();
        assert!(lines.len() >= 3, "{system}: {lines:?}");
        for words in lines {
            if let Err(error) = cli::read(&words) {
                // Help is an error with status 0.
                assert_eq!(error.exit_code(), 0, "{system}: {words:?}: {error}");
            }
        }
    }
}

#[test]
fn the_preset_of_the_downloads_can_be_drawn() {
    let file = root().join("packaging/my-place.toml");
    let line = ["lightfall", "presets", "check"].map(PathBuf::from);
    let Ok(Command::Presets(check)) = cli::read(line.into_iter().chain([file])) else {
        panic!("the line checks a preset")
    };
    presets(&check, &mut Vec::new()).unwrap();
}

#[test]
fn the_pictures_of_the_page_exist() {
    let page = read("packaging/itch/page.md");
    let is_end = |c: char| c.is_whitespace() || ",|)".contains(c);
    let pictures: Vec<_> = page
        .split(is_end)
        .filter(|word| word.ends_with(".png"))
        .collect();
    assert!(pictures.len() > 3, "{pictures:?}");
    for picture in pictures {
        assert!(root().join(picture).is_file(), "{picture}");
    }
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(file: &str) -> String {
    fs::read_to_string(root().join(file)).unwrap()
}

fn workflow() -> String {
    read(".github/workflows/release.yml")
}

fn examine(workflow: &str) -> Findings {
    let mut findings = Findings::default();
    let documents = match Yaml::load_from_str(workflow) {
        Ok(documents) => documents,
        Err(error) => {
            findings.faults.push(error.to_string());
            return findings;
        }
    };
    let Some(jobs) = documents
        .first()
        .and_then(|document| document.as_mapping_get("jobs"))
    else {
        findings.faults.push("there are no jobs".into());
        return findings;
    };
    for job in jobs.as_mapping().into_iter().flat_map(|jobs| jobs.values()) {
        for needed in list(job.as_mapping_get("needs")) {
            if !jobs.contains_mapping_key(needed) {
                findings
                    .faults
                    .push(format!("needs {needed}, which is no job"));
            }
        }
        for step in job
            .as_mapping_get("steps")
            .and_then(Yaml::as_vec)
            .into_iter()
            .flatten()
        {
            findings.examine_step(step);
        }
    }
    findings
}

/// The words of a value that is one word or a list of words.
fn list<'a>(value: Option<&'a Yaml<'a>>) -> Vec<&'a str> {
    let Some(value) = value else {
        return Vec::new();
    };
    match value.as_vec() {
        Some(words) => words.iter().filter_map(|word| word.as_str()).collect(),
        None => value.as_str().into_iter().collect(),
    }
}

impl Findings {
    fn examine_step(&mut self, step: &Yaml) {
        let text = |key| step.as_mapping_get(key).and_then(Yaml::as_str);
        match (text("run"), text("uses")) {
            (Some(script), None) => script.lines().for_each(|line| self.examine_line(line)),
            (None, Some(action)) if is_pinned(action) => {}
            _ => self
                .faults
                .push(format!("a step neither runs nor uses: {step:?}")),
        }
        let path = step
            .as_mapping_get("with")
            .and_then(|with| with.as_mapping_get("path"));
        if let Some(path) = path.and_then(Yaml::as_str) {
            self.examine_path(path);
        }
    }

    fn examine_line(&mut self, line: &str) {
        let Some(words) = shlex::split(line) else {
            self.faults
                .push(format!("a quotation mark is missing: {line}"));
            return;
        };
        for word in &words {
            self.examine_path(word.trim_start_matches("$(").trim_end_matches(')'));
        }
        if let Some(words) = program_line(line) {
            match cli::read(&words) {
                Ok(_) => self.lines.push(line.to_owned()),
                Err(error) => self.faults.push(format!("{line}: {error}")),
            }
        }
    }

    /// Examines a word that may be a path from the top.
    fn examine_path(&mut self, word: &str) {
        let Some((top, _)) = word.split_once('/') else {
            return;
        };
        let is_elsewhere = top.is_empty() || top.starts_with('$') || top.ends_with(':');
        if is_elsewhere || MADE.contains(&top) {
            return;
        }
        let path = root().join(word);
        if !path.exists() {
            self.faults.push(format!("{word}: no such file"));
        } else if !is_executable(&path) {
            self.faults.push(format!("{word}: no command"));
        } else {
            self.scripts.push(word.to_owned());
        }
    }
}

/// Whether an action is one of a stated major version.
fn is_pinned(action: &str) -> bool {
    action
        .split_once("@v")
        .is_some_and(|(name, version)| name.contains('/') && version.parse::<u32>().is_ok())
}

/// The words of a line that starts the program.
fn program_line(line: &str) -> Option<Vec<String>> {
    let words = shlex::split(line)?;
    let program = Path::new(words.first()?).file_stem()?;
    (program == "lightfall").then_some(words)
}

#[cfg(unix)]
fn is_executable(path: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    path.is_file() && path.metadata().unwrap().permissions().mode() & 0o111 != 0
}

#[cfg(not(unix))]
fn is_executable(path: &Path) -> bool {
    path.is_file()
}
