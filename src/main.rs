//! The program `lightfall`; see [`lightfall::commands`].

use std::process::ExitCode;

fn main() -> ExitCode {
    lightfall::commands::run()
}
