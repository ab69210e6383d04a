//! The built-in lessons: every number that their captions state is computed here.

use glam::DVec3;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::geometry::schwarzschild::CRITICAL_IMPACT;
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::apparent_hole::ApparentHole;
use lightfall_core::optics::readout::si::MASSES;
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::{InspectorView, Journey, LESSONS, Stop, built_in};
use std::cell::Cell;

/// The text with its numbers taken out, and these as they are written.
fn numbers_in(text: &str) -> Vec<&str> {
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let words = text.split(|c: char| !is_part(c));
    words
        .map(|word| word.trim_matches('.'))
        .filter(|word| word.contains('.'))
        .collect()
}

/// A number in as many digits as a text has.
fn rounded_like(value: f64, written: &str) -> String {
    let decimals = written
        .split_once('.')
        .map_or(0, |(_, decimals)| decimals.len());
    format!("{value:.decimals$}")
}

struct Lesson {
    journey: Journey,
    /// How many numbers with a decimal point were compared.
    compared: Cell<usize>,
}

impl Lesson {
    fn of(name: &str) -> Self {
        Self {
            journey: built_in(name).unwrap(),
            compared: Cell::new(0),
        }
    }

    fn stop(&self, number: usize) -> &Stop {
        &self.journey.stops[number - 1]
    }

    /// The scene at the stop of this number, counted from 1.
    fn scene(&self, number: usize) -> Scene {
        let mut scene = self.journey.preset.unwrap().plain_scene().clone();
        self.journey.apply(self.stop(number).time, &mut scene);
        scene
    }

    /// The ray that the inspector shows at a stop.
    fn ray(&self, number: usize) -> Inspected {
        let shown = self.journey.switches_of(number).inspector;
        let Some(InspectorView::Toward(direction)) = shown else {
            panic!("stop {number} shows {shown:?}")
        };
        self.ray_toward(number, direction)
    }

    fn ray_toward(&self, number: usize, direction: [f64; 3]) -> Inspected {
        let direction = DVec3::from_array(direction).normalize();
        Inspected::new(&self.scene(number), direction, None, 200.0).unwrap()
    }

    /// Compares all numbers with a decimal point of a stop's caption with these values, in order.
    fn states(&self, number: usize, values: &[f64]) {
        let caption = self.stop(number).caption.clone();
        let written = numbers_in(&caption);
        let rounded: Vec<String> = values
            .iter()
            .zip(&written)
            .map(|(value, written)| rounded_like(*value, written))
            .collect();
        assert_eq!(rounded, written, "stop {number}: {caption}");
        assert_eq!(values.len(), written.len(), "stop {number}: {caption}");
        self.compared.set(self.compared.get() + values.len());
    }

    /// Checks that the numbers of all captions were compared.
    fn ends(&self) {
        let captions = self
            .journey
            .stops
            .iter()
            .map(|stop| numbers_in(&stop.caption).len());
        assert_eq!(captions.sum::<usize>(), self.compared.get());
    }
}

#[test]
fn every_lesson_is_flown_in_its_preset_from_a_stop_to_a_stop_at_its_end() {
    for (name, _) in LESSONS {
        let journey = Lesson::of(name).journey;
        let preset = journey.preset.unwrap().plain_scene();
        assert_eq!(journey.check(preset, 0.0, Drawable::new), Ok(()), "{name}");
        let (first, last) = (&journey.stops[0], &journey.stops[journey.stops.len() - 1]);
        assert_eq!([first.time, last.time], [0.0, journey.duration], "{name}");
        assert!(
            !journey.title.is_empty() && !journey.teaches.is_empty() && !journey.ending.is_empty()
        );
        // Every lesson asks one thing that a class can compute.
        assert!(
            journey.stops.iter().any(|stop| stop.question.is_some()),
            "{name}"
        );
        // The ray of every stop is in the picture, and so marked there.
        for stop in 1..=journey.stops.len() {
            let lesson = Lesson::of(name);
            if let Some(InspectorView::Toward(direction)) = journey.switches_of(stop).inspector {
                let camera = lesson.scene(stop).camera;
                let looking =
                    camera.tetrad_from_camera().transpose() * DVec3::from_array(direction);
                // As narrow as a picture beside the inspector in the usual window.
                assert!(
                    camera.shows(looking, glam::DVec2::new(700.0, 540.0)),
                    "{name}, stop {stop}"
                );
            }
        }
    }
}

#[test]
fn the_numbers_of_the_lesson_about_the_shadow_are_those_of_the_reference() {
    let lesson = Lesson::of("shadow");
    // The f64 reference's edge, and Synge's formula sin(alpha) = b sqrt(1 - 1/r)/r.
    let edge = |stop: usize| {
        let scene = lesson.scene(stop);
        let alpha = ApparentHole::new(&scene).unwrap().radius;
        let r = scene.camera.r;
        let synge = (CRITICAL_IMPACT * (1.0 - 1.0 / r).sqrt() / r).asin();
        assert!((alpha - synge).abs() < 1e-6, "{alpha} {synge}");
        synge
    };
    let [near, far] = [edge(2), edge(7)];
    let straight = (1.0_f64 / 20.0).asin();
    let wider = near / straight;
    // In a perspective picture the width of a disk in the middle goes with the tangent: the same to the
    // digits of the caption.
    let on_screen = near.tan() / straight.tan();
    assert_eq!(format!("{wider:.1}"), format!("{on_screen:.1}"));
    let [passes, falls] = [lesson.ray(4), lesson.ray(5)];
    assert!(passes.trace.sky.is_some() && falls.trace.sky.is_none());
    lesson.states(1, &[]);
    lesson.states(2, &[near.to_degrees(), straight.to_degrees()]);
    lesson.states(3, &[wider]);
    let numbers = &passes.numbers;
    let deflection = numbers.deflection.unwrap().to_degrees();
    lesson.states(
        4,
        &[
            numbers.impact_parameter.unwrap(),
            deflection,
            1.5,
            numbers.closest_r,
        ],
    );
    assert!((lesson.scene(4).kerr().photon_orbit_prograde() - 1.5).abs() < 1e-12);
    lesson.states(
        5,
        &[falls.numbers.impact_parameter.unwrap(), CRITICAL_IMPACT],
    );
    lesson.states(6, &[]);
    lesson.states(7, &[far.to_degrees(), far.sin(), 60.0 * far.sin()]);
    let views = [1, 7].map(|stop| lesson.scene(stop).camera.fov_deg);
    assert_eq!(views, [40.0, 20.0]);
    let question = lesson.stop(7).question.clone().unwrap();
    assert!((2.0 * CRITICAL_IMPACT * 12.7 - question.answer).abs() < 0.01);
    lesson.ends();
}

#[test]
fn the_numbers_of_the_lesson_about_the_bright_side_are_those_of_the_reference() {
    let lesson = Lesson::of("bright-side");
    let hit = |ray: Inspected| ray.trace.hits[0].unwrap();
    let [left, right] = [hit(lesson.ray(2)), hit(lesson.ray(3))];
    assert!((left.r - right.r).abs() < 1e-12, "mirror images");
    lesson.states(1, &[]);
    lesson.states(2, &[left.r, left.g, left.g, left.g.powi(4)]);
    lesson.states(3, &[right.g, right.g.powi(4), (left.g / right.g).powi(4)]);
    lesson.states(4, &[]);
    let direction = |stop| match lesson.stop(stop).inspector {
        Some(InspectorView::Toward(direction)) => direction,
        other => panic!("{other:?}"),
    };
    let without = [2, 3].map(|stop| hit(lesson.ray_toward(5, direction(stop))).g);
    assert!((without[0] - without[1]).abs() < 1e-12, "{without:?}");
    lesson.states(5, &[without[0], left.r]);
    // g = 1 is met on the left side, between its bright part and the middle of the near side.
    let middle = hit(lesson.ray_toward(6, [-0.98, 0.1, 0.0]));
    assert!(left.g > 1.0 && middle.g < 1.0, "{middle:?}");
    lesson.states(6, &[]);
    // The formula on the page, for a ray straight from above.
    let seen = hit(lesson.ray_toward(7, [-1.0, 0.3, 0.0]));
    let formula = |r: f64| ((1.0 - 1.5 / r) / (1.0 - 1.0 / 20.0)).sqrt();
    // Half a degree from the axis some of the motion is along the ray.
    assert!(
        (seen.g - formula(seen.r)).abs() < 0.005,
        "{} {}",
        seen.g,
        formula(seen.r)
    );
    // Gravity alone takes 1 of the 1.5, and the clock of a circular orbit the rest: its speed past one who
    // hovers there is v^2 = 0.5/(r - 1), and (1 - 1/r) (1 - v^2) = 1 - 1.5/r.
    let gravity = ((1.0 - 1.0 / left.r) / (1.0 - 1.0 / 20.0)).sqrt();
    assert!((gravity - without[0]).abs() < 1e-6, "{gravity} {without:?}");
    let moving = (1.0 - 0.5 / (left.r - 1.0)).sqrt();
    assert!((gravity * moving - formula(left.r)).abs() < 1e-12);
    lesson.states(7, &[1.5, 1.5, without[0], 0.5]);
    let question = lesson.stop(7).question.clone().unwrap();
    assert!((formula(6.0) - question.answer).abs() < 1e-4);
    lesson.ends();
}

#[test]
fn the_numbers_of_the_lesson_about_two_clocks_are_those_of_the_reference() {
    let lesson = Lesson::of("two-clocks");
    let rate = |stop: usize| (1.0 - 1.0 / lesson.scene(stop).camera.r).sqrt();
    let sky_g = |stop: usize| lesson.ray(stop).numbers.sky_g.unwrap();
    // From rest far away, without spin: tau = 2/3 r^(3/2) is left, and t from there to here is the
    // integral of -sqrt(r) r/(r - 1) dr.
    let left = |r: f64| 2.0 / 3.0 * r.powf(1.5);
    let far = |r: f64| {
        let root = r.sqrt();
        -(left(r) + 2.0 * root + ((root - 1.0) / (root + 1.0)).ln())
    };
    let [one, two, three] = [1, 2, 3].map(|stop| (rate(stop), sky_g(stop)));
    // The shadow of a hole fills half of the directions at the photon sphere.
    let half = ApparentHole::new(&lesson.scene(2)).unwrap().radius;
    assert!((half.to_degrees() - 90.0).abs() < 1e-4, "{half}");
    lesson.states(1, &[one.0, one.1]);
    lesson.states(2, &[1.5, two.0, 1.0 / two.0, two.1]);
    lesson.states(3, &[1.1, three.1, three.0]);
    let falls = |stop: usize| lesson.scene(stop).camera.r;
    let [six, seven] = [6, 7].map(|stop| (falls(stop), sky_g(stop)));
    let behind = lesson.ray_toward(4, [1.0, 0.0, 0.0]);
    let four = (falls(4), behind.numbers.sky_g.unwrap());
    lesson.states(4, &[(1.0 / four.0).sqrt(), left(four.0), four.1]);
    let since = |r: f64| [left(8.0) - left(r), far(r) - far(8.0)];
    let [[own, home], [own_later, home_later]] = [since(1.01), since(1.001)];
    lesson.states(5, &[1.01, own, home, 1.001, own_later, home_later]);
    lesson.states(6, &[six.1, left(six.0)]);
    assert!((six.0 - 1.0).abs() < 1e-12);
    // One who falls from rest sees light of the sky from the angle psi to the hole with the shift
    // g = 1/(1 - v cos psi), v = sqrt(1/r), also inside, where v is above 1.
    let shift = |psi: f64| 1.0 / (1.0 - (1.0 / seven.0).sqrt() * psi.cos());
    let edge = ApparentHole::new(&lesson.scene(7)).unwrap().radius;
    let beside: f64 = edge + 0.05;
    let ray = lesson.ray_toward(7, [-beside.cos(), beside.sin(), 0.0]);
    assert!((ray.numbers.sky_g.unwrap() / shift(beside) - 1.0).abs() < 1e-6);
    lesson.states(7, &[seven.0, seven.1, shift(edge), left(seven.0)]);
    let question = lesson.stop(6).question.clone().unwrap();
    let second = MASSES[0].seconds();
    assert!(question.text.contains(&format!("{second:.2} s")) && MASSES[0].suns == 4.3e6);
    assert!((left(1.0) * second - question.answer).abs() < 0.01);
    lesson.ends();
}

#[test]
fn the_answers_to_questions_on_the_way_are_computed_and_a_wrong_one_gets_a_hint() {
    let question = |name: &str, stop: usize| Lesson::of(name).stop(stop).question.clone().unwrap();
    let half_rate = 1.0 / (1.0 - 0.5_f64.powi(2));
    for (name, stop, answer) in [
        ("shadow", 5, CRITICAL_IMPACT.powi(2)),
        ("bright-side", 2, 0.5_f64.powi(4)),
        ("two-clocks", 2, half_rate),
    ] {
        let question = question(name, stop);
        assert!((question.answer - answer).abs() < 1e-4, "{name}: {answer}");
        assert!(question.judge(&format!("{answer}")).unwrap().is_right);
    }
    for (name, _) in LESSONS {
        let stops = Lesson::of(name).journey.stops;
        for question in stops.into_iter().filter_map(|stop| stop.question) {
            let wrong = question
                .judge(&format!("{}", 3.0 * question.answer))
                .unwrap();
            assert!(
                !wrong.is_right && wrong.said.ends_with(&question.hint),
                "{wrong:?}"
            );
            assert!(!question.hint.is_empty(), "{name}");
        }
    }
}
