//! `lightfall --list-gpus`.

use super::output::print;
use super::stop::Stop;
use lightfall_core::gpu;
use lightfall_platform::log::say;

/// Lists the graphics adapters. An adapter name that no adapter has is an error here too.
pub(super) fn list_adapters() -> Result<(), Stop> {
    gpu::check_adapter().map_err(Stop::without_device)?;
    let lines: String = gpu::adapters()
        .iter()
        .map(|adapter| format!("{adapter}\n"))
        .collect();
    print(&lines)?;
    if let Some(hidden) = gpu::about_hidden_adapters() {
        say(format_args!("lightfall: {hidden}"));
    }
    Ok(())
}
