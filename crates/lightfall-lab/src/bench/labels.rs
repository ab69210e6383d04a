//! The positions of a plot's labels, none of which covers another one or a point.

/// A rectangle in pixels: left, top, right, bottom.
type Frame = [i32; 4];

/// Free space around a point, in pixels.
const POINT: i32 = 6;
/// Positions that are tried for a label, the best first: steps to the right and down. A step is
/// half the label's size plus the free space around the point.
const PLACES: [[i32; 2]; 12] = [
    [1, -1],
    [1, 1],
    [-1, -1],
    [-1, 1],
    [0, -1],
    [0, 1],
    [1, 0],
    [-1, 0],
    [1, -2],
    [-1, -2],
    [1, 2],
    [-1, 2],
];

/// Places a label of the given size (width, height) at each point. Returns the labels' upper left
/// corners relative to their points, in order; `None` where there is no room. No label covers the
/// rectangle `taken`.
pub(super) fn place_labels(
    points: &[[i32; 2]],
    sizes: &[[i32; 2]],
    taken: Frame,
) -> Vec<Option<[i32; 2]>> {
    let mut frames: Vec<Frame> = points
        .iter()
        .map(|[x, y]| [x - POINT, y - POINT, x + POINT, y + POINT])
        .chain([taken])
        .collect();
    let mut place = |[x, y]: [i32; 2], [width, height]: [i32; 2]| {
        let corner = PLACES.into_iter().map(|[right, down]| {
            [
                right * (width / 2 + POINT) - width / 2,
                down * (height / 2 + POINT / 2) - height / 2,
            ]
        });
        let mut frames_at = corner.map(|[left, top]| {
            (
                [left, top],
                [x + left, y + top, x + left + width, y + top + height],
            )
        });
        let (corner, frame) =
            frames_at.find(|(_, frame)| !frames.iter().any(|other| overlap(frame, other)))?;
        frames.push(frame);
        Some(corner)
    };
    points
        .iter()
        .zip(sizes)
        .map(|(point, size)| place(*point, *size))
        .collect()
}

fn overlap(a: &Frame, b: &Frame) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}
