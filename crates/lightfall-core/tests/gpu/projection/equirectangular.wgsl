// The equirectangular projection, for tests: columns are longitudes and rows are latitudes, with the
// camera's forward in the middle.
//
// Needs: PI, atan2_precise, scene, sin_cos_precise.
// Gives: is_in_view, pixel_direction, pixel_solid_angle, project, ray_solid_angle, shown_place.

var<private> ray_solid_angle: f32;

// Longitude and latitude of a place.
fn angles_at(place: vec2<f32>) -> vec2<f32> {
    return PI * (place / scene.picture.whole * vec2<f32>(2.0, -1.0) + vec2<f32>(-1.0, 0.5));
}

fn pixel_direction(place: vec2<f32>) -> vec3<f32> {
    let angles = angles_at(place);
    let longitude = sin_cos_precise(angles.x);
    let latitude = sin_cos_precise(angles.y);
    ray_solid_angle = pixel_solid_angle(place);
    return vec3<f32>(latitude.y * longitude.x, latitude.x, latitude.y * longitude.y);
}

fn project(direction: vec3<f32>) -> vec2<f32> {
    let longitude = atan2_precise(direction.x, direction.z);
    let latitude = atan2_precise(direction.y, length(direction.xz));
    return (vec2<f32>(longitude, latitude) / PI * vec2<f32>(0.5, -1.0) + 0.5) * scene.picture.whole;
}

fn is_in_view(direction: vec3<f32>, margin: f32) -> bool {
    return true;
}

// Beyond a pole the rows go on half a turn farther on; beyond the sides the columns begin again.
fn shown_place(place: vec2<f32>) -> vec2<f32> {
    let size = scene.picture.whole;
    let is_beyond_pole = place.y < 0.0 || place.y > size.y;
    let row = select(place.y, select(2.0 * size.y - place.y, -place.y, place.y < 0.0), is_beyond_pole);
    let column = place.x + select(0.0, 0.5 * size.x, is_beyond_pole);
    return vec2<f32>(column - size.x * floor(column / size.x), row);
}

fn pixel_solid_angle(place: vec2<f32>) -> f32 {
    let side = PI * vec2<f32>(2.0, 1.0) / scene.picture.whole;
    return side.x * side.y * abs(sin_cos_precise(angles_at(place).y).y);
}
