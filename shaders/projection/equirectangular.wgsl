// The equirectangular projection: columns are longitudes and rows are latitudes, with the camera's
// forward in the middle. The twin in f64 is scene/projection.rs. Places are in pixels from the upper
// left corner of the whole picture, and directions are (right, up, forward) of the camera.
// scene.picture.projection holds the angles between two columns and between two rows.
//
// Gives: coverage, image_reach, is_in_view, is_on_sky, pixel_direction, pixel_solid_angle, project,
//     ray_solid_angle, shown_place.

// The solid angle of a pixel about the last pixel_direction, in steradians.
var<private> ray_solid_angle: f32;

// Longitude and latitude of a place.
fn angles_at(place: vec2<f32>) -> vec2<f32> {
    return (place - 0.5 * scene.picture.whole) * scene.picture.projection * vec2<f32>(1.0, -1.0);
}

// The unit direction that is seen at a place.
fn pixel_direction(place: vec2<f32>) -> vec3<f32> {
    let angles = angles_at(place);
    let longitude = sin_cos_precise(angles.x);
    let latitude = sin_cos_precise(angles.y);
    ray_solid_angle = pixel_solid_angle(place);
    return vec3<f32>(latitude.y * longitude.x, latitude.x, latitude.y * longitude.y);
}

// The place at which a direction is seen: the inverse of pixel_direction.
fn project(direction: vec3<f32>) -> vec2<f32> {
    let longitude = atan2_precise(direction.x, direction.z);
    let latitude = atan2_precise(direction.y, length(direction.xz));
    let off = vec2<f32>(longitude, -latitude) / scene.picture.projection;
    return off + 0.5 * scene.picture.whole;
}

// Whether a direction is seen within the picture: all are.
fn is_in_view(direction: vec3<f32>, margin: f32) -> bool {
    return true;
}

// Whether a place shows any direction: not above the zenith and below the nadir.
fn is_on_sky(place: vec2<f32>) -> bool {
    return place.y > 0.0 && place.y < scene.picture.whole.y;
}

// The share of the pixel with its middle at a place that shows anything.
fn coverage(place: vec2<f32>) -> f32 {
    return 1.0;
}

// The place within the picture that shows the same direction as a place beside it: beyond the sides
// the columns begin again, and beyond a pole the rows go on half a turn farther on.
fn shown_place(place: vec2<f32>) -> vec2<f32> {
    let size = scene.picture.whole;
    let is_beyond_pole = place.y < 0.0 || place.y > size.y;
    let row = select(place.y, select(2.0 * size.y - place.y, -place.y, place.y < 0.0), is_beyond_pole);
    let column = place.x + select(0.0, 0.5 * size.x, is_beyond_pole);
    return vec2<f32>(column - size.x * floor(column / size.x), row);
}

// The solid angle in steradians of the pixel with its middle at this place.
fn pixel_solid_angle(place: vec2<f32>) -> f32 {
    let side = scene.picture.projection;
    return side.x * side.y * max(sin_cos_precise(angles_at(place).y).y, 0.0);
}

// Half the width and the height of the rectangle about a place that shows what lies within `reach`
// pixels of the line of sight about its direction: all columns where that includes a pole.
fn image_reach(place: vec2<f32>, reach: f32) -> vec2<f32> {
    let side = scene.picture.projection;
    let angle = reach * sqrt(side.x * side.y);
    let farthest = abs(angles_at(place).y) + angle;
    // A parallel is shorter than the equator by the cosine.
    let columns = angle / max(sin_cos_precise(min(farthest, 0.5 * PI)).y, TINY) / side.x;
    return vec2<f32>(min(columns, 0.5 * scene.picture.whole.x), angle / side.y);
}
