//! From relative flux to the linear light of a picture.

/// Linear light of the disk per unit of `disk.brightness` and relative flux. The profile peaks at
/// 0.057, and light as bright as white paper is 1.
pub const DISK_HDR_SCALE: f64 = 10.0;
