//! Where the labels of a plot's points stand, so that none covers another one or a point.

/// A rectangle in pixels: left, top, right, bottom.
type Frame = [i32; 4];

/// Room about a point, in pixels.
const POINT: i32 = 6;
/// Places tried for a label, the best first: steps to the right and down, a step being half of its
/// own size and of the room about the point.
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

/// Upper left corners, relative to its point, of a label of each size (width, height) beside each
/// point, in order; none where there is no room for it. Nothing stands on `taken`.
pub(super) fn placed(
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
