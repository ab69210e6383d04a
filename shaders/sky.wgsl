// The light of the sky. Sources at infinity have fixed directions in the hole's frame; their light
// arrives shifted by g.
//
// Gives: MAX_SPOT_RADIUS, shifted_spot_radius, sky_light, spot_profile.

// The largest radius of the image of a star or line: the charts of stars leave this much room
// around every star.
const MAX_SPOT_RADIUS: f32 = 0.008;

// Radius on the sky of the image of a point or line, which is one and a half pixels in the picture.
// A moving or deep observer sees the sky shrunk by g.
fn shifted_spot_radius(g: f32) -> f32 {
    return clamp(scene.sky.spot_radius * g, TINY, MAX_SPOT_RADIUS);
}

// Share of the light at a squared distance from the center of an image of this radius.
fn spot_profile(distance2: f32, radius: f32) -> f32 {
    let inside = max(1.0 - distance2 / (radius * radius), 0.0);
    return inside * inside * inside;
}

// The footprint is the difference of the direction from those of neighbouring rays.
fn sky_light(direction: vec3<f32>, shift: f32, footprint: Footprint) -> vec3<f32> {
    let g = min(shift, 1e6);
    let light = sky_background(direction, g, footprint) + reference_star_light(direction, g, footprint);
    return light * (beaming_factor(g) * scene.sky.brightness);
}
