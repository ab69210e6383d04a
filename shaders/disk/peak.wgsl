// How bright the brightest place of a disk is.
//
// Gives: brightest_disk_light.

// The largest flux of a disk, in the unit of its brightness (optics/photometry.rs).
const DISK_PEAK: f32 = 0.057;

fn brightest_disk_light() -> f32 {
    return DISK_PEAK * scene.disk.brightness;
}
