//! Results of commands: on standard output, and as files in a folder of reports.

use super::cli::ReportArgs;
use super::stop::Stop;
use lightfall_core::accuracy::rays::is_closed_pipe;
use lightfall_core::reason::reason;
use lightfall_lab::circumstances::Circumstances;
use lightfall_lab::export::{csv, json};
use lightfall_platform::storage;
use serde::Serialize;
use std::io::{self, Write};
use std::path::Path;

/// Writes a result to standard output.
pub(super) fn print(text: &str) -> Result<(), Stop> {
    print_to(text, &mut io::stdout().lock())
}

/// Writes a result to `out`, which errors call standard output. A reader that has closed the pipe,
/// such as `head`, is not an error.
pub(super) fn print_to(text: &str, out: &mut impl Write) -> Result<(), Stop> {
    output_result(out.write_all(text.as_bytes()).and_then(|()| out.flush()))
}

/// The result of writing to standard output, where a closed pipe is not an error.
pub(super) fn output_result(written: io::Result<()>) -> Result<(), Stop> {
    match written {
        Err(error) if !is_closed_pipe(&error) => {
            Err(Stop::failed(format!("standard output: {}", reason(&error))))
        }
        _ => Ok(()),
    }
}

/// Creates the folder of `--out` and checks that it accepts files, before any work is done for its
/// reports.
pub(super) fn create_report_folder(args: &ReportArgs) -> Result<(), Stop> {
    let Some(folder) = &args.out else {
        return Ok(());
    };
    let fault = |reason| Stop::failed(format!("--out {}: {reason}", folder.display()));
    std::fs::create_dir_all(folder).map_err(|error| {
        fault(
            match folder
                .ancestors()
                .find(|part| part.exists() && !part.is_dir())
            {
                Some(part) => format!(
                    "{} is a file, and this must be a folder, or one that can be made",
                    part.display()
                ),
                None => format!("this folder cannot be made: {}", reason(&error)),
            },
        )
    })?;
    storage::check_folder_writable(folder)
        .map_err(|error| fault(format!("no report can be written: {}", reason(&error))))
}

/// Writes one file of a report.
pub(super) fn write_report(folder: &Path, name: &str, text: &str) -> Result<(), Stop> {
    storage::write_atomically(&folder.join(name), text.as_bytes()).map_err(Stop::failed)
}

/// Writes the files of a report, NAME.csv, NAME.json and its text for people with another ending.
/// Prints the text or the JSON.
pub(super) fn publish(
    args: &ReportArgs,
    name: &str,
    circumstances: &Circumstances,
    rows: &[impl Serialize],
    (ending, text): (&str, &str),
) -> Result<(), Stop> {
    let json = json(circumstances, rows);
    if let Some(folder) = &args.out {
        let csv = csv(circumstances, rows);
        for (ending, text) in [("csv", &*csv), ("json", &*json), (ending, text)] {
            write_report(folder, &format!("{name}.{ending}"), text)?;
        }
    }
    print(if args.json { &json } else { text })
}
