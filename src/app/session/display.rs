//! Whether a window can be opened here, found out before the window system is started.

/// The display on which a window can be opened.
///
/// # Errors
/// There is no display. One clause says what is missing.
#[cfg(target_os = "linux")]
pub fn display() -> Result<String, String> {
    let set = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty());
    let wayland = set("WAYLAND_DISPLAY");
    if let Some(name) = &wayland
        && let Some(folder) = set("XDG_RUNTIME_DIR")
        && std::os::unix::net::UnixStream::connect(std::path::Path::new(&folder).join(name)).is_ok()
    {
        return Ok(format!("Wayland, {}", name.to_string_lossy()));
    }
    match (set("DISPLAY"), wayland) {
        (None, None) => Err("neither DISPLAY nor WAYLAND_DISPLAY names one".into()),
        (None, Some(name)) => Err(format!(
            "the Wayland server {} does not answer",
            name.to_string_lossy()
        )),
        (Some(name), _) => match x11rb::connect(None) {
            Ok(_) => Ok(format!("X11, {}", name.to_string_lossy())),
            Err(error) => Err(format!(
                "the X server {} does not answer: {error}",
                name.to_string_lossy()
            )),
        },
    }
}

/// The desktop, which other systems always have.
///
/// # Errors
/// None.
#[cfg(not(target_os = "linux"))]
pub fn display() -> Result<String, String> {
    Ok("the desktop".into())
}
