//! Copy, cut and paste in the panel's text fields.

use crate::desktop::{Desktop, PROGRAM};
use crate::{PLAIN, unfold_texts};
use std::process::{Child, Command};
use watched::HOLD_CLIPBOARD;

/// Text that another program holds.
const FOREIGN: &str = "from afar · δ";

/// Starts a program that holds the clipboard until another program takes it.
fn holder(desktop: &Desktop) -> Child {
    let holder = Command::new(PROGRAM)
        .args([HOLD_CLIPBOARD, FOREIGN])
        .env("DISPLAY", desktop.display())
        .spawn()
        .unwrap();
    desktop.wait("the other program's text", || {
        desktop.clipboard().as_deref() == Some(FOREIGN)
    });
    holder
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn text_fields_copy_cut_and_paste_within_the_program_and_with_others() {
    let desktop = Desktop::open(&["--preset", PLAIN]);
    desktop.press("p");
    // The field `title` is also the title of the window.
    unfold_texts(&desktop);
    desktop.click_field("Title");
    let titled = |title: &str| {
        let whole = if title.is_empty() {
            "Lightfall".to_owned()
        } else {
            format!("Lightfall: {title}")
        };
        desktop.wait(&whole, || desktop.title() == whole);
    };
    desktop.chord("ctrl", "a");
    desktop.type_text("gp");
    titled("gp");
    desktop.chord("ctrl", "a");
    desktop.chord("ctrl", "c");
    desktop.wait("what was copied", || {
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
    desktop.wait("what was cut", || {
        desktop.clipboard() == Some(format!("gpgp{FOREIGN}"))
    });
    other.wait().unwrap();
    desktop.end_without_error();
}
