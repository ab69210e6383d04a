//! The device that the tests of one program share.

use lightfall_core::gpu::Gpu;
use std::sync::OnceLock;

/// The device. Tests that use it are ignored unless `--include-ignored` asks for them, as `./check`
/// does; then they fail if there is no adapter.
pub fn gpu() -> &'static Gpu {
    static SHARED: OnceLock<Gpu> = OnceLock::new();
    SHARED.get_or_init(|| {
        Gpu::headless()
            .unwrap_or_else(|error| panic!("this test needs a graphics adapter: {error}"))
    })
}
