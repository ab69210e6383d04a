// The disk model `page-thorne`: relative flux of a disk around Kerr (Page & Thorne 1974), as the
// Newtonian profile with the same edge times a correction. The table of optics/disk/page_thorne.rs
// has it as cubics, equidistant in p = sqrt(1 - sqrt(r_in / r)), from the edge at 0 to infinity at
// 1.
//
// Gives: disk_flux.

@group(0) @binding(BINDING_PAGE_THORNE) var<uniform> page_thorne: array<vec4<f32>, PAGE_THORNE_LEN>;

fn disk_flux(r: f32) -> f32 {
    let x = scene.disk.inner / max(r, TINY);
    let depth = max(1.0 - sqrt(x), 0.0);
    let position = sqrt(depth) * f32(PAGE_THORNE_LEN);
    let i = min(u32(position), PAGE_THORNE_LEN - 1u);
    let t = position - f32(i);
    let cubic = page_thorne[i];
    let correction = cubic.x + t * (cubic.y + t * (cubic.z + t * cubic.w));
    return x * x * x * depth * max(correction, 0.0);
}
