// The view `classes`. Blue: the ray comes from the sky. Orange: it ends at the horizon. Magenta:
// the method gave no answer. The colour is lighter for more crossings of the disk. No two classes
// share a colour, and no two hues differ in red and green only.
//
//   crossings          0                   1                   2
//
// Gives: light_along.

const SKY_CLASSES = array<vec3<f32>, 3>(vec3(0.00, 0.02, 0.16), vec3(0.02, 0.20, 0.75), vec3(0.30, 0.75, 1.00));
const CAPTURED_CLASSES = array<vec3<f32>, 3>(vec3(0.06, 0.02, 0.00), vec3(0.60, 0.15, 0.00), vec3(1.00, 0.65, 0.05));
const UNFINISHED_CLASSES = array<vec3<f32>, 3>(vec3(1.00, 0.00, 1.00), vec3(1.00, 0.30, 1.00), vec3(1.00, 0.60, 1.00));

// Selections, because a computed index into a constant array copies the array for every ray.
fn colour_by_crossings(colours: array<vec3<f32>, 3>, count: u32) -> vec3<f32> {
    return select(select(colours[0], colours[1], count == 1u), colours[2], count == 2u);
}

fn light_along(photon: Photon) -> vec4<f32> {
    let ray = trace(photon);
    if ray.outcome == OUTCOME_SKY {
        return mark(colour_by_crossings(SKY_CLASSES, ray.hit_count));
    }
    if ray.outcome == OUTCOME_CAPTURED {
        return mark(colour_by_crossings(CAPTURED_CLASSES, ray.hit_count));
    }
    return mark(colour_by_crossings(UNFINISHED_CLASSES, ray.hit_count));
}
