//! Copy, cut and paste in the panel's text fields.

use crate::desktop::Desktop;
use crate::{PLAIN, place, unfold_texts};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Text that another program holds.
const FOREIGN: &str = "from afar · δ";

/// How long a busy machine may take.
const PATIENCE: Duration = Duration::from_secs(20);

/// A program that holds the clipboard until another program takes it. This is no test: the test of
/// pasting starts it.
#[test]
#[ignore = "started by the test of pasting"]
fn started_program_that_holds_the_clipboard() {
    use arboard::SetExtLinux;
    arboard::Clipboard::new()
        .unwrap()
        .set()
        .wait()
        .text(FOREIGN)
        .unwrap();
}

fn holder(desktop: &Desktop) -> Child {
    let only = [
        "--exact",
        "pasting::started_program_that_holds_the_clipboard",
        "--ignored",
        "--test-threads=1",
    ];
    let mut command = Command::new(std::env::current_exe().unwrap());
    let holder = command
        .args(only)
        .env("DISPLAY", desktop.display())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    wait("the other program's text", || {
        desktop.clipboard().as_deref() == Some(FOREIGN)
    });
    holder
}

#[track_caller]
fn wait(what: &str, condition: impl Fn() -> bool) {
    let start = Instant::now();
    while !condition() {
        assert!(start.elapsed() < PATIENCE, "{what}");
        std::thread::sleep(Duration::from_millis(100));
    }
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn text_fields_copy_cut_and_paste_within_the_program_and_with_others() {
    let desktop = Desktop::open(&["--preset", PLAIN]);
    desktop.settled("first picture", |shot| shot.colours() > 50);
    desktop.press("p");
    desktop.settled("panel", |_| true);
    // The field `title` is also the title of the window.
    unfold_texts(&desktop);
    desktop.click(place::PANEL_TITLE);
    let titled = |title: &str| {
        let whole = if title.is_empty() {
            "Lightfall".to_owned()
        } else {
            format!("Lightfall: {title}")
        };
        let start = Instant::now();
        while desktop.title() != whole {
            assert!(
                start.elapsed() < PATIENCE,
                "{:?} and not {whole:?}",
                desktop.title()
            );
            std::thread::sleep(Duration::from_millis(100));
        }
    };
    desktop.chord("ctrl", "a");
    desktop.type_text("gp");
    titled("gp");
    desktop.chord("ctrl", "a");
    desktop.chord("ctrl", "c");
    wait("what was copied", || {
        desktop.clipboard().as_deref() == Some("gp")
    });
    desktop.chord("ctrl", "x");
    titled("");
    desktop.chord("ctrl", "v");
    titled("gp");
    desktop.chord("shift", "Insert");
    titled("gpgp");
    let mut other = holder(&desktop);
    desktop.chord("ctrl", "v");
    titled(&format!("gpgp{FOREIGN}"));
    desktop.chord("ctrl", "a");
    desktop.chord("ctrl", "x");
    titled("");
    wait("what was cut", || {
        desktop.clipboard() == Some(format!("gpgp{FOREIGN}"))
    });
    other.wait().unwrap();
    assert!(!desktop.stderr().contains("ERROR"), "{}", desktop.stderr());
}
