// The sky behind a tilted disk, in whose frame rays are traced. The file of the sky mode takes
// directions in the hole's frame, and is linked with its `sky_background` renamed to
// `background_in_hole_frame` (gpu/shader/choices.rs).
//
// Gives: sky_background.

// Mirror of `GpuTilt` in gpu/scene/tilt.rs.
struct Tilt {
    // From the disk's frame to the hole's.
    hole_from_disk: mat3x3<f32>,
}

@group(0) @binding(BINDING_TILT) var<uniform> tilted_disk: Tilt;

fn in_hole_frame(v: vec3<f32>) -> vec3<f32> {
    return tilted_disk.hole_from_disk * v;
}

fn sky_background(direction: vec3<f32>, g: f32, footprint: Footprint) -> vec3<f32> {
    let turned = Footprint(in_hole_frame(footprint.to_the_right), in_hole_frame(footprint.downward));
    return background_in_hole_frame(in_hole_frame(direction), g, turned);
}
