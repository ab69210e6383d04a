//! The sources of light, one row each: the files of every disk model and sky mode.

use super::entry::Entry;
use super::text::{Part, part};
use crate::scene::{DiskModel, HotSpotKind, LimbDarkening, SkyMode};

/// The files that find a ray's crossings of a disk, or of none.
pub(super) fn disk_parts(disk: bool) -> &'static [Part] {
    if disk {
        &[part!("disk.wgsl")]
    } else {
        &[part!("disk/none.wgsl")]
    }
}

/// The files that define `disk_flux`.
pub(super) fn flux_parts(model: DiskModel) -> &'static [Part] {
    match model {
        DiskModel::Newtonian => &[part!("disk/newtonian.wgsl")],
        DiskModel::PageThorne => &[part!("disk/page_thorne.wgsl")],
    }
}

/// The file that defines `differences`, by which a footprint is measured. Only the entries of
/// pictures have neighbours.
pub(super) fn neighbour_parts(needed: bool, entry: Entry) -> &'static [Part] {
    match (needed, entry) {
        (_, Entry::Refine) => &[part!("neighbours/lanes.wgsl")],
        (true, Entry::Picture) => &[part!("neighbours/pixels.wgsl")],
        _ => &[part!("neighbours/none.wgsl")],
    }
}

/// The files that define `structure_factor`.
pub(super) fn structure_parts(structure: bool, has_neighbours: bool) -> &'static [Part] {
    match (structure, has_neighbours) {
        (false, _) => &[part!("disk/structure/none.wgsl")],
        (true, true) => &[
            part!("disk/structure/footprint.wgsl"),
            part!("disk/structure/waves.wgsl"),
        ],
        (true, false) => &[
            part!("disk/structure/fixed_footprint.wgsl"),
            part!("disk/structure/waves.wgsl"),
        ],
    }
}

/// The files that define `hot_spot_factor`.
pub(super) fn hot_spot_parts(kind: HotSpotKind) -> &'static [Part] {
    match kind {
        HotSpotKind::None => &[part!("disk/hot_spot/none.wgsl")],
        HotSpotKind::Rigid | HotSpotKind::Sheared => &[part!("disk/hot_spot/spot.wgsl")],
    }
}

/// The files that define `limb_darkening`.
pub(super) fn limb_parts(limb: LimbDarkening) -> &'static [Part] {
    match limb {
        LimbDarkening::None => &[part!("disk/limb/none.wgsl")],
        LimbDarkening::ElectronScattering => &[part!("disk/limb/electron_scattering.wgsl")],
    }
}

/// The files that define `sky_light`. Behind a tilted disk rays come in the disk's frame: if the sky
/// is `turned`, a file between the two turns their directions to the hole's.
pub(super) fn sky_parts(mode: SkyMode, turned: bool) -> Vec<Part> {
    let background = match mode {
        SkyMode::Stars => part!("sky/stars.wgsl"),
        SkyMode::Procedural => part!("sky/procedural.wgsl"),
        SkyMode::Grid => part!("sky/grid.wgsl"),
        SkyMode::Off => return vec![part!("sky/none.wgsl")],
    };
    if turned {
        let background = background.renaming("sky_background", "background_in_hole_frame");
        vec![part!("sky.wgsl"), part!("sky/tilted.wgsl"), background]
    } else {
        vec![part!("sky.wgsl"), background]
    }
}

/// Whether a sky needs its directions turned behind a tilted disk. The mode `stars` turns them
/// anyway, to the celestial frame.
pub(super) fn needs_turned_directions(mode: SkyMode) -> bool {
    matches!(mode, SkyMode::Procedural | SkyMode::Grid)
}

/// The file that defines `point_light`.
pub(super) fn point_light_parts(mode: SkyMode) -> &'static [Part] {
    match mode {
        SkyMode::Stars => &[part!("stars/sums.wgsl")],
        SkyMode::Procedural | SkyMode::Grid | SkyMode::Off => &[part!("stars/none.wgsl")],
    }
}
