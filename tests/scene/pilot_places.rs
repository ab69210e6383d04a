//! The places of what a pilot always sees, in the windows and text sizes of players and teachers.

use bevy_egui::egui::{Align2, Rect, Vec2, pos2, vec2};
use lightfall::app::{
    FlightStep, HoldKind, Layout, PilotNeeds, PilotPlaces, ShipFlight, ShipFrame, Slide, Stick,
    instruments, most_rows, pilot_places,
};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::mission::{self, MISSIONS};

/// Sizes of windows, in pixels, and sizes of texts.
const WINDOWS: [[f32; 2]; 4] = [
    [800.0, 600.0],
    [1024.0, 768.0],
    [1280.0, 720.0],
    [1920.0, 1080.0],
];
const TEXTS: [f32; 4] = [1.0, 1.25, 1.5, 2.0];
/// Widths of the inspector at the left and of the panel at the right, and the least width beside them, in
/// points.
const PANELS: [[f32; 2]; 4] = [[0.0, 0.0], [390.0, 0.0], [0.0, 420.0], [390.0, 420.0]];
const MIN_PICTURE: f32 = 150.0;
/// Room at the window's edges and between two boxes, in points.
const MARGIN: f32 = 12.0;
const GAP: f32 = 6.0;
/// The least width of a part of the window in which everything has a place, in points.
const ROOMY: f32 = 200.0;
/// Sizes of goals and of captions: of few words, and of as many as a mission may have.
const GOALS: [Vec2; 2] = [vec2(300.0, 48.0), vec2(450.0, 190.0)];
const CAPTIONS: [Vec2; 2] = [vec2(240.0, 34.0), vec2(480.0, 220.0)];
/// A message in one line, and one in four, in the shapes in which it is tried: the last one is cut.
const MESSAGES: [&[Vec2]; 2] = [
    &[vec2(190.0, 31.0)],
    &[
        vec2(640.0, 50.0),
        vec2(392.0, 70.0),
        vec2(268.0, 88.0),
        vec2(200.0, 26.0),
    ],
];

/// What the first mission needs; the map of a hole with spin is the highest.
fn needs() -> PilotNeeds {
    PilotNeeds {
        clocks: 72.0,
        row: 19.0,
        rows: [11, 8, 7],
        maps: vec![vec2(246.0, 443.0), vec2(166.0, 333.0)],
    }
}

/// The free parts of all windows, with what they are of.
fn rooms() -> Vec<(String, Rect)> {
    let mut rooms = Vec::new();
    for [width, height] in WINDOWS {
        for text in TEXTS {
            for [left, right] in PANELS {
                let right = width / text - right;
                if right - left >= MIN_PICTURE {
                    let whole = Rect::from_min_max(pos2(left, 0.0), pos2(right, height / text));
                    let what = format!("{width} x {height}, text {text}, from {left} to {right}");
                    rooms.push((what, whole.shrink(MARGIN)));
                }
            }
        }
    }
    assert!(rooms.len() >= WINDOWS.len() * TEXTS.len());
    rooms
}

/// The boxes that a pilot always sees.
fn fixed(places: &PilotPlaces) -> Vec<(&'static str, Rect)> {
    let boxes = [
        ("instruments", places.instruments),
        ("map", places.map),
        ("messages", places.messages),
        ("goals", Some(places.goals)),
    ];
    let there = |(name, place): (&'static str, Option<Rect>)| Some((name, place?));
    boxes
        .into_iter()
        .filter_map(there)
        .filter(|(_, place)| place.height() > 0.0)
        .collect()
}

#[track_caller]
fn assert_apart(boxes: &[(&str, Rect)], room: Rect, what: &str) {
    for (index, (name, place)) in boxes.iter().enumerate() {
        assert!(
            room.expand(1.0).contains_rect(*place),
            "{what}: {name} {place:?} leaves {room:?}"
        );
        for (other, taken) in &boxes[..index] {
            assert!(
                !place.expand(0.5 * GAP).intersects(*taken),
                "{what}: {name} {place:?} covers {other} {taken:?}"
            );
        }
    }
}

#[test]
fn what_a_pilot_always_sees_overlaps_in_no_window_and_at_no_size_of_texts() {
    for (what, room) in rooms() {
        let places = pilot_places(room, &needs());
        assert_apart(&fixed(&places), room, &what);
        if room.width() >= ROOMY {
            assert!(places.instruments.is_some(), "{what}: no clocks");
            assert!(places.messages.is_some(), "{what}: no room for messages");
        }
    }
    // Without panels and at the usual size of texts the map has its place in each of the windows.
    for [width, height] in WINDOWS {
        let room = Rect::from_min_size(pos2(0.0, 0.0), vec2(width, height)).shrink(MARGIN);
        let places = pilot_places(room, &needs());
        assert!(places.map.is_some(), "{width} x {height}: no map");
        assert!(
            places.rows >= needs().rows[1],
            "{width} x {height}: {places:?}"
        );
    }
}

/// Lays a frame out in the order of the window: instruments and map, a card, goals, a caption, a message.
fn laid_out(
    room: Rect,
    [goals, caption]: [Vec2; 2],
    message: &[Vec2],
    has_card: bool,
) -> Vec<(&'static str, Rect)> {
    let places = pilot_places(room, &needs());
    let mut layout = Layout::within(room);
    for (name, place) in [("instruments", places.instruments), ("map", places.map)] {
        if let Some(place) = place {
            layout.take(name, place);
        }
    }
    if let Some(place) = places.messages {
        layout.keep_for_messages(place);
    }
    if has_card {
        // A card takes what is left, and scrolls.
        let left = layout.room_for(330.0_f32.min(room.width()));
        let wish = layout.at(Align2::RIGHT_CENTER, Slide::Anywhere);
        let size = vec2(330.0, 420.0).min(left.size());
        layout
            .place("end card", size, wish.even_over_hole())
            .unwrap();
    }
    let corner = layout.at(Align2::LEFT_TOP, Slide::Nowhere);
    let fits = goals.x <= places.goals.width() && goals.y <= places.goals.height();
    if fits {
        layout.place("mission", goals, corner.even_over_hole());
    }
    let top = layout.at(Align2::CENTER_TOP, Slide::Anywhere);
    layout.place("caption", caption, top.even_over_hole());
    layout.release();
    let wish = layout.above_read_outs(0.0);
    for shape in message {
        if layout.place("toast", *shape, wish).is_some() {
            break;
        }
    }
    let taken = layout.taken().iter();
    taken.map(|taken| (taken.name, taken.place)).collect()
}

#[test]
fn neither_a_long_message_nor_a_card_moves_the_instruments_and_the_map() {
    let place = |boxes: &[(&str, Rect)], wanted: &str| {
        let found = boxes.iter().find(|(name, _)| *name == wanted);
        found.map(|(_, place)| *place)
    };
    for (what, room) in rooms() {
        let quiet = laid_out(room, [GOALS[0], CAPTIONS[0]], &[], false);
        for goals in GOALS {
            for caption in CAPTIONS {
                for message in MESSAGES {
                    for has_card in [false, true] {
                        let boxes = laid_out(room, [goals, caption], message, has_card);
                        assert_apart(&boxes, room, &what);
                        for name in ["instruments", "map"] {
                            assert_eq!(place(&boxes, name), place(&quiet, name), "{what}: {name}");
                        }
                        let is_said = place(&boxes, "toast").is_some();
                        assert!(is_said || room.width() < ROOMY, "{what}: {message:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn free_rooms_cover_nothing_and_the_place_for_messages_is_free_when_they_come() {
    let bounds = Rect::from_min_size(pos2(12.0, 12.0), vec2(776.0, 576.0));
    let mut layout = Layout::within(bounds);
    assert_eq!(layout.free_rooms(false), [bounds]);
    let kept = Rect::from_min_max(pos2(416.0, 542.0), bounds.max);
    layout.keep_for_messages(kept);
    layout.take(
        "instruments",
        Rect::from_min_max(pos2(12.0, 300.0), pos2(410.0, 588.0)),
    );
    layout.take(
        "map",
        Rect::from_min_max(pos2(542.0, 12.0), pos2(788.0, 455.0)),
    );
    let rooms = layout.free_rooms(false);
    assert!(rooms.iter().all(|room| layout.is_free(*room)), "{rooms:?}");
    // The widest free place is above the instruments and beside the map.
    let wide = Rect::from_min_max(bounds.min, pos2(542.0 - GAP, 300.0 - GAP));
    assert_eq!(layout.room_for(500.0), wide);
    // The highest one that is wide enough leads down beside the instruments.
    let narrow = layout.room_for(100.0);
    assert_eq!(
        narrow.x_range(),
        Rect::from_min_max(pos2(416.0, 0.0), wide.max).x_range()
    );
    assert!(!layout.is_free(kept));
    layout.release();
    assert!(layout.is_free(kept));
}

/// The ship of a mission after so many seconds without thrust.
fn coast(name: &str, seconds: f64) -> ShipFlight {
    let mission = mission::built_in(name).unwrap();
    let mut scene = mission.scene().clone();
    let mut ship = ShipFlight::default();
    ship.start(&mission, &scene).unwrap();
    let frame = ShipFrame {
        seconds: 0.05,
        turn_seconds: 0.05,
        stick: Stick::NEUTRAL,
        reduced_motion: false,
    };
    for _ in 0..(seconds / frame.seconds) as usize {
        match ship.advance(&frame, &scene).0 {
            FlightStep::Moved(next) => scene = next.into_scene(),
            FlightStep::Ended(_) => break,
            other => panic!("{name}: {other:?}"),
        }
    }
    ship
}

/// The numbers of the instruments: all, those that are not minor, and those that are needed.
fn counts(ship: &ShipFlight) -> [usize; 3] {
    let all = instruments(ship, ship.mass().unwrap(), Units::Hole);
    let main = all.iter().filter(|row| !row.is_minor || row.is_needed);
    let needed = all.iter().filter(|row| row.is_needed);
    [all.len(), main.count(), needed.count()]
}

#[test]
fn no_moment_of_a_mission_has_more_instruments_than_their_place_has_rows() {
    for (name, _) in MISSIONS {
        let start = coast(name, 0.0);
        let most = most_rows(start.attempt().map(|attempt| &attempt.mission));
        let mut reached = [0; 3];
        // At the start, held, and on the way, some of them inside the horizon.
        for seconds in [0.0, 2.0, 60.0] {
            let mut ship = coast(name, seconds);
            for held in [false, true] {
                if held && ship.switch_hold(HoldKind::Orbit).is_err() {
                    continue;
                }
                let now = counts(&ship);
                for (count, most) in now.into_iter().zip(most) {
                    assert!(count <= most, "{name}, {seconds} s: {now:?} of {most:?}");
                }
                reached = [0, 1, 2].map(|index| now[index].max(reached[index]));
            }
        }
        // No more than two rows stay empty: those of a hold and of a highest point.
        assert!(reached[0] + 2 >= most[0], "{name}: {reached:?} of {most:?}");
    }
}
