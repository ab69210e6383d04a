// Differences between a ray and its neighbours, in a workgroup whose lanes trace square grids of
// rays. Each pair of neighbours has one difference, as in a fragment entry.
//
// Gives: differences, lane_below, lane_beside, own_lane, own_share, ray_share.

// This ray's lane, and those of its neighbours.
var<private> own_lane: u32;
var<private> lane_beside: u32;
var<private> lane_below: u32;
// The share of the pixel that this ray stands for.
var<private> own_share: f32;

var<workgroup> lanes: array<vec3<f32>, WORKGROUP_SIZE>;

// All lanes must call it before any branch.
fn differences(value: vec3<f32>) -> Footprint {
    // Other lanes may still read the last values.
    workgroupBarrier();
    lanes[own_lane] = value;
    workgroupBarrier();
    let to_the_right = select(value - lanes[lane_beside], lanes[lane_beside] - value, lane_beside > own_lane);
    let downward = select(value - lanes[lane_below], lanes[lane_below] - value, lane_below > own_lane);
    // In a turned grid neighbours are farther apart than the side of the part that a ray stands for.
    let side = scene.picture.footprint * inverseSqrt(1.0 + own_share);
    return Footprint(to_the_right * side, downward * side);
}

fn ray_share() -> f32 {
    return own_share * square(scene.picture.footprint);
}
