//! Random numbers for tests of properties.

#![allow(
    dead_code,
    reason = "several test programs share it, and none uses all of it"
)]

/// A sequence of random numbers.
pub struct Random(lightfall_core::random::Random);

impl Random {
    /// The sequence of the seed in the environment variable `LIGHTFALL_SEED`, or of seed 1. Prints
    /// the seed.
    pub fn new() -> Self {
        let seed = std::env::var("LIGHTFALL_SEED").unwrap_or_else(|_| "1".into());
        println!("LIGHTFALL_SEED={seed}");
        let thread = std::thread::current();
        let test = thread.name().unwrap_or("main");
        assert!(
            test == "main" || test.contains("random"),
            "scripts/soak finds {test} only if its name contains the word random"
        );
        let seed = seed.parse().expect("LIGHTFALL_SEED is a whole number");
        Self(lightfall_core::random::Random::new(seed))
    }

    /// A number from `low` to `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.between(low, high)
    }

    /// A number whose logarithm is spread evenly from `low` to `high`.
    pub fn log_between(&mut self, low: f64, high: f64) -> f64 {
        self.0.log_between(low, high)
    }

    /// A whole number from `low` to `high`.
    pub fn integer(&mut self, low: u32, high: u32) -> u32 {
        low + (self.0.bits() % u64::from(high - low + 1)) as u32
    }

    /// True in one of `count` cases.
    pub fn one_in(&mut self, count: u32) -> bool {
        self.integer(1, count) == 1
    }

    /// One of these.
    pub fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.integer(0, choices.len() as u32 - 1) as usize]
    }

    /// A direction, spread evenly over the sphere.
    pub fn direction(&mut self) -> glam::DVec3 {
        let (z, angle) = (
            self.between(-1.0, 1.0),
            self.between(0.0, std::f64::consts::TAU),
        );
        let (sin, cos) = angle.sin_cos();
        let across = (1.0 - z * z).sqrt();
        glam::DVec3::new(across * cos, across * sin, z)
    }
}
