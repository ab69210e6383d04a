//! Whether a window can be opened here, found out before the window system is started.

#[cfg(target_os = "linux")]
use lightfall_core::reason::reason;
#[cfg(target_os = "linux")]
use std::{
    ffi::OsString, io::ErrorKind, os::unix::net::UnixStream, path::Path, sync::LazyLock,
    time::Duration,
};
#[cfg(target_os = "linux")]
use x11rb::{errors::ConnectError, rust_connection::RustConnection};

/// The display on which a window can be opened.
///
/// # Errors
/// There is no display. One clause says what is missing.
#[cfg(target_os = "linux")]
pub fn display() -> Result<String, String> {
    let wayland = variable("WAYLAND_DISPLAY");
    if let Some(name) = wayland.as_ref().filter(|name| wayland_answers(name)) {
        return Ok(format!("Wayland, {}", name.to_string_lossy()));
    }
    match (variable("DISPLAY"), wayland) {
        (None, None) => Err("neither DISPLAY nor WAYLAND_DISPLAY names one".into()),
        (None, Some(name)) => Err(format!(
            "the Wayland server {} does not answer",
            name.to_string_lossy()
        )),
        (Some(name), _) => match x_connection() {
            Ok(_) => Ok(format!("X11, {}", name.to_string_lossy())),
            Err(error) => Err(format!(
                "the X server {} does not answer: {}",
                name.to_string_lossy(),
                match error {
                    ConnectError::IoError(error) => reason(error),
                    other => other.to_string(),
                }
            )),
        },
    }
}

/// Whether a Wayland server is named that does not answer, while an X server does.
#[cfg(target_os = "linux")]
#[must_use]
pub fn prefers_dead_wayland() -> bool {
    variable("WAYLAND_DISPLAY").is_some_and(|name| !wayland_answers(&name))
        && variable("DISPLAY").is_some()
        && x_connection().is_ok()
}

/// How often an X server is asked that is there and does not answer, and the time between two
/// questions: a server that starts anew needs less than a second.
#[cfg(target_os = "linux")]
const TRIES: u32 = 5;
#[cfg(target_os = "linux")]
const BETWEEN_TRIES: Duration = Duration::from_millis(300);

/// The program's own connection to the X server. It stays open as long as the program runs: a server
/// without other clients starts anew when its last one leaves, and refuses those that come meanwhile.
#[cfg(target_os = "linux")]
pub(crate) fn x_connection() -> &'static Result<RustConnection, ConnectError> {
    static CONNECTION: LazyLock<Result<RustConnection, ConnectError>> = LazyLock::new(|| {
        let mut tries = 1;
        loop {
            let absent = |error: &ConnectError| match error {
                ConnectError::IoError(error) => {
                    matches!(
                        error.kind(),
                        ErrorKind::ConnectionRefused | ErrorKind::NotFound
                    )
                }
                ConnectError::DisplayParsingError(_) | ConnectError::SetupFailed(_) => true,
                _ => false,
            };
            match x11rb::connect(None) {
                Ok((connection, _)) => return Ok(connection),
                Err(error) if absent(&error) || tries == TRIES => return Err(error),
                Err(_) => tries += 1,
            }
            std::thread::sleep(BETWEEN_TRIES);
        }
    });
    &CONNECTION
}

/// The value of a variable of the environment, unless it is empty.
#[cfg(target_os = "linux")]
fn variable(name: &str) -> Option<OsString> {
    std::env::var_os(name).filter(|value| !value.is_empty())
}

/// Whether a Wayland server answers. Its name is that of a socket in XDG_RUNTIME_DIR, or a path.
#[cfg(target_os = "linux")]
fn wayland_answers(name: &OsString) -> bool {
    let folder = variable("XDG_RUNTIME_DIR").unwrap_or_default();
    let socket = Path::new(&folder).join(name);
    socket.is_absolute() && UnixStream::connect(socket).is_ok()
}

/// The desktop, which other systems always have.
///
/// # Errors
/// None.
#[cfg(not(target_os = "linux"))]
pub fn display() -> Result<String, String> {
    Ok("the desktop".into())
}

/// Other systems have no Wayland.
#[cfg(not(target_os = "linux"))]
#[must_use]
pub fn prefers_dead_wayland() -> bool {
    false
}
