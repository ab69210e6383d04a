//! The hardest places, by what makes them hard.

use glam::DVec3;
use lightfall_accuracy::{
    EDGE_DISTANCES, Ray, rays_near_edge, rays_over_picture, rays_over_picture_and_near_edge,
    rays_over_sky,
};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::scene::{ObserverKind, Scene};
use std::f64::consts::TAU;
use std::fmt::Display;

/// A scene and rays through it.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// What is extreme.
    pub group: &'static str,
    /// How extreme it is.
    pub name: String,
    /// The scene. Its method does not matter.
    pub scene: Scene,
    /// The rays.
    pub rays: Vec<Ray>,
}

impl Cell {
    /// The cell of a scene and its rays. Its name begins with the spin.
    pub(super) fn new(
        group: &'static str,
        name: impl Display,
        scene: Scene,
        rays: impl FnOnce(&Scene) -> Vec<Ray>,
    ) -> Self {
        Self {
            group,
            name: format!("chi {}, {name}", scene.hole.spin),
            rays: rays(&scene),
            scene,
        }
    }
}

/// The spins of the groups that are not about spin.
const SPINS: [f64; 2] = [0.0, 0.9];

/// Every cell, with about `count` rays each.
pub fn cells(count: usize) -> Vec<Cell> {
    let groups: [(&[f64], fn(f64, usize) -> Vec<Cell>); 9] = [
        (&[0.0, 0.9, 0.998], distances),
        (
            &[
                0.0, 0.5, -0.5, 0.9, -0.9, 0.98, -0.98, 0.998, -0.998, 0.9999, -0.9999, 0.999999,
                -0.999999,
            ],
            spins,
        ),
        (&SPINS, radii),
        (&SPINS, axis),
        (&SPINS, radial),
        (&SPINS, plane),
        (&SPINS, fields_of_view),
        (&SPINS, disks),
        (&SPINS, observers),
    ];
    let cells = |(spins, group): (&'static [f64], fn(f64, usize) -> Vec<Cell>)| {
        spins.iter().flat_map(move |spin| group(*spin, count))
    };
    groups.into_iter().flat_map(cells).collect()
}

/// The scene that all cells vary: a camera 15 degrees above the disk.
pub(super) fn base_scene(spin: f64, r: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    scene.disk.follow_isco = true;
    (scene.camera.r, scene.camera.theta_deg) = (r, 75.0);
    scene
}

/// Half of the rays over the whole sky, half near the shadow's edge.
pub(super) fn sky_and_edge_rays(scene: &Scene, count: usize) -> Vec<Ray> {
    let mut rays = rays_over_sky(count / 2);
    rays.extend(rays_near_edge(scene, count / 2, EDGE_DISTANCES));
    rays
}

/// The ray of a direction on the observer's axes.
fn ray_in_tetrad(scene: &Scene, direction: DVec3) -> Ray {
    Ray::toward(scene.camera.tetrad_from_camera().transpose() * direction)
}

/// The sines and cosines of `count` angles that divide a turn evenly.
fn around(count: usize) -> impl Iterator<Item = (f64, f64)> {
    (0..count).map(move |i| (TAU * (i as f64 + 0.5) / count as f64).sin_cos())
}

fn distances(spin: f64, count: usize) -> Vec<Cell> {
    let cell = |decade: i32| {
        let range = [10_f64.powi(-decade - 1), 10_f64.powi(-decade)];
        let name = format!("1e-{} to 1e-{decade}", decade + 1);
        let group = "distance to the critical curve";
        Cell::new(group, name, base_scene(spin, 20.0), |scene| {
            rays_near_edge(scene, count, range)
        })
    };
    (1..=6).map(cell).collect()
}

fn spins(spin: f64, count: usize) -> Vec<Cell> {
    let rays = |scene: &Scene| sky_and_edge_rays(scene, count);
    vec![Cell::new("spin", "from 5 r_s", base_scene(spin, 5.0), rays)]
}

fn radii(spin: f64, count: usize) -> Vec<Cell> {
    let deep = 1.0001 * Kerr { spin }.horizon();
    let falling = (ObserverKind::Rain, "1.0001 r_+, falling".to_owned(), deep);
    let others = [1.01, 1.12, 1.5, 3.0, 1e3, 1e5, 1e7];
    let others = others.map(|r| (ObserverKind::Zamo, format!("{r} r_s"), r));
    let cell = |(kind, name, r): (ObserverKind, String, f64)| {
        let mut scene = base_scene(spin, r);
        scene.observer.kind = kind;
        // Far away, the field of view is narrowed to the hole and its disk.
        scene.camera.fov_deg = scene.camera.fov_deg.min((30.0 / r).to_degrees());
        Cell::new("place of the camera", name, scene, |scene| {
            rays_over_picture_and_near_edge(scene, count)
        })
    };
    [falling].into_iter().chain(others).map(cell).collect()
}

fn axis(spin: f64, count: usize) -> Vec<Cell> {
    let cameras = [("on the axis", 0.0), ("1e-6 rad off the axis", 1e-6)];
    let cameras = cameras.map(|(name, theta)| {
        let mut scene = base_scene(spin, 10.0);
        scene.camera.theta_deg = f64::to_degrees(theta);
        Cell::new("axis", format!("camera {name}"), scene, |scene| {
            sky_and_edge_rays(scene, count)
        })
    });
    let through_it = [
        ("no angular momentum", 0.0),
        ("1e-7 of the whole", 1e-7),
        ("1e-4 of the whole", 1e-4),
    ];
    let through_it = through_it.map(|(name, aside)| {
        let mut scene = base_scene(spin, 10.0);
        // A ZAMO sees light without angular momentum in the meridional plane.
        scene.observer.kind = ObserverKind::Zamo;
        Cell::new("axis", format!("rays through it, {name}"), scene, |scene| {
            let directions = around(count).map(|(sin, cos)| DVec3::new(cos, sin, aside));
            directions.map(|to| ray_in_tetrad(scene, to)).collect()
        })
    });
    cameras.into_iter().chain(through_it).collect()
}

fn radial(spin: f64, _: usize) -> Vec<Cell> {
    let offsets = [
        ("exactly", 0.0),
        ("within 1e-7 rad", 1e-7),
        ("within 1e-5 rad", 1e-5),
    ];
    let cell = |(name, aside): (&str, f64)| {
        let mut scene = base_scene(spin, 10.0);
        scene.observer.kind = ObserverKind::Zamo;
        Cell::new("radial", format!("in and out, {name}"), scene, |scene| {
            let directions = around(16).flat_map(|(sin, cos)| {
                [-1.0, 1.0].map(|outward| DVec3::new(outward, aside * sin, aside * cos))
            });
            directions.map(|to| ray_in_tetrad(scene, to)).collect()
        })
    };
    offsets.map(cell).into()
}

fn plane(spin: f64, count: usize) -> Vec<Cell> {
    let cameras = [("camera in it", 0.0), ("camera 1e-6 rad above it", 1e-6)];
    let cells = cameras.map(|(name, above)| {
        let mut scene = base_scene(spin, 12.0);
        scene.camera.theta_deg = 90.0 - f64::to_degrees(above);
        let spread = Cell::new("plane of the disk", name, scene.clone(), |scene| {
            sky_and_edge_rays(scene, count)
        });
        let grazing = [("in it", 0.0), ("grazing it at 1e-6 rad", 1e-6)].map(|(rays, tilt)| {
            let name = format!("{name}, rays {rays}");
            Cell::new("plane of the disk", name, scene.clone(), |scene| {
                let directions = around(count).enumerate().map(|(i, (sin, cos))| {
                    DVec3::new(cos, if i % 2 == 0 { tilt } else { -tilt }, sin)
                });
                directions.map(|to| ray_in_tetrad(scene, to)).collect()
            })
        });
        [spread].into_iter().chain(grazing)
    });
    cells.into_iter().flatten().collect()
}

fn fields_of_view(spin: f64, count: usize) -> Vec<Cell> {
    // Turned aside by half the shadow's size, the camera looks at its edge or close to it.
    let sides = [("at the centre", 0.0), ("at the shadow's edge", 7.27)];
    let narrow = [("1e-6 rad", 1e-6), ("1e-4 rad", 1e-4), ("0.01 rad", 0.01)];
    let narrow = narrow.into_iter().flat_map(|(name, radians)| {
        let fov_deg = f64::to_degrees(radians);
        sides.map(|(place, yaw_deg)| (format!("{name}, {place}"), fov_deg, yaw_deg))
    });
    let wide = ("179 degrees".to_owned(), 179.0, 0.0);
    let cell = |(name, fov_deg, yaw_deg): (String, f64, f64)| {
        let mut scene = base_scene(spin, 20.0);
        (scene.camera.fov_deg, scene.camera.yaw_deg) = (fov_deg, yaw_deg);
        Cell::new("field of view", name, scene, |scene| {
            rays_over_picture(scene, count)
        })
    };
    narrow.chain([wide]).map(cell).collect()
}

fn disks(spin: f64, count: usize) -> Vec<Cell> {
    let disks = [
        ("from the ISCO to 1e5 r_s, from 20 r_s", 1.0, 1e5, 20.0),
        ("from the ISCO to 1e5 r_s, from 1e5 r_s", 1.0, 1e5, 1e5),
        ("a ring from 8 to 8.00001 r_s", 8.0, 8.00001, 20.0),
        ("a ring from 5000 to 5000.01 r_s", 5000.0, 5000.01, 1e4),
    ];
    let cell = |(name, inner, outer, r): (&str, f64, f64, f64)| {
        let mut scene = base_scene(spin, r);
        (scene.disk.follow_isco, scene.disk.inner, scene.disk.outer) = (false, inner, outer);
        Cell::new("disk", name, scene, |scene| sky_and_edge_rays(scene, count))
    };
    disks.map(cell).into()
}

fn observers(spin: f64, count: usize) -> Vec<Cell> {
    let cell = |kind: ObserverKind, r: f64, velocity: DVec3, name: &str| {
        let mut scene = base_scene(spin, r);
        scene.observer.kind = kind;
        scene.observer.velocity = velocity.to_array();
        if kind == ObserverKind::Orbit {
            scene.camera.theta_deg = 90.0;
        }
        Cell::new("observer", name, scene, |scene| {
            sky_and_edge_rays(scene, count)
        })
    };
    let mut cells = Vec::new();
    for speed in [0.9, 0.99, 0.9999] {
        for (toward, axis) in [
            ("outward", DVec3::X),
            ("inward", -DVec3::X),
            ("across", DVec3::NEG_Z),
        ] {
            let name = format!("{speed} c {toward}, from 5 r_s");
            cells.push(cell(ObserverKind::Static, 5.0, speed * axis, &name));
        }
    }
    let name = "on the orbit at 1.6 r_s";
    cells.push(cell(ObserverKind::Orbit, 1.6, DVec3::ZERO, name));
    let name = "falling past 1.6 r_s";
    cells.push(cell(ObserverKind::Rain, 1.6, DVec3::ZERO, name));
    cells
}
