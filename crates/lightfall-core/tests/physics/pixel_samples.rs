//! Places of rays within a pixel, against what defines a (0, 2)-sequence in base 2, and against
//! integrals that are known.

use glam::DVec2;
use lightfall_core::optics::pixel_samples::pixel_offset;
use std::collections::BTreeSet;

#[test]
fn the_first_place_is_the_middle_and_all_are_within_the_pixel() {
    assert_eq!(pixel_offset(0), DVec2::ZERO);
    for frame in 1..1024 {
        let at = pixel_offset(frame);
        assert!(at.abs().max_element() <= 0.5, "{frame}: {at}");
    }
}

#[test]
fn every_box_of_equal_area_has_one_place() {
    // Sobol (1967): of 2^k places from a multiple of 2^k on, one is in each of the 2^k boxes that
    // 2^i columns and 2^(k - i) rows make.
    for k in 0..=10 {
        let count = 1_u32 << k;
        for start in [0, count, 5 * count] {
            let places: Vec<DVec2> = (start..start + count)
                .map(|frame| pixel_offset(frame) + 0.5)
                .collect();
            for i in 0..=k {
                let boxes = DVec2::new(f64::from(1 << i), f64::from(1 << (k - i)));
                let filled: BTreeSet<[u32; 2]> = places
                    .iter()
                    .map(|at| (at * boxes).as_uvec2().to_array())
                    .collect();
                assert_eq!(
                    filled.len(),
                    places.len(),
                    "{count} places from {start}, {boxes}"
                );
            }
        }
    }
}

#[test]
fn the_share_of_a_pixel_beside_an_edge_is_found_far_better_than_by_random_places() {
    // Edges through a pixel at 90 angles and 20 distances: the exact area against the share of 64
    // places. Random places err by sqrt(p (1 - p) / 64), 0.05 in the mean; a (0, 2)-net errs by the
    // boxes that the edge crosses, some 2 sqrt(64) of 64 with random signs: 0.013. The bound is
    // half as much again.
    let places: Vec<DVec2> = (0..64).map(pixel_offset).collect();
    let mut squares: f64 = 0.0;
    let mut count: f64 = 0.0;
    for i in 0..90 {
        let normal = DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 90.0 + 0.01);
        for j in 0..20 {
            let distance = -0.6 + 0.06 * (f64::from(j) + 0.3);
            let inside = places.iter().filter(|at| at.dot(normal) < distance).count();
            let error = inside as f64 / 64.0 - area_beside(normal, distance);
            squares += error * error;
            count += 1.0;
        }
    }
    let rms: f64 = (squares / count).sqrt();
    assert!(rms < 0.02, "rms {rms}");
    assert!(rms > 1e-4, "an error of {rms} is too good for 64 places");
}

/// The part of the unit square about the origin whose points p have p . normal < distance: the mean
/// over columns of the part of each, by the midpoint rule with 4000 columns, which errs by less than
/// 1e-3 even where an edge is nearly upright.
fn area_beside(normal: DVec2, distance: f64) -> f64 {
    let columns = 4000;
    (0..columns)
        .map(|i| {
            let x = (f64::from(i) + 0.5) / f64::from(columns) - 0.5;
            let rest = distance - x * normal.x;
            let y = rest / normal.y;
            if normal.y > 0.0 {
                (y + 0.5).clamp(0.0, 1.0)
            } else {
                (0.5 - y).clamp(0.0, 1.0)
            }
        })
        .sum::<f64>()
        / f64::from(columns)
}
