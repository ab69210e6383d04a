//! The disk's frame: how a tilted disk lies in the hole's frame.

use super::camera::sin_cos_deg;
use super::{Disk, Scene};
use glam::{DMat3, DVec3};

impl Disk {
    /// Whether the disk lies in another plane than the equator of the hole's frame.
    pub fn is_tilted(&self) -> bool {
        self.tilt_deg != 0.0
    }

    /// The rotation from the disk's frame, whose z axis is the disk's normal, to the hole's: by
    /// `tilt_deg` about the ascending node (Rodrigues' formula).
    ///
    /// The node has the azimuth `node_deg` in both frames. So azimuths in the disk are counted on
    /// from the node, and without tilt both frames are the same, exactly and for every node.
    pub fn hole_from_disk(&self) -> DMat3 {
        let (sin, cos) = sin_cos_deg(self.tilt_deg);
        let (node_sin, node_cos) = sin_cos_deg(self.node_deg);
        let node = DVec3::new(node_cos, node_sin, 0.0);
        let turned = |v: DVec3| cos * v + sin * node.cross(v) + (1.0 - cos) * node.dot(v) * node;
        DMat3::from_cols(turned(DVec3::X), turned(DVec3::Y), turned(DVec3::Z))
    }
}

impl Scene {
    /// How far the camera is above the disk's plane, as seen from the hole, in degrees; negative
    /// below it.
    pub fn degrees_above_disk(&self) -> f64 {
        if !self.disk.is_tilted() {
            return 90.0 - self.camera.theta_deg;
        }
        let normal = self.disk.hole_from_disk().z_axis;
        let along = normal.dot(self.camera.direction());
        along.clamp(-1.0, 1.0).asin().to_degrees()
    }
}
