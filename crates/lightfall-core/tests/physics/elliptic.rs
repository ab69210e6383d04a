//! Carlson's R_F against another implementation and its special values.

use crate::assert_close;
use lightfall_core::geometry::elliptic::carlson_rf_pair;

/// R_F(x, y, z) for a real pair.
fn carlson_rf(x: f64, y: f64, z: f64) -> f64 {
    carlson_rf_pair(x, 0.5 * (y + z), (0.5 * (y - z)).powi(2))
}

/// Against the `ellip` crate, an independent implementation. The product of a pair is the difference
/// of two squares, which loses as many digits as their ratio has: up to three here.
#[test]
fn carlson_rf_agrees_with_another_implementation() {
    let values = [1e-12, 1e-3, 0.2, 1.0, 3.7, 50.0, 1e9];
    for x in [0.0].into_iter().chain(values) {
        for y in values {
            for ratio in [1.0, 1.001, 3.0, 1000.0] {
                let z = ratio * y;
                let expected = ellip::elliprf(x, y, z).unwrap();
                let found = carlson_rf(x, y, z);
                assert_close(format_args!("R_F({x}, {y}, {z})"), found, expected, 1e-12);
            }
        }
    }
}

/// DLMF 19.20.1: R_F(x, x, x) = 1/sqrt(x), and Carlson's lemniscatic value R_F(0, 1, 2).
#[test]
fn carlson_rf_has_its_special_values() {
    assert_close("R_F(4, 4, 4)", carlson_rf(4.0, 4.0, 4.0), 0.5, 1e-15);
    let lemniscatic = carlson_rf(0.0, 1.0, 2.0);
    assert_close("R_F(0, 1, 2)", lemniscatic, 1.311_028_777_146_059_9, 1e-15);
}

#[test]
fn carlson_rf_is_nan_where_it_is_not_defined() {
    for [x, y, z] in [
        [-1.0, 1.0, 1.0],
        [f64::NAN, 1.0, 1.0],
        [1.0, f64::INFINITY, 1.0],
    ] {
        assert!(carlson_rf(x, y, z).is_nan(), "R_F({x}, {y}, {z})");
    }
}
