// The mesh of rays through the picture, by which the images of stars are found without an
// inversion. gpu/stars/mesh.rs has the same structs.
//
// Gives: MeshPoint, cell_number, in_list, mesh, mesh_cells, mesh_place.

struct StarMesh {
    // The place of the first point, in pixels.
    origin: vec2<f32>,
    // Points in a row, and rows.
    points: vec2<u32>,
    // Rows of the rotation from the hole's frame to that of the list of stars; between them, in
    // pixels, the distance between neighbouring points and that from an image of the rays that
    // measure its magnification, and the capacity of each list of candidates.
    list_x: vec3<f32>,
    spacing: f32,
    list_y: vec3<f32>,
    half_step: f32,
    list_z: vec3<f32>,
    capacity: u32,
    // Rows of the rotation from the directions (right, up, forward) of the mesh's own picture to those
    // of the picture that is drawn.
    picture_right: vec3<f32>,
    picture_up: vec3<f32>,
    picture_forward: vec3<f32>,
}

// The result of the ray through a point of the mesh.
struct MeshPoint {
    // Unit vector toward the source, in the frame of the list of stars.
    sky: vec3<f32>,
    // Angle swept about the hole.
    turn: f32,
    // The factor by which motion and gravity multiply the flux of a star there, or -1 where the ray
    // does not reach the sky.
    gain: f32,
}

@group(0) @binding(BINDING_STAR_MESH) var<uniform> mesh: StarMesh;

// A direction of the hole's frame in the frame of the list of stars.
fn in_list(direction: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(dot(mesh.list_x, direction), dot(mesh.list_y, direction), dot(mesh.list_z, direction));
}

// Cells in a row, and rows of cells.
fn mesh_cells() -> vec2<u32> {
    return max(mesh.points, vec2<u32>(2u)) - 1u;
}

// The cell with this number.
fn cell_number(number: u32) -> vec2<u32> {
    let columns = mesh_cells().x;
    return vec2<u32>(number % columns, number / columns);
}

// The place in the picture, in pixels, of a place in the mesh, in cells.
fn mesh_place(place: vec2<f32>) -> vec2<f32> {
    return mesh.origin + mesh.spacing * place;
}
