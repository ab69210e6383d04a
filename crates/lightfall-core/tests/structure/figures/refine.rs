//! The series that refine the article's methods, in docs/ACCURACY.md.

use super::document::{Claim, claim};
use super::measured::measured;
use super::render::{count, short};
use lightfall_core::reports::bench::{RefinementMeasurement, Study};

/// The rows of one method in one scene.
struct Series<'a>(Vec<&'a RefinementMeasurement>);

impl<'a> Series<'a> {
    fn of(rows: &'a [RefinementMeasurement], scene: &str, method: &str) -> Self {
        let own = rows.iter();
        Self(
            own.filter(|row| row.scene == scene && row.method == method)
                .collect(),
        )
    }

    /// The row of a series whose refined number has this text.
    fn at(&self, study: Study, label: &str) -> &'a RefinementMeasurement {
        let mut own = self.0.iter().filter(|row| row.study == study);
        let found = own.find(|row| row.label() == label);
        found.unwrap_or_else(|| panic!("no row {} {label}", study.word()))
    }

    /// The first row of a series whose 99th percentile is about the smallest.
    fn first_best(&self, study: Study) -> &'a RefinementMeasurement {
        let own = || self.0.iter().filter(|row| row.study == study);
        let least = own()
            .map(|row| row.backward_p99)
            .fold(f64::INFINITY, f64::min);
        let is_best = |row: &&&RefinementMeasurement| row.backward_p99 <= (1.0 + SAME) * least;
        own().find(is_best).expect("the series is measured")
    }

    fn last(&self, study: Study) -> &'a RefinementMeasurement {
        let mut own = self.0.iter().filter(|row| row.study == study);
        own.next_back().expect("the series is measured")
    }
}

/// Errors that differ by less than this share are the same.
const SAME: f64 = 0.1;

fn p99(rows: &[&RefinementMeasurement]) -> Vec<String> {
    rows.iter().map(|row| short(row.backward_p99_px)).collect()
}

fn given_up(rows: &[&RefinementMeasurement]) -> Vec<String> {
    rows.iter().map(|row| count(row.unfinished)).collect()
}

fn sky(row: &RefinementMeasurement) -> String {
    short(row.sky_p50)
}

fn steps(row: &RefinementMeasurement) -> String {
    count(row.steps_mean.round() as usize)
}

pub fn claims() -> Vec<Claim> {
    let rows = measured::<RefinementMeasurement>("llvmpipe/refine").rows;
    let verlet = Series::of(&rows, "edge-on", "verlet");
    let kerr_schild = Series::of(&rows, "edge-on", "kerr-schild");
    let spinning = Series::of(&rows, "edge-on-spinning", "kerr-schild");
    let at = |study: Study, label: &str| [verlet.at(study, label), kerr_schild.at(study, label)];
    let [usual, quarter, eighth] =
        ["0.85", "0.213", "0.106"].map(|label| at(Study::StepScale, label));
    let hits = |i: usize| [usual[i], quarter[i]].map(|row| short(row.hit_r_p50));
    let errors = |i: usize| p99(&[usual[i], quarter[i]]);
    let budget = ["768", "1536", "3072"].map(|label| verlet.at(Study::Budget, label));
    let largest = |series: &Series| series.at(Study::Budget, "12288").unfinished;
    let [near, far] = ["33", "132"].map(|label| at(Study::EscapeRadius, label));
    let [near_spinning, far_spinning] =
        ["33", "132"].map(|label| spinning.at(Study::EscapeRadius, label));
    let farther = kerr_schild.at(Study::EscapeRadius, "264");
    let [largest_step, smallest_step] =
        ["0.018", "0.00112"].map(|label| verlet.at(Study::LeastStep, label));
    let [finest, finest_kerr_schild, finest_spinning] =
        [&verlet, &kerr_schild, &spinning].map(|series| series.last(Study::LeastStep));
    let farthest = kerr_schild.last(Study::EscapeRadius);
    let best = [
        verlet.first_best(Study::LeastStep),
        kerr_schild.first_best(Study::EscapeRadius),
    ];
    vec![
        claim(
            "These are {} rays on Mesa's software driver",
            [count(rows[0].rays)],
        ),
        claim(
            "In `edge-on` the radii of hits improve from {} to {} in the median when `verlet` goes from 0.85 to 0.213, \
             and from {} to {} with `kerr-schild`",
            [hits(0), hits(1)].concat(),
        ),
        claim(
            "The median of the backward error of `verlet` falls from {} to {} of a pixel. The 99th percentile gets no \
             better: {} and {} of a pixel for `verlet`, {} and {} for `kerr-schild`",
            [
                [usual[0], quarter[0]]
                    .map(|row| short(row.backward_p50_px))
                    .to_vec(),
                errors(0),
                errors(1),
            ]
            .concat(),
        ),
        claim(
            "At half of that step, {} and {} of 512 rays are given up",
            given_up(&eighth),
        ),
        claim(
            "At 0.0266 `verlet` gives up {} rays with 768 steps, {} with 1536 and {} with 3072",
            given_up(&budget),
        ),
        claim(
            "The 99th percentile is then {} of a pixel after {} steps a ray, no better than the {} after {} steps at 0.85",
            [
                short(budget[2].backward_p99_px),
                steps(budget[2]),
                short(usual[0].backward_p99_px),
                steps(usual[0]),
            ],
        ),
        claim(
            "`kerr-schild` gives up {} rays with 12 288 steps; with spin it still gives up {}",
            [largest(&kerr_schild), largest(&spinning)].map(count),
        ),
        claim(
            "From 33 r_s to 132 the 99th percentile of `verlet` falls from {} to {} of a pixel, and the median error of its \
             sky from {} to {} rad",
            [p99(&[near[0], far[0]]), vec![sky(near[0]), sky(far[0])]].concat(),
        ),
        claim(
            "That of `kerr-schild` falls from {} to {} of a pixel (with spin from {} to {}), its sky from {} to {} rad",
            [
                p99(&[near[1], far[1], near_spinning, far_spinning]),
                vec![sky(near[1]), sky(far[1])],
            ]
            .concat(),
        ),
        claim(
            "It costs {} and {} steps a ray",
            [0, 1].map(|i| count((far[i].steps_mean - near[i].steps_mean).round() as usize)),
        ),
        claim(
            "`kerr-schild` gains a little more, {} of a pixel and {} rad at 264 r_s",
            [short(farther.backward_p99_px), sky(farther)],
        ),
        claim(
            "From there to 0.00112 the 99th percentile falls from {} to {} of a pixel, and {} instead of {} rays end in the \
             wrong class",
            [
                p99(&[largest_step, smallest_step]),
                vec![
                    count(smallest_step.misclassified),
                    count(largest_step.misclassified),
                ],
            ]
            .concat(),
        ),
        claim(
            "The sky of `verlet` is off by {} rad in the median, after {} steps a ray",
            [sky(finest), steps(finest)],
        ),
        claim(
            "its sky is off by {} rad after {} steps and by {} after {}",
            [
                sky(farthest),
                steps(farthest),
                sky(finest_kerr_schild),
                steps(finest_kerr_schild),
            ],
        ),
        claim(
            "With spin the shortest steps give up {} of 512 rays",
            given_up(&[finest_spinning]),
        ),
        claim(
            "for 99 of 100 rays, is {} of a pixel or {} rad with `verlet` after {} steps a ray, and {} or {} with `kerr-schild` \
             after {}",
            best.iter()
                .flat_map(|row| {
                    [
                        short(row.backward_p99_px),
                        short(row.backward_p99),
                        steps(row),
                    ]
                })
                .collect::<Vec<_>>(),
        ),
    ]
}
