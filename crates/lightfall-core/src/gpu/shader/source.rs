//! The sources of light, one row each: the files of every disk model and sky mode.

use super::Variant;
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

/// The files that define `disk_light`.
pub(super) fn emission_parts(variant: Variant) -> Vec<Part> {
    let mut parts = vec![match variant.disk_model {
        DiskModel::Newtonian => part!("disk/newtonian.wgsl"),
        DiskModel::PageThorne => part!("disk/page_thorne.wgsl"),
    }];
    if variant.structure {
        parts.extend([
            part!("disk/structure/footprint.wgsl"),
            part!("disk/structure/waves.wgsl"),
        ]);
    } else {
        parts.push(part!("disk/structure/none.wgsl"));
    }
    parts.extend([
        match variant.hot_spot {
            HotSpotKind::None => part!("disk/hot_spot/none.wgsl"),
            HotSpotKind::Rigid | HotSpotKind::Sheared => part!("disk/hot_spot/spot.wgsl"),
        },
        match variant.limb {
            LimbDarkening::None => part!("disk/limb/none.wgsl"),
            LimbDarkening::ElectronScattering => part!("disk/limb/electron_scattering.wgsl"),
        },
        part!("disk/emission.wgsl"),
    ]);
    parts
}

/// The files that define `sky_light`.
pub(super) fn sky_parts(mode: SkyMode) -> &'static [Part] {
    match mode {
        SkyMode::Stars => &[part!("sky.wgsl"), part!("sky/stars.wgsl")],
        SkyMode::Grid => &[part!("sky.wgsl"), part!("sky/grid.wgsl")],
        SkyMode::Off => &[part!("sky/none.wgsl")],
    }
}
