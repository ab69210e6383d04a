// The class of a ray, by which the search for edges compares pixels: its outcome and its number of
// hits in one number.
//
// Gives: NO_CLASS, is_class_captured, ray_class.

// A pixel without a ray: the foreground covers it.
const NO_CLASS: u32 = 0u;

// Two bits for the outcome and two for the number of hits, plus one so that no ray has NO_CLASS.
fn ray_class(outcome: u32, hit_count: u32) -> u32 {
    return 1u + outcome + 4u * hit_count;
}

fn is_class_captured(seen_class: u32) -> bool {
    return seen_class != NO_CLASS && (seen_class - 1u) % 4u == OUTCOME_CAPTURED;
}
