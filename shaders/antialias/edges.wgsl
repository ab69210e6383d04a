// EDGES: lists the pixels whose neighbourhood of 3x3 pixels holds several classes, or across which
// brightness has a large second difference. The list has no fixed order, and none shows.
//
// Gives: edges.

// The work of one dispatch of REFINE. The first three numbers are the size of an indirect dispatch.
struct Work {
    columns: atomic<u32>,
    // Workgroups in a column: enough to keep the number of columns within WebGPU's limit.
    rows: u32,
    layers: u32,
    groups: atomic<u32>,
    // Numbers of pixels that get 4 rays (listed from the middle on), 16 (from the start on) and 64
    // (from the end backward).
    bent: atomic<u32>,
    coarse: atomic<u32>,
    fine: atomic<u32>,
}

// What is looked for.
struct Search {
    // The scene's columns of the picture: the first, and the one after the last. A comparison shows
    // another scene on the other side of its divider.
    columns: vec2<u32>,
    // Whether the frame has to be drawn quickly (1) or not (0): each kind of edge then gets the rays of
    // the next softer kind, and the softest gets none.
    quick: u32,
    // Whether the columns go around the whole sky (1) or not (0): the first one is then the neighbour
    // of the last.
    around: u32,
}

@group(0) @binding(BINDING_TRAITS) var traits: Traits;
@group(0) @binding(BINDING_SEARCH) var<uniform> search: Search;
@group(0) @binding(BINDING_WORK) var<storage, read_write> work: Work;
@group(0) @binding(BINDING_LIST) var<storage, read_write> list: array<u32>;

// The largest second differences of brightness across a pixel, in levels, that need no refinement,
// and only 4 rays. The error of a single ray is a 24th of the second difference where brightness
// varies smoothly, and up to half of it at an edge.
const MAX_BEND: i32 = 40;
const MAX_SOFT_BEND: i32 = 100;

// The largest difference of brightness between classes, in levels, that needs no refinement, except
// at the shadow's edge, where images of the disk may be too thin for a single ray.
const MAX_STEP: i32 = 5;

// A pixel and its neighbours to the left and right.
struct Row {
    // Brightness, or -1 for a pixel without a class.
    brightness: vec3<i32>,
    // The middle pixel's class, and one bit for each class among the three.
    own_class: u32,
    classes: u32,
}

// The traits of a pixel. A pixel that the foreground partly covers has no class.
fn traits_at(at: vec2<u32>) -> vec2<u32> {
    var seen = textureLoad(traits, at, 0).xy;
    for (var i = 1u; i < SAMPLES; i++) {
        seen.x = select(seen.x, NO_CLASS, textureLoad(traits, at, i).x == NO_CLASS);
    }
    return seen;
}

// Beyond the scene's border its outermost pixels are repeated, or its columns begin again.
fn row_at(at: vec2<u32>) -> Row {
    let is_first = at.x <= search.columns.x;
    let is_last = at.x + 1u >= search.columns.y;
    let before = select(at.x, search.columns.y - 1u, search.around == 1u);
    let after = select(at.x, search.columns.x, search.around == 1u);
    let left = traits_at(vec2<u32>(select(max(at.x, 1u) - 1u, before, is_first), at.y));
    let middle = traits_at(at);
    let right = traits_at(vec2<u32>(select(at.x + 1u, after, is_last), at.y));
    let seen = vec3<u32>(left.x, middle.x, right.x);
    let bits = (vec3<u32>(1u) << seen) & vec3<u32>(~(1u << NO_CLASS));
    let brightness = vec3<i32>(i32(left.y), i32(middle.y), i32(right.y));
    return Row(
        select(brightness, vec3<i32>(-1), seen == vec3<u32>(NO_CLASS)),
        middle.x,
        bits.x | bits.y | bits.z,
    );
}

// The second difference across a pixel, zero beside the foreground.
fn bend(before: i32, here: i32, after: i32) -> i32 {
    return select(abs(before - 2 * here + after), 0, min(before, after) < 0);
}

fn largest_bend(above: vec3<i32>, here: vec3<i32>, lower: vec3<i32>) -> i32 {
    let straight = max(bend(here.x, here.y, here.z), bend(above.y, here.y, lower.y));
    return max(straight, max(bend(above.x, here.y, lower.z), bend(above.z, here.y, lower.x)));
}

// The difference between the greatest and the least brightness; covered pixels do not count.
fn range(above: Row, here: Row, lower: Row) -> i32 {
    let brightest = max(above.brightness, max(here.brightness, lower.brightness));
    let all = array<vec3<i32>, 3>(above.brightness, here.brightness, lower.brightness);
    var darkest = vec3<i32>(255);
    for (var i = 0u; i < 3u; i++) {
        darkest = min(darkest, select(all[i], vec3<i32>(255), all[i] < vec3<i32>(0)));
    }
    return max(brightest.x, max(brightest.y, brightest.z)) - min(darkest.x, min(darkest.y, darkest.z));
}

// Whether some of the classes are captured and others are not.
fn passes_shadow(classes: u32) -> bool {
    let captured = captured_classes();
    return (classes & captured) != 0u && (classes & ~captured) != 0u;
}

fn captured_classes() -> u32 {
    var bits = 0u;
    for (var i = 1u; i < 16u; i++) {
        bits |= select(0u, 1u << i, is_class_captured(i));
    }
    return bits;
}

fn add_group() {
    if atomicAdd(&work.groups, 1u) % work.rows == 0u {
        atomicAdd(&work.columns, 1u);
    }
}

// The kinds of edges, from the softest.
const NO_EDGE: u32 = 0u;
const BENT: u32 = 1u;
const HARD: u32 = 2u;
const SHADOW: u32 = 3u;

// Adds a pixel to the list of its kind; a pixel without an edge is in none.
fn mark(pixel: u32, kind: u32) {
    if kind == SHADOW {
        let place = atomicAdd(&work.fine, 1u);
        list[arrayLength(&list) - 1u - place] = pixel;
        add_group();
    } else if kind == HARD {
        let place = atomicAdd(&work.coarse, 1u);
        list[place] = pixel;
        if place % COARSE_PIXELS == 0u {
            add_group();
        }
    } else if kind == BENT {
        let place = atomicAdd(&work.bent, 1u);
        list[arrayLength(&list) / 2u + place] = pixel;
        if place % BENT_PIXELS == 0u {
            add_group();
        }
    }
}

// The kind of edge in the middle of three rows.
fn kind_of_edge(above: Row, here: Row, lower: Row) -> u32 {
    if here.own_class == NO_CLASS {
        return NO_EDGE;
    }
    let classes = above.classes | here.classes | lower.classes;
    if passes_shadow(classes) {
        return SHADOW;
    }
    let bends = largest_bend(above.brightness, here.brightness, lower.brightness);
    let differs = countOneBits(classes) > 1u && range(above, here, lower) > MAX_STEP;
    return select(select(NO_EDGE, BENT, bends > MAX_BEND), HARD, differs || bends > MAX_SOFT_BEND);
}

// One invocation walks down a strip of pixels, so that it reads every row only once.
@compute @workgroup_size(WORKGROUP_SIZE)
fn edges(@builtin(global_invocation_id) id: vec3<u32>) {
    let size = textureDimensions(traits);
    let x = search.columns.x + id.x;
    let top = id.y * STRIP;
    if x >= search.columns.y || top >= size.y {
        return;
    }
    var above = row_at(vec2<u32>(x, max(top, 1u) - 1u));
    var here = row_at(vec2<u32>(x, top));
    for (var y = top; y < min(top + STRIP, size.y); y++) {
        let lower = row_at(vec2<u32>(x, min(y + 1u, size.y - 1u)));
        let kind = kind_of_edge(above, here, lower);
        mark(y * size.x + x, kind - min(kind, search.quick));
        above = here;
        here = lower;
    }
}
