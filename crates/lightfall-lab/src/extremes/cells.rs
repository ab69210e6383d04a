//! The hardest places, by what makes them hard.

use glam::DVec3;
use lightfall_accuracy::{
    EDGE_DISTANCES, Ray, rays_near_edge, rays_over_picture, rays_over_picture_and_near_edge,
    rays_over_sky,
};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::scene::{ObserverKind, Scene};

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

/// Every cell, with about `count` rays each.
pub fn cells(count: usize) -> Vec<Cell> {
    let mut all = Vec::new();
    distances(&mut all, count);
    spins(&mut all, count);
    radii(&mut all, count);
    axis(&mut all, count);
    radial(&mut all);
    plane(&mut all, count);
    fields_of_view(&mut all, count);
    disks(&mut all, count);
    observers(&mut all, count);
    all
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

fn add(all: &mut Vec<Cell>, group: &'static str, name: String, scene: Scene, rays: Vec<Ray>) {
    all.push(Cell {
        group,
        name,
        scene,
        rays,
    });
}

fn distances(all: &mut Vec<Cell>, count: usize) {
    for spin in [0.0, 0.9, 0.998] {
        for decade in 1..=6 {
            let range = [10_f64.powi(-decade - 1), 10_f64.powi(-decade)];
            let scene = base_scene(spin, 20.0);
            let rays = rays_near_edge(&scene, count, range);
            add(
                all,
                "distance to the critical curve",
                format!("chi {spin}, 1e-{} to 1e-{decade}", decade + 1),
                scene,
                rays,
            );
        }
    }
}

fn spins(all: &mut Vec<Cell>, count: usize) {
    for size in [0.0, 0.5, 0.9, 0.98, 0.998, 0.9999, 0.999999] {
        for spin in if size == 0.0 {
            vec![0.0]
        } else {
            vec![size, -size]
        } {
            let scene = base_scene(spin, 5.0);
            let rays = sky_and_edge_rays(&scene, count);
            add(all, "spin", format!("chi {spin}, from 5 r_s"), scene, rays);
        }
    }
}

fn radii(all: &mut Vec<Cell>, count: usize) {
    for spin in [0.0, 0.9] {
        let deep = 1.0001 * Kerr { spin }.horizon();
        for (name, r) in [("1.0001 r_+, falling".to_owned(), deep)]
            .into_iter()
            .chain([1.01, 1.12, 1.5, 3.0, 1e3, 1e5, 1e7].map(|r| (format!("{r} r_s"), r)))
        {
            let mut scene = base_scene(spin, r);
            scene.observer.kind = if r == deep {
                ObserverKind::Rain
            } else {
                ObserverKind::Zamo
            };
            // Far away, the field of view is narrowed to the hole and its disk.
            scene.camera.fov_deg = scene.camera.fov_deg.min((30.0 / r).to_degrees());
            let rays = rays_over_picture_and_near_edge(&scene, count);
            add(
                all,
                "place of the camera",
                format!("chi {spin}, {name}"),
                scene,
                rays,
            );
        }
    }
}

fn axis(all: &mut Vec<Cell>, count: usize) {
    for spin in [0.0, 0.9] {
        for (name, theta) in [("on the axis", 0.0), ("1e-6 rad off the axis", 1e-6)] {
            let mut scene = base_scene(spin, 10.0);
            scene.camera.theta_deg = f64::to_degrees(theta);
            let rays = sky_and_edge_rays(&scene, count);
            add(
                all,
                "axis",
                format!("chi {spin}, camera {name}"),
                scene,
                rays,
            );
        }
        for (name, aside) in [
            ("no angular momentum", 0.0),
            ("1e-7 of the whole", 1e-7),
            ("1e-4 of the whole", 1e-4),
        ] {
            let mut scene = base_scene(spin, 10.0);
            scene.observer.kind = ObserverKind::Zamo;
            // A ZAMO sees light without angular momentum in the meridional plane.
            let rays = (0..count).map(|i| {
                let (sin, cos) =
                    (std::f64::consts::TAU * (i as f64 + 0.5) / count as f64).sin_cos();
                ray_in_tetrad(&scene, DVec3::new(cos, sin, aside))
            });
            let rays = rays.collect();
            add(
                all,
                "axis",
                format!("chi {spin}, rays through it, {name}"),
                scene,
                rays,
            );
        }
    }
}

/// The ray of a direction on the observer's axes.
fn ray_in_tetrad(scene: &Scene, direction: DVec3) -> Ray {
    Ray::toward(scene.camera.tetrad_from_camera().transpose() * direction)
}

fn radial(all: &mut Vec<Cell>) {
    for spin in [0.0, 0.9] {
        for (name, aside) in [
            ("exactly", 0.0),
            ("within 1e-7 rad", 1e-7),
            ("within 1e-5 rad", 1e-5),
        ] {
            let mut scene = base_scene(spin, 10.0);
            scene.observer.kind = ObserverKind::Zamo;
            let round = (0..16).flat_map(|i| {
                let (sin, cos) = (std::f64::consts::TAU * (f64::from(i) + 0.5) / 16.0).sin_cos();
                [-1.0, 1.0].map(|outward| DVec3::new(outward, aside * sin, aside * cos))
            });
            let rays = round
                .map(|direction| ray_in_tetrad(&scene, direction))
                .collect();
            add(
                all,
                "radial",
                format!("chi {spin}, in and out, {name}"),
                scene,
                rays,
            );
        }
    }
}

fn plane(all: &mut Vec<Cell>, count: usize) {
    for spin in [0.0, 0.9] {
        for (name, above) in [("in it", 0.0), ("1e-6 rad above it", 1e-6)] {
            let mut scene = base_scene(spin, 12.0);
            scene.camera.theta_deg = 90.0 - f64::to_degrees(above);
            let rays = sky_and_edge_rays(&scene, count);
            add(
                all,
                "plane of the disk",
                format!("chi {spin}, camera {name}"),
                scene.clone(),
                rays,
            );
            for (rays_name, tilt) in [("in it", 0.0), ("grazing it at 1e-6 rad", 1e-6)] {
                let rays = (0..count).map(|i| {
                    let (sin, cos) =
                        (std::f64::consts::TAU * (i as f64 + 0.5) / count as f64).sin_cos();
                    ray_in_tetrad(
                        &scene,
                        DVec3::new(cos, if i % 2 == 0 { tilt } else { -tilt }, sin),
                    )
                });
                let rays = rays.collect();
                add(
                    all,
                    "plane of the disk",
                    format!("chi {spin}, camera {name}, rays {rays_name}"),
                    scene.clone(),
                    rays,
                );
            }
        }
    }
}

fn fields_of_view(all: &mut Vec<Cell>, count: usize) {
    for spin in [0.0, 0.9] {
        for (name, radians) in [("1e-6 rad", 1e-6), ("1e-4 rad", 1e-4), ("0.01 rad", 0.01)] {
            let mut scene = base_scene(spin, 20.0);
            scene.camera.fov_deg = f64::to_degrees(radians);
            let rays = rays_over_picture(&scene, count);
            add(
                all,
                "field of view",
                format!("chi {spin}, {name}, at the centre"),
                scene.clone(),
                rays,
            );
            // Turned aside by half the shadow's size, the camera looks at its edge or close to it.
            scene.camera.yaw_deg = 7.27;
            let rays = rays_over_picture(&scene, count);
            add(
                all,
                "field of view",
                format!("chi {spin}, {name}, at the shadow's edge"),
                scene,
                rays,
            );
        }
        let mut scene = base_scene(spin, 20.0);
        scene.camera.fov_deg = 179.0;
        let rays = rays_over_picture(&scene, count);
        add(
            all,
            "field of view",
            format!("chi {spin}, 179 degrees"),
            scene,
            rays,
        );
    }
}

fn disks(all: &mut Vec<Cell>, count: usize) {
    for spin in [0.0, 0.9] {
        for (name, inner, outer, r) in [
            ("from the ISCO to 1e5 r_s, from 20 r_s", 1.0, 1e5, 20.0),
            ("from the ISCO to 1e5 r_s, from 1e5 r_s", 1.0, 1e5, 1e5),
            ("a ring from 8 to 8.00001 r_s", 8.0, 8.00001, 20.0),
            ("a ring from 5000 to 5000.01 r_s", 5000.0, 5000.01, 1e4),
        ] {
            let mut scene = base_scene(spin, r);
            (scene.disk.follow_isco, scene.disk.inner, scene.disk.outer) = (false, inner, outer);
            let rays = sky_and_edge_rays(&scene, count);
            add(all, "disk", format!("chi {spin}, {name}"), scene, rays);
        }
    }
}

fn observers(all: &mut Vec<Cell>, count: usize) {
    for spin in [0.0, 0.9] {
        let mut fast = Vec::new();
        for speed in [0.9, 0.99, 0.9999] {
            for (name, axis) in [
                ("outward", DVec3::X),
                ("inward", -DVec3::X),
                ("across", DVec3::NEG_Z),
            ] {
                fast.push((
                    ObserverKind::Static,
                    5.0,
                    (speed * axis).to_array(),
                    format!("{speed} c {name}, from 5 r_s"),
                ));
            }
        }
        fast.push((
            ObserverKind::Orbit,
            1.6,
            [0.0; 3],
            "on the orbit at 1.6 r_s".into(),
        ));
        fast.push((
            ObserverKind::Rain,
            1.6,
            [0.0; 3],
            "falling past 1.6 r_s".into(),
        ));
        for (kind, r, velocity, name) in fast {
            let mut scene = base_scene(spin, r);
            (scene.observer.kind, scene.observer.velocity) = (kind, velocity);
            scene.camera.theta_deg = if kind == ObserverKind::Orbit {
                90.0
            } else {
                75.0
            };
            let rays = sky_and_edge_rays(&scene, count);
            add(all, "observer", format!("chi {spin}, {name}"), scene, rays);
        }
    }
}
