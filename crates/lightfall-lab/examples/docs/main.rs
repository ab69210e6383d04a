//! Writes the tables and plots of the documents: measured ones from the CSV files in docs/bench, and
//! the promises from the program's constants. With `--check` it writes nothing, and fails if a table
//! or a plot differs. `scripts/docs` runs it at the top of the repository.

mod accuracy;
mod bench;
mod document;
mod extremes;
mod measured;
mod passes;
mod plots;
mod render;
mod scenes;
mod timings;

use lightfall_model::scene::promises;
use std::error::Error;
use std::fs;
use std::process::ExitCode;

const DOCUMENTS: [&str; 4] = [
    "docs/ACCURACY.md",
    "docs/EXTREMES.md",
    "docs/PASSES.md",
    "docs/SCENES.md",
];

/// The table with this name in a document.
fn table(name: &str) -> Result<String, String> {
    match name {
        "promises" => Ok(promises::table()),
        "auto" => accuracy::auto(),
        "others" => accuracy::others(),
        "refine" => accuracy::refine(),
        "delay" => accuracy::delay(),
        "light" => accuracy::light(),
        "medium" => accuracy::medium(),
        "pictures" => accuracy::pictures(),
        "flight" => accuracy::flight(),
        "totals" => extremes::totals(),
        "matrix" => extremes::matrix(),
        "hits" => extremes::hits(),
        "delays" => extremes::delays(),
        "hunts" => extremes::hunts(),
        "matter" => extremes::matter(),
        "passes" => passes::passes(),
        "methods" => passes::methods(),
        "living" => passes::living(),
        "omissions" => scenes::omissions(),
        "timings" => timings::sources(),
        _ => Err(format!("nothing renders table {name}")),
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let check = std::env::args().any(|argument| argument == "--check");
    let mut files = plots::all()?;
    for path in DOCUMENTS {
        let text = fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
        let text = document::rendered(&text, table).map_err(|error| format!("{path}: {error}"))?;
        files.push((path.to_owned(), text));
    }
    let mut differing = Vec::new();
    for (path, text) in files {
        let former = fs::read_to_string(&path).unwrap_or_default();
        if former == text {
            continue;
        }
        if check {
            differing.push(difference(&path, &former, &text));
        } else {
            fs::write(&path, text)?;
        }
    }
    for difference in &differing {
        println!("{difference}");
    }
    if !differing.is_empty() {
        println!("scripts/docs writes these files anew");
        return Ok(ExitCode::FAILURE);
    }
    Ok(ExitCode::SUCCESS)
}

/// A sentence about the first line in which a file differs from what it should be.
fn difference(path: &str, former: &str, right: &str) -> String {
    let mut pairs = former.lines().zip(right.lines());
    match pairs.find(|(former, right)| former != right) {
        Some((former, right)) => {
            format!("{path} says\n    {former}\nand its source says\n    {right}")
        }
        None => format!("{path} has another length than its source gives it"),
    }
}
