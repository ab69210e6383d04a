//! Keyboards of other layouts: which key each control has there, and what it is called.

use bevy::prelude::KeyCode;
use lightfall::app::{
    Action, Bindings, CONTROLS, Group, KeyLabels, Modifier, PRINTED, help_rows, help_rows_at_helm,
    ship_rows,
};
use std::collections::BTreeMap;

/// What the keys of `PRINTED` type, row by row from the key left of the 1: a blank is a key that
/// types a digit with Shift only or nothing.
const LAYOUTS: [(&str, &str); 6] = [
    ("US", "`-=qwertyuiop[]asdfghjkl;'\\zxcvbnm,./"),
    ("French", "²)=azertyuiop^$qsdfghjklmù*wxcvbn,;:!"),
    ("German", "^ß´qwertzuiopü+asdfghjklöä#yxcvbnm,.-"),
    ("Dvorak", "`[]',.pyfgcrl/=aoeuidhtns-\\;qjkxbmwvz"),
    ("Russian", "ё-=йцукенгшщзхъфывапролджэ\\ячсмитьбю."),
    ("Turkish", "\"*-qwertyuıopğüasdfghjklşi,zxcvbnmöç."),
];

fn labels(layout: &str) -> KeyLabels {
    let (_, row) = LAYOUTS.iter().find(|(name, _)| *name == layout).unwrap();
    let prints: Vec<char> = row.chars().collect();
    assert_eq!(prints.len(), PRINTED.len(), "{layout}");
    KeyLabels::new(|code| {
        let place = PRINTED.iter().position(|(_, _, known)| *known == code);
        place.map(|place| prints[place])
    })
}

fn bound(layout: &str) -> Bindings {
    Bindings::with_defaults(&labels(layout))
}

#[test]
fn on_every_layout_each_control_has_a_key_that_no_other_control_has() {
    for (layout, _) in LAYOUTS {
        let bindings = bound(layout);
        for (control, keys) in bindings.iter() {
            assert_eq!(keys.len(), control.keys.len(), "{layout}: {}", control.id);
            for key in keys {
                assert_eq!(
                    bindings.owner(*key, control.modifier).unwrap().id,
                    control.id,
                    "{layout}"
                );
            }
        }
    }
}

#[test]
fn flight_is_by_place_and_the_rest_by_the_printed_letter() {
    for (layout, row) in LAYOUTS {
        let bindings = bound(layout);
        let flies = |place| {
            let owner = bindings.owner(place, None);
            matches!(owner.map(|control| control.action), Some(Action::Hold(_)))
        };
        for (control, keys) in bindings.iter() {
            for (key, usual) in keys.iter().zip(control.keys) {
                let print = PRINTED.iter().find(|(key, ..)| key == usual);
                let printed =
                    print.and_then(|(_, print, _)| row.chars().position(|its| its == *print));
                let flown = control.modifier.is_none() && flies(*key);
                let name = format!("{layout}: {}", control.id);
                match (control.action, printed.map(|place| PRINTED[place].0)) {
                    (Action::Hold(_), _) => assert_eq!(key, usual, "{name}"),
                    (_, Some(place)) if control.modifier.is_some() || !flies(place) => {
                        assert_eq!(*key, place, "{name}");
                    }
                    // A letter whose key flies, or that the layout lacks.
                    _ => assert!(!flown, "{name}"),
                }
            }
        }
    }
}

#[test]
fn keys_are_called_by_what_the_layout_prints() {
    for (layout, id, key, label) in [
        ("French", "window.quit", KeyCode::KeyA, "Ctrl+Q"),
        ("French", "fly.forward", KeyCode::KeyW, "Z"),
        ("French", "fly.left", KeyCode::KeyA, "Q"),
        ("French", "view.residual", KeyCode::Semicolon, "M"),
        // Z flies there, and W is left over.
        ("French", "light.doppler", KeyCode::KeyZ, "W"),
        ("French", "preset.1", KeyCode::Digit1, "1"),
        ("German", "light.doppler", KeyCode::KeyY, "Z"),
        ("German", "fly.face", KeyCode::KeyZ, "Y"),
        ("German", "picture.darker", KeyCode::Slash, "-"),
        ("German", "view.steps", KeyCode::Semicolon, "Ö"),
        ("Dvorak", "light.lensing", KeyCode::KeyP, "L"),
        ("Dvorak", "fly.forward", KeyCode::KeyW, ","),
        ("Russian", "light.lensing", KeyCode::KeyL, "Д"),
        ("Russian", "window.quit", KeyCode::KeyQ, "Ctrl+Й"),
        ("Turkish", "window.inspector", KeyCode::Quote, "I"),
        ("US", "picture.brighter", KeyCode::Equal, "+"),
    ] {
        let bindings = bound(layout);
        assert_eq!(bindings.of(id)[0], key, "{layout}: {id}");
        assert_eq!(bindings.first_name(id), label, "{layout}: {id}");
    }
    // In a sentence a punctuation mark would end it.
    let us = bound("US");
    assert_eq!(us.first_name("motion.faster"), ".");
    assert_eq!(us.first_label("motion.faster"), "\".\"");
    assert_eq!(us.first_label("motion.slower"), "\",\"");
    assert_eq!(us.first_label("fly.forward"), "W");
    assert_eq!(us.first_label("window.fullscreen"), "Alt+Enter");
    let help = help_rows(&bound("French"), Group::Flight);
    assert!(
        help.contains(&["Z Q S D".to_owned(), "fly".to_owned()]),
        "{help:?}"
    );
}

#[test]
fn the_settings_mean_a_letter_on_every_layout_and_give_back_what_was_bound() {
    let given = BTreeMap::from([
        ("window.help".to_owned(), vec!["Q".to_owned()]),
        ("fly.up".to_owned(), vec!["R".to_owned()]),
    ]);
    let french = Bindings::new(&given, &labels("French")).unwrap();
    // Q is printed on the key of A, which flew to the left.
    assert_eq!(french.of("window.help"), [KeyCode::KeyA]);
    assert!(french.of("fly.left").is_empty());
    assert_eq!(french.of("fly.up"), [KeyCode::KeyR]);
    for (layout, _) in LAYOUTS {
        let labels = labels(layout);
        for (key, ..) in PRINTED {
            let mut bindings = Bindings::with_defaults(&labels);
            bindings.bind("window.help", *key);
            bindings.bind("fly.up", *key);
            bindings.bind("scene.disk", *key);
            let again = Bindings::new(&bindings.settings(), &labels);
            assert_eq!(again.as_ref(), Ok(&bindings), "{layout}: {key:?}");
        }
    }
}

#[test]
fn a_layout_is_learned_from_what_its_keys_type() {
    let german = labels("German");
    let mut learned = KeyLabels::default();
    // Each key of which the two layouts differ is pressed once.
    for (place, ..) in PRINTED {
        let typed = german
            .print_of(*place)
            .map(|print| print.chars().next().unwrap());
        if let Some(typed) = typed {
            assert!(
                !learned.agrees(*place, typed) || *place == KeyCode::KeyZ,
                "{place:?}"
            );
            learned.learn(*place, typed);
            assert!(learned.agrees(*place, typed), "{place:?}");
        }
    }
    for control in CONTROLS
        .iter()
        .filter(|control| control.modifier != Some(Modifier::Alt))
    {
        assert_eq!(
            Bindings::with_defaults(&learned).label_of(control),
            Bindings::with_defaults(&german).label_of(control),
            "{}",
            control.id
        );
    }
    // One press of Z is enough for both letters, and no letter is ever on two keys.
    let mut swapped = KeyLabels::default();
    swapped.learn(KeyCode::KeyY, 'z');
    assert_eq!(swapped.place_of(KeyCode::KeyY), KeyCode::KeyZ);
    assert_eq!(swapped.place_of(KeyCode::KeyZ), KeyCode::KeyY);
}

#[test]
fn at_the_ships_controls_the_help_lists_what_its_keys_do_there_and_on_a_mission_two_more() {
    let bindings = Bindings::default();
    let rows = ship_rows(&bindings, false);
    let keys_of = |does: &str| {
        let row = rows.iter().find(|[_, words]| words == does);
        row.map(|[keys, _]| keys.as_str())
    };
    for (does, keys) in [
        ("nose: next heading, back", "Y Shift+Y"),
        ("look at the hole, along the nose", "T"),
        ("hold still", "O"),
        ("turn the ship", "arrow keys"),
        ("the thrust that is set", "wheel"),
        ("time slower, faster", ", ."),
        ("leave the ship", "Shift+F"),
    ] {
        assert_eq!(keys_of(does), Some(keys), "{does}");
    }
    let on_mission = ship_rows(&bindings, true);
    assert_eq!(on_mission[..rows.len()], rows);
    let more: Vec<&str> = on_mission[rows.len()..]
        .iter()
        .map(|[keys, _]| keys.as_str())
        .collect();
    assert_eq!(more, ["Backspace", "Enter"]);
    // The rest of the help does not name these keys again with what they do elsewhere.
    let others: Vec<String> = Group::ALL
        .into_iter()
        .flat_map(|group| help_rows_at_helm(&bindings, group, true))
        .flat_map(|[keys, _]| keys.split(' ').map(str::to_owned).collect::<Vec<_>>())
        .collect();
    for key in ["T", "O", "Y", "K", "W", "F", "Backspace", "Enter", "wheel"] {
        assert!(
            !others.iter().any(|other| other == key),
            "{key}: {others:?}"
        );
    }
    assert!(others.iter().any(|other| other == "F12,"), "{others:?}");
    // A control without a key has no row.
    let unbound = [("ship.map".to_owned(), Vec::new())].into();
    let bindings = Bindings::new(&unbound, &KeyLabels::default()).unwrap();
    assert_eq!(ship_rows(&bindings, false).len(), rows.len() - 1);
}
