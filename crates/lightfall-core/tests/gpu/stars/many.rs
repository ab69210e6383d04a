//! Many stars: what a whole list shows that some bright stars cannot.

use super::preset;
use super::run::StarRun;
use crate::gpu;
use glam::DMat3;
use lightfall_core::gpu::stars::{GpuStarImage, PackedStars, mesh_layout};
use lightfall_core::optics::stars::images::MeshLayout;
use lightfall_core::optics::stars::{Catalogue, Depth, Star, StarList};
use lightfall_core::scene::promises::STAR_LIGHT_MISSED_FALLING;
use lightfall_core::scene::{ObserverKind, Scene};

/// How deep the stars go.
const DEPTH: Depth = Depth {
    limit: 8.0,
    last: 8.5,
};

fn whole_list() -> StarList {
    StarList::new(Catalogue::built_in(), 1, DEPTH.last)
}

/// A falling observer, to whom the stars ahead are shifted to the blue so far that all of them are
/// bright, in each of their images.
fn falling(spin: f64, r: f64) -> Scene {
    let mut scene = preset(2);
    (scene.hole.spin, scene.disk.enabled) = (spin, false);
    (scene.camera.r, scene.camera.theta_deg) = (r, 83.0);
    scene.camera.fov_deg = 110.0;
    scene.observer.kind = ObserverKind::Rain;
    scene
}

fn images(scene: &Scene, stars: &[Star], cells: f64) -> Vec<GpuStarImage> {
    let list = PackedStars::new(stars);
    let layout = mesh_layout(scene, cells);
    let run = StarRun::with_mesh(gpu(), scene, &list, DMat3::IDENTITY, DEPTH, layout);
    run.run().images
}

fn flux(images: &[GpuStarImage]) -> f64 {
    images.iter().map(|image| f64::from(image.flux)).sum()
}

/// A star's number and its image's flux, in an order of their own.
fn sorted(images: &[GpuStarImage]) -> Vec<(u32, u32)> {
    let mut pairs: Vec<_> = images
        .iter()
        .map(|image| (image.star, image.flux.to_bits()))
        .collect();
    pairs.sort_unstable();
    pairs
}

/// Cells next to the shadow see much of the sky: they must not leave out stars that a blue shift makes
/// bright.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_falling_observer_sees_the_light_that_a_finer_mesh_finds() {
    let list = whole_list();
    for spin in [-0.9, 0.5] {
        let scene = falling(spin, 4.5);
        let found = images(&scene, list.stars(), MeshLayout::CELLS);
        let finer = images(&scene, list.stars(), 4.0 * MeshLayout::CELLS);
        let missed = 1.0 - flux(&found) / flux(&finer);
        println!(
            "spin {spin}: {} images, {} by the finer mesh, {missed:.1e} of the light missed",
            found.len(),
            finer.len()
        );
        // Images of high order lie between the rays next to the shadow. They have less than a 30th of
        // their star's light, but the blue shift makes them bright. About 1e-2 is missed; a search
        // among the 1000 brightest stars alone, where cells see much of the sky, missed 9e-2.
        assert!(missed.abs() < STAR_LIGHT_MISSED_FALLING, "{missed:e}");
    }
}

/// Next to the horizon there are more candidates than rays to spend on them. Which ones are left out
/// must not depend on chance, and must not be the bright ones.
#[test]
#[ignore = "needs a graphics adapter"]
fn where_candidates_are_too_many_the_faintest_stars_are_left_out() {
    const BRIGHT: usize = 2000;
    let list = whole_list();
    let scene = falling(0.9, 1.0);
    let found = images(&scene, list.stars(), MeshLayout::CELLS);
    let again = images(&scene, list.stars(), MeshLayout::CELLS);
    assert_eq!(sorted(&found), sorted(&again));
    let alone = images(&scene, &list.stars()[..BRIGHT], MeshLayout::CELLS);
    let is_bright = |image: &GpuStarImage| (image.star as usize) < BRIGHT;
    let bright: Vec<_> = found.iter().copied().filter(is_bright).collect();
    println!("{} images, {} of bright stars", found.len(), bright.len());
    assert!(alone.len() > 1000);
    assert_eq!(sorted(&bright), sorted(&alone));
}
