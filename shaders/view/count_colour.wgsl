// The colours of counts, by a logarithmic scale: dark violet at 4 or fewer through red to pale yellow at 256
// or more.
//
// Gives: count_colour.

// The ends of the scale, in powers of two.
const LOG_FEWEST: f32 = 2.0;
const LOG_MOST: f32 = 8.0;

// Lightness grows linearly along the scale, so that it can also be read without its hues.
fn count_colour(count: f32) -> vec3<f32> {
    let share = (log2(max(count, 1.0)) - LOG_FEWEST) / (LOG_MOST - LOG_FEWEST);
    let t = clamp(share, 0.0, 1.0);
    return from_oklab(0.24 + 0.705 * t, 0.05 + t * (0.42 - 0.49 * t), t * (0.30 - 0.10 * t) - 0.10);
}
