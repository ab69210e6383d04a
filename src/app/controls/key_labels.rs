//! What the keyboard's layout prints on the keys. Controls are bound to places of keys; apart from
//! flight, which is meant by place, a control belongs to the letter that is printed there.

use bevy::prelude::KeyCode;
use std::collections::BTreeMap;

/// The keys whose prints differ between layouts: their US prints, and their numbers in a keyboard's
/// first set of scan codes, which Linux and Windows share. Digits stand on the same keys of every
/// layout, some with Shift.
pub const PRINTED: &[(KeyCode, char, u8)] = &[
    (KeyCode::Backquote, '`', 41),
    (KeyCode::Minus, '-', 12),
    (KeyCode::Equal, '=', 13),
    (KeyCode::KeyQ, 'q', 16),
    (KeyCode::KeyW, 'w', 17),
    (KeyCode::KeyE, 'e', 18),
    (KeyCode::KeyR, 'r', 19),
    (KeyCode::KeyT, 't', 20),
    (KeyCode::KeyY, 'y', 21),
    (KeyCode::KeyU, 'u', 22),
    (KeyCode::KeyI, 'i', 23),
    (KeyCode::KeyO, 'o', 24),
    (KeyCode::KeyP, 'p', 25),
    (KeyCode::BracketLeft, '[', 26),
    (KeyCode::BracketRight, ']', 27),
    (KeyCode::KeyA, 'a', 30),
    (KeyCode::KeyS, 's', 31),
    (KeyCode::KeyD, 'd', 32),
    (KeyCode::KeyF, 'f', 33),
    (KeyCode::KeyG, 'g', 34),
    (KeyCode::KeyH, 'h', 35),
    (KeyCode::KeyJ, 'j', 36),
    (KeyCode::KeyK, 'k', 37),
    (KeyCode::KeyL, 'l', 38),
    (KeyCode::Semicolon, ';', 39),
    (KeyCode::Quote, '\'', 40),
    (KeyCode::Backslash, '\\', 43),
    (KeyCode::KeyZ, 'z', 44),
    (KeyCode::KeyX, 'x', 45),
    (KeyCode::KeyC, 'c', 46),
    (KeyCode::KeyV, 'v', 47),
    (KeyCode::KeyB, 'b', 48),
    (KeyCode::KeyN, 'n', 49),
    (KeyCode::KeyM, 'm', 50),
    (KeyCode::Comma, ',', 51),
    (KeyCode::Period, '.', 52),
    (KeyCode::Slash, '/', 53),
];

/// A layout of the keys of [`PRINTED`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KeyLabels {
    /// The character that each key types without a modifier, in lower case.
    prints: BTreeMap<KeyCode, char>,
    /// For each key of a US board, the key that stands for it.
    places: BTreeMap<KeyCode, KeyCode>,
}

/// The US layout.
impl Default for KeyLabels {
    fn default() -> Self {
        Self::new(|_| None)
    }
}

impl KeyLabels {
    /// The layout in which a key of this scan code types this character. Keys of which nothing is
    /// known have their US prints.
    pub fn new(typed: impl Fn(u8) -> Option<char>) -> Self {
        let prints = PRINTED
            .iter()
            .map(|(place, usual, code)| (*place, typed(*code).map_or(*usual, lower)));
        Self::from_prints(prints.collect())
    }

    /// Finds the key that stands for each key of a US board: the key with its print, or its own
    /// place where the layout lacks the print, or any key that is left.
    fn from_prints(prints: BTreeMap<KeyCode, char>) -> Self {
        let mut places = BTreeMap::new();
        let mut free: Vec<KeyCode> = PRINTED.iter().map(|(place, ..)| *place).collect();
        let with_its_print = |key: KeyCode, usual: char, free: &[KeyCode]| {
            // A US board has both characters on this key, and other layouts have a key for each.
            let prints_of_key: &[char] = if key == KeyCode::Equal {
                &['+', '=']
            } else {
                &[usual]
            };
            let with_print = |print: &char| free.iter().position(|place| prints[place] == *print);
            prints_of_key.iter().find_map(with_print)
        };
        let in_its_place =
            |key: KeyCode, _: char, free: &[KeyCode]| free.iter().position(|place| *place == key);
        let anywhere = |_: KeyCode, _: char, free: &[KeyCode]| (!free.is_empty()).then_some(0);
        let ways: [&dyn Fn(KeyCode, char, &[KeyCode]) -> Option<usize>; 3] =
            [&with_its_print, &in_its_place, &anywhere];
        for find in ways {
            for (key, usual, _) in PRINTED {
                if places.contains_key(key) {
                    continue;
                }
                if let Some(found) = find(*key, *usual, &free) {
                    places.insert(*key, free.remove(found));
                }
            }
        }
        Self { prints, places }
    }

    /// The key that stands for a key of a US board: the one with the same print, if there is one.
    #[must_use]
    pub fn place_of(&self, key: KeyCode) -> KeyCode {
        self.places.get(&key).copied().unwrap_or(key)
    }

    /// The key of a US board that a key stands for: the opposite of [`place_of`](Self::place_of).
    #[must_use]
    pub fn key_at(&self, place: KeyCode) -> KeyCode {
        let found = self
            .places
            .iter()
            .find(|(_, its_place)| **its_place == place);
        found.map_or(place, |(key, _)| *key)
    }

    /// What is printed on a key, in capitals. None for a key with its usual name.
    #[must_use]
    pub fn print_of(&self, place: KeyCode) -> Option<String> {
        let label = self.prints.get(&place)?;
        (usual_print(place) != Some(*label)).then(|| {
            let capital = label.to_uppercase();
            let single = capital.clone().count() == 1;
            if single {
                capital.to_string()
            } else {
                label.to_string()
            }
        })
    }

    /// Whether a key types this character in this layout. True for a key whose print never differs.
    #[must_use]
    pub fn agrees(&self, place: KeyCode, typed: char) -> bool {
        usual_print(place).is_none() || self.prints.get(&place) == Some(&lower(typed))
    }

    /// Notes that a key types this character. The key that was thought to type it gets this key's
    /// former character, so that every letter stays on one key while a layout is learned.
    pub fn learn(&mut self, place: KeyCode, typed: char) {
        let typed = lower(typed);
        let mut prints = std::mem::take(&mut self.prints);
        let former = prints.insert(place, typed);
        let other = prints
            .iter_mut()
            .find(|(other, print)| **other != place && **print == typed);
        if let (Some((_, print)), Some(former)) = (other, former) {
            *print = former;
        }
        *self = Self::from_prints(prints);
    }
}

/// What a US board prints on a key of [`PRINTED`].
fn usual_print(key: KeyCode) -> Option<char> {
    let row = PRINTED.iter().find(|(known, ..)| *known == key);
    row.map(|(_, print, _)| *print)
}

/// The character in lower case, where this is a single character.
fn lower(label: char) -> char {
    let mut lower = label.to_lowercase();
    match (lower.next(), lower.next()) {
        (Some(one), None) => one,
        _ => label,
    }
}
