//! The physics against independent results: closed forms, published values, identities, and a code
//! that uses other coordinates and another integrator.
#![allow(
    clippy::print_stderr,
    reason = "what a test says is read beside its result"
)]
#![allow(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

mod accuracy;
mod apparent_hole;
mod bisect;
mod delay;
mod delay_error;
mod disk;
mod disk_clock;
mod echo;
mod effects;
mod elliptic;
mod exposure;
mod faint_stars;
mod guides;
mod hot_spot;
mod hot_spot_flux;
mod inside;
mod jet;
mod kerr;
mod kerr_schild;
mod lessons;
mod light_without_spin;
mod limb;
mod lut;
mod medium;
mod milky_way;
mod mino;
mod moved_camera;
mod observer;
mod path;
mod pixel_samples;
mod projection_pairs;
mod projections;
mod random;
mod ray_plane;
mod readout;
mod reference;
mod released;
mod returning;
mod schwarzschild;
mod shadow_edge;
mod ship_errors;
mod ship_flights;
mod ship_frames;
mod ship_gyroscopes;
mod ship_missions;
mod ship_orbits;
mod ship_scenes;
mod ship_seen_path;
mod ship_stars;
mod ship_tank;
mod ship_values;
mod sky_picture;
mod sky_texel;
mod sound;
mod spectrum;
mod star_catalogues;
mod star_images;
mod starlight;
mod stars;
mod stretches;
mod structure;
mod structure_field;
mod structure_period;
mod tabulated_images;
mod tilted_disk;
mod timelike;

use bisect::bisect;

/// Asserts that `found` equals `expected` within the relative tolerance `relative`.
#[track_caller]
fn assert_close(what: impl std::fmt::Display, found: f64, expected: f64, relative: f64) {
    let error = (found - expected).abs();
    assert!(
        error <= relative * expected.abs(),
        "{what}: found {found}, expected {expected}, off by {error:e}"
    );
}
