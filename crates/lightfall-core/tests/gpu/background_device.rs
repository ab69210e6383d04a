//! The device of background work: shared, and replaced only after it failed.

use glam::DVec3;
use lightfall_core::gpu::{GpuError, rays, with_background_device};
use lightfall_core::scene::Scene;

fn trace_a_ray() -> Result<usize, GpuError> {
    with_background_device(|gpu| rays::trace(gpu, &Scene::default(), &[DVec3::Z]))
        .map(|traces| traces.len())
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_refused_scene_keeps_the_background_device_and_a_lost_device_is_replaced() {
    let device = with_background_device(|gpu| Ok(gpu.device.clone())).unwrap();
    let refused = with_background_device(|_| Err::<(), _>(GpuError::MethodOfCpu));
    assert_eq!(refused, Err(GpuError::MethodOfCpu));
    // Losing the device from before the refusal matters only if it is still in use.
    device.destroy();
    let lost = trace_a_ray();
    assert!(
        lost.as_ref().is_err_and(GpuError::is_device_failure),
        "{lost:?}"
    );
    assert_eq!(trace_a_ray(), Ok(1));
}
