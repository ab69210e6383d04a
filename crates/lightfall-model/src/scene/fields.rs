//! The field table: every leaf field of a [`Scene`]. Loading, validation, `presets show` and the
//! panel all read it.

use super::row::Row;
use super::{Camera, Disk, Effects, Hole, HotSpot, Observer, Picture, Probe, Quality, Scene, Sky};

/// One leaf field of a scene.
pub type Field = Row<Scene>;

/// Every leaf field of a scene, in the order of declaration.
pub const FIELDS: &[Field] = &all_fields();

const TABLES: [&[Field]; 11] = [
    Scene::FIELDS,
    Hole::FIELDS,
    Camera::FIELDS,
    Observer::FIELDS,
    Effects::FIELDS,
    Disk::FIELDS,
    HotSpot::FIELDS,
    Sky::FIELDS,
    Probe::FIELDS,
    Picture::FIELDS,
    Quality::FIELDS,
];

const FIELD_COUNT: usize = {
    let (mut count, mut table) = (0, 0);
    while table < TABLES.len() {
        count += TABLES[table].len();
        table += 1;
    }
    count
};

const fn all_fields() -> [Field; FIELD_COUNT] {
    let mut all = [TABLES[0][0]; FIELD_COUNT];
    let (mut count, mut table) = (0, 0);
    while table < TABLES.len() {
        let mut row = 0;
        while row < TABLES[table].len() {
            all[count] = TABLES[table][row];
            count += 1;
            row += 1;
        }
        table += 1;
    }
    all
}

/// The field with this key.
pub fn field(key: &str) -> Option<&'static Field> {
    FIELDS.iter().find(|field| field.key == key)
}
