//! The images of stars: positions and magnifications against an independent tracer, weak lensing,
//! and the area of the sky.

use crate::assert_close;
use crate::light_without_spin::deflection;
use crate::random::Random;
use crate::tabulated_images::{TabulatedImage, tabulated_images};
use glam::{DMat2, DVec2, DVec3};
use lightfall_core::geometry::schwarzschild::rain_sky::RainSky;
use lightfall_core::geometry::schwarzschild::{CRITICAL_IMPACT, shadow_half_angle_static};
use lightfall_core::geometry::sphere::angle_between;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::stars::Catalogue;
use lightfall_core::optics::stars::images::refine_image::{ImageRefiner, Tangents};
use lightfall_core::optics::stars::images::{
    Inversion, MIN_SOURCE_RADIUS, MeshLayout, RayMesh, StarImage, named_images,
};
use lightfall_core::scene::{ObserverKind, Scene};
use std::f64::consts::{PI, TAU};

/// A camera at rest in the equator that looks at the hole, without a disk.
fn static_at(r: f64) -> Scene {
    let mut scene = Scene::default();
    scene.observer.kind = ObserverKind::Static;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.phi_deg) = (r, 90.0, 0.0);
    scene.disk.enabled = false;
    scene
}

/// The tables' digits leave 1e-8 in direction and shift and, with six of them, 4e-6 of mu.
#[test]
fn images_without_spin_are_where_an_independent_tracer_finds_them() {
    let rows = tabulated_images(&static_at(20.0)).into_iter();
    let mut checked = 0;
    for row in rows.filter(|row| row.scene.hole.spin == 0.0) {
        let images = Inversion::new(&row.scene).unwrap();
        let image = nearest(images.images(row.star), row.direction);
        assert_image(&image, &row, 4e-6);
        checked += 1;
    }
    assert_eq!(checked, 3);
}

/// The polished image does not know the closed form, and works for every spin.
#[test]
fn polished_images_are_where_an_independent_tracer_finds_them() {
    for row in tabulated_images(&static_at(20.0)) {
        let (mut scene, star, direction) = (row.scene, row.star, row.direction);
        // The whole sphere's half toward the image is in front of the camera.
        if direction.x > -0.5 {
            scene.camera.yaw_deg = 70.0 * direction.z.signum();
        }
        let axes = scene.camera.tetrad_from_camera();
        let reference = Reference::new(&scene).unwrap();
        let sky = |place: DVec2| reference.trace(axes * place.extend(1.0)).sky;
        let refiner = ImageRefiner {
            max_step: 0.02,
            max_rays: 40,
            half_step: 1e-5,
        };
        let seen = axes.transpose() * direction;
        let image = seen.truncate() / seen.z;
        let tangents = Tangents::at(star);
        // The guess is a hundredth off, with the Jacobian of that place.
        let guess = image + DVec2::new(0.008, -0.006).clamp_length_max(0.002);
        let rate = |step: DVec2| {
            let at = |place: DVec2| tangents.missed(sky(place).unwrap()).unwrap();
            (at(guess + step) - at(guess - step)) / (2.0 * step.length())
        };
        let jacobian = DMat2::from_cols(rate(DVec2::X * 1e-5), rate(DVec2::Y * 1e-5));
        let found = refiner
            .image(&sky, star, guess, jacobian)
            .unwrap_or_else(|| panic!("no image at {direction}"));
        let polished = (axes * found.place.extend(1.0)).normalize();
        assert!(
            polished.distance(direction) < 2e-8,
            "{polished} and {direction}, {found:?}"
        );
        let shift = 1.0 / reference.photon(polished).energy;
        assert_close("1/E", shift, row.shift, 1e-8);
        assert_close("mu", found.magnification, row.magnification, 4e-6);
    }
}

/// A mesh four times as coarse as the picture's own, as names of stars take it, against an independent
/// tracer in f64. It may miss images of less than a twentieth of the star's light.
#[test]
fn a_mesh_of_reference_rays_finds_the_tabulated_images() {
    let mut bright = tabulated_images(&static_at(20.0));
    bright.retain(|row| row.magnification > 0.05);
    assert!(bright.len() > 5);
    for row in bright {
        let mut scene = row.scene.clone();
        let [outward, theta, phi] = row.direction.to_array();
        scene.camera.yaw_deg = phi.atan2(-outward).to_degrees() + 4.0;
        scene.camera.pitch_deg = (-theta).asin().to_degrees() + 3.0;
        scene.effects.beaming = false;
        let mesh = RayMesh::new(&scene, MeshLayout::CELLS / 16.0).unwrap();
        let found = nearest(mesh.images(row.star).into_iter(), row.direction);
        assert_image(&found, &row, 1e-4);
    }
}

#[track_caller]
fn assert_image(found: &StarImage, expected: &TabulatedImage, relative: f64) {
    let off = found.direction.distance(expected.direction);
    assert!(off < 2e-8, "{found:?} and {}", expected.direction);
    assert_close("1/E", found.shift, expected.shift, 1e-8);
    assert_close("mu", found.magnification, expected.magnification, relative);
}

/// The names of the stars around a hole that hardly spins are those around one that does not, which are
/// found by inversion.
#[test]
fn named_images_with_a_trace_of_spin_are_those_without() {
    let mut scene = static_at(20.0);
    let named = |scene: &Scene| named_images(scene, Catalogue::built_in(), 50, 5.0).unwrap();
    let expected = named(&scene);
    scene.hole.spin = 1e-9;
    let found = named(&scene);
    assert!(!found.is_empty());
    for image in &found {
        let same = expected.iter().find(|other| {
            other.name == image.name && other.image.direction.distance(image.image.direction) < 1e-6
        });
        let same = same.unwrap_or_else(|| panic!("{image:?}"));
        assert_eq!(image.image.order, same.image.order, "{image:?}");
        assert!((image.magnitude - same.magnitude).abs() < 1e-3, "{image:?}");
    }
    let camera_from_tetrad = scene.camera.tetrad_from_camera().transpose();
    let size = scene.picture.size().as_dvec2();
    let mut seen = 0;
    for image in expected
        .iter()
        .filter(|image| image.image.magnification > 0.1)
    {
        let looking = camera_from_tetrad * image.image.direction;
        let place = scene.camera.pixel_of(looking, size);
        let inside = place.is_some_and(|place| place.min(size - place).min_element() > 1.0);
        assert!(
            !inside || found.iter().any(|other| other.name == image.name),
            "{image:?}"
        );
        seen += u32::from(inside);
    }
    assert!(seen > 5, "{seen} images are within the picture");
}

fn nearest(images: impl Iterator<Item = StarImage>, direction: DVec3) -> StarImage {
    images
        .min_by(|a, b| {
            let distance = |image: &StarImage| image.direction.distance(direction);
            distance(a).total_cmp(&distance(b))
        })
        .unwrap()
}

/// r, psi; for each order alpha from the outward direction of an observer at rest, and mu. From the
/// same independent integrator.
const STATIC: [([f64; 2], &[[f64; 2]]); 4] = [
    (
        [20.0, 3.0],
        &[
            [2.719615032, 1.585284],
            [2.842730173, 0.6854965],
            [3.014475152, 1.461751e-4],
            [3.014515249, 1.099145e-4],
        ],
    ),
    (
        [20.0, 1.0],
        &[
            [0.972441283, 0.9500235],
            [3.004517454, 1.851041e-3],
            [3.013416231, 1.892518e-4],
        ],
    ),
    (
        [3.0, 2.0],
        &[
            [1.522158277, 0.6929567],
            [2.268145336, 7.863974e-2],
            [2.354711942, 1.157940e-3],
        ],
    ),
    (
        [1.2, 1.0],
        &[
            [0.394314616, 0.1675347],
            [1.063322788, 2.103143e-2],
            [1.081220843, 3.007941e-3],
        ],
    ),
];

/// Half a unit of the last digit, and for mu also the table's error of up to 1e-6.
#[test]
fn images_of_every_order_are_where_an_independent_tracer_finds_them() {
    for ([r, psi], orders) in STATIC {
        let images = Inversion::new(&static_at(r)).unwrap();
        let star = DVec3::new(psi.cos(), psi.sin(), 0.0);
        for (order, [alpha, magnification]) in (0..).zip(orders) {
            let image = images.image(star, order).unwrap();
            let found = angle_between(image.direction, DVec3::X);
            assert!(
                (found - alpha).abs() < 1.5e-9,
                "r {r}, psi {psi}, order {order}: {found} and {alpha}"
            );
            let side = if order % 2 == 0 { 1.0 } else { -1.0 };
            assert!(side * image.direction.z > 0.0);
            assert_close("mu", image.magnification, *magnification, 2e-6);
        }
    }
}

/// Light from infinity to infinity sweeps pi and its deflection, of which a distant observer sees
/// all but the angle b/r. The table of deflections has 25 digits.
#[test]
fn the_angle_about_the_hole_is_that_of_the_deflection() {
    let r = 1e7;
    let sky = RainSky::new(r);
    for b in [2.6, 2.7, 3.0, 5.0, 20.0, 100.0] {
        // b = r sin(theta) / (1 - v cos(theta)), by iteration, since v is small.
        let speed = (1.0 / r).sqrt();
        let mut theta = b / r;
        for _ in 0..60 {
            theta = (b / r * (1.0 - speed * f64::cos(theta))).asin();
        }
        let psi = sky.angle_to_infinity(theta - sky.shadow_half_angle());
        let expected = PI + deflection(b).unwrap() - (b / r).asin();
        // A relative error of theta of 1e-16 next to the edge grows by b / (b - b_c).
        let tolerance = 1e-8 + 1e-14 * b / (b - CRITICAL_IMPACT);
        assert!(
            (psi - expected).abs() < tolerance,
            "b {b}: {psi}, {expected}"
        );
    }
}

/// The weak-field limit of a point lens, with u the star's angle from the line behind the lens in
/// Einstein radii (Paczynski 1986): both images together are magnified (u^2 + 2)/(u sqrt(u^2 + 4)).
/// Corrections are of the order of the Einstein radius.
#[test]
fn far_away_both_images_have_the_magnification_of_a_point_lens() {
    for r in [1e6, 1e7] {
        let images = Inversion::new(&static_at(r)).unwrap();
        let einstein = (2.0 / r).sqrt();
        for u in [0.1, 0.3, 1.0, 3.0] {
            let beta: f64 = u * einstein;
            let star = DVec3::new(-beta.cos(), beta.sin(), 0.0);
            let total: f64 = images
                .images(star)
                .take(2)
                .map(|image| image.magnification)
                .sum();
            let expected = (u * u + 2.0) / (u * (u * u + 4.0).sqrt());
            assert_close(
                format_args!("r {r}, u {u}"),
                total,
                expected,
                3.0 * einstein,
            );
        }
    }
}

/// The sky within the camera's picture is magnified to the picture, so stars spread evenly over the
/// sky have a mean magnification of the picture's sky over the whole sphere. Here the picture is
/// the whole sphere less the shadow.
///
/// Next to the axis through the hole the magnification goes with 1/sin(beta), and its variance over
/// the sphere is infinite: a sample has no standard error. So the angle beta is spread evenly, and
/// the magnification is weighed with sin(beta). This is bounded, and three runs in a million exceed
/// five standard errors at one of the three radii.
#[test]
fn the_mean_magnification_of_random_stars_is_the_share_of_the_sky_that_is_not_shadow() {
    let mut random = Random::new();
    for r in [1.3, 3.0, 20.0] {
        let images = Inversion::new(&static_at(r)).unwrap();
        let totals: Vec<f64> = (0..20_000)
            .map(|_| {
                let (beta, around) = (random.between(0.0, PI), random.between(0.0, TAU));
                let across = DVec3::new(0.0, around.cos(), around.sin());
                let star = beta.cos() * DVec3::X + beta.sin() * across;
                let total: f64 = images.images(star).map(|image| image.magnification).sum();
                0.5 * PI * beta.sin() * total
            })
            .collect();
        let count = totals.len() as f64;
        let mean = totals.iter().sum::<f64>() / count;
        let spread = totals
            .iter()
            .map(|total| (total - mean).powi(2))
            .sum::<f64>()
            / count;
        let expected = 0.5 * (1.0 + shadow_half_angle_static(r).cos());
        assert!(
            (mean - expected).abs() < 5.0 * (spread / count).sqrt(),
            "r {r}: {mean} and {expected}"
        );
    }
}

/// Aberration and Doppler shift in flat space: solid angles go with g^-2, so that the flux, g^4 mu
/// F, goes with g^2 (Misner, Thorne & Wheeler 1973, section 22.6).
#[test]
fn without_lensing_the_flux_of_a_star_goes_with_the_square_of_its_shift() {
    let mut scene = static_at(1e7);
    scene.observer.velocity = [0.5, 0.0, 0.0];
    scene.effects.lensing = false;
    let images = Inversion::new(&scene).unwrap();
    let doppler = |cosine: f64| (1.0 - 0.25_f64).sqrt() / (1.0 - 0.5 * cosine);
    for star in [DVec3::X, DVec3::new(0.6, 0.8, 0.0), DVec3::Z] {
        let image = images.image(star, 0).unwrap();
        // At this distance the gravitational shift is 5e-8.
        let g = doppler(image.direction.x);
        assert_close("shift", image.shift, g, 1e-7);
        assert_close("flux", image.gain, g * g, 4e-7);
    }
    let ahead = images.image(DVec3::X, 0).unwrap();
    assert_close(
        "ahead",
        ahead.shift.powi(4) * ahead.magnification,
        3.0,
        4e-7,
    );
}

#[test]
fn without_lensing_the_hole_hides_the_stars_behind_a_ball_of_its_size() {
    let mut scene = static_at(5.0);
    scene.effects.lensing = false;
    let images = Inversion::new(&scene).unwrap();
    let edge = (1.0_f64 / 5.0).asin();
    for (off, seen) in [(-0.01, false), (0.01, true)] {
        let beta = edge + off;
        let star = DVec3::new(-beta.cos(), beta.sin(), 0.0);
        assert_eq!(images.image(star, 0).is_some(), seen);
        assert!(images.image(star, 1).is_none());
    }
}

/// A point on the caustic would be magnified without limit; the star's disc is not. In the middle
/// the mean of 1/x is 2/rho.
#[test]
fn a_star_on_the_line_through_the_hole_is_as_bright_as_its_disc_allows() {
    let images = Inversion::new(&static_at(20.0)).unwrap();
    let near = |beta: f64| {
        images
            .image(DVec3::new(-beta.cos(), beta.sin(), 0.0), 0)
            .unwrap()
    };
    let brightest = near(0.0).magnification;
    assert!(brightest.is_finite() && brightest > 1e5);
    // Away from the line mu falls like 1/beta, to the order of beta over the Einstein radius.
    let far = near(100.0 * MIN_SOURCE_RADIUS).magnification;
    assert_close("2/rho and 1/beta", brightest / far, 200.0, 1e-3);
    for i in 0..200 {
        let beta = 1e-7 * f64::from(i);
        assert!(near(beta).magnification <= brightest * (1.0 + 1e-6));
    }
    // Straight overhead only the second image is on a caustic.
    let overhead = images.image(DVec3::X, 0).unwrap().magnification;
    let beside = DVec3::new(1.0, 0.3_f64.to_radians(), 0.0).normalize();
    let beside = images.image(beside, 0).unwrap().magnification;
    assert_close("overhead", overhead, beside, 1e-4);
    assert!(images.image(DVec3::X, 1).unwrap().magnification > 1e2);
}
