// What can be seen of a ray: by the outcome and the number of hits, the search for edges compares
// neighbouring pixels.
//
// Gives: VisibleHits, visible_outcome, with_crossing.

// A crossing counts for the class where the disk's coverage is larger: a fade is one edge, not two.
const MIN_COVER: f32 = 0.5;
// The smallest share of light from behind the counted crossings that matters for the class.
const MIN_VISIBLE: f32 = 0.02;

// The crossings of the disk that count, and the share of light from behind them that is seen.
struct VisibleHits {
    count: u32,
    share: f32,
}

// The hits with a further crossing, where the disk has this coverage.
fn with_crossing(hits: VisibleHits, cover: f32) -> VisibleHits {
    let counts = cover > MIN_COVER && hits.share > MIN_VISIBLE;
    return VisibleHits(
        hits.count + select(0u, 1u, counts),
        hits.share * select(1.0, scene.disk.transmission, counts),
    );
}

// The outcome of a ray of whose end this share is seen.
fn visible_outcome(outcome: u32, share: f32) -> u32 {
    return select(OUTCOME_HIDDEN, outcome, share > MIN_VISIBLE);
}
