//! Sequences whose end goes on at their beginning.

use crate::commands::cli::RenderArgs;
use crate::commands::scene::NO_JOURNEY;
use crate::commands::stop::Stop;
use lightfall_core::numbers::four_digits;
use lightfall_core::optics::hot_spot::HotSpot;
use lightfall_core::scene::{DiskStructure, HotSpotKind, Scene};
use lightfall_picture::{Frames, Sequence, loop_lines};
use lightfall_platform::log::say;
use std::path::Path;

/// By how much of an orbit a hot spot may miss its place at the end: less than a pixel of a picture of 1000.
const MAX_MISS: f64 = 1e-3;

/// A sequence of this length, at whose end the scene is that of its beginning. What repeats in the scene gets
/// this period.
pub(super) fn loop_sequence(
    args: &RenderArgs,
    seconds: f64,
    scene: &mut Scene,
) -> Result<Sequence, Stop> {
    let refused = |reason: String| Stop::refused(format!("--loop {seconds}: {reason}"));
    if args
        .journey
        .as_deref()
        .is_some_and(|file| file != Path::new(NO_JOURNEY))
    {
        return Err(refused(
            "a journey does not end where it begins; --frames A..B draws it".into(),
        ));
    }
    let count = (seconds * args.fps).round();
    let frames = Frames::counted(count as u32).map_err(&refused)?;
    let whole = (seconds * args.fps - count).abs() < 1e-6 * count.max(1.0);
    if !whole || count < 2.0 {
        return Err(refused(format!(
            "a loop has a whole number of frames, at least 2, and with --fps {} these are {}",
            args.fps,
            four_digits(seconds * args.fps)
        )));
    }
    let mut sequence = Sequence::new(None, frames, args.fps, &args.out).map_err(&refused)?;
    if scene.disk_moves() {
        let period = repeat(scene, seconds).map_err(&refused)?;
        scene
            .check()
            .map_err(|refusal| refused(refusal.to_string()))?;
        say(format_args!(
            "lightfall: the loop lasts {} r_s/c of the disk's clock",
            four_digits(period)
        ));
    } else {
        sequence.turn = Some(seconds);
        say("lightfall: nothing moves in this scene, so the camera goes once around");
    }
    Ok(sequence)
}

/// Gives what moves in the scene a period of this many seconds, and returns it in r_s/c.
fn repeat(scene: &mut Scene, seconds: f64) -> Result<f64, String> {
    if scene.jets_move() {
        return Err(
            "the jets do not repeat; --set jet.knots=0 or --set jet.enabled=false stills them"
                .into(),
        );
    }
    let period = seconds * scene.disk.rate;
    if period <= 0.0 {
        return Err("the disk's clock stands still; --set disk.rate=6 starts it".into());
    }
    if let Some(spot) = HotSpot::new(scene) {
        if scene.hot_spot.kind == HotSpotKind::Sheared {
            return Err(
                "a sheared hot spot does not repeat; --set hot_spot.kind=rigid keeps its shape"
                    .into(),
            );
        }
        if scene.hot_spot.duration > 0.0 {
            return Err(
                "a hot spot that fades does not repeat; --set hot_spot.duration=0 lets it shine"
                    .into(),
            );
        }
        let orbits = period / spot.period();
        let near = orbits.round().max(1.0);
        if (orbits - near).abs() > MAX_MISS {
            return Err(format!(
                "the hot spot goes around {} times; with --set disk.rate={} it does so {near} times",
                four_digits(orbits),
                near * spot.period() / seconds
            ));
        }
    }
    if scene.disk.structure != DiskStructure::None {
        scene.disk.period = period;
    }
    Ok(period)
}

/// Says how pages and messages get the loop.
pub(super) fn note_loop(film: &Path) {
    for line in loop_lines(film) {
        say(format_args!("lightfall: the loop for a page: {line}"));
    }
}
