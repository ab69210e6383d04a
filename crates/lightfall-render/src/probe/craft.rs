//! The craft's parts: a body in golden foil, a dish, two wings of solar cells, an engine and a boom.
//!
//! The craft is about one unit long. x points away from the hole, y along the long axis, and z along
//! the wings.

use bevy::prelude::*;
use bevy::render::mesh::{Indices, PrimitiveTopology};
use std::f32::consts::TAU;

/// A part: its shape, its material and its place in the craft.
pub(super) type Part = (Mesh, Handle<StandardMaterial>, Transform);

/// Sides of the body, which is a prism so that its faces catch light one by one.
const SIDES: u32 = 8;
/// Panels of a wing, their size along the wing, and the gap between them.
const PANELS: usize = 3;
const PANEL: f32 = 0.19;
const PANEL_GAP: f32 = 0.012;
/// Rows of cells across a panel, and the width of a panel across the wing.
const CELL_ROWS: usize = 4;
const WING_WIDTH: f32 = 0.27;
/// The dish: its radius, its depth and the height of its rim above the body's middle.
const DISH_RADIUS: f32 = 0.27;
const DISH_DEPTH: f32 = 0.085;
const DISH_HEIGHT: f32 = 0.36;

struct Materials {
    foil: Handle<StandardMaterial>,
    metal: Handle<StandardMaterial>,
    dark_metal: Handle<StandardMaterial>,
    paint: Handle<StandardMaterial>,
    cells: Handle<StandardMaterial>,
    red_lamp: Handle<StandardMaterial>,
    white_lamp: Handle<StandardMaterial>,
}

impl Materials {
    fn new(assets: &mut Assets<StandardMaterial>) -> Self {
        let mut surface = |rgb: [f32; 3], metallic: f32, roughness: f32| {
            assets.add(StandardMaterial {
                base_color: Color::srgb_from_array(rgb),
                metallic,
                perceptual_roughness: roughness,
                double_sided: true,
                cull_mode: None,
                ..default()
            })
        };
        let foil = surface([0.95, 0.66, 0.25], 0.45, 0.38);
        let metal = surface([0.75, 0.76, 0.78], 0.4, 0.42);
        let dark_metal = surface([0.16, 0.15, 0.15], 0.4, 0.45);
        let paint = surface([0.9, 0.89, 0.86], 0.0, 0.7);
        let cells = surface([0.03, 0.05, 0.16], 0.45, 0.22);
        let mut lamp = |red, green, blue| {
            assets.add(StandardMaterial {
                base_color: Color::BLACK,
                emissive: LinearRgba::rgb(red, green, blue),
                ..default()
            })
        };
        Self {
            foil,
            metal,
            dark_metal,
            paint,
            cells,
            red_lamp: lamp(3.0, 0.35, 0.15),
            white_lamp: lamp(2.2, 2.4, 2.6),
        }
    }
}

/// The parts of a craft.
pub(super) fn parts(assets: &mut Assets<StandardMaterial>) -> Vec<Part> {
    let materials = Materials::new(assets);
    let mut parts = body(&materials);
    parts.extend(dish(&materials));
    for side in [-1.0, 1.0] {
        parts.extend(wing(&materials, side));
    }
    parts.extend(engine(&materials));
    parts.extend(boom(&materials));
    parts
}

fn body(materials: &Materials) -> Vec<Part> {
    let mut parts = vec![
        (
            faceted(0.13, 0.34),
            materials.foil.clone(),
            at(0.0, 0.0, 0.0),
        ),
        (
            faceted(0.142, 0.025),
            materials.metal.clone(),
            at(0.0, 0.17, 0.0),
        ),
        (
            faceted(0.142, 0.025),
            materials.metal.clone(),
            at(0.0, -0.17, 0.0),
        ),
        (
            faceted(0.137, 0.05),
            materials.dark_metal.clone(),
            at(0.0, 0.03, 0.0),
        ),
        (
            frustum(0.07, 0.12, 0.09),
            materials.metal.clone(),
            at(0.0, 0.225, 0.0),
        ),
        (
            ball(0.016),
            materials.white_lamp.clone(),
            at(0.15, 0.12, 0.0),
        ),
        (
            ball(0.016),
            materials.red_lamp.clone(),
            at(-0.15, -0.12, 0.0),
        ),
    ];
    // Boxes of instruments on every second face.
    for (number, height) in [(0, -0.07), (2, 0.1), (4, -0.02), (6, 0.09)] {
        let turn = Quat::from_rotation_y(TAU * (number as f32 + 0.5) / SIDES as f32);
        let place = turn * Vec3::new(0.145, height, 0.0);
        let instrument = Mesh::from(Cuboid::new(0.05, 0.09, 0.07));
        let transform = Transform::from_translation(place).with_rotation(turn);
        parts.push((instrument, materials.paint.clone(), transform));
    }
    parts
}

/// A dish on a mast, with its horn on three struts, that looks along the long axis.
fn dish(materials: &Materials) -> Vec<Part> {
    let horn = Vec3::new(0.0, DISH_HEIGHT + 0.17, 0.0);
    let mut parts = vec![
        (
            paraboloid(),
            materials.paint.clone(),
            at(0.0, DISH_HEIGHT, 0.0),
        ),
        (
            torus(0.007, DISH_RADIUS),
            materials.dark_metal.clone(),
            at(0.0, DISH_HEIGHT, 0.0),
        ),
        (
            frustum(0.03, 0.018, 0.05),
            materials.dark_metal.clone(),
            Transform::from_translation(horn),
        ),
        (
            ball(0.014),
            materials.red_lamp.clone(),
            at(0.0, horn.y + 0.045, 0.0),
        ),
    ];
    for strut in 0..3 {
        let turn = Quat::from_rotation_y(TAU * strut as f32 / 3.0);
        let foot = turn * Vec3::new(0.75 * DISH_RADIUS, DISH_HEIGHT - 0.035, 0.0);
        parts.push(rod(foot, horn, 0.006, &materials.metal));
    }
    parts
}

fn wing(materials: &Materials, side: f32) -> Vec<Part> {
    let first = 0.24;
    let length = PANELS as f32 * (PANEL + PANEL_GAP);
    let root = Vec3::new(0.0, 0.0, 0.12 * side);
    let tip = Vec3::new(0.0, 0.0, (first + length) * side);
    let mut parts = vec![rod(root, tip, 0.011, &materials.metal)];
    for panel in 0..PANELS {
        let middle = side * (first + (panel as f32 + 0.5) * (PANEL + PANEL_GAP));
        let frame = Mesh::from(Cuboid::new(0.008, WING_WIDTH, PANEL));
        parts.push((frame, materials.metal.clone(), at(0.0, 0.0, middle)));
        let cell = Vec2::new(WING_WIDTH / CELL_ROWS as f32, PANEL / 2.0);
        for (row, column) in (0..CELL_ROWS).flat_map(|row| (0..2).map(move |column| (row, column)))
        {
            let y = (row as f32 + 0.5) * cell.x - 0.5 * WING_WIDTH;
            let z = middle + (column as f32 - 0.5) * cell.y;
            let size = Vec3::new(0.014, cell.x - 0.008, cell.y - 0.008);
            let shape = Mesh::from(Cuboid::from_size(size));
            parts.push((shape, materials.cells.clone(), at(0.0, y, z)));
        }
    }
    parts
}

fn engine(materials: &Materials) -> Vec<Part> {
    let mut parts = vec![
        (
            frustum(0.045, 0.09, 0.13),
            materials.dark_metal.clone(),
            at(0.0, -0.32, 0.0),
        ),
        (
            frustum(0.08, 0.05, 0.06),
            materials.metal.clone(),
            at(0.0, -0.22, 0.0),
        ),
    ];
    // Tanks around the engine.
    for tank in 0..4 {
        let turn = Quat::from_rotation_y(TAU * (tank as f32 + 0.5) / 4.0);
        let place = turn * Vec3::new(0.1, -0.225, 0.0);
        parts.push((
            ball(0.052),
            materials.paint.clone(),
            Transform::from_translation(place),
        ));
    }
    parts
}

/// A thin boom that carries a magnetometer, far from the body's own fields.
fn boom(materials: &Materials) -> Vec<Part> {
    let (root, tip) = (Vec3::new(0.1, -0.1, 0.05), Vec3::new(0.5, -0.42, 0.1));
    let sensor = Mesh::from(Cuboid::new(0.03, 0.03, 0.03));
    vec![
        rod(root, tip, 0.006, &materials.metal),
        (
            sensor,
            materials.foil.clone(),
            Transform::from_translation(tip),
        ),
    ]
}

fn at(x: f32, y: f32, z: f32) -> Transform {
    Transform::from_xyz(x, y, z)
}

fn ball(radius: f32) -> Mesh {
    Sphere::new(radius).into()
}

/// A cone without its tip.
fn frustum(radius_top: f32, radius_bottom: f32, height: f32) -> Mesh {
    let frustum = ConicalFrustum {
        radius_top,
        radius_bottom,
        height,
    };
    frustum.into()
}

fn torus(minor_radius: f32, major_radius: f32) -> Mesh {
    let torus = Torus {
        minor_radius,
        major_radius,
    };
    torus.into()
}

/// A rod from one point to another.
fn rod(from: Vec3, to: Vec3, radius: f32, material: &Handle<StandardMaterial>) -> Part {
    let along = to - from;
    let turn = Quat::from_rotation_arc(Vec3::Y, along.normalize());
    let place = Transform::from_translation(0.5 * (from + to)).with_rotation(turn);
    let cylinder = Cylinder::new(radius, along.length()).mesh().resolution(8);
    (cylinder.into(), material.clone(), place)
}

/// A prism with flat faces about the y axis.
fn faceted(radius: f32, height: f32) -> Mesh {
    let prism = Cylinder::new(radius, height).mesh().resolution(SIDES);
    let mesh = Mesh::from(prism).with_duplicated_vertices();
    mesh.with_computed_flat_normals()
}

/// The bowl of the dish, open toward y, with its rim at zero.
fn paraboloid() -> Mesh {
    const RINGS: u32 = 8;
    const SECTORS: u32 = 40;
    let mut positions = Vec::new();
    let mut normals = Vec::new();
    for ring in 0..=RINGS {
        let share = ring as f32 / RINGS as f32;
        let slope = 2.0 * DISH_DEPTH * share / DISH_RADIUS;
        for sector in 0..SECTORS {
            let (sin, cos) = (TAU * sector as f32 / SECTORS as f32).sin_cos();
            let radius = DISH_RADIUS * share;
            let height = DISH_DEPTH * (share * share - 1.0);
            positions.push([radius * cos, height, radius * sin]);
            normals.push(
                Vec3::new(-slope * cos, 1.0, -slope * sin)
                    .normalize()
                    .to_array(),
            );
        }
    }
    let corner = |ring: u32, sector: u32| ring * SECTORS + sector % SECTORS;
    let quads = (0..RINGS).flat_map(|ring| (0..SECTORS).map(move |sector| (ring, sector)));
    let indices = quads.flat_map(|(ring, sector)| {
        let inner = [corner(ring, sector), corner(ring, sector + 1)];
        let outer = [corner(ring + 1, sector), corner(ring + 1, sector + 1)];
        [inner[0], inner[1], outer[0], inner[1], outer[1], outer[0]]
    });
    Mesh::new(PrimitiveTopology::TriangleList, default())
        .with_inserted_indices(Indices::U32(indices.collect()))
        .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, positions)
        .with_inserted_attribute(Mesh::ATTRIBUTE_NORMAL, normals)
}
