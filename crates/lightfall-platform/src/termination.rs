//! The request to end that schedulers send some time before they kill a program: SIGTERM. Only Unix has
//! it.

use std::sync::atomic::{AtomicBool, Ordering};
#[cfg(unix)]
use std::time::Duration;

/// The exit status after the request: 128 and the signal's number, as shells count.
pub const TERMINATED: u8 = 143;

/// The program ends by itself at the next frame. If a frame takes longer than this, the program is ended
/// here: schedulers wait for half a minute or more.
#[cfg(unix)]
const MAX_WAIT: Duration = Duration::from_secs(10);

static IS_ASKED: AtomicBool = AtomicBool::new(false);

/// Whether the program has been asked to end since [`watch`].
#[must_use]
pub fn is_asked() -> bool {
    IS_ASKED.load(Ordering::Relaxed)
}

/// Notes requests to end from now on. Without it, a request ends the program at once and leaves its
/// temporary files. The same happens if the system provides no pipe or no thread.
pub fn watch() {
    #[cfg(unix)]
    {
        static BEGUN: std::sync::Once = std::sync::Once::new();
        BEGUN.call_once(|| {
            watch_signal().ok();
        });
    }
}

#[cfg(unix)]
#[expect(
    unsafe_code,
    reason = "what is done while a signal interrupts the program has to be safe there"
)]
fn watch_signal() -> std::io::Result<()> {
    use std::io::{Read, Write};

    let (mut noted, note) = std::io::pipe()?;
    let action = move || {
        IS_ASKED.store(true, Ordering::Relaxed);
        // Its reader lives as long as the program.
        (&note).write_all(&[1]).ok();
    };
    std::thread::Builder::new()
        .name("termination".into())
        .spawn(move || {
            if noted.read_exact(&mut [0]).is_ok() {
                std::thread::sleep(MAX_WAIT);
                end_at_once();
            }
        })?;
    // SAFETY: the action sets a number and writes to a pipe, which POSIX allows in a signal handler; it takes
    // no lock and asks for no memory.
    let registered = unsafe { signal_hook_registry::register(libc::SIGTERM, action) };
    registered.map(drop)
}

/// Removes temporary files and ends the program, whatever its other threads are doing.
#[cfg(unix)]
#[expect(
    unsafe_code,
    reason = "the ordinary end would run the drivers' clean-up while other threads use them"
)]
fn end_at_once() {
    crate::storage::remove_unfinished();
    // SAFETY: the function takes a number and does not return.
    unsafe { libc::_exit(TERMINATED.into()) }
}
