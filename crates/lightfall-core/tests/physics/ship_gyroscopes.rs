//! A ship's gyroscopes against Marck's frame, which is known in closed form, and against published
//! angles.

use crate::ship_flights::ship;
use crate::ship_values::{assert_digits, assert_near, hold};
use crate::timelike::scene;
use glam::{DMat3, DQuat, DVec3, DVec4};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::quadrature::gauss_legendre;
use lightfall_core::geometry::ship::{Controls, Place, Ship, VectorConstants, minkowski};
use lightfall_core::geometry::sphere::celestial_frame;
use lightfall_core::optics::ship::{Hold, Mount, board, write_scene};
use lightfall_core::scene::{ObserverKind, Scene};
use std::f64::consts::TAU;

/// A vector on Carter's frame (Carter 1968): (P, V)/sqrt(Sigma Delta), then c/sqrt(Sigma) along
/// theta and along phi.
fn on_carters_frame(place: &Place, p: DVec4) -> DVec4 {
    let constants = VectorConstants::new(place, p);
    let [_, theta_hat, phi_hat] = celestial_frame(place.theta(), place.azimuth().unwrap());
    let (sigma, delta) = (place.sigma(), place.kerr.delta(place.r));
    let c = constants.carter_vector(place) / sigma.sqrt();
    let scale = (sigma * delta).sqrt();
    DVec4::new(
        constants.p(place) / scale,
        constants.radial / scale,
        c.dot(theta_hat),
        c.dot(phi_hat),
    )
}

/// Marck's vectors on Carter's frame, and the rate at which the first and the third turn about the
/// second relative to gyroscopes. Marck 1983 eqs. 29 to 31.
fn marck(ship: &Ship) -> ([DVec4; 3], f64) {
    let place = ship.place();
    let u = on_carters_frame(&place, ship.velocity());
    let constants = ship.constants();
    let (a, r, k) = (place.kerr.a(), place.r, constants.k_prime(&place));
    let height = a * place.n.z;
    let alpha = ((k - height * height) / (k + r * r)).sqrt();
    let beta = 1.0 / alpha;
    let root = k.sqrt();
    let first = DVec4::new(
        alpha * r * u.y,
        alpha * r * u.x,
        -beta * height * u.w,
        beta * height * u.z,
    ) / root;
    let second = DVec4::new(height * u.y, height * u.x, r * u.w, -r * u.z) / root;
    let third = DVec4::new(alpha * u.x, alpha * u.y, beta * u.z, beta * u.w);
    let sin = place.sin_theta();
    let rate = root / place.sigma()
        * (constants.p(&place) / (r * r + k)
            + a * (constants.angular_momentum - a * constants.energy * sin * sin)
                / (k - height * height));
    ([first, second, third], rate)
}

/// Marck's vectors on the ship's axes, one per column.
fn on_ship(ship: &Ship) -> [DVec3; 3] {
    let place = ship.place();
    let frame = ship.frame();
    let axes = [frame.y_axis, frame.z_axis, frame.w_axis].map(|e| on_carters_frame(&place, e));
    marck(ship)
        .0
        .map(|vector| DVec3::from_array(axes.map(|axis| minkowski(axis, vector))))
}

#[test]
fn gyroscopes_keep_their_place_in_marcks_frame() {
    for (spin, r, theta, velocity, time) in [
        (0.9, 6.0, 1.1, [0.45, 0.15, 0.28], 60.0),
        (0.998, 2.0, 1.3, [0.55, 0.2, 0.45], 15.0),
        (-0.7, 5.0, 0.4, [0.4, 0.1, 0.35], 40.0),
        (0.5, 9.0, 2.0, [0.1, -0.25, 0.1], 25.0),
    ] {
        let start = ship(spin, r, theta, DVec3::from_array(velocity));
        let before = on_ship(&start);
        let mut ship = start;
        let mut angle = 0.0;
        let pieces = 24;
        let nodes = gauss_legendre(12);
        for piece in 0..pieces {
            let length = time / f64::from(pieces);
            for &(node, weight) in &nodes {
                let at = length * (f64::from(piece) + node);
                assert_eq!(
                    ship.advance(&Controls::default(), at - ship.proper_time())
                        .unwrap(),
                    None
                );
                angle += weight * length * marck(&ship).1;
            }
        }
        ship.advance(&Controls::default(), time - ship.proper_time())
            .unwrap();
        let after = on_ship(&ship);
        let [first, second, third] = before;
        let turned = angle.cos() * first + angle.sin() * third;
        // Rounding of some hundred steps, and of the quadrature of the angle.
        let error = (after[1] - second)
            .length()
            .max((after[0] - turned).length());
        eprintln!("Marck, spin {spin}: angle {angle:.3}, error {error:.1e}");
        assert!(
            error < 1e-12,
            "spin {spin}: {error:e}, {before:?} {after:?} {angle} {third:?}"
        );
    }
}

/// How the ship's axes are turned on the axes of the scene's observer.
fn attitude(ship: &Ship, scene: &Scene) -> DMat3 {
    let mut scene = scene.clone();
    write_scene(ship, &Mount::NOSE, &mut scene).unwrap();
    scene.camera.tetrad_from_camera() * Mount::NOSE.0.transpose()
}

#[test]
fn gyroscopes_turn_by_the_published_angles() {
    // In the circling axes a gyroscope turns back by a turn less the geodetic angle and that of
    // Lense and Thirring: 2 pi - sqrt(M/r^3) T (Rindler & Perlick 1990 without spin).
    for (spin, r, expected) in [
        (0.0, 6.0, 0.8417872145),
        (0.0, 4.0, 1.3158911743),
        (0.9, 6.0, 0.6869116514),
        (-0.9, 6.0, 1.0012020077),
    ] {
        let scene = scene(spin, ObserverKind::Orbit, [0.0; 3], r, 90.0);
        let mut ship = board(&scene, &Mount::NOSE).unwrap();
        let orbit = Kerr { spin }.circular_orbit(r).unwrap();
        let before = attitude(&ship, &scene);
        ship.advance(
            &Controls::default(),
            TAU / (orbit.angular_velocity * orbit.u_t),
        )
        .unwrap();
        let turn =
            DQuat::from_mat3(&(attitude(&ship, &scene) * before.transpose())).to_scaled_axis();
        assert_digits("angle", turn.length(), expected);
        assert!(turn.cross(DVec3::Y).length() < 1e-9, "about theta: {turn}");
    }
    let scene = scene(0.9, ObserverKind::Static, [0.0; 3], 3.0, 90.0);
    let ship = board(&scene, &Mount::NOSE).unwrap();
    let before = attitude(&ship, &scene);
    let mut flight = hold(Hold::Hover(3.0), ship);
    flight.advance(20.0).unwrap();
    let turn = DQuat::from_mat3(&(attitude(&flight.ship, &scene) * before.transpose()));
    // The hold keeps the place to the square of a tick, some 1e-6.
    assert_near("rate", turn.to_scaled_axis().y / 20.0, 0.0125, 2e-6);
}
