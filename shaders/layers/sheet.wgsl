// What the crossings of a disk without thickness add to a ray among jets, as layers. The file of the disk is
// linked with its `add_sheet` renamed to `add_whole_sheet` (gpu/shader/choices.rs).
//
// Gives: add_sheet, begin_sheets, sheet_of.

// The light and the share of the first crossing of the disk, and those of further ones.
var<private> first_sheet: vec4<f32>;
var<private> later_sheets: vec4<f32>;

// Whether the ray has crossed the disk.
var<private> crossed: bool;

// Forgets the crossings of the ray before.
fn begin_sheets() {
    first_sheet = vec4<f32>(0.0);
    later_sheets = vec4<f32>(0.0);
    crossed = false;
}

fn add_sheet(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, share: f32) {
    let light = (*result).light;
    let transmission = (*result).transmission;
    add_whole_sheet(result, way, orbit, photon, share);
    let added = vec4<f32>((*result).light - light, transmission - (*result).transmission);
    if all(added == vec4<f32>(0.0)) {
        return;
    }
    if crossed {
        later_sheets += added;
    } else {
        first_sheet = added;
    }
    crossed = true;
}

// The light and the share of the ray that the first crossing adds (0), or further ones (1).
fn sheet_of(order: u32) -> vec4<f32> {
    return select(first_sheet, later_sheets, order > 0u);
}
