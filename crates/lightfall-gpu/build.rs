//! Lists the shaders, whose texts are part of the program.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
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
