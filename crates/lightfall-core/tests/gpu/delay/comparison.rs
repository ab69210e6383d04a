//! How delays are compared with the reference's, and what a method may be wrong by.

use crate::{gpu, quantile};
use glam::DVec3;
use lightfall_core::accuracy::TimedRay;
use lightfall_core::gpu::rays;
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::Scene;
use lightfall_core::scene::promises::{CLOSED_DELAY, MINO_DELAY};

/// What a method may be wrong by.
#[derive(Clone, Copy, Debug)]
pub struct Bar {
    /// The delay at the place that the method has found, in r_s/c.
    pub delay: f64,
    /// The share of hits whose delay may be off by up to ten times as much.
    beyond: f64,
    /// The share of hits at places that are too far apart to compare, of all scenes of a test
    /// together: above the largest share of 60 runs or more by half of it or more. A single scene may
    /// exceed it, because the number of its rays next to the critical curve depends on its camera.
    elsewhere: f64,
}

/// A thousandth of a radian of the innermost orbits. At most 4e-4 r_s/c are measured, the error of
/// four Gaussian nodes next to the critical curve. Up to 0.063 of the hits are elsewhere.
pub const CLOSED: Bar = Bar {
    delay: CLOSED_DELAY,
    beyond: 0.0,
    elsewhere: 0.1,
};

/// From a camera inside the horizon of a hole that spins, u at a first hit may lose three digits: in
/// 14 of 2800 scenes a delay was off by more than 4e-5 r_s/c, the worst by 5e-4, and delays of rays
/// next to it by up to 8e-4.
pub const CLOSED_INSIDE_SPINNING: Bar = Bar {
    beyond: 1e-3,
    ..CLOSED
};

/// Up to 1.6e-3 r_s/c are measured. Up to 0.042 of the hits are elsewhere.
pub const MINO: Bar = Bar {
    delay: MINO_DELAY,
    beyond: 0.0,
    elsewhere: 0.12,
};

/// The truncation error of the trapezoidal rule over the article's steps: up to 9e-3 r_s/c are
/// measured for verlet and 5e-3 for kerr-schild. Their rays stray, too, most of all next to the
/// photon sphere: up to 0.06 of the hits are elsewhere.
pub const ARTICLE: Bar = Bar {
    delay: 1.5e-2,
    beyond: 0.0,
    elsewhere: 0.2,
};

/// The least number of hits that count as a test.
pub const ENOUGH: usize = 20;

/// The differences between the GPU's delays and the reference's, in r_s/c.
///
/// Next to the critical curve a tiny turn of the ray moves the hit and the delay with it. So the
/// second number is what remains at the place that the GPU has found.
#[derive(Default)]
pub struct Differences {
    plain: Vec<f64>,
    pub there: Vec<f64>,
    elsewhere: usize,
    worst: Option<(f64, String)>,
}

impl Differences {
    /// Traces the rays by the method and by the reference.
    pub fn add(&mut self, scene: &Scene, directions: &[DVec3]) {
        let reference = Reference::new(scene).unwrap();
        let kerr = reference.hole_and_disk().kerr;
        // Inside the horizon the GPU's number is the lag as it stands.
        let lead = match (scene.camera.r > kerr.horizon(), scene.effects.lensing) {
            (false, _) => 0.0,
            (true, true) => kerr.ingoing_time_lead(scene.camera.r),
            (true, false) => scene.camera.r,
        };
        let records = rays::records(gpu(), scene, directions).unwrap();
        for (direction, record) in directions.iter().zip(records) {
            let ray = TimedRay::of(&reference, *direction);
            let errors = ray.errors(&record.trace(Some(lead)));
            for (i, error) in errors.into_iter().flatten().enumerate() {
                self.plain.push(error.plain.abs());
                if !error.same_place() {
                    self.elsewhere += 1;
                    continue;
                }
                let off = error.at_place.abs();
                self.there.push(off);
                if self
                    .worst
                    .as_ref()
                    .is_none_or(|(worst, _)| off.total_cmp(worst).is_gt())
                {
                    let (camera, [_, dphi]) = (&scene.camera, error.moved());
                    let place = format!(
                        "camera {} r_s, {} deg, {:?} {:?}, {direction}: hit {} at r {} and {}, \
                         phi off by {dphi:e}, delay {:?} and {:?}",
                        camera.r,
                        camera.theta_deg,
                        scene.observer.kind,
                        scene.observer.velocity,
                        i + 1,
                        error.found.r,
                        error.truth.r,
                        error.found.delay,
                        error.truth.delay
                    );
                    self.worst = Some((off, place));
                }
            }
        }
    }
}

/// What the scenes of a test show of a method.
pub struct Comparison {
    bar: Bar,
    hits: usize,
    beyond: usize,
    elsewhere: usize,
    faults: Vec<String>,
}

impl Comparison {
    pub fn new(bar: Bar) -> Self {
        Self {
            bar,
            hits: 0,
            beyond: 0,
            elsewhere: 0,
            faults: vec![],
        }
    }

    /// Prints the differences of some scenes, and notes a fault if a delay is wrong or too few
    /// places can be compared.
    pub fn add(&mut self, what: &str, off: &Differences) {
        self.hits += off.plain.len();
        self.elsewhere += off.elsewhere;
        let is_beyond = |off: &&f64| off.total_cmp(&self.bar.delay).is_gt();
        self.beyond += off.there.iter().filter(is_beyond).count();
        let count = off.there.len();
        if count < ENOUGH {
            self.faults.push(format!("{what}: {count} hits"));
            return;
        }
        let of = |all: &[f64]| [0.5, 0.99, 1.0].map(|share| quantile(all, share));
        let ([middle, much, most], plain) = (of(&off.there), of(&off.plain));
        println!(
            "{what}: {count} hits, {middle:.1e} {much:.1e} {most:.1e}, plain {:.1e} {:.1e} {:.1e}, \
             {} elsewhere",
            plain[0], plain[1], plain[2], off.elsewhere
        );
        let allowance = if self.bar.beyond > 0.0 { 10.0 } else { 1.0 };
        let right = most <= allowance * self.bar.delay;
        if !right {
            let (_, worst) = off.worst.as_ref().unwrap();
            self.faults.push(format!(
                "{what}: {middle:.1e} {much:.1e} {most:.1e}; {worst}"
            ));
        }
    }

    #[track_caller]
    pub fn assert_within_the_bar(mut self) {
        let Self { bar, hits, .. } = self;
        for (what, count, allowed) in [
            ("beyond the bar", self.beyond, bar.beyond),
            ("elsewhere", self.elsewhere, bar.elsewhere),
        ] {
            let result = format!("{count} of {hits} hits {what}");
            println!("{result}");
            if count as f64 > allowed * hits as f64 {
                self.faults.push(result);
            }
        }
        assert!(self.faults.is_empty(), "\n{}", self.faults.join("\n"));
    }
}
