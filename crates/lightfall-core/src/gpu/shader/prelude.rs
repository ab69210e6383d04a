//! The constants at the top of a variant: its flags, and what its parts must share with the CPU.

use super::{Entry, Variant, traces};
use crate::gpu::ErrorMap;
use crate::optics::disk;
use crate::optics::spectrum::{TABLE_LEN, TABLE_MAX_TEMPERATURE, TABLE_MIN_TEMPERATURE};
use crate::scene::{SkyMode, View};
use std::fmt::Write;

impl Variant {
    /// The flags, by their names in the shaders. Compilers drop what stands behind one that is not
    /// set.
    pub fn flags(self) -> [(&'static str, bool); 13] {
        let records = self.entry == Entry::Rays;
        [
            ("SPINNING", self.spinning),
            ("NEAR_HORIZON", self.near_horizon),
            ("AZIMUTH", records),
            // What is timed does all the work that a picture with a sky does.
            (
                "SKY_DIRECTION",
                self.entry != Entry::Picture || self.sky != SkyMode::Off,
            ),
            ("REFERENCE_STAR", self.reference_star),
            ("SHOW_UNFINISHED", self.view == View::Unfinished),
            ("FOLLOW_BEYOND_HITS", self.follow_beyond_hits),
            ("LENSING", self.effects.lensing),
            ("DOPPLER", self.effects.doppler),
            ("BEAMING", self.effects.beaming),
            ("GRAVITATIONAL_SHIFT", self.effects.gravitational_shift),
            ("ABERRATION", self.effects.aberration),
            (
                "DIAGNOSTICS",
                records || matches!(self.view, View::Residual | View::Order),
            ),
        ]
    }

    /// The flags, and what the parts must share with the CPU.
    pub(super) fn prelude(self) -> String {
        let mut text = String::new();
        for (name, value) in self.flags() {
            constant(&mut text, name, "bool", value);
        }
        if !traces(self.view) {
            for (name, kind, value) in ErrorMap::constants() {
                constant(&mut text, name, kind, value);
            }
        }
        constant(&mut text, "MAX_HITS", "u32", format!("{}u", self.most_hits));
        constant(
            &mut text,
            "PAGE_THORNE_LEN",
            "u32",
            format!("{}u", disk::TABLE_LEN),
        );
        constant(&mut text, "SPECTRUM_LEN", "u32", format!("{TABLE_LEN}u"));
        constant(
            &mut text,
            "SPECTRUM_MIN_TEMPERATURE",
            "f32",
            format!("{TABLE_MIN_TEMPERATURE:?}"),
        );
        constant(
            &mut text,
            "SPECTRUM_MAX_TEMPERATURE",
            "f32",
            format!("{TABLE_MAX_TEMPERATURE:?}"),
        );
        constant(
            &mut text,
            "SPECTRUM_LN_RANGE",
            "f32",
            format!("{:?}", (TABLE_MAX_TEMPERATURE / TABLE_MIN_TEMPERATURE).ln()),
        );
        text
    }
}

fn constant(text: &mut String, name: &str, kind: &str, value: impl std::fmt::Display) {
    writeln!(text, "const {name}: {kind} = {value};").expect("writing to a string cannot fail");
}
