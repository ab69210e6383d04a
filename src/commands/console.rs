//! How the program tells the user why it ends, which on Windows needs more than standard error.
//!
//! lightfall.exe is a console program, so that `--help`, pipes and exit statuses work in a terminal. A
//! double click gives it a console of its own. The window program closes that console at once, and
//! every other one vanishes with the program, so what is written there is not read by anybody.

use lightfall_platform::log::say;
use std::io::IsTerminal;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
#[cfg(windows)]
use windows_sys::Win32::{Foundation::INVALID_HANDLE_VALUE, System::Console};

/// Where standard error leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StandardError {
    /// To a terminal. On Windows: to a console that other programs use too, such as a shell.
    Terminal,
    /// To a console that was opened for this program alone, as a double click does.
    OwnConsole,
    /// To a file or a pipe.
    Redirected,
    /// To nowhere: the program was started without a standard error.
    Nowhere,
}

impl StandardError {
    /// Whether somebody can read it after the program has ended.
    #[must_use]
    pub fn is_read(self) -> bool {
        matches!(self, Self::Terminal | Self::Redirected)
    }

    /// Where it leads to. `processes` is the number of programs that use the console.
    #[must_use]
    pub fn of(exists: bool, is_terminal: bool, processes: u32) -> Self {
        match (exists, is_terminal, processes) {
            (false, ..) => Self::Nowhere,
            (true, false, _) => Self::Redirected,
            (true, true, 1) => Self::OwnConsole,
            (true, true, _) => Self::Terminal,
        }
    }

    /// Where it led when this was asked first: a closed console cannot be asked any more.
    fn at_start() -> Self {
        static AT_START: OnceLock<StandardError> = OnceLock::new();
        *AT_START.get_or_init(standard_error)
    }
}

/// Closes the console, if it was opened for this program alone.
pub(super) fn close_own_console() {
    if StandardError::at_start() == StandardError::OwnConsole {
        close_console();
    }
}

/// Whether no message box is shown, whatever happens.
static SHOWS_NO_BOX: AtomicBool = AtomicBool::new(false);

/// Shows no message box from now on: in a window for visitors nobody would close it, and what starts the
/// program again would wait for that.
pub(super) fn show_no_box() {
    SHOWS_NO_BOX.store(true, Ordering::Relaxed);
}

/// Says why the program ends: on standard error and, where nobody reads that, in a message box.
pub(super) fn report(message: &str) {
    say(format_args!("lightfall: {message}"));
    if StandardError::at_start().is_read() || SHOWS_NO_BOX.load(Ordering::Relaxed) {
        return;
    }
    show_box(message.to_owned());
}

/// Shows a message box until the user closes it.
#[cfg(windows)]
fn show_box(message: String) {
    // On a thread of its own, because a message box runs the window's code until it is closed, and
    // after a panic that code must not run again.
    let shown = std::thread::spawn(move || {
        rfd::MessageDialog::new()
            .set_level(rfd::MessageLevel::Error)
            .set_title("Lightfall")
            .set_description(message)
            .show()
    });
    // If there is no box either, nothing is left to say it with.
    shown.join().ok();
}

/// Standard error is missing on Windows only.
#[cfg(not(windows))]
fn show_box(_: String) {}

/// Where standard error leads.
#[cfg(windows)]
#[expect(unsafe_code, reason = "Windows has no other interface to its consoles")]
fn standard_error() -> StandardError {
    // SAFETY: the call takes a constant.
    let handle = unsafe { Console::GetStdHandle(Console::STD_ERROR_HANDLE) };
    let exists = !handle.is_null() && handle != INVALID_HANDLE_VALUE;
    let mut processes = [0; 2];
    // SAFETY: the list has room for as many processes as is said.
    let count = unsafe { Console::GetConsoleProcessList(processes.as_mut_ptr(), 2) };
    StandardError::of(exists, std::io::stderr().is_terminal(), count)
}

/// Where standard error leads. A console of the program's own exists on Windows only.
#[cfg(not(windows))]
fn standard_error() -> StandardError {
    StandardError::of(true, std::io::stderr().is_terminal(), 0)
}

/// Closes the console.
#[cfg(windows)]
#[expect(unsafe_code, reason = "Windows has no other interface to its consoles")]
fn close_console() {
    // SAFETY: the calls take constants and a null handle, which means that there is none. Without the
    // latter, what is still written would go to whatever gets the closed handles next.
    unsafe {
        Console::FreeConsole();
        for stream in [
            Console::STD_INPUT_HANDLE,
            Console::STD_OUTPUT_HANDLE,
            Console::STD_ERROR_HANDLE,
        ] {
            Console::SetStdHandle(stream, std::ptr::null_mut());
        }
    }
}

/// Consoles are closed on Windows only.
#[cfg(not(windows))]
fn close_console() {}
