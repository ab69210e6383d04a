// A disk without thickness on the way through matter with depth: an event where a ray crosses the plane.
//
// Gives: add_sheet, plane_share.

// The share of a step at which the ray crosses the plane within its first `end`; more than `end` if it does
// not. n_z'' vanishes in the plane, so Newton's method converges at once.
fn plane_share(path: Curve, end: f32) -> f32 {
    let z = vec2<f32>(path.c0.y, curve_at(path, end).y);
    if !crosses_plane(z.x, z.y) {
        return end + 1.0;
    }
    var share = end * z.x / (z.x - z.y);
    for (var i = 0u; i < 2u; i++) {
        share = clamp(share - curve_at(path, share).y / curve_slope(path, share).y, 0.0, end);
    }
    return share;
}

// Adds the disk where the ray crosses the plane, if it is there.
fn add_sheet(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, share: f32) {
    let y = curve_at(way.path, share);
    let r = 1.0 / max(way.motion.base + y.x, TINY);
    if !in_annulus(r) {
        return;
    }
    var toward = y.zw * inverseSqrt(max(dot(y.zw, y.zw), TINY));
    if SPINNING && AZIMUTH {
        var gain = azimuth_gain(way.motion, way.path, way.h, share, y.x, way.regular, way.ingoing);
        if way.ingoing {
            gain += azimuth_lag_to_infinity(way.motion, y.x);
        }
        toward = rotate_z(toward, sin_cos_precise(wrap_angle(add_angle(way.chi, gain))));
    }
    let delay = way.delay + crossing_delay(way.motion, way.step, way.h, share, y.x);
    var record = empty_trace();
    add_hit(&record, vec3<f32>(r * toward, 0.0), photon.energy, orbit.lambda, delay);
    let footprint = sheet_footprint(way, share, y, record.hits[0].position);
    let arriving = (*result).transmission * disk_light(photon, record.hits[0], footprint);
    weigh(way, share, r, 0.0, record.hits[0].g, arriving);
    (*result).light += arriving;
    (*result).transmission *= disk_transmission(r);
}
