//! The constants in front of a variant: its flags, and the numbers that its parts must share with
//! the CPU.

use super::text::add_constant;
use super::view::view_shader;
use super::{Entry, Variant};
use crate::gpu::bindings;
use crate::gpu::error_map::ErrorMap;
use crate::optics::disk;
use crate::optics::spectrum::{TABLE_LEN, TABLE_MAX_TEMPERATURE, TABLE_MIN_TEMPERATURE};
use crate::scene::{SkyMode, View};

impl Variant {
    /// The flags, by their names in the shaders.
    pub fn flags(self) -> [(&'static str, bool); 13] {
        let records = self.entry == Entry::Rays;
        [
            ("SPINNING", self.spinning),
            ("NEAR_HORIZON", self.near_horizon),
            ("AZIMUTH", records),
            // A timed shader does all the work that a picture with a sky does.
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
            ("DIAGNOSTICS", records || view_shader(self.view).diagnostics),
        ]
    }

    /// The flags, and the numbers that the parts must share with the CPU.
    pub(super) fn prelude(self) -> String {
        let mut text = String::new();
        for (name, value) in self.flags() {
            add_constant(&mut text, name, "bool", value);
        }
        for (name, value) in bindings::CONSTANTS {
            add_constant(&mut text, name, "u32", format!("{value}u"));
        }
        if !self.view.properties().traces {
            for (name, kind, value) in ErrorMap::constants() {
                add_constant(&mut text, name, kind, value);
            }
        }
        let lengths = [
            ("MAX_HITS", self.max_hits),
            ("PAGE_THORNE_LEN", disk::TABLE_LEN as u32),
            ("SPECTRUM_LEN", TABLE_LEN as u32),
        ];
        for (name, value) in lengths {
            add_constant(&mut text, name, "u32", format!("{value}u"));
        }
        let temperatures = [
            ("SPECTRUM_MIN_TEMPERATURE", TABLE_MIN_TEMPERATURE),
            ("SPECTRUM_MAX_TEMPERATURE", TABLE_MAX_TEMPERATURE),
            (
                "SPECTRUM_LN_RANGE",
                (TABLE_MAX_TEMPERATURE / TABLE_MIN_TEMPERATURE).ln(),
            ),
        ];
        for (name, value) in temperatures {
            add_constant(&mut text, name, "f32", format!("{value:?}"));
        }
        text
    }
}
