// The disk's coverage and transmission.
//
// Gives: disk_cover, disk_transmission.

// The disk's coverage at radius r. Emission and opacity fade together at both edges, so that an
// edge is never darker than both the disk and what lies behind.
fn disk_cover(r: f32) -> f32 {
    let inner = (r - scene.disk.inner) / max(scene.disk.inner_fade, 1e-6);
    let outer = (scene.disk.outer - r) / max(scene.disk.outer_fade, 1e-6);
    let share = clamp(vec2<f32>(inner, outer), vec2<f32>(0.0), vec2<f32>(1.0));
    let smooth_share = share * share * (3.0 - 2.0 * share);
    return smooth_share.x * smooth_share.y;
}

// Share of the light from behind that passes through the disk at radius r.
fn disk_transmission(r: f32) -> f32 {
    return mix(1.0, scene.disk.transmission, disk_cover(r));
}
