//! `lightfall --list-gpus`.

use super::output::print;
use super::stop::Stop;
use lightfall_core::gpu;
use lightfall_platform::log::say;

/// Lists the graphics adapters with their numbers. A request for an adapter that means none of them, or
/// several, is an error here too.
pub(super) fn list_adapters() -> Result<(), Stop> {
    gpu::check_adapter().map_err(Stop::without_device)?;
    let lines: String = gpu::numbered(&gpu::adapters())
        .iter()
        .map(|line| format!("{line}\n"))
        .collect();
    print(&lines)?;
    if let Some(hidden) = gpu::about_hidden_adapters() {
        say(format_args!("lightfall: {hidden}"));
    }
    Ok(())
}
