//! Gestures of fingers on the picture: one finger drags it, two pinch and turn it, and a tap is a
//! finger that comes and goes without moving.

use bevy::input::touch::TouchPhase;
use bevy::prelude::Vec2;
use std::f32::consts::{PI, TAU};

/// Way of a single finger, in points, below which it rests: fingers tremble.
const REST: f32 = 10.0;
/// Change of the distance of two fingers, as a power of e, and turn of the line between them, in
/// radians, below which they rest. A pinch then turns nothing, and a turn pinches nothing.
const PINCH_REST: f32 = 0.05;
const TURN_REST: f32 = 0.12;
/// The smallest distance of two fingers that counts, in points: closer together, a trembling finger
/// would pinch and turn wildly.
const MIN_DISTANCE: f32 = 24.0;

/// What a change of a finger means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gesture {
    /// One finger drags the picture by this many points, to the right and down.
    Drag(Vec2),
    /// Two fingers pinch or turn the picture.
    Pinch {
        /// Power of e by which the distance of the fingers has grown.
        spread: f32,
        /// Clockwise turn, in radians.
        turn: f32,
    },
    /// A tap at this place.
    Tap(Vec2),
}

/// A finger on the picture.
#[derive(Clone, Copy, Debug)]
struct Finger {
    id: u64,
    /// Where it began to rest.
    start: Vec2,
    place: Vec2,
}

/// The fingers on the picture. More than two mean nothing.
#[derive(Debug, Default)]
pub struct Gestures {
    fingers: Vec<Finger>,
    /// Whether the one finger is the first since there was none, and has not moved.
    taps: bool,
    /// Whether the one finger drags.
    drags: bool,
    /// The pinch and the turn of two fingers, as far as they rest: none once they move.
    rest: [Option<f32>; 2],
}

impl Gestures {
    /// Takes in a change of a finger. Fingers that are put down where `on_picture` is false, and
    /// those that were never put down, mean nothing.
    pub fn follow(
        &mut self,
        id: u64,
        phase: TouchPhase,
        place: Vec2,
        on_picture: bool,
    ) -> Option<Gesture> {
        match phase {
            TouchPhase::Started => {
                // A finger whose end was not reported begins again.
                self.fingers.retain(|finger| finger.id != id);
                if on_picture {
                    let start = place;
                    self.fingers.push(Finger { id, start, place });
                }
                self.begin();
                self.taps = on_picture && self.fingers.len() == 1;
                None
            }
            TouchPhase::Moved => self.drag(id, place),
            TouchPhase::Ended | TouchPhase::Canceled => {
                let before = self.fingers.len();
                self.fingers.retain(|finger| finger.id != id);
                if self.fingers.len() == before {
                    return None;
                }
                let tapped = phase == TouchPhase::Ended && self.taps;
                self.begin();
                tapped.then_some(Gesture::Tap(place))
            }
        }
    }

    /// Lets go of all fingers.
    pub fn clear(&mut self) {
        self.fingers.clear();
        self.begin();
    }

    /// Lets the fingers rest where they are, so that none that comes or goes moves the picture.
    fn begin(&mut self) {
        for finger in &mut self.fingers {
            finger.start = finger.place;
        }
        (self.taps, self.drags, self.rest) = (false, false, [Some(0.0); 2]);
    }

    fn drag(&mut self, id: u64, place: Vec2) -> Option<Gesture> {
        let line = self.line();
        let finger = self.fingers.iter_mut().find(|finger| finger.id == id)?;
        let way = place - finger.place;
        finger.place = place;
        let far = place.distance(finger.start) > REST;
        match (line, self.line()) {
            (Some(before), Some(after)) => self.pinch(before, after),
            _ if self.fingers.len() > 1 => None,
            _ if self.drags => Some(Gesture::Drag(way)),
            _ => {
                self.drags = far;
                self.taps &= !far;
                None
            }
        }
    }

    /// The line from the first to the second of two fingers.
    fn line(&self) -> Option<Vec2> {
        match self.fingers.as_slice() {
            [a, b] => Some(b.place - a.place),
            _ => None,
        }
    }

    fn pinch(&mut self, before: Vec2, after: Vec2) -> Option<Gesture> {
        let [from, to] = [before, after].map(|line| line.length().max(MIN_DISTANCE));
        let spread = (to / from).ln();
        let near = before.length().min(after.length()) < MIN_DISTANCE;
        let turn = if near { 0.0 } else { turned(before, after) };
        let [pinch_rest, turn_rest] = &mut self.rest;
        let spread = beyond(pinch_rest, spread, PINCH_REST);
        let turn = beyond(turn_rest, turn, TURN_REST);
        (spread != 0.0 || turn != 0.0).then_some(Gesture::Pinch { spread, turn })
    }
}

/// The clockwise angle from one line to another, in radians, on a screen whose y axis points down.
fn turned(from: Vec2, to: Vec2) -> f32 {
    (to.to_angle() - from.to_angle() + PI).rem_euclid(TAU) - PI
}

/// A step that counts once all steps together exceed the limit of rest.
fn beyond(rest: &mut Option<f32>, step: f32, limit: f32) -> f32 {
    let Some(sum) = rest else {
        return step;
    };
    *sum += step;
    if sum.abs() > limit {
        *rest = None;
    }
    0.0
}
