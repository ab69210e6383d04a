//! Images that are found by a mesh of rays: against tables in f64, against the inversion, and against
//! a finer mesh.

use super::run::StarRun;
use super::{DEPTH, bright_stars, limit_flux, place_of, star_at, star_of};
use crate::random::Random;
use crate::tabulated_images::tabulated_images;
use crate::{gpu, quantile};
use glam::{DMat2, DMat3, DVec2, DVec3};
use lightfall_core::gpu::stars::{GpuStarImage, PackedStars, mesh_layout};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::stars::images::MeshLayout;
use lightfall_core::optics::stars::images::refine_image::{ImageRefiner, Tangents};
use lightfall_core::optics::stars::{Depth, Star, luminance};
use lightfall_core::scene::promises::{
    STAR_FLUX_SPINNING, STAR_LIGHT_MISSED, STAR_PLACE_SPINNING_PX,
};
use lightfall_core::scene::{Method, ObserverKind, Scene};
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// The images of these stars, whose directions are those of the hole's frame, in a picture that the
/// mesh covers.
fn images(scene: &Scene, stars: &[Star], depth: Depth) -> Vec<GpuStarImage> {
    let list = PackedStars::new(stars);
    let layout = mesh_layout(scene, MeshLayout::CELLS);
    let run = StarRun::with_mesh(gpu(), scene, &list, DMat3::IDENTITY, depth, layout);
    run.run().images
}

/// The directions and magnifications were computed in f64 by a tracer that agrees with an independent
/// one to 1e-10. The bars are a thousandth of a pixel of 960x540 and of the flux, and of the shift some
/// roundings of f32.
#[test]
#[ignore = "needs a graphics adapter"]
fn images_are_where_tables_in_f64_have_them_and_as_magnified() {
    for row in tabulated_images(&around(0.0)) {
        let (mut scene, direction) = (row.scene, row.direction);
        scene.effects.beaming = false;
        let star = star_at(row.star);
        // Look near the image, and not straight at it, where a corner of a cell may be.
        let [outward, theta_hat, phi_hat] = direction.to_array();
        scene.camera.yaw_deg = phi_hat.atan2(-outward).to_degrees() + 3.2;
        scene.camera.pitch_deg = (-theta_hat).asin().to_degrees() - 1.7;
        let depth = Depth {
            limit: 9.0,
            last: f64::INFINITY,
        };
        let found = images(&scene, &[star], depth);
        let looking = scene.camera.tetrad_from_camera().transpose() * direction;
        let size = scene.picture.size().as_dvec2();
        let place = scene.camera.pixel_of(looking, size).unwrap();
        let distance = |image: &GpuStarImage| place_of(&scene, image).distance(place);
        let nearest = found
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or_else(|| panic!("no image at {direction}"));
        let own = star_of(&PackedStars::new(&[star]), 0);
        let unmagnified = own.luminous_flux / luminance(own.temperature);
        let off = f64::from(nearest.flux) / unmagnified / row.magnification - 1.0;
        let shift = f64::from(nearest.temperature) / own.temperature / row.shift - 1.0;
        println!(
            "spin {}, r {}: {} images; {:.1e} px, flux {off:.1e}, shift {shift:.1e}",
            scene.hole.spin,
            scene.camera.r,
            found.len(),
            distance(nearest)
        );
        assert!(distance(nearest) < 1e-3);
        assert!(off.abs() < 1e-3 && shift.abs() < 1e-5);
    }
}

/// A hole with this spin, seen by `mino` with rays as precise as f32 allows.
fn around(spin: f64) -> Scene {
    let mut scene = crate::bare_hole(20.0);
    scene.method = Method::Mino;
    scene.hole.spin = spin;
    scene.quality.max_error_px = 1e-3;
    (scene.camera.theta_deg, scene.camera.fov_deg) = (83.0, 50.0);
    (scene.picture.width, scene.picture.height) = (960, 540);
    scene
}

/// The nearest image of the same star among others.
fn same_image<'a>(
    scene: &Scene,
    image: &GpuStarImage,
    others: &'a [GpuStarImage],
) -> Option<(f64, &'a GpuStarImage)> {
    let place = place_of(scene, image);
    others
        .iter()
        .filter(|other| other.star == image.star)
        .map(|other| (place_of(scene, other).distance(place), other))
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

fn relative_flux(image: &GpuStarImage, other: &GpuStarImage) -> f64 {
    (f64::from(image.flux) / f64::from(other.flux) - 1.0).abs()
}

/// The inversion knows nothing of rays and meshes. The bars are 2e-3 pixels and 2e-3 of the flux: what
/// finite differences of rays in f32 give. Images of the second order lie within a cell of the
/// shadow's edge, where the mesh finds none.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_mesh_finds_the_images_that_the_inversion_finds() {
    let (list, turn) = bright_stars();
    let mut without_spin = around(0.0);
    without_spin.method = Method::Closed;
    let truth = StarRun::new(gpu(), &without_spin, &list, turn, DEPTH);
    let truth = truth.run().images;
    let by_mesh = |scene: &Scene| {
        let layout = mesh_layout(scene, MeshLayout::CELLS);
        let run = StarRun::with_mesh(gpu(), scene, &list, turn, DEPTH, layout);
        run.run().images
    };
    for (name, scene) in [("mino", around(0.0)), ("spin 1e-6", around(1e-6))] {
        let found = by_mesh(&scene);
        let (mut places, mut fluxes) = (vec![], vec![]);
        let mut missed = vec![];
        for image in &truth {
            let own = star_of(&list, image.star);
            let gain = f64::from(image.flux) * luminance(own.temperature) / own.luminous_flux;
            match same_image(&scene, image, &found) {
                Some((distance, other)) if distance < 0.5 => {
                    places.push(distance);
                    fluxes.push(relative_flux(other, image));
                }
                _ => missed.push(gain),
            }
        }
        let largest_missed = missed.iter().copied().fold(0.0, f64::max);
        println!(
            "{name}: {} of {}; missed up to {largest_missed:.1e}; {:.1e} px, {:.1e} in 99 %; flux {:.1e}, {:.1e} in 99 %",
            places.len(),
            truth.len(),
            quantile(&places, 1.0),
            quantile(&places, 0.99),
            quantile(&fluxes, 1.0),
            quantile(&fluxes, 0.99),
        );
        assert!(places.len() > 300);
        // A star within the limit's rounding may be on either side of it.
        let faint = |image: &GpuStarImage| {
            f64::from(image.flux) * luminance(star_of(&list, image.star).temperature)
                < 1.01 * limit_flux()
        };
        let faint = truth.iter().filter(|image| faint(image)).count();
        assert!(missed.len() <= faint || largest_missed < 0.03, "{missed:?}");
        assert!(quantile(&places, 0.99) < STAR_PLACE_SPINNING_PX);
        assert!(quantile(&fluxes, 0.99) < STAR_FLUX_SPINNING);
        // No image that the inversion does not have.
        for image in &found {
            let (distance, _) = same_image(&scene, image, &truth).unwrap_or((1e9, image));
            let bright = f64::from(image.flux) * luminance(star_of(&list, image.star).temperature);
            assert!(
                distance < 0.5 || bright < 1.01 * limit_flux(),
                "{name}: {image:?}"
            );
        }
    }
}

/// Random stars, a third of them near the line behind the hole, where images are bright.
fn random_stars(scene: &Scene, count: usize) -> Vec<Star> {
    let mut random = Random::new();
    let [n, theta_hat, phi_hat] = scene.camera.tetrad().to_cols_array_2d().map(DVec3::from);
    (0..count)
        .map(|i| {
            let turn = random.between(0.0, TAU);
            let across = turn.cos() * theta_hat + turn.sin() * phi_hat;
            let cosine = if i % 3 == 0 {
                random.between(0.03, 0.0).cos()
            } else {
                random.between(-1.0, 1.0)
            };
            star_at(-cosine * n + (1.0 - cosine * cosine).sqrt() * across)
        })
        .collect()
}

/// Stars of magnitude 0 whose images count down to a thousandth of their light.
const THOUSANDTH: Depth = Depth {
    limit: 7.5,
    last: f64::INFINITY,
};

/// Missed images are those squeezed between the cells and the shadow. They have less than 0.03 times
/// the star's light, except next to the caustic of stars behind the camera, which lies there: of 24 000
/// stars, 4 had two images each there, with at most 0.12.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_mesh_finds_the_images_of_random_stars_that_a_mesh_four_times_as_fine_finds() {
    let scene = around(0.9);
    let stars = random_stars(&scene, 1000);
    let list = PackedStars::new(&stars);
    let found_by = |cells: f64| {
        let layout = mesh_layout(&scene, cells);
        let turn = DMat3::IDENTITY;
        let run = StarRun::with_mesh(gpu(), &scene, &list, turn, THOUSANDTH, layout);
        run.run().images
    };
    let found = found_by(MeshLayout::CELLS);
    let truth = found_by(16.0 * MeshLayout::CELLS);
    let unit = f64::from(stars[0].flux() as f32);
    let (mut missed, mut total, mut largest, mut bright) = (0.0, 0.0, 0.0_f64, 0);
    let mut on_caustic = BTreeSet::new();
    for image in &truth {
        let flux = f64::from(image.flux) / unit;
        if flux > 1.0
            && same_image(&scene, image, &found).is_none_or(|(distance, _)| distance > 5.0)
        {
            on_caustic.insert(image.star);
            continue;
        }
        total += flux;
        // Next to a caustic a place is less certain.
        let reach = 0.5 + 0.01 * flux;
        if same_image(&scene, image, &found).is_none_or(|(distance, _)| distance > reach) {
            missed += flux;
            largest = largest.max(flux);
            bright += u32::from(flux > 0.03);
        }
    }
    println!(
        "{} of {} images; {bright} bright ones missed, {:.1e} of the flux missed, {largest:.1e} at most",
        found.len(),
        truth.len(),
        missed / total
    );
    assert!(found.len() > 400);
    // Two images of a star next to a caustic come and go together, and a coarse cell may see neither.
    // One star in 50 000 is so near: three of 1000 are once in 1e5 runs.
    assert!(on_caustic.len() < 3, "{on_caustic:?}");
    assert!(bright <= 4 && largest < 0.3 && missed / total < STAR_LIGHT_MISSED);
    let doubles = found.iter().enumerate().filter(|(i, image)| {
        let again = same_image(&scene, image, &found[i + 1..]);
        again.is_some_and(|(distance, _)| distance < 0.02)
    });
    // Where an image lies on the side of two cells, rounding decides which of them accepts it: about
    // one image in 5000 is found by both. Five of 1300 are once in 1e5 runs.
    let doubles = doubles.count();
    println!("{doubles} images found twice");
    assert!(doubles < 5, "{doubles} of {} images", found.len());
}

/// The judge is Broyden's method with the reference tracer, which begins at the image found. The bars
/// are a thousandth of a pixel and two of the flux for nine of ten images: a third of the stars are next to
/// the caustic, which magnifies the rounding of directions.
#[test]
#[ignore = "needs a graphics adapter"]
fn images_of_random_stars_are_those_that_the_reference_polishes() {
    let mut scene = around(0.9);
    scene.effects.beaming = false;
    let stars = random_stars(&scene, 300);
    let found = images(&scene, &stars, THOUSANDTH);
    let list = PackedStars::new(&stars);
    let reference = Reference::new(&scene).unwrap();
    let axes = scene.camera.tetrad_from_camera();
    let sky = |place: DVec2| reference.trace(axes * place.extend(1.0)).sky;
    let refiner = ImageRefiner {
        max_step: 0.01,
        max_rays: 30,
        half_step: 1e-5,
    };
    let size = scene.picture.size().as_dvec2();
    let (mut places, mut fluxes) = (vec![], vec![]);
    for image in &found {
        let star = star_of(&list, image.star);
        let direction = star.direction.as_dvec3().normalize();
        let tangents = Tangents::at(direction);
        let looking = image.direction.as_dvec3();
        let guess = looking.truncate() / looking.z;
        let rate = |step: DVec2| {
            let along = sky(guess + step)? - sky(guess - step)?;
            Some(tangents.components(along) / (2.0 * step.length()))
        };
        let h = 1e-6;
        let (Some(x), Some(y)) = (rate(DVec2::X * h), rate(DVec2::Y * h)) else {
            continue;
        };
        let jacobian = DMat2::from_cols(x, y);
        let Some(truth) = refiner.image(&sky, direction, guess, jacobian) else {
            panic!("no image at {guess}");
        };
        let place = scene
            .camera
            .pixel_of(truth.place.extend(1.0), size)
            .unwrap();
        places.push(place_of(&scene, image).distance(place));
        let own = star.luminous_flux / luminance(star.temperature);
        fluxes.push((f64::from(image.flux) / own / truth.magnification - 1.0).abs());
    }
    println!(
        "{} of {}: {:.1e} px, {:.1e} in 99 %; flux {:.1e}, {:.1e} in 99 %",
        places.len(),
        found.len(),
        quantile(&places, 1.0),
        quantile(&places, 0.99),
        quantile(&fluxes, 1.0),
        quantile(&fluxes, 0.99)
    );
    assert!(places.len() > 100 && places.len() + 5 > found.len());
    assert!(quantile(&places, 0.9) < 1e-3 && quantile(&fluxes, 0.9) < 2e-3);
    assert!(quantile(&places, 0.98) < 1e-2 && quantile(&fluxes, 0.98) < 1e-2);
}

/// Images within a ten-thousandth of a pixel of the sides of cells, by the reference tracer: two cells
/// find each, round differently, and one must accept it. Where they round across a point between two
/// anchors they cannot agree: measured, 1 of 1000 here. With anchors as close as elsewhere it is 16.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_random_image_on_the_side_of_two_cells_is_there_once() {
    let mut random = Random::new();
    let scene = around(0.9);
    let reference = Reference::new(&scene).unwrap();
    let layout = mesh_layout(&scene, MeshLayout::CELLS);
    let size = scene.picture.size().as_dvec2();
    let axes = scene.camera.tetrad_from_camera();
    let mut stars = vec![];
    while stars.len() < 2000 {
        let mut place = DVec2::new(random.between(2.0, 958.0), random.between(2.0, 538.0));
        let cell = ((place - layout.origin) / layout.spacing).round();
        let side = layout.origin + layout.spacing * cell;
        place[stars.len() % 2] = side[stars.len() % 2] + random.between(-1e-4, 1e-4);
        let sky = reference
            .trace(axes * scene.camera.looking(place, size))
            .sky;
        // Away from the ring and the shadow, where a star may have further images nearby.
        if let Some(sky) = sky.filter(|_| place.distance(0.5 * size) > 250.0) {
            stars.push((place, star_at(sky)));
        }
    }
    let list: Vec<Star> = stars.iter().map(|(_, star)| *star).collect();
    let found = images(&scene, &list, THOUSANDTH);
    let mut counts = vec![0; stars.len()];
    for image in &found {
        let number = image.star as usize;
        counts[number] += u32::from(place_of(&scene, image).distance(stars[number].0) < 0.5);
    }
    let wrong = counts.iter().filter(|count| **count != 1).count();
    println!("{wrong} of {}", counts.len());
    assert!(wrong <= 10, "{wrong}");
}

/// Every tracer and every flag that shaders of stars can have, for as many images as the picture of the
/// method mino has: the tracers differ by less than a star's own width.
#[test]
#[ignore = "needs a graphics adapter"]
fn every_tracer_that_has_no_inversion_finds_images() {
    let (list, turn) = bright_stars();
    let found = |scene: &Scene| {
        let run = StarRun::new(gpu(), scene, &list, turn, DEPTH);
        run.run().images
    };
    for spin in [0.0, 0.9] {
        let mut scene = around(spin);
        scene.disk.enabled = true;
        let truth = found(&scene);
        for method in [Method::Verlet, Method::KerrSchild] {
            scene.method = method;
            if spin != 0.0 && !method.properties().spins {
                continue;
            }
            let others = found(&scene);
            let same = |image: &&GpuStarImage| {
                let nearest = same_image(&scene, image, &others);
                nearest.is_some_and(|(distance, _)| distance < 1.0)
            };
            let share = truth.iter().filter(same).count() as f64 / truth.len() as f64;
            println!(
                "{method:?}, spin {spin}: {share:.3} of {} images",
                truth.len()
            );
            assert!(share > 0.98, "{method:?}");
        }
    }
    // Next to the horizon, and with effects off.
    let mut scene = around(0.998);
    (scene.camera.r, scene.observer.kind) = (0.8, ObserverKind::Zamo);
    (scene.camera.yaw_deg, scene.camera.fov_deg) = (180.0, 100.0);
    assert!(found(&scene).len() > 100);
    let mut scene = around(0.9);
    scene.observer.velocity = [0.1, -0.2, 0.3];
    let effects = &mut scene.effects;
    (effects.aberration, effects.beaming, effects.doppler) = (false, false, false);
    assert!(found(&scene).len() > 100);
}
