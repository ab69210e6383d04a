//! Lightfall, watched by a test: the program with all of its command line, which writes down its
//! state after every frame and takes orders. The library of this package says what both are.

mod answers;
mod device;
mod gamepad;
mod kept_picture;
mod orders;
mod shown;
mod watch;

use bevy::app::App;
use lightfall::app::CockpitSound;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    match &arguments[..] {
        #[cfg(target_os = "linux")]
        [_, word, text] if word == watched::HOLD_CLIPBOARD => hold_clipboard(text),
        _ => lightfall::commands::run_with(add_watch),
    }
}

/// Adds what tests need to the window program, if one watches it.
fn add_watch(app: &mut App) {
    if let Some(file) = std::env::var_os(watched::STATE_FILE) {
        app.insert_resource(CockpitSound {
            may_play: false,
            ..Default::default()
        });
        app.add_plugins((
            orders::plugin,
            device::plugin,
            gamepad::plugin,
            kept_picture::plugin,
            answers::plugin,
        ));
        watch::add(app, file.into());
    }
}

/// Holds the clipboard until another program takes it.
#[cfg(target_os = "linux")]
fn hold_clipboard(text: &str) -> ExitCode {
    use arboard::SetExtLinux;
    let held = arboard::Clipboard::new().and_then(|mut board| board.set().wait().text(text));
    ExitCode::from(u8::from(held.is_err()))
}
