//! The gestures of fingers on the picture, from sequences of touches.

use bevy::input::touch::TouchPhase::{self, Canceled, Ended, Moved, Started};
use bevy::prelude::Vec2;
use lightfall::app::{Gesture, Gestures};
use std::f32::consts::{FRAC_PI_2, PI};

/// More than a finger trembles, in points.
const FAR: f32 = 40.0;

/// One change of a finger.
type Touch = (u64, TouchPhase, [f32; 2]);

/// What changes of fingers on the picture mean.
fn gestures(touches: &[Touch]) -> Vec<Gesture> {
    let mut gestures = Gestures::default();
    let follow = |(id, phase, place): &Touch| gestures.follow(*id, *phase, (*place).into(), true);
    touches.iter().filter_map(follow).collect()
}

/// The sums of the gestures: way, spread, turn, and the taps.
fn sums(gestures: &[Gesture]) -> (Vec2, f32, f32, Vec<Vec2>) {
    let mut sums = (Vec2::ZERO, 0.0, 0.0, Vec::new());
    for gesture in gestures {
        match gesture {
            Gesture::Drag(way) => sums.0 += *way,
            Gesture::Pinch { spread, turn } => {
                sums.1 += spread;
                sums.2 += turn;
            }
            Gesture::Tap(place) => sums.3.push(*place),
        }
    }
    sums
}

/// A finger that goes straight from one place to another, without its first and its last touch.
fn way(id: u64, [from, to]: [[f32; 2]; 2]) -> Vec<Touch> {
    let steps = 20;
    let [from, to] = [from, to].map(Vec2::from);
    let place = |step: i32| from.lerp(to, step as f32 / steps as f32).to_array();
    (1..=steps).map(|step| (id, Moved, place(step))).collect()
}

#[test]
fn one_finger_drags_by_its_way_after_it_has_left_its_place() {
    let mut touches = vec![(7, Started, [100.0, 100.0])];
    touches.extend(way(7, [[100.0, 100.0], [300.0, 60.0]]));
    touches.push((7, Ended, [300.0, 60.0]));
    let (dragged, spread, turn, taps) = sums(&gestures(&touches));
    let whole = Vec2::new(200.0, -40.0);
    let lost = whole - dragged;
    // What is lost is the step that leaves the place, and what trembles before.
    assert!(dragged.normalize().distance(whole.normalize()) < 1e-4);
    assert!(lost.length() > 0.0 && lost.length() < 0.15 * whole.length());
    assert_eq!((spread, turn, taps), (0.0, 0.0, vec![]));
}

#[test]
fn a_finger_that_comes_and_goes_without_moving_taps_and_one_that_trembles_does_so_too() {
    let still = [(1, Started, [50.0, 60.0]), (1, Ended, [50.0, 60.0])];
    assert_eq!(gestures(&still), [Gesture::Tap(Vec2::new(50.0, 60.0))]);
    let trembling = [
        (1, Started, [50.0, 60.0]),
        (1, Moved, [53.0, 58.0]),
        (1, Moved, [48.0, 63.0]),
        (1, Ended, [48.0, 63.0]),
    ];
    assert_eq!(gestures(&trembling), [Gesture::Tap(Vec2::new(48.0, 63.0))]);
    // One that goes and comes back has moved.
    let there_and_back = [
        (1, Started, [50.0, 60.0]),
        (1, Moved, [50.0 + FAR, 60.0]),
        (1, Moved, [50.0, 60.0]),
        (1, Ended, [50.0, 60.0]),
    ];
    assert_eq!(
        gestures(&there_and_back),
        [Gesture::Drag(Vec2::new(-FAR, 0.0))]
    );
}

#[test]
fn a_touch_that_the_system_cancels_and_one_on_the_user_interface_mean_nothing() {
    assert_eq!(
        gestures(&[(1, Started, [50.0, 60.0]), (1, Canceled, [50.0, 60.0])]),
        []
    );
    let mut gestures = Gestures::default();
    let mut follow = |(id, phase, place): Touch, on_picture: bool| {
        gestures.follow(id, phase, place.into(), on_picture)
    };
    // Put down on a button, moved onto the picture, and lifted there.
    assert_eq!(follow((1, Started, [0.0, 0.0]), false), None);
    assert_eq!(follow((1, Moved, [FAR, 0.0]), true), None);
    assert_eq!(follow((1, Moved, [2.0 * FAR, 0.0]), true), None);
    assert_eq!(follow((1, Ended, [2.0 * FAR, 0.0]), true), None);
    // A finger that is on the user interface does not make a pair with one on the picture.
    assert_eq!(follow((1, Started, [0.0, 0.0]), false), None);
    assert_eq!(follow((2, Started, [100.0, 100.0]), true), None);
    assert_eq!(follow((2, Moved, [100.0 + FAR, 100.0]), true), None);
    assert_eq!(
        follow((2, Moved, [100.0 + 2.0 * FAR, 100.0]), true),
        Some(Gesture::Drag(Vec2::new(FAR, 0.0)))
    );
    // Nor does one whose first touch was never reported.
    assert_eq!(follow((9, Moved, [FAR, 0.0]), true), None);
    assert_eq!(follow((9, Ended, [FAR, 0.0]), true), None);
}

#[test]
fn two_fingers_that_part_pinch_and_do_not_turn() {
    let mut touches = vec![(1, Started, [200.0, 200.0]), (2, Started, [300.0, 200.0])];
    touches.extend(way(2, [[300.0, 200.0], [600.0, 200.0]]));
    let (dragged, spread, turn, taps) = sums(&gestures(&touches));
    // Four times as far apart, less the steps up to the one that ends the rest.
    let whole = 4.0_f32.ln();
    assert!(spread < whole && spread > whole - 0.15, "{spread}");
    assert_eq!((dragged, turn, taps), (Vec2::ZERO, 0.0, vec![]));

    // Back again is the same, less the same rest.
    let mut touches = vec![(1, Started, [200.0, 200.0]), (2, Started, [600.0, 200.0])];
    touches.extend(way(2, [[600.0, 200.0], [300.0, 200.0]]));
    let (_, spread, turn, _) = sums(&gestures(&touches));
    assert!(spread > -whole && spread < 0.15 - whole, "{spread}");
    assert_eq!(turn, 0.0);
}

#[test]
fn two_fingers_that_circle_each_other_turn_and_do_not_pinch() {
    let place = |angle: f32| (Vec2::splat(300.0) + 100.0 * Vec2::from_angle(angle)).to_array();
    for direction in [1.0, -1.0] {
        let mut touches = vec![(1, Started, place(0.0)), (2, Started, place(PI))];
        let steps = 60;
        for step in 1..=steps {
            // Through the angle at which `atan2` jumps.
            let angle = direction * 3.0 * FRAC_PI_2 * step as f32 / steps as f32;
            // The fingers move one after the other, as their messages do.
            touches.push((1, Moved, place(angle)));
            touches.push((2, Moved, place(angle + PI)));
        }
        let (dragged, spread, turn, taps) = sums(&gestures(&touches));
        // Clockwise is positive on a screen whose y axis points down.
        let whole = direction * 3.0 * FRAC_PI_2;
        let lost = (whole - turn) * direction;
        assert!(lost > 0.0 && lost < 0.2, "{turn} of {whole}");
        assert!(spread.abs() < 0.05, "{spread}");
        assert_eq!((dragged, taps), (Vec2::ZERO, vec![]));
    }
}

#[test]
fn the_picture_does_not_jump_when_a_finger_comes_or_goes() {
    let (left, right) = ([200.0, 300.0], [600.0, 300.0]);
    let mut pinch = vec![(1, Started, left), (2, Started, right)];
    pinch.extend(way(2, [right, [700.0, 300.0]]));
    let before = gestures(&pinch).len();
    // One finger goes: the other one rests until it leaves its place, and then drags by its own way.
    pinch.push((1, Ended, left));
    pinch.push((2, Moved, [702.0, 300.0]));
    assert_eq!(gestures(&pinch).len(), before);
    pinch.push((2, Moved, [702.0 + FAR, 300.0]));
    pinch.push((2, Moved, [702.0 + FAR, 305.0]));
    assert_eq!(
        gestures(&pinch)[before..],
        [Gesture::Drag(Vec2::new(0.0, 5.0))]
    );
    // Lifted, it does not tap; another one in its place is a new finger.
    pinch.push((2, Ended, [702.0 + FAR, 305.0]));
    pinch.push((3, Started, [10.0, 10.0]));
    pinch.push((3, Ended, [10.0, 10.0]));
    assert_eq!(
        gestures(&pinch)[before + 1..],
        [Gesture::Tap(Vec2::splat(10.0))]
    );

    // The first finger is lifted and put down elsewhere: the pair begins anew, at its new distance.
    let again = [
        (1, Started, left),
        (2, Started, right),
        (1, Ended, left),
        (1, Started, [400.0, 300.0]),
        (2, Moved, [602.0, 300.0]),
        (1, Ended, [400.0, 300.0]),
        (2, Ended, [602.0, 300.0]),
    ];
    assert_eq!(gestures(&again), []);
}

#[test]
fn three_fingers_mean_nothing_and_two_of_them_go_on_where_they_are() {
    let places = [[200.0, 300.0], [600.0, 300.0], [400.0, 100.0]];
    let mut touches: Vec<Touch> = (0..3)
        .map(|id| (id, Started, places[id as usize]))
        .collect();
    touches.extend(way(0, [places[0], [100.0, 500.0]]));
    touches.extend(way(2, [places[2], [900.0, 100.0]]));
    touches.push((2, Ended, [900.0, 100.0]));
    assert_eq!(gestures(&touches), []);
    // The two that are left are as far apart as they are now.
    touches.push((1, Moved, [601.0, 301.0]));
    assert_eq!(gestures(&touches), []);
    touches.push((0, Canceled, [100.0, 500.0]));
    touches.push((1, Ended, [601.0, 301.0]));
    assert_eq!(gestures(&touches), []);
}

#[test]
fn fingers_that_touch_each_other_neither_pinch_nor_turn_wildly() {
    let mut touches = vec![(1, Started, [300.0, 300.0]), (2, Started, [300.0, 300.0])];
    for step in 0..50 {
        let angle = step as f32;
        let place = Vec2::splat(300.0) + 5.0 * Vec2::from_angle(angle);
        touches.push((2, Moved, place.to_array()));
    }
    assert_eq!(gestures(&touches), []);
}

#[test]
fn no_finger_is_left_after_a_window_has_lost_the_focus() {
    let mut gestures = Gestures::default();
    gestures.follow(1, Started, Vec2::ZERO, true);
    gestures.clear();
    assert_eq!(gestures.follow(1, Moved, Vec2::splat(FAR), true), None);
    // The next finger is alone.
    gestures.follow(2, Started, Vec2::ZERO, true);
    assert_eq!(
        gestures.follow(2, Ended, Vec2::ZERO, true),
        Some(Gesture::Tap(Vec2::ZERO))
    );
}
