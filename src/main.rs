//! The program `lightfall`; see [`lightfall::commands`].

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    lightfall::commands::run()
}

/// In a browser the page's address takes the place of the command line; see [`lightfall::page`].
#[cfg(target_arch = "wasm32")]
fn main() {
    lightfall::page::run();
}
