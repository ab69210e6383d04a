//! The rows of an inspected ray about matter with depth.

use super::{Rows, shift_in_words, size};
use lightfall_core::accuracy::inspection::{InspectedMatter, InspectedStretch};
use lightfall_core::accuracy::rays::Record;
use lightfall_core::numbers::four_digits;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::trace::Outcome;

/// Stretches with rows of their own. A ray around the hole may have more, which are dimmer.
const MAX_STRETCHES: usize = 4;
/// The optical depth beyond which nothing is seen.
const OPAQUE: f64 = 5.0;

/// What the ray shows, and the stretches of its way on which there is matter.
pub(super) fn add_stretches(rows: &mut Rows, matter: &InspectedMatter, cpu: &Record, units: Units) {
    rows.add("shows", Some(shows(matter, cpu).into()));
    if !matter.stretches.is_empty() {
        rows.add("optical depth", Some(depth(matter.depth)));
    }
    for stretch in matter.stretches.iter().take(MAX_STRETCHES) {
        add_stretch(rows, stretch, units);
    }
    let more = matter.stretches.len().saturating_sub(MAX_STRETCHES);
    rows.add("and", (more > 0).then(|| format!("{more} more")));
}

fn add_stretch(rows: &mut Rows, stretch: &InspectedStretch, units: Units) {
    let length = |length| units.length(length, four_digits);
    let from_to = |near: f64, far: f64| format!("{} to {}", length(near), length(far));
    let place = match units {
        Units::Hole => format!("r {}", from_to(stretch.near_r, stretch.far_r)),
        Units::Everyday(_) => format!("{} from the hole", from_to(stretch.near_r, stretch.far_r)),
    };
    rows.add(&format!("through {}", stretch.matter), Some(place));
    rows.add(
        "   above its plane",
        Some(from_to(stretch.near_height, stretch.far_height)),
    );
    let share = format!(
        "{:.0} % of it, depth {}",
        100.0 * stretch.share,
        depth(stretch.depth)
    );
    rows.add("   light", Some(share));
    if let Some(g) = stretch.g {
        rows.add(
            &format!("   {}", shift_in_words(g)),
            Some(format!("g {}, a mean", four_digits(g))),
        );
    }
    let earlier = |delay| format!("{} earlier, a mean", units.time(delay, four_digits));
    rows.add("   emitted", stretch.delay.map(earlier));
}

/// How well the light of the matter is known.
pub(super) fn add_errors(rows: &mut Rows, matter: &InspectedMatter) {
    let light = |light: [f64; 3]| light.map(four_digits).join(" ");
    rows.add("light of matter, f64", Some(light(matter.light)));
    let Some(gpu) = &matter.gpu else {
        return;
    };
    rows.add(
        "light of matter, GPU",
        Some(light(gpu.light.map(f64::from))),
    );
    rows.add("GPU error, light", gpu.error.map(size));
    let samples = format!(
        "{}; twice as many change {}",
        gpu.samples,
        size(gpu.change.into())
    );
    rows.add("samples of matter", Some(samples));
}

/// What the ray shows, in words.
fn shows(matter: &InspectedMatter, cpu: &Record) -> &'static str {
    match (
        matter.stretches.is_empty(),
        matter.depth > OPAQUE,
        cpu.outcome,
    ) {
        (true, _, Outcome::Captured) => "captured by the hole",
        (true, _, other) => other.word(),
        (false, true, _) => "matter, and nothing behind",
        (false, false, Outcome::Captured) => "matter, then the hole",
        (false, false, _) => "matter, then sky",
    }
}

/// An optical depth. A ray is given up where nothing is seen behind.
fn depth(depth: f64) -> String {
    if depth > OPAQUE {
        "more than 5".into()
    } else {
        four_digits(depth)
    }
}
