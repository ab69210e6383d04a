//! The file dialog of the desktop's portal: only the answer "cancelled" is no failure.

use crate::portal::{self, Answer, Asked, Bus};
use lightfall_platform::file_dialog::{FileRequest, Portal};
use std::os::unix::net::UnixListener;
use std::path::PathBuf;
use std::time::Duration;

/// For answers that do come: far longer than a busy machine needs.
const LONG: Duration = Duration::from_secs(60);
/// For answers that do not come: long enough for those before them.
const SHORT: Duration = Duration::from_secs(2);

fn request() -> FileRequest {
    FileRequest {
        title: "Open",
        kind: "Presets",
        extensions: &["toml", "png"],
        folder: Some("/".into()),
    }
}

/// What comes of a dialog on the bus with this address.
fn pick_file(address: &str, patience: Duration) -> Result<Option<PathBuf>, String> {
    let bus = Some(address.to_owned());
    Portal { bus, patience }.pick_file(&request())
}

/// What comes of a dialog that a portal answers so.
fn answered(bus: &Bus, answer: Answer) -> Result<Option<PathBuf>, String> {
    let portal = portal::Portal::start(bus, answer);
    let picked = pick_file(&bus.address, LONG);
    let asked = Asked {
        title: "Open".into(),
        folder: Some(b"/\0".to_vec()),
        filters: vec![(
            "Presets".into(),
            vec![(0, "*.toml".into()), (0, "*.png".into())],
        )],
    };
    assert_eq!(portal.asked().0, asked);
    picked
}

#[test]
#[ignore = "needs dbus-daemon"]
fn a_response_of_the_portal_is_a_file_or_cancelled_and_anything_else_is_a_failure() {
    let bus = Bus::start();
    let file = Answer::Response(0, Some("file:///a%20b%C3%A9%25.toml"));
    assert_eq!(answered(&bus, file), Ok(Some("/a bé%.toml".into())));
    let local = Answer::Response(0, Some("file://localhost/a.png"));
    assert_eq!(answered(&bus, local), Ok(Some("/a.png".into())));
    assert_eq!(answered(&bus, Answer::Response(1, None)), Ok(None));
    for failure in [
        Answer::Response(2, None),
        // Not a response of the portal's documentation.
        Answer::Response(7, None),
        // Success without a file, and with one that is elsewhere.
        Answer::Response(0, None),
        Answer::Response(0, Some("https://example.org/a.toml")),
        Answer::Refusal,
    ] {
        let picked = answered(&bus, failure);
        assert!(picked.is_err(), "{failure:?}: {picked:?}");
    }
}

#[test]
#[ignore = "needs dbus-daemon"]
fn without_a_bus_or_a_portal_that_answers_there_is_no_file_dialog() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("bus");
    let address = format!("unix:path={}", place.display());
    let no_bus = pick_file(&address, LONG);
    assert!(no_bus.is_err(), "{no_bus:?}");

    // The kernel connects to a socket that listens; nobody reads what is sent.
    let _mute_bus = UnixListener::bind(&place).unwrap();
    let mute_bus = pick_file(&address, SHORT);
    assert!(mute_bus.is_err(), "{mute_bus:?}");

    let bus = Bus::start();
    let no_portal = pick_file(&bus.address, LONG);
    assert!(no_portal.is_err(), "{no_portal:?}");

    let mute = portal::Portal::start_mute(&bus);
    let mute_portal = pick_file(&bus.address, SHORT);
    assert!(mute_portal.is_err(), "{mute_portal:?}");
    drop(mute);

    let portal = portal::Portal::start(&bus, Answer::None);
    let no_answer = pick_file(&bus.address, SHORT);
    assert!(no_answer.is_err(), "{no_answer:?}");
    portal.asked();
}

#[test]
#[ignore = "needs dbus-daemon"]
fn a_portal_or_a_bus_that_ends_while_the_dialog_is_open_is_a_failure() {
    let mut bus = Bus::start();
    let address = bus.address.clone();
    let open = |ends: &mut dyn FnMut()| {
        std::thread::scope(|scope| {
            // No time limit ends this wait.
            let picked = scope.spawn(|| pick_file(&address, LONG));
            ends();
            picked.join().unwrap()
        })
    };

    let mut portal = portal::Portal::start(&bus, Answer::Dialog);
    let no_portal = open(&mut || {
        portal.asked();
        portal.end();
    });
    assert!(no_portal.is_err(), "{no_portal:?}");

    let portal = portal::Portal::start(&bus, Answer::Dialog);
    let no_bus = open(&mut || {
        portal.asked();
        bus.end();
    });
    assert!(no_bus.is_err(), "{no_bus:?}");
}

#[test]
#[ignore = "needs dbus-daemon"]
fn a_user_may_take_longer_than_the_portal_and_an_answer_before_its_end_counts() {
    let bus = Bus::start();
    let mut portal = portal::Portal::start(&bus, Answer::Dialog);
    let picked = std::thread::scope(|scope| {
        let picked = scope.spawn(|| pick_file(&bus.address, SHORT));
        let (_, dialog) = portal.asked();
        std::thread::sleep(2 * SHORT);
        assert!(!picked.is_finished(), "the wait for the user has a limit");
        portal.respond(&dialog, 0, Some("file:///a.toml"));
        portal.end();
        picked.join().unwrap()
    });
    assert_eq!(picked, Ok(Some("/a.toml".into())));
}
