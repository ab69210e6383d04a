// REFINE: traces a turned grid of rays through each marked pixel and writes the mean of their light.
// A workgroup refines sixteen pixels with 4 rays each, four with 16, or one with 64.
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

// The place of a ray within its pixel. The grid is turned, so that no two rays have the same row or
// column: thin upright or level lines, such as the rings at the shadow's edge, meet as many rays as
// slanting ones. The offset of the frame moves each ray within its own cell of the grid.
fn place_in_grid(cell: vec2<u32>, side: u32) -> vec2<f32> {
    let turned = vec2<f32>(f32(cell.y), f32(side - 1u - cell.x)) + 0.5;
    let within = fract(turned / f32(side) + scene.picture.offset);
    return (vec2<f32>(cell) + within) / f32(side);
}

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
    let own_mark = (index - first_group) * (WORKGROUP_SIZE / rays) + lane / rays;
    let mark = min(own_mark, max(count, 1u) - 1u);
    let length = arrayLength(&list);
    let at = list[select(select(mark, length - 1u - mark, fine), length / 2u + mark, bent)];
    let width = max(textureDimensions(picture).x, 1u);
    let pixel = vec2<u32>(at % width, at / width);
    // The same within the scene's own part of the picture.
    let part = pixel - vec2<u32>(scene.picture.corner);

    let ray = lane % rays;
    own_lane = lane;
    own_share = 1.0 / f32(rays);
    lane_beside = lane ^ 1u;
    lane_below = lane ^ side;
    let place = shown_place(corner_of(part) + place_in_grid(vec2<u32>(ray % side, ray / side), side));
    let seen = light_along(photon_from(pixel_direction(place)));
    lights[lane] = vec4<f32>(bounded_light(seen.rgb), seen.a);
    workgroupBarrier();

    // One lane adds the light of a pixel's rays, always in the same order.
    if ray == 0u && own_mark < count {
        var sum = vec4<f32>(0.0);
        for (var i = 0u; i < rays; i++) {
            sum += lights[lane + i];
        }
        let mean = sum / f32(rays);
        let whole = coverage(place_of(part)) * bounded_light(mean.rgb + point_light(part));
        textureStore(picture, pixel, vec4<f32>(whole, mean.a));
    }
}
