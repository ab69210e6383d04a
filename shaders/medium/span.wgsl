// Where a step of the method mino is inside the medium: the shares of the step between which it may
// be. A span that ends before it begins is empty.
//
// Gives: span_in_medium.

const EMPTY: vec2<f32> = vec2<f32>(1.0, 0.0);

// The share between two others at which a component of the curve, u or n_z, has a value: Newton's
// method, with a bisection where a step leaves the bracket. Where the value is found, the next step is
// rounding, which may leave the bracket, too; so the step from the best place counts.
fn share_of_value(path: Curve, component: vec4<f32>, value: f32, ends: vec2<f32>) -> f32 {
    var low = ends.x;
    var high = ends.y;
    let start = dot(component, curve_at(path, low)) - value;
    let end = dot(component, curve_at(path, high)) - value;
    var share = mix(low, high, clamp(start / select(start - end, TINY, start == end), 0.0, 1.0));
    var best = share;
    var least = abs(start) + abs(end);
    for (var i = 0u; i < MEDIUM_SEARCHES; i++) {
        let off = dot(component, curve_at(path, share)) - value;
        let before = (off > 0.0) == (start > 0.0);
        low = select(low, share, before);
        high = select(share, high, before);
        let slope = dot(component, curve_slope(path, share));
        let next = share - off / select(slope, TINY, slope == 0.0);
        if abs(off) < least {
            best = clamp(next, low, high);
            least = abs(off);
        }
        share = select(0.5 * (low + high), next, next > low && next < high);
    }
    return best;
}

const RADIAL: vec4<f32> = vec4<f32>(1.0, 0.0, 0.0, 0.0);
const POLAR: vec4<f32> = vec4<f32>(0.0, 1.0, 0.0, 0.0);

// The part of the first `end` of a step with |n_z| below `height`. Between two crossings of the plane
// |n_z| is concave.
fn span_below(path: Curve, height: f32, end: f32) -> vec2<f32> {
    let z = vec2<f32>(path.c0.y, curve_at(path, end).y);
    let outside = abs(z) > vec2<f32>(height);
    if all(outside) && z.x * z.y > 0.0 {
        return EMPTY;
    }
    var span = vec2<f32>(0.0, end);
    if outside.x {
        span.x = share_of_value(path, POLAR, sign(z.x) * height, span);
    }
    if outside.y {
        span.y = share_of_value(path, POLAR, sign(z.y) * height, span);
    }
    return span;
}

// The share at which u turns within a span, or its end.
fn turning_share(path: Curve, span: vec2<f32>) -> f32 {
    var low = span.x;
    var high = span.y;
    let inward = curve_slope(path, low).x > 0.0;
    if inward == (curve_slope(path, high).x > 0.0) {
        return high;
    }
    // The slope is almost linear within a step.
    var slopes = vec2<f32>(curve_slope(path, low).x, curve_slope(path, high).x);
    var middle = low;
    for (var i = 0u; i < MEDIUM_SEARCHES; i++) {
        let fall = slopes.x - slopes.y;
        middle = mix(low, high, clamp(slopes.x / select(fall, TINY, fall == 0.0), 0.0, 1.0));
        let slope = curve_slope(path, middle).x;
        let before = (slope > 0.0) == inward;
        low = select(low, middle, before);
        high = select(middle, high, before);
        slopes = select(vec2<f32>(slopes.x, slope), vec2<f32>(slope, slopes.y), before);
    }
    return middle;
}

// The part of a span between the disk's edges. Where r turns inside the inner edge, the part between
// the two crossings of this edge stays in.
fn span_in_annulus(path: Curve, base: f32, span: vec2<f32>) -> vec2<f32> {
    let outer = 1.0 / scene.disk.outer - base;
    let inner = 1.0 / scene.disk.inner - base;
    let turn = turning_share(path, span);
    let v = vec3<f32>(curve_at(path, span.x).x, curve_at(path, turn).x, curve_at(path, span.y).x);
    if max(v.x, max(v.y, v.z)) <= outer || turn >= span.y && min(v.x, v.z) >= inner {
        return EMPTY;
    }
    var part = span;
    if v.x < outer {
        part.x = share_of_value(path, RADIAL, outer, vec2<f32>(span.x, turn));
    } else if v.x > inner {
        part.x = select(part.x, share_of_value(path, RADIAL, inner, vec2<f32>(span.x, turn)), v.y < inner);
    }
    if v.z < outer {
        let from_turn = vec2<f32>(select(span.x, turn, turn < span.y), span.y);
        part.y = share_of_value(path, RADIAL, outer, from_turn);
    } else if v.z > inner {
        let from_turn = vec2<f32>(select(span.x, turn, turn < span.y), span.y);
        part.y = select(part.y, share_of_value(path, RADIAL, inner, from_turn), turn >= span.y && v.x < inner);
    }
    return part;
}

// How far inside the medium a place between its edges is: positive inside.
fn depth_inside(path: Curve, base: f32, share: f32) -> f32 {
    let y = curve_at(path, share);
    let opening = opening_between_edges(vec4<f32>(1.0 / max(base + y.x, TINY))).x;
    return opening - abs(y.y);
}

// Where the medium ends between a place inside and one that may be outside: secants, and a bisection after
// each secant that keeps more than half of the bracket.
fn boundary(path: Curve, base: f32, within: f32, beyond: f32) -> f32 {
    var inside = vec2<f32>(within, depth_inside(path, base, within));
    var outside = vec2<f32>(beyond, depth_inside(path, base, beyond));
    if outside.y >= 0.0 {
        return beyond;
    }
    var halve = false;
    for (var i = 0u; i < MEDIUM_SEARCHES; i++) {
        let width = outside.x - inside.x;
        let share = select(secant(inside, outside), inside.x + 0.5 * width, halve);
        let place = vec2<f32>(share, depth_inside(path, base, share));
        if place.y > 0.0 {
            inside = place;
        } else {
            outside = place;
        }
        halve = !halve && abs(outside.x - inside.x) > 0.5 * abs(width);
    }
    return secant(inside, outside);
}

// Where the line through two points, of which only the first has a positive height, has none.
fn secant(inside: vec2<f32>, outside: vec2<f32>) -> f32 {
    return inside.x + (outside.x - inside.x) * inside.y / max(inside.y - outside.y, TINY);
}

// The place of a span that is deepest inside, about, by three places and two parabolas.
fn deepest(path: Curve, base: f32, span: vec2<f32>) -> vec2<f32> {
    var width = 0.25 * (span.y - span.x);
    var best = vec2<f32>(span.x + 2.0 * width, depth_inside(path, base, span.x + 2.0 * width));
    var left = depth_inside(path, base, best.x - width);
    var right = depth_inside(path, base, best.x + width);
    if left > best.y && left >= right {
        right = best.y;
        best = vec2<f32>(best.x - width, left);
        left = depth_inside(path, base, span.x);
    } else if right > best.y {
        left = best.y;
        best = vec2<f32>(best.x + width, right);
        right = depth_inside(path, base, span.y);
    }
    for (var i = 0u; i < 2u; i++) {
        let bend = left - 2.0 * best.y + right;
        if bend >= 0.0 || best.y > 0.0 {
            break;
        }
        let share = clamp(best.x + 0.5 * width * (left - right) / bend, span.x, span.y);
        let place = vec2<f32>(share, depth_inside(path, base, share));
        if place.y > best.y {
            best = place;
        }
        width *= 0.35;
        left = depth_inside(path, base, best.x - width);
        right = depth_inside(path, base, best.x + width);
    }
    return best;
}

// The part of the first `end` of a step that may be inside the medium.
fn span_in_medium(path: Curve, base: f32, end: f32) -> vec2<f32> {
    var span = span_below(path, max_half_opening(), end);
    if span.x >= span.y {
        return EMPTY;
    }
    span = span_in_annulus(path, base, span);
    if span.x >= span.y {
        return EMPTY;
    }
    let z = vec2<f32>(curve_at(path, span.x).y, curve_at(path, span.y).y);
    var from_place = span.x;
    if z.x * z.y < 0.0 {
        from_place = share_of_value(path, POLAR, 0.0, span);
        if depth_inside(path, base, from_place) <= 0.0 {
            return EMPTY;
        }
        return vec2<f32>(boundary(path, base, from_place, span.x), boundary(path, base, from_place, span.y));
    }
    let inside = vec2<bool>(depth_inside(path, base, span.x) > 0.0, depth_inside(path, base, span.y) > 0.0);
    if inside.x {
        return vec2<f32>(span.x, boundary(path, base, span.x, span.y));
    }
    if inside.y {
        return vec2<f32>(boundary(path, base, span.y, span.x), span.y);
    }
    let best = deepest(path, base, span);
    if best.y <= 0.0 {
        return EMPTY;
    }
    return vec2<f32>(boundary(path, base, best.x, span.x), boundary(path, base, best.x, span.y));
}
