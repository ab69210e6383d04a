//! The device that the tests of one program share.

use lightfall::gpu::{Gpu, GpuError};
use std::sync::OnceLock;

/// The device; none, and said so, where there is no adapter and none is required by
/// LIGHTFALL_REQUIRE_GPU=1.
pub fn gpu() -> Option<&'static Gpu> {
    static SHARED: OnceLock<Result<Gpu, GpuError>> = OnceLock::new();
    let required = std::env::var("LIGHTFALL_REQUIRE_GPU").is_ok_and(|value| value == "1");
    match SHARED.get_or_init(Gpu::headless) {
        Ok(gpu) => Some(gpu),
        Err(error) if required => panic!("LIGHTFALL_REQUIRE_GPU is 1, but {error}"),
        Err(GpuError::NoAdapter) => {
            println!("skipped: no adapter");
            None
        }
        Err(error) => panic!("{error}"),
    }
}
