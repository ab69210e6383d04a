//! The twin of a scene with a tilted disk: the same view without tilt, from a camera that is moved
//! and rolled with everything but the hole. The rotation is one of quaternions, apart from the
//! program's own.

use glam::{DMat3, DQuat, DVec3};
use lightfall_core::scene::{ObserverKind, Scene};

/// A scene without tilt that shows what another scene shows of its disk.
pub struct Twin {
    pub scene: Scene,
    /// From the twin's frame, whose z axis is the disk's normal, to the frame of the tilted scene.
    pub turn: DMat3,
    /// From directions on the axes of the tilted scene's observer to those on the twin's.
    pub axes: DMat3,
}

impl Twin {
    /// The twin of a scene whose observer is neither on an orbit nor in a hole with spin.
    pub fn of(tilted: &Scene) -> Self {
        assert!(tilted.hole.spin == 0.0 && tilted.observer.kind != ObserverKind::Orbit);
        let [tilt, node] = [tilted.disk.tilt_deg, tilted.disk.node_deg].map(f64::to_radians);
        let turn = DQuat::from_rotation_z(node)
            * DQuat::from_rotation_x(tilt)
            * DQuat::from_rotation_z(-node);
        let turn = DMat3::from_quat(turn);
        let mut scene = tilted.clone();
        (scene.disk.tilt_deg, scene.disk.node_deg) = (0.0, 0.0);
        let camera = &tilted.camera;
        let from_camera = camera.tetrad() * camera.tetrad_from_camera();
        scene.camera.set_pose(
            turn.transpose() * camera.direction() * camera.r,
            turn.transpose() * from_camera,
        );
        let axes = scene.camera.tetrad().transpose() * turn.transpose() * camera.tetrad();
        let velocity = axes * DVec3::from_array(tilted.observer.velocity);
        scene.observer.velocity = velocity.to_array();
        Self { scene, turn, axes }
    }
}
