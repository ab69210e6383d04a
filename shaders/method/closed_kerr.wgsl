// The method closed around a spinning hole: Kerr's null geodesics in closed form, with real
// arithmetic, without steps and residuals. closed_kerr_radial.wgsl has the motion in r,
// closed_kerr_polar.wgsl the motion in latitude and closed_kerr_azimuth.wgsl the azimuth; this file
// finds the hits and the outcome.
//
// Gives: trace.

// Maximum number of crossings of the plane: rays next to the critical curve go round ten times.
const MAX_CROSSINGS: u32 = 24u;
// Where |u'| is below this share of E, the ray lingers near the critical orbit, and a step of
// Newton's method on the time improves u.
const SLOW_SHARE: f32 = 0.2;

// The Mino times at which a ray reaches its centre, which is the turning point or the place where
// it is slowest, and its end; and the places from which u is computed.
struct Schedule {
    centre: f32,
    end: f32,
    at_centre: Anchor,
    // (u, u') at the camera and at the end.
    at_camera: vec2<f32>,
    at_end: vec2<f32>,
}

// u at the time t, from the nearest of camera, centre and end, because errors grow with the time.
fn u_at(m: Radial, series: LaurentSeries, s: Schedule, t: f32) -> f32 {
    let from_end = t + t > s.end;
    var since = select(t, s.end - t, from_end);
    let place = select(s.at_camera, s.at_end, vec2<bool>(from_end));
    var anchor = anchor_at(m, place.x, place.y);
    if abs(t - s.centre) < since {
        anchor = s.at_centre;
        anchor.slope *= sign(t - s.centre);
        since = max(abs(t - s.centre), TINY);
    }
    return u_after(m, series, anchor, since);
}

// One step of Newton's method toward the u that the ray reaches at the time t. Where the ray is
// slow, the time at a place is more accurate than the place at a time.
fn newton_step_in_time(m: Radial, s: Schedule, centre: Centre, turns: bool, inward: bool, u: f32, t: f32) -> f32 {
    let speed = sqrt(potential(m, u));
    var arguments: TimeArguments;
    var target_time = t;
    var rate = select(-speed, speed, inward);
    if turns {
        arguments = time_from_turn(centre, centre.side * (centre.u - u));
        target_time = abs(t - s.centre);
        rate = -centre.side * speed;
    } else {
        arguments = time_between(m, vec2<f32>(s.at_camera.x, abs(s.at_camera.y)), vec2<f32>(u, speed));
    }
    return u + rate * (target_time - mino_time(m, arguments));
}

fn trace(photon: Photon) -> Trace {
    var result = empty_trace();
    result.outcome = OUTCOME_CAPTURED;
    let orbit = kerr_ray(photon);
    let c = orbit.constants;
    if camera_is_inside() && c.horizon_w <= 0.0 {
        // The light comes through the horizon's other branch, and nothing from outside does.
        return result;
    }
    let u_0 = scene.observer.u;
    let slope = orbit.scale * photon.radial;
    let m = radial_of(c, slope);
    let inward = slope > 0.0;
    let outside_barrier = u_0 < m.barrier;
    // Light of negative energy does not come from infinity.
    let escapes = m.energy > 0.0 && select(!inward, outside_barrier, m.has_barrier);
    let turns = m.has_barrier && inward == outside_barrier;

    // A ray that does not escape is followed to the disk's inner edge.
    let u_inner = 1.0 / scene.disk.inner;
    let u_end = select(u_inner, 0.0, escapes);
    let course = radial_course(m, c, slope, u_end);
    let centre = course.centre;
    let comes_from_disk = select(inward && u_0 < u_inner, centre.u < u_inner, turns);
    if !(escapes || HAS_DISK && comes_from_disk) {
        return result;
    }
    let polar = polar_of(scene.observer.position_direction, -orbit.w, orbit.k, orbit.angular_momentum, c);
    // Rays that turn beyond the disk's outer edge meet no disk.
    let deepest = select(max(u_0, u_end), centre.u, turns && outside_barrier);
    let may_hit = HAS_DISK && polar.crosses && deepest * scene.disk.outer > 1.0;

    // The times of the centre and of the end, from the camera or from the turning point.
    let camera = vec2<f32>(u_0, abs(slope));
    let speed_end = select(sqrt(potential(m, u_end)), m.energy, escapes);
    var to_centre: TimeArguments;
    var to_end: TimeArguments;
    if turns {
        to_centre = time_from_turn(centre, course.distance);
        to_end = time_from_turn(centre, centre.side * (centre.u - u_end));
    } else {
        to_centre = time_between(m, camera, vec2<f32>(centre.u, sqrt(centre.c_0)));
        to_end = time_between(m, camera, vec2<f32>(u_end, speed_end));
    }
    let centre_time = mino_time(m, to_centre);
    var end_time = mino_time(m, to_end) + select(0.0, centre_time, turns);
    if is_slow_outgoing(m, slope) {
        end_time = slow_outgoing_time(m, centre, vec2<f32>(u_end, speed_end));
    }
    // A centre at the camera or at the end is not a third place to compute u from.
    let passes = !m.has_barrier && centre.u != u_0 && centre.u != u_end;

    if may_hit {
        let series = radial_series(m);
        let schedule = Schedule(
            select(0.0, centre_time, turns || passes),
            end_time,
            anchor_at_centre(centre, sqrt(centre.c_0) * select(-1.0, 1.0, u_end > u_0)),
            vec2<f32>(u_0, slope),
            vec2<f32>(u_end, select(-speed_end, speed_end, escapes)),
        );
        var t = polar.first_crossing;
        for (var i = 0u; i < MAX_CROSSINGS; i++) {
            if t >= end_time || result.hit_count >= MAX_HITS {
                break;
            }
            var u = u_at(m, series, schedule, t);
            let slow = m.base > 0.0 && potential(m, u) < square(SLOW_SHARE * m.energy);
            if slow {
                u = newton_step_in_time(m, schedule, centre, turns, inward, u, t);
            }
            if u * scene.disk.outer > 1.0 && u * scene.disk.inner < 1.0 {
                let returned = turns && t > centre_time;
                // Pictures of a smooth disk need neither the azimuth of a hit nor its delay.
                var azimuth = 0.0;
                if AZIMUTH {
                    azimuth = dragged_azimuth(m, c, course, u, returned, t, centre_time);
                }
                var place = vec3<f32>(1.0, 0.0, 0.0);
                var delay = 0.0;
                if AZIMUTH || DELAY {
                    let there = place_after(polar, t, azimuth);
                    place = vec3<f32>(there.n.xy * inverseSqrt(max(dot(there.n.xy, there.n.xy), TINY)), 0.0);
                    delay = crossing_delay(m, c, course, inward, u, returned, t, there.height2);
                }
                if DIAGNOSTICS && result.hit_count == 0u {
                    result.turn = arc_after(polar, t);
                }
                add_hit(&result, place / u, photon.energy, orbit.lambda, delay);
            }
            t += polar.period;
        }
    }
    if escapes {
        result.outcome = OUTCOME_SKY;
        if DIAGNOSTICS && result.hit_count == 0u {
            result.turn = arc_after(polar, end_time);
        }
        if !FOLLOW_BEYOND_HITS && result.hit_count == MAX_HITS {
            result.outcome = OUTCOME_HIDDEN;
        } else if SKY_DIRECTION {
            let azimuth = dragged_azimuth(m, c, course, 0.0, turns, end_time, centre_time);
            result.sky = safe_normalize(place_after(polar, end_time, azimuth).n);
        }
    }
    return result;
}
