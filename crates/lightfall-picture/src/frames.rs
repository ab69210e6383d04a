//! Which frames of a sequence are drawn: runs, lists and shards of numbers.

use std::collections::HashSet;
use std::str::FromStr;

/// Maximum number of frames of one run: an hour and a half at 24 frames per second.
const MAX_FRAMES: u32 = 130_000;

/// Maximum number of a frame: nine digits.
const MAX_NUMBER: u32 = 999_999_999;

/// The error of a text that is no list of frames.
const ALLOWED: &str = "frames are A..B, such as 0..149: whole numbers, A not above B, both included; a list such as \
                       0..9,20,30..300:10 has several of them, and :10 takes every tenth";

/// A run of frames, by number, with both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frames {
    /// Number of the first frame.
    pub first: u32,
    /// Number of the last frame.
    pub last: u32,
}

impl FromStr for Frames {
    type Err = String;

    /// Reads `A..B`, `A-B` or `A`.
    fn from_str(text: &str) -> Result<Self, String> {
        let frames = Self::of_any_length(text)?;
        check_count(u64::from(frames.last - frames.first) + 1)?;
        Ok(frames)
    }
}

impl Frames {
    /// So many frames, the first of which has the number 0.
    ///
    /// # Errors
    /// They are more than one run draws.
    pub fn counted(count: u32) -> Result<Self, String> {
        check_count(count.into())?;
        Ok(Self {
            first: 0,
            last: count.saturating_sub(1),
        })
    }

    fn of_any_length(text: &str) -> Result<Self, String> {
        let ends = text.split_once("..").or_else(|| text.split_once('-'));
        let (first, last) = ends.unwrap_or((text, text));
        match (number(first), number(last)) {
            (Some(_), Some(last)) if last > MAX_NUMBER => {
                Err(format!("the number of a frame is at most {MAX_NUMBER}"))
            }
            (Some(first), Some(last)) if first <= last => Ok(Self { first, last }),
            _ => Err(ALLOWED.into()),
        }
    }
}

/// A number in decimal digits alone; `u32::MAX` in place of a larger one.
fn number(text: &str) -> Option<u32> {
    let is_number = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then(|| text.parse().unwrap_or(u32::MAX))
}

fn check_count(count: u64) -> Result<(), String> {
    if count > u64::from(MAX_FRAMES) {
        return Err(format!(
            "these are {count} frames, and one run draws at most {MAX_FRAMES}"
        ));
    }
    Ok(())
}

/// A list of frames in the order in which they are drawn, each of them once.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrameList(Vec<u32>);

impl FromStr for FrameList {
    type Err = String;

    /// Reads runs with commas between them. A run may have a step: `A..B:S`, or `A-BxS`, as schedulers write
    /// it. A frame that is named again is drawn in its first place only.
    fn from_str(text: &str) -> Result<Self, String> {
        let (mut numbers, mut known) = (Vec::new(), HashSet::new());
        for item in text.split(',') {
            let (run, step) = match item.split_once([':', 'x']) {
                Some((run, step)) => (run, Some(step)),
                None => (item, None),
            };
            let Frames { first, last } = Frames::of_any_length(run)?;
            let step = step.map_or(Ok(1), read_step)?;
            check_count(u64::from((last - first) / step) + 1)?;
            let run = (first..=last).step_by(step as usize);
            numbers.extend(run.filter(|number| known.insert(*number)));
            check_count(numbers.len() as u64)?;
        }
        Ok(Self(numbers))
    }
}

fn read_step(text: &str) -> Result<u32, String> {
    let step = number(text).filter(|step| (1..=MAX_NUMBER).contains(step));
    step.ok_or_else(|| {
        format!("the step of frames is a whole number from 1 to {MAX_NUMBER}, as in 0..300:10")
    })
}

impl FrameList {
    /// The numbers, in the order in which they are drawn.
    #[must_use]
    pub fn numbers(&self) -> &[u32] {
        &self.0
    }

    /// The lowest and the highest number.
    #[must_use]
    pub fn ends(&self) -> Frames {
        let ends = (self.0.iter().min(), self.0.iter().max());
        // A list has a frame at least.
        let (first, last) = (ends.0.copied(), ends.1.copied());
        Frames {
            first: first.unwrap_or_default(),
            last: last.unwrap_or_default(),
        }
    }

    /// The frames as a run, if they are one: rising numbers without a gap.
    #[must_use]
    pub fn run(&self) -> Option<Frames> {
        let ends = self.ends();
        (ends.first..=ends.last)
            .eq(self.0.iter().copied())
            .then_some(ends)
    }
}

/// One of several parts of a list of frames, which several machines draw at the same time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Its number, from 1.
    pub number: u32,
    /// How many there are.
    pub count: u32,
}

impl FromStr for Shard {
    type Err = String;

    /// Reads `K/N`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (first, second) = text.split_once('/').unwrap_or_default();
        match (number(first), number(second)) {
            (Some(number), Some(count)) if (1..=count).contains(&number) && count <= MAX_FRAMES => {
                Ok(Self { number, count })
            }
            _ => Err(format!(
                "a shard is K/N, such as 1/4, the first of four: whole numbers, K from 1 to N, and N at most {MAX_FRAMES}"
            )),
        }
    }
}

impl Shard {
    /// The frames of this shard: those whose place in the list, from 0, is K - 1 modulo N. Neighbours go to
    /// different machines, so shards take about the same time. All shards together have every frame once.
    #[must_use]
    pub fn of(self, frames: &FrameList) -> Vec<u32> {
        let own = frames.numbers().iter().copied();
        own.skip(self.number as usize - 1)
            .step_by(self.count as usize)
            .collect()
    }
}
