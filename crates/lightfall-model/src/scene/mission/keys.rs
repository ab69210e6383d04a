//! The keys that the card at the start of a mission lists.

use super::error::Fault;

/// Largest number of keys on the card at the start.
const MAX_KEYS: usize = 10;

crate::words! {
    /// A control that a mission can need, by its name in the table of controls.
    pub enum MissionKey {
        /// Pushes along the nose.
        Forward = "fly.forward",
        /// Pushes against the nose.
        Backward = "fly.backward",
        /// Pushes to the left.
        Left = "fly.left",
        /// Pushes to the right.
        Right = "fly.right",
        /// Pushes up.
        Up = "fly.up",
        /// Pushes down.
        Down = "fly.down",
        /// Pushes with a quarter of the thrust.
        Slower = "fly.slower",
        /// Turns the nose to a heading.
        Face = "fly.face",
        /// Holds the orbit.
        Orbit = "fly.orbit",
        /// Holds still.
        Still = "scene.observer",
        /// Looks at the hole, or along the nose.
        Look = "scene.spin",
        /// Switches the engine off.
        EngineOff = "motion.let_go",
        /// Lets time run faster.
        FasterTime = "motion.faster",
        /// Lets time run slower.
        SlowerTime = "motion.slower",
        /// Pauses.
        Pause = "motion.pause",
        /// Shows the map.
        Map = "ship.map",
        /// Begins the mission again.
        Again = "journey.again",
    }
}

/// Each key once, and no more than the card has room for.
pub(super) fn check_keys(keys: &[MissionKey]) -> Result<(), Fault> {
    let count = keys.len();
    if count > MAX_KEYS {
        return Err(Fault::Number {
            key: "number of keys".into(),
            given: count.to_string(),
            allowed: "at most 10",
        });
    }
    let mut seen = keys.iter().enumerate();
    match seen.find(|(place, key)| keys[..*place].contains(key)) {
        Some((_, key)) => Err(Fault::KeyTwice { key: key.word() }),
        None => Ok(()),
    }
}
