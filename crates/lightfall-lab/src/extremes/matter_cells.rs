//! The hardest places of matter with depth.

use super::cells::Cell;
use crate::medium::{jet_scene, thick_scene};
use lightfall_accuracy::{Ray, rays_over_picture, rays_over_sky, true_passages};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::scene::{DiskStructure, ObserverKind, Scene};

const GROUP: &str = "matter with depth";

/// How far inside the rim of the matter tangent rays pass, as angles of the camera in radians: half of
/// them within a thousandth of the disk's half opening.
const TANGENT: [f64; 2] = [1e-6, 1e-2];

/// Halvings that find the rim to f32's last digit.
const HALVINGS: u32 = 40;

/// Columns of the picture in which the rim is sought.
const COLUMNS: usize = 24;

/// Every cell, with about `count` rays each.
pub fn matter_cells(count: usize) -> Vec<Cell> {
    let camera = [20.0, 83.0];
    let edge_on = |spin: f64| thick_scene(spin, camera, 0.06, 12.0);
    let of_shape = |thickness, depth| thick_scene(0.9, camera, thickness, depth);
    let with = |mut scene: Scene, change: &dyn Fn(&mut Scene)| {
        change(&mut scene);
        scene
    };
    let inside = |spin: f64| {
        let deep = 0.9 * Kerr { spin }.horizon();
        let scene = thick_scene(spin, [deep, 70.0], 0.06, 12.0);
        with(scene, &|scene| scene.observer.kind = ObserverKind::Rain)
    };
    let in_matter = |r: f64, theta_deg: f64| {
        let scene = thick_scene(0.9, [r, theta_deg], 0.1, 12.0);
        with(scene, &|scene| scene.camera.fov_deg = 90.0)
    };
    let orbit = with(in_matter(6.0, 90.0), &|scene| {
        scene.observer.kind = ObserverKind::Orbit;
    });
    let lumpy = with(edge_on(0.9), &|scene| {
        (scene.disk.structure, scene.disk.lumps) = (DiskStructure::Turbulent, 2.0);
    });
    let tilted = with(edge_on(0.0), &|scene| {
        (scene.disk.tilt_deg, scene.disk.node_deg) = (35.0, 40.0);
    });
    let flat = with(edge_on(0.9), &|scene| scene.camera.theta_deg = 89.9);
    let jets = |spin: f64, place: [f64; 2], knots: f64| {
        with(jet_scene(spin, place), &|scene| scene.jet.knots = knots)
    };
    let narrow = |scene: Scene, fov_deg: f64| with(scene, &|scene| scene.camera.fov_deg = fov_deg);
    let wide_jets = with(jets(0.998, [12.0, 60.0], 0.0), &|scene| {
        (scene.jet.width, scene.jet.length, scene.jet.speed) = (1.0, 15.0, 4.0);
    });
    let jets_in_matter = with(jets(0.9, [20.0, 65.0], 0.0), &|scene| {
        (scene.disk.thickness, scene.disk.depth) = (0.3, 2.0);
    });
    let falling_among_jets = with(inside(0.9), &|scene| {
        (scene.jet.enabled, scene.jet.brightness, scene.jet.knots) = (true, 3.0, 0.0);
    });
    let in_picture = [
        ("edge-on, for comparison", edge_on(0.9)),
        ("depth 200", of_shape(0.05, 200.0)),
        ("depth 0.1", of_shape(0.06, 0.1)),
        ("thickness 0.002", of_shape(0.002, 12.0)),
        ("thickness 0.3", of_shape(0.3, 12.0)),
        ("camera at 89.9 degrees", flat),
        ("edge-on", edge_on(0.9999)),
        ("edge-on", edge_on(-0.9)),
        ("a disk tilted by 35 degrees", tilted),
        ("lumps 2", lumpy),
        ("jets from the side", jets(0.9, [30.0, 70.0], 0.0)),
        (
            "jets from 400 r_s",
            narrow(jets(0.9, [400.0, 90.0], 0.0), 4.0),
        ),
        (
            "jets along their axis",
            narrow(jets(0.5, [60.0, 0.0], 0.0), 25.0),
        ),
        ("wide and fast jets", wide_jets),
        ("jets through a disk with thickness 0.3", jets_in_matter),
        ("jets with knots", jets(0.9, [30.0, 70.0], 1.0)),
    ];
    let in_sky = [
        (
            "camera in the matter, at rest at 6 r_s",
            in_matter(6.0, 87.0),
        ),
        ("camera in the matter, in orbit at 6 r_s", orbit),
        ("camera at 0.9 r_+, falling", inside(0.0)),
        ("camera at 0.9 r_+, falling", inside(0.9)),
        ("camera in a jet", jets(0.9, [9.0, 12.0], 0.0)),
        ("camera at 0.9 r_+, falling, with jets", falling_among_jets),
    ];
    let picture = in_picture.map(|(name, scene)| {
        Cell::new(GROUP, name, scene, |scene| rays_over_picture(scene, count))
    });
    let sky = in_sky.map(|(name, scene)| Cell::new(GROUP, name, scene, |_| rays_over_sky(count)));
    let tangent = [(0.0, 12.0), (0.9, 12.0), (0.9, 200.0)].map(|(spin, depth)| {
        let name = format!("rays tangent to the matter, depth {depth}");
        let scene = thick_scene(spin, camera, 0.06, depth);
        Cell::new(GROUP, name, scene, |scene| tangent_rays(scene, count))
    });
    picture.into_iter().chain(sky).chain(tangent).collect()
}

/// Rays that graze the matter from within, on both sides of its rim.
fn tangent_rays(scene: &Scene, count: usize) -> Vec<Ray> {
    let size = scene.picture.size().as_dvec2();
    let at = |column: usize, row: f64| {
        let x = (column as f64 + 0.5) / COLUMNS as f64 * size.x;
        Ray::toward(scene.camera.looking(glam::dvec2(x, row), size))
    };
    let meets = |ray: Ray| {
        let found = true_passages(scene, &[ray], 1e-2);
        found.is_some_and(|passages| passages[0].depth > 0.0)
    };
    let pixel = scene.camera.fov_deg.to_radians() / size.y;
    let each = count.div_ceil(COLUMNS);
    let mut rays = Vec::new();
    for column in 0..COLUMNS {
        // From above the disk downward, the first ray that meets it.
        let rows = (0..64).map(|i| f64::from(i) / 64.0 * size.y);
        let rows: Vec<f64> = rows.collect();
        let first = rows.iter().position(|row| meets(at(column, *row)));
        let Some(first) = first.filter(|first| *first > 0) else {
            continue;
        };
        let [mut above, mut below] = [rows[first - 1], rows[first]];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (above + below);
            if meets(at(column, middle)) {
                below = middle;
            } else {
                above = middle;
            }
        }
        let [near, far] = TANGENT.map(f64::ln);
        let aside = |i: usize| (near + (far - near) * i as f64 / each as f64).exp() / pixel;
        rays.extend((0..each).map(|i| at(column, below + aside(i))));
    }
    rays
}
