// The cells of the mesh, each of which maps the picture to the sky by two flat triangles.
//
// Gives: Cell, Triangle, cell_at, mesh_points, triangles_of.

// The rays through a cell's corners: at (0, 0), (1, 0), (0, 1) and (1, 1).
struct Cell {
    corners: array<MeshPoint, 4>,
}

// The sky at the place (x, y) of a cell is origin + along_x x + along_y y.
struct Triangle {
    origin: vec3<f32>,
    along_x: vec3<f32>,
    along_y: vec3<f32>,
}

@group(0) @binding(BINDING_MESH_POINTS) var<storage, read> mesh_points: array<MeshPoint>;

fn cell_at(cell: vec2<u32>) -> Cell {
    let first = cell.y * mesh.points.x + cell.x;
    let below = first + mesh.points.x;
    return Cell(array<MeshPoint, 4>(
        mesh_points[first],
        mesh_points[first + 1u],
        mesh_points[below],
        mesh_points[below + 1u],
    ));
}

// The triangles of a cell above and below the diagonal from (0, 0) to (1, 1).
fn triangles_of(cell: Cell) -> array<Triangle, 2> {
    let first = cell.corners[0].sky;
    let right = cell.corners[1].sky;
    let down = cell.corners[2].sky;
    let last = cell.corners[3].sky;
    return array<Triangle, 2>(
        Triangle(first, right - first, last - right),
        Triangle(first, last - down, down - first),
    );
}
