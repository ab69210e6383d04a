//! The name of the machine.

/// The name of this machine on its network, if it has one.
#[must_use]
pub fn host_name() -> Option<String> {
    let name = gethostname::gethostname().into_string().ok()?;
    Some(name).filter(|name| !name.is_empty())
}
