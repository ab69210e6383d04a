//! The sources of light, one row each: the files of every disk model and sky mode.

use super::text::{Part, part};
use crate::scene::{DiskModel, SkyMode};

/// The files that find a ray's crossings of a disk, or of none.
pub(super) fn disk_parts(disk: bool) -> &'static [Part] {
    if disk {
        &[part!("disk.wgsl")]
    } else {
        &[part!("disk/none.wgsl")]
    }
}

/// The files that define `disk_light`.
pub(super) fn emission_parts(model: DiskModel) -> &'static [Part] {
    match model {
        DiskModel::Newtonian => &[part!("disk/newtonian.wgsl"), part!("disk/emission.wgsl")],
        DiskModel::PageThorne => &[part!("disk/page_thorne.wgsl"), part!("disk/emission.wgsl")],
    }
}

/// The files that define `sky_light`.
pub(super) fn sky_parts(mode: SkyMode) -> &'static [Part] {
    match mode {
        SkyMode::Stars => &[part!("sky.wgsl"), part!("sky/stars.wgsl")],
        SkyMode::Grid => &[part!("sky.wgsl"), part!("sky/grid.wgsl")],
        SkyMode::Off => &[part!("sky/none.wgsl")],
    }
}
