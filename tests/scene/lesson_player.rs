//! The player of a journey with stops: it waits, goes on and back, and puts back what stops switch.

use lightfall::app::{FlightStep, JourneyPlayer, NotedAnswer, next_lesson};
use lightfall_core::scene::journey::{FLIGHTS, LESSONS, load};
use lightfall_core::scene::{Scene, presets};

const LESSON: &str = "[[keyframe]]\ntime = 0\nr = 20\n[[keyframe]]\ntime = 4\nr = 10\n\
    [[stop]]\nat = 1\neffects.doppler = false\n[[stop]]\nat = 2\neffects.beaming = false\n\
    [[stop]]\nat = 4\neffects.doppler = true\n";
/// Time of a frame, in seconds, whose sums are exact.
const FRAME: f64 = 0.125;

fn scene() -> Scene {
    presets::find("above").unwrap().plain_scene().clone()
}

fn player() -> JourneyPlayer {
    let mut player = JourneyPlayer::new(load("lesson.toml", LESSON).unwrap());
    player.rewind(&scene());
    player.restart();
    player
}

/// The scene after so many frames; none once the flight is over.
fn after(player: &mut JourneyPlayer, scene: &Scene, frames: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    for _ in 0..frames {
        if player.rests() {
            player.follow(&scene);
            continue;
        }
        scene = match player.advance(FRAME, &scene, false) {
            FlightStep::Moved(next) => next.into_scene(),
            FlightStep::Ended(_) => return None,
            other => panic!("{other:?}"),
        };
    }
    Some(scene)
}

fn effects(scene: &Scene) -> [bool; 2] {
    [scene.effects.doppler, scene.effects.beaming]
}

#[test]
fn a_lesson_waits_at_each_stop_until_it_goes_on_and_ends_after_the_last() {
    let mut player = player();
    let begun = after(&mut player, &scene(), 4).unwrap();
    assert_eq!(
        (effects(&begun), player.waits_at().map(|(_, n)| n)),
        ([true, true], None)
    );
    let first = after(&mut player, &begun, 100).unwrap();
    assert!(player.rests() && player.time() == 1.0 && player.has_lesson());
    assert_eq!(
        (effects(&first), player.waits_at().map(|(_, n)| n)),
        ([false, true], Some(1))
    );
    player.go_on(&first);
    let second = after(&mut player, &first, 100).unwrap();
    assert_eq!((effects(&second), player.time()), ([false, false], 2.0));
    // On the way, the next stop is shown at once.
    player.go_on(&second);
    let on_the_way = after(&mut player, &second, 3).unwrap();
    assert!(player.waits_at().is_none());
    player.go_on(&on_the_way);
    let last = after(&mut player, &on_the_way, 2).unwrap();
    assert_eq!((effects(&last), player.time()), ([true, false], 4.0));
    assert!((last.camera.r - 10.0).abs() < 1e-9);
    player.go_on(&last);
    assert_eq!(after(&mut player, &last, 2), None);
    assert!(!player.is_playing());
    // The fields are as they were, and the camera stays.
    let back = player.unswitched(last.clone()).unwrap();
    assert_eq!((effects(&back), back.camera), ([true, true], last.camera));
    assert_eq!(player.unswitched(back), None, "put back once");
}

#[test]
fn a_lesson_goes_back_to_the_stop_before_with_what_was_switched_there() {
    let mut player = player();
    let first = after(&mut player, &scene(), 50).unwrap();
    player.go_on(&first);
    let second = after(&mut player, &first, 50).unwrap();
    player.go_back();
    let back = after(&mut player, &second, 2).unwrap();
    assert_eq!((effects(&back), player.time()), ([false, true], 1.0));
    assert_eq!(back.camera, first.camera);
    // From the first one to the beginning, which is no stop: the flight begins again.
    player.go_back();
    let begun = after(&mut player, &back, 1).unwrap();
    assert_eq!(effects(&begun), [true, true]);
    let again = after(&mut player, &begun, 50).unwrap();
    assert_eq!((effects(&again), player.time()), ([false, true], 1.0));
    // A skip ahead goes no farther than to the next stop, and one back as far as it says.
    player.skip(100.0);
    let second = after(&mut player, &again, 2).unwrap();
    assert_eq!(player.time(), 2.0);
    player.skip(-1.5);
    let early = after(&mut player, &second, 1).unwrap();
    assert!(player.time() < 1.0 && effects(&early) == [true, true]);
}

#[test]
fn at_a_stop_the_hands_have_the_camera_and_going_on_leads_gently_back() {
    let mut player = player();
    let mut flown = after(&mut player, &scene(), 50).unwrap();
    (flown.camera.r, flown.camera.phi_deg) = (40.0, 90.0);
    // Keys switch what they like.
    flown.effects.beaming = false;
    let waited = after(&mut player, &flown, 10).unwrap();
    assert_eq!(waited, flown);
    player.go_on(&flown);
    let mut before = flown;
    for _ in 0..40 {
        let next = after(&mut player, &before, 1).unwrap();
        let moved = (next.camera.r.ln() - before.camera.r.ln()).abs();
        assert!(moved < 0.2, "{} to {}", before.camera.r, next.camera.r);
        before = next;
    }
    assert!(player.rests() && player.time() == 2.0);
    let mut there = before.clone();
    load("lesson.toml", LESSON).unwrap().lead(2.0, &mut there);
    assert_eq!(before.camera, there.camera);
}

#[test]
fn a_lesson_that_was_left_at_a_stop_goes_on_there_and_switches_again() {
    let mut player = player();
    let first = after(&mut player, &scene(), 50).unwrap();
    player.stop();
    let left = player.unswitched(first).unwrap();
    assert_eq!(effects(&left), [true, true]);
    player.start(&left);
    let again = after(&mut player, &left, 60).unwrap();
    assert_eq!(
        (effects(&again), player.time(), player.rests()),
        ([false, true], 1.0, true)
    );
    // A journey that is taken in its place begins at its own beginning.
    player.take(
        load(
            "other.toml",
            "[[keyframe]]\ntime = 0\n[[keyframe]]\ntime = 3\n",
        )
        .unwrap(),
    );
    assert!(!player.is_playing() && player.time() == 0.0 && player.begins_anew(&scene()));
}

/// A lesson that compares, and one that has switched the disk off before.
const COMPARES: &str = "preset = \"above\"\n[[keyframe]]\ntime = 0\nr = 20\n[[keyframe]]\ntime = 4\nr = 10\n\
    [[stop]]\nat = 0\neffects.beaming = false\nside_by_side = true\n";
const DARK: &str = "[[keyframe]]\ntime = 0\nr = 20\n[[keyframe]]\ntime = 4\nr = 10\n\
    [[stop]]\nat = 0\ndisk.enabled = false\n";

/// The scene beside the present one at the stop at which a lesson waits.
fn beside(player: &JourneyPlayer) -> Scene {
    let stops = player.shown_stops().unwrap().stops;
    let switches = player.journey().switches_of(stops);
    player.beside(&switches).unwrap()
}

#[test]
fn a_lesson_chosen_while_another_one_waits_is_compared_with_its_own_scene() {
    let mut player = JourneyPlayer::new(load("dark.toml", DARK).unwrap());
    player.rewind(&scene());
    player.restart();
    let dark = after(&mut player, &scene(), 3).unwrap();
    assert!(player.rests() && !dark.disk.enabled);
    // As the menu does it: what was switched is put back, and the next lesson begins in the same frame.
    let home = player.unswitched(dark).unwrap();
    player.take(load("compares.toml", COMPARES).unwrap());
    player.rewind(&scene());
    player.restart();
    let compared = after(&mut player, &home, 3).unwrap();
    assert!(player.rests() && !compared.effects.beaming);
    let beside = beside(&player);
    assert!(beside.disk.enabled && beside.effects.beaming);
}

#[test]
fn a_lesson_that_begins_again_in_its_own_preset_is_compared_with_it() {
    let close = presets::find("close").unwrap().plain_scene().clone();
    let mut player = JourneyPlayer::new(load("compares.toml", COMPARES).unwrap());
    player.rewind(&close);
    player.restart();
    after(&mut player, &close, 3).unwrap();
    assert_eq!(beside(&player).name, "close");
    // Enter puts the preset that the lesson names in place, without a frame in between.
    player.rewind(&scene());
    player.restart();
    after(&mut player, &scene(), 3).unwrap();
    assert_eq!(beside(&player).name, "above");
}

/// A lesson with a question at its second and its third stop.
const ASKS: &str = "[[keyframe]]\ntime = 0\nr = 20\n[[keyframe]]\ntime = 2\nr = 10\n[[stop]]\nat = 0\n\
    [[stop]]\nat = 1\nquestion = { text = \"a\", answer = 1, tolerance = 0.1 }\n\
    [[stop]]\nat = 2\nquestion = { text = \"b\", answer = 2, tolerance = 0.1 }\n";

#[test]
fn the_tries_at_each_question_are_counted_until_the_lesson_begins_anew() {
    let mut player = JourneyPlayer::new(load("asks.toml", ASKS).unwrap());
    player.rewind(&scene());
    player.restart();
    let first = after(&mut player, &scene(), 3).unwrap();
    assert_eq!(player.note_answer(true), None, "nothing is asked here");
    assert_eq!(player.score(), None, "nobody has answered");
    player.go_on(&first);
    let second = after(&mut player, &first, 20).unwrap();
    let noted = |question, tries| Some(NotedAnswer { question, tries });
    assert_eq!(player.note_answer(false), noted(1, 1));
    assert_eq!(player.note_answer(true), noted(1, 2));
    assert_eq!(player.note_answer(true), None, "it was right before");
    let score = |player: &JourneyPlayer| player.score().unwrap();
    assert_eq!(
        score(&player),
        "0 of 2 questions right at once, 1 after more tries, 1 not solved."
    );
    player.go_on(&second);
    after(&mut player, &second, 20).unwrap();
    assert_eq!(player.note_answer(true), noted(2, 1));
    assert_eq!(
        score(&player),
        "1 of 2 questions right at once, 1 after more tries."
    );
    player.restart();
    assert_eq!(player.score(), None);
}

#[test]
fn after_a_lesson_comes_the_next_one_that_has_stops() {
    let list: Vec<_> = LESSONS
        .iter()
        .chain(&FLIGHTS)
        .map(|(name, text)| load(name, text).unwrap())
        .collect();
    let next = |title: &str| next_lesson(&list, title).map(|lesson| lesson.title.clone());
    for pair in list[..LESSONS.len()].windows(2) {
        assert_eq!(next(&pair[0].title), Some(pair[1].title.clone()));
    }
    // A flight is no lesson, and an unknown title has no place in the list.
    assert_eq!(next(&list[LESSONS.len() - 1].title), None);
    assert_eq!(next("mine"), None);
}

#[test]
fn what_keyframes_set_is_shown_on_the_way_and_put_back_when_the_journey_is_left() {
    let text = "[[keyframe]]\ntime = 0\nr = 20\nease = \"linear\"\nset = { disk.brightness = 1, picture.exposure_ev = 0 }\n\
                [[keyframe]]\ntime = 4\nr = 10\nset = { disk.brightness = 3 }\n";
    let mut player = JourneyPlayer::new(load("set.toml", text).unwrap());
    let mut home = scene();
    home.disk.brightness = 0.5;
    home.picture.automatic_exposure = true;
    player.rewind(&home);
    player.restart();
    // The first frame shows the start itself, and 16 more are 2 s.
    let half = after(&mut player, &home, 17).unwrap();
    assert_eq!((player.time(), half.disk.brightness), (2.0, 2.0));
    assert_eq!(
        (half.picture.automatic_exposure, half.picture.exposure_ev),
        (false, 0.0)
    );
    player.stop();
    let mut back = player.unswitched(half).unwrap();
    // The disk's clock goes on.
    back.disk.time = home.disk.time;
    assert_eq!((back.disk, back.picture), (home.disk, home.picture));
}
