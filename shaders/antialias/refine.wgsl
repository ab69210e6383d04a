// REFINE: traces a regular grid of rays through each marked pixel and writes the mean of their
// light. A workgroup refines sixteen pixels with 4 rays each, four with 16, or one with 64.
//
// Gives: refine.

// As in antialias/edges.wgsl.
struct Work {
    columns: u32,
    rows: u32,
    layers: u32,
    groups: u32,
    bent: u32,
    coarse: u32,
    fine: u32,
}

@group(1) @binding(BINDING_WORK) var<storage, read> work: Work;
@group(1) @binding(BINDING_LIST) var<storage, read> list: array<u32>;
@group(1) @binding(BINDING_PICTURE) var picture: texture_storage_2d<rgba16float, write>;

var<workgroup> lights: array<vec4<f32>, WORKGROUP_SIZE>;

@compute @workgroup_size(WORKGROUP_SIZE)
fn refine(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let index = group.x * work.rows + group.y;
    let bent_groups = (work.bent + BENT_PIXELS - 1u) / BENT_PIXELS;
    let coarse_groups = (work.coarse + COARSE_PIXELS - 1u) / COARSE_PIXELS;
    // The last column of workgroups may have more of them than there is work.
    if index >= bent_groups + coarse_groups + work.fine {
        return;
    }
    // Which of the three lists, where it begins, and its grid of rays.
    let bent = index < bent_groups;
    let fine = index >= bent_groups + coarse_groups;
    let first_group = select(select(bent_groups, bent_groups + coarse_groups, fine), 0u, bent);
    let count = select(select(work.coarse, work.fine, fine), work.bent, bent);
    let side = select(select(4u, 8u, fine), 2u, bent);
    let rays = side * side;
    // A lane without a pixel traces the last one and writes nothing: all lanes must reach barriers.
    let own_place = (index - first_group) * (WORKGROUP_SIZE / rays) + lane / rays;
    let place = min(own_place, max(count, 1u) - 1u);
    let length = arrayLength(&list);
    let at = list[select(select(place, length - 1u - place, fine), length / 2u + place, bent)];
    let width = max(textureDimensions(picture).x, 1u);
    let pixel = vec2<u32>(at % width, at / width);
    // The same within the scene's own part of the picture.
    let part = pixel - vec2<u32>(scene.picture.corner);

    let ray = lane % rays;
    own_lane = lane;
    own_share = 1.0 / f32(rays);
    lane_beside = lane ^ 1u;
    lane_below = lane ^ side;
    // The offset of the frame moves each ray within its own cell of the grid.
    let cell = vec2<f32>(vec2<u32>(ray % side, ray / side)) + 0.5 + scene.picture.offset;
    let seen = light_along(photon_from(pixel_direction(vec2<f32>(part) + cell / f32(side))));
    lights[lane] = vec4<f32>(bounded_light(seen.rgb), seen.a);
    workgroupBarrier();

    // One lane adds the light of a pixel's rays, always in the same order.
    if ray == 0u && own_place < count {
        var sum = vec4<f32>(0.0);
        for (var i = 0u; i < rays; i++) {
            sum += lights[lane + i];
        }
        let mean = sum / f32(rays);
        textureStore(picture, pixel, vec4<f32>(bounded_light(mean.rgb + point_light(part)), mean.a));
    }
}
