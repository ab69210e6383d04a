//! The field table: every leaf field of a [`Scene`]. Loading, validation, `presets show` and the
//! panel all read it.

use super::field::Field;
use super::{
    Camera, Disk, Effects, Hole, HotSpot, Jet, Observer, Picture, Probe, Quality, Scene, Sky,
};
use std::sync::LazyLock;

/// Every leaf field of a scene, in the order of declaration.
pub static FIELDS: LazyLock<Vec<Field>> = LazyLock::new(|| {
    let tables = [
        Scene::FIELDS,
        Hole::FIELDS,
        Camera::FIELDS,
        Observer::FIELDS,
        Effects::FIELDS,
        Disk::FIELDS,
        HotSpot::FIELDS,
        Jet::FIELDS,
        Sky::FIELDS,
        Probe::FIELDS,
        Picture::FIELDS,
        Quality::FIELDS,
    ];
    tables.concat()
});

/// The field with this key.
pub fn field(key: &str) -> Option<&'static Field> {
    FIELDS.iter().find(|field| field.key == key)
}
