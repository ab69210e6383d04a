//! Fingerprints of the sources that decide the figures of each report, so that a report says which
//! sources it measured, and a test finds figures that are older than their sources.
//!
//! A report's sources are its shaders, the numbers that these are given, the measure of errors with
//! its reference, and the report's own code and scenes. Comments, blank lines and white space do not
//! count.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// What traces rays and judges them: files and folders, from the top of the repository.
const RAYS: [&str; 28] = [
    "shaders/math.wgsl",
    "shaders/scene.wgsl",
    "shaders/trace.wgsl",
    "shaders/elementary.wgsl",
    "shaders/elliptic.wgsl",
    "shaders/observer.wgsl",
    "shaders/projection",
    "shaders/shift.wgsl",
    "shaders/disk.wgsl",
    "shaders/disk/none.wgsl",
    "shaders/method",
    "shaders/delay",
    "shaders/rays.wgsl",
    "shaders/fullscreen.wgsl",
    "shaders/timed.wgsl",
    "crates/lightfall-core/src/gpu/scene",
    "crates/lightfall-core/src/gpu/shader",
    "crates/lightfall-core/src/gpu/rays.rs",
    "crates/lightfall-core/src/accuracy",
    "crates/lightfall-core/src/optics/camera_rays.rs",
    "crates/lightfall-core/src/optics/delay.rs",
    "crates/lightfall-core/src/optics/disk",
    "crates/lightfall-core/src/optics/disk.rs",
    "crates/lightfall-core/src/optics/reference.rs",
    "crates/lightfall-core/src/optics/shift.rs",
    "crates/lightfall-core/src/optics/trace.rs",
    "crates/lightfall-core/src/geometry",
    "crates/lightfall-core/src/scene/method.rs",
];

/// The scenes of `lightfall bench`, and how they are timed.
const BENCH: [&str; 5] = [
    "assets/presets",
    "crates/lightfall-core/src/gpu/timing",
    "crates/lightfall-core/src/gpu/timing.rs",
    "crates/lightfall-core/src/reports/bench/plan.rs",
    "crates/lightfall-core/src/reports/bench/scenes.rs",
];

/// What a picture is drawn with.
const PICTURES: [&str; 13] = [
    "shaders",
    "assets/presets",
    "crates/lightfall-core/src/gpu/antialias.rs",
    "crates/lightfall-core/src/gpu/presentation.rs",
    "crates/lightfall-core/src/gpu/scene",
    "crates/lightfall-core/src/gpu/shader",
    "crates/lightfall-core/src/gpu/sky_texture.rs",
    "crates/lightfall-core/src/gpu/starlight.rs",
    "crates/lightfall-core/src/gpu/stars",
    "crates/lightfall-core/src/gpu/structure.rs",
    "crates/lightfall-core/src/optics/stars",
    "crates/lightfall-core/src/optics/structure",
    "src/render",
];

/// The name of each report, which is that of its CSV file, and its own sources.
const REPORTS: [(&str, &[&[&str]]); 10] = [
    (
        "bench",
        &[
            &RAYS,
            &BENCH,
            // The time of a whole frame.
            &PICTURES,
            &[
                "crates/lightfall-core/src/reports/bench/measurement.rs",
                "crates/lightfall-core/src/reports/bench/settings.rs",
                "crates/lightfall-core/src/scene/step_policy.rs",
            ],
        ],
    ),
    (
        "delay",
        &[
            &RAYS,
            &BENCH,
            &["crates/lightfall-core/src/reports/bench/delay.rs"],
        ],
    ),
    (
        "light",
        &[
            &PICTURES,
            &BENCH,
            &["crates/lightfall-core/src/reports/bench/light.rs"],
        ],
    ),
    (
        "pictures",
        &[
            &PICTURES,
            &[
                "crates/lightfall-core/src/reports/bench/pictures.rs",
                "src/commands/bench/pictures.rs",
                "src/picture/pass_time.rs",
            ],
        ],
    ),
    (
        "refine",
        &[
            &RAYS,
            &BENCH,
            &[
                "crates/lightfall-core/src/scene/step_policy.rs",
                "crates/lightfall-core/src/reports/bench/refine.rs",
                "crates/lightfall-core/src/reports/bench/studies.rs",
            ],
        ],
    ),
    ("extremes", EXTREMES),
    ("grid", EXTREMES),
    ("delays", EXTREMES),
    ("hunt", EXTREMES),
    (
        "timings",
        &[&PICTURES, &["scripts/timings", "src/picture/pass_time.rs"]],
    ),
];

const EXTREMES: &[&[&str]] = &[&RAYS, &["crates/lightfall-core/src/reports/extremes"]];

fn main() -> Result<(), Box<dyn Error>> {
    list_shaders()?;
    let top = Path::new(&std::env::var("CARGO_MANIFEST_DIR")?).join("../..");
    let mut table = String::from("&[\n");
    for (report, groups) in REPORTS {
        let mut files = Vec::new();
        for place in groups.iter().copied().flatten() {
            println!("cargo::rerun-if-changed={}", top.join(place).display());
            add_files(&top, Path::new(place), &mut files)?;
        }
        files.sort();
        files.dedup();
        let mut fingerprint = Fingerprint::new();
        for file in &files {
            fingerprint.add(file, &fs::read_to_string(top.join(file))?);
        }
        table += &format!("    ({report:?}, \"{:08x}\", &{files:?}),\n", fingerprint.0);
    }
    let out = PathBuf::from(std::env::var("OUT_DIR")?);
    fs::write(out.join("sources.rs"), table + "]\n")?;
    Ok(())
}

/// Adds a file, or all files of a folder, with `/` between the words of each path.
fn add_files(top: &Path, place: &Path, files: &mut Vec<String>) -> Result<(), Box<dyn Error>> {
    let full = top.join(place);
    if full.is_dir() {
        for entry in fs::read_dir(full)? {
            add_files(top, &place.join(entry?.file_name()), files)?;
        }
        return Ok(());
    }
    let words: Vec<_> = place.iter().map(|word| word.to_string_lossy()).collect();
    files.push(words.join("/"));
    Ok(())
}

/// The FNV-1a hash, with 32 bits, of the code of files.
struct Fingerprint(u32);

impl Fingerprint {
    fn new() -> Self {
        Self(0x811c_9dc5)
    }

    fn add(&mut self, file: &str, text: &str) {
        let comment = match file.rsplit_once('.') {
            Some((_, "rs" | "wgsl")) => "//",
            _ => "#",
        };
        self.add_bytes(file);
        for line in text.lines() {
            self.add_bytes(line.split(comment).next().unwrap_or_default());
        }
    }

    fn add_bytes(&mut self, text: &str) {
        for byte in text.bytes().filter(|byte| !byte.is_ascii_whitespace()) {
            self.0 = (self.0 ^ u32::from(byte)).wrapping_mul(0x0100_0193);
        }
    }
}

fn list_shaders() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(&std::env::var("CARGO_MANIFEST_DIR")?).join("../../shaders");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut rows = Vec::new();
    add_shaders(&folder, "", &mut rows)?;
    rows.sort();
    let list = PathBuf::from(std::env::var("OUT_DIR")?).join("shader_files.rs");
    fs::write(list, format!("&[\n{}]\n", rows.concat()))?;
    Ok(())
}

/// Adds a row for each WGSL file of a folder and of those below it: its name, which begins with
/// `prefix`, and its text.
fn add_shaders(folder: &Path, prefix: &str, rows: &mut Vec<String>) -> Result<(), Box<dyn Error>> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let own_name = path.file_name().unwrap_or_default().to_string_lossy();
        let name = format!("{prefix}{own_name}");
        if path.is_dir() {
            add_shaders(&path, &format!("{name}/"), rows)?;
        } else if name.ends_with(".wgsl") {
            rows.push(format!("    ({name:?}, include_str!({path:?})),\n"));
        }
    }
    Ok(())
}
