//! The console of the program on Windows.
//!
//! lightfall.exe is a console program, so that `--help`, pipes and exit statuses work in a terminal. A
//! double click gives it a console of its own, which is closed at once.

use std::sync::atomic::{AtomicBool, Ordering};

/// Whether the program has closed the console that was its own. Nothing written to standard error is
/// seen from then on.
static CLOSED: AtomicBool = AtomicBool::new(false);

/// Closes the console, if it was opened for this program alone.
pub(super) fn close_own_console() {
    if is_alone() && close() {
        CLOSED.store(true, Ordering::Relaxed);
    }
}

/// Says why the program ends: on standard error or, without a console, in a message box.
pub(super) fn report(message: &str) {
    eprintln!("lightfall: {message}");
    if CLOSED.load(Ordering::Relaxed) {
        rfd::MessageDialog::new()
            .set_level(rfd::MessageLevel::Error)
            .set_title("Lightfall")
            .set_description(message)
            .show();
    }
}

/// Whether no other program uses the console of this one.
#[cfg(windows)]
#[expect(unsafe_code, reason = "Windows has no other interface to its consoles")]
fn is_alone() -> bool {
    let mut processes = [0; 2];
    // SAFETY: the list has room for as many processes as is said.
    let count = unsafe {
        windows_sys::Win32::System::Console::GetConsoleProcessList(processes.as_mut_ptr(), 2)
    };
    count == 1
}

#[cfg(windows)]
#[expect(unsafe_code, reason = "Windows has no other interface to its consoles")]
fn close() -> bool {
    // SAFETY: the call takes nothing. Writing to a closed console fails, which no writer minds.
    unsafe { windows_sys::Win32::System::Console::FreeConsole() != 0 }
}

#[cfg(not(windows))]
fn is_alone() -> bool {
    false
}

#[cfg(not(windows))]
fn close() -> bool {
    false
}
