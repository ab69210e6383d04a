//! Where the camera is and looks: from angles to axes and back. The axes are compared, because angles
//! are not unique.

use glam::{DMat3, DVec3};
use lightfall_core::scene::Camera;

fn camera(r: f64, angles: [f64; 5]) -> Camera {
    let [theta_deg, phi_deg, yaw_deg, pitch_deg, roll_deg] = angles;
    Camera {
        r,
        theta_deg,
        phi_deg,
        yaw_deg,
        pitch_deg,
        roll_deg,
        ..Camera::default()
    }
}

fn axes(camera: &Camera) -> DMat3 {
    camera.tetrad() * camera.tetrad_from_camera()
}

fn largest_difference(a: DMat3, b: DMat3) -> f64 {
    (a - b)
        .to_cols_array()
        .into_iter()
        .fold(0.0, |largest, x| largest.max(x.abs()))
}

#[test]
fn a_camera_put_where_it_is_stays_where_it_is() {
    // Poles and straight looks up and down are where the angles are not unique.
    for theta in [0.0, 1e-9, 12.0, 90.0, 171.0, 180.0] {
        for phi in [-170.0, 0.0, 33.0] {
            for yaw in [-120.0, 0.0, 45.0] {
                for pitch in [-90.0, -30.0, 0.0, 89.999, 90.0, 125.0] {
                    for roll in [-100.0, 0.0, 20.0] {
                        let before = camera(7.5, [theta, phi, yaw, pitch, roll]);
                        let mut after = before;
                        after.set_pose(before.direction() * before.r, axes(&before));
                        let place =
                            (after.direction() * after.r - before.direction() * before.r).length();
                        // Degrees round to 1e-14 of a turn, and a place of 7.5 r_s to as many of
                        // its own.
                        assert!(place < 1e-12, "{before:?} moved by {place}");
                        let turn = largest_difference(axes(&after), axes(&before));
                        assert!(turn < 1e-11, "{before:?} turned by {turn} to {after:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn without_turns_the_camera_looks_at_the_hole_with_growing_phi_to_the_right() {
    let camera = camera(20.0, [80.0, 30.0, 0.0, 0.0, 0.0]);
    let [right, up, forward] = [
        axes(&camera).x_axis,
        axes(&camera).y_axis,
        axes(&camera).z_axis,
    ];
    let axes = camera.tetrad();
    assert!((forward + axes.x_axis).length() < 1e-15);
    assert!((up + axes.y_axis).length() < 1e-15);
    assert!((right - axes.z_axis).length() < 1e-15);
}

#[test]
fn yaw_turns_right_pitch_turns_up_and_roll_turns_clockwise() {
    let level = axes(&camera(20.0, [80.0, 0.0, 0.0, 0.0, 0.0]));
    let [right, up, forward] = [level.x_axis, level.y_axis, level.z_axis];
    let near = |a: DVec3, b: DVec3| (a - b).length() < 1e-15;
    assert!(near(
        axes(&camera(20.0, [80.0, 0.0, 90.0, 0.0, 0.0])).z_axis,
        right
    ));
    assert!(near(
        axes(&camera(20.0, [80.0, 0.0, 0.0, 90.0, 0.0])).z_axis,
        up
    ));
    // Clockwise as seen from behind the camera: up goes to where right was.
    assert!(near(
        axes(&camera(20.0, [80.0, 0.0, 0.0, 0.0, 90.0])).y_axis,
        right
    ));
    assert!(near(
        axes(&camera(20.0, [80.0, 0.0, 0.0, 0.0, 90.0])).z_axis,
        forward
    ));
}
