//! The keys of the comparison: pin the present settings, show a difference, end the comparison.

use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use lightfall_core::scene::View;
use lightfall_render::{Comparison, ComparisonMode, CurrentScene, Pinned};

/// What a difference is multiplied by: each press of its key takes the next number.
pub(crate) const GAINS: [u32; 5] = [1, 4, 16, 64, 256];
const DEFAULT_GAIN: u32 = 16;

/// The amplification after this one.
pub(crate) fn next_gain(gain: u32) -> u32 {
    let place = GAINS.iter().position(|other| *other == gain);
    place.map_or(DEFAULT_GAIN, |place| GAINS[(place + 1) % GAINS.len()])
}

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, switch_comparison);
}

fn switch_comparison(
    mut commands: MessageReader<AppCommand>,
    scene: Res<CurrentScene>,
    bindings: Res<Bindings>,
    mut comparison: ResMut<Comparison>,
    mut toast: ResMut<Toast>,
) {
    use ComparisonMode::{Difference, SideBySide, TwoPictures};
    for command in commands.read() {
        let mode = comparison.0.as_ref().map(|(_, mode)| *mode);
        let next = match (command, mode) {
            (AppCommand::Compare, Some(TwoPictures)) => {
                comparison.0 = None;
                toast.say("Side by side: off");
                continue;
            }
            (AppCommand::Compare, Some(SideBySide { .. })) => TwoPictures,
            (AppCommand::Compare, _) => SideBySide {
                divider: ComparisonMode::MIDDLE,
            },
            (AppCommand::Difference, Some(Difference { gain })) => Difference {
                gain: next_gain(gain),
            },
            (AppCommand::Difference, _) => Difference { gain: DEFAULT_GAIN },
            _ => continue,
        };
        let compared = &mut comparison.0;
        match compared {
            Some((_, mode)) => *mode = next,
            None if scene.view == View::Error => {
                toast.say("The view error has numbers for one picture only: leave it to compare");
                continue;
            }
            None => *compared = Some((Pinned::new(&scene), next)),
        }
        let key = bindings.label("picture.compare");
        toast.say(match next {
            SideBySide { .. } => {
                format!(
                    "Side by side: on. What you change now shows on the right. {key} again shows two whole pictures"
                )
            }
            TwoPictures => {
                let without = if scene.probe.enabled {
                    ", without the probe"
                } else {
                    ""
                };
                format!("Side by side: two whole pictures{without}. {key} ends it")
            }
            Difference { gain } => {
                format!("Difference, amplified {gain} times. {key} returns to the two sides")
            }
        });
    }
}
