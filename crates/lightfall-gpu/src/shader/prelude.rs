//! The constants in front of a variant: its flags, and the numbers that its files share with the
//! CPU.

use super::spectrum_constants::add_spectrum_constants;
use super::text::{add_constant, add_u32};
use super::{Entry, Variant};
use crate::antialias;
use crate::error_map::ErrorMap;
use crate::jet;
use crate::medium;
use crate::starlight;
use crate::stars::add_star_constants;
use crate::structure::GpuStructure;
use lightfall_model::geometry::quadrature::gauss_legendre;
use lightfall_model::scene::{HotSpotKind, MAX_STEP_BUDGET, SkyMode, View};
use lightfall_optics::disk;

impl Variant {
    /// The flags, by their names in the shaders.
    pub fn flags(self) -> Vec<(&'static str, bool)> {
        let records = self.entry == Entry::Rays;
        vec![
            ("SPINNING", self.spinning),
            ("NEAR_HORIZON", self.near_horizon),
            ("AZIMUTH", records || self.moves()),
            ("DELAY", self.delay_nodes > 0),
            ("SHEARED_SPOT", self.hot_spot == HotSpotKind::Sheared),
            // A timed shader does all the work that a picture with a sky does.
            (
                "SKY_DIRECTION",
                matches!(self.entry, Entry::Rays | Entry::Timed)
                    || self.seeks_stars()
                    || self.sky != SkyMode::Off,
            ),
            ("SHOW_UNFINISHED", self.view == View::Unfinished),
            ("FOLLOW_BEYOND_HITS", self.follow_beyond_hits),
            ("LENSING", self.effects.lensing),
            ("DOPPLER", self.effects.doppler),
            ("BEAMING", self.effects.beaming),
            ("GRAVITATIONAL_SHIFT", self.effects.gravitational_shift),
            ("ABERRATION", self.effects.aberration),
            (
                "DIAGNOSTICS",
                records || self.seeks_stars() || self.view.properties().diagnostics,
            ),
        ]
    }

    /// The flags, and the numbers that the files share with the CPU.
    pub(super) fn prelude(self) -> String {
        let mut text = String::new();
        for (name, value) in self.flags() {
            add_constant(&mut text, name, "bool", value);
        }
        if self.entry == Entry::Refine {
            antialias::add_sizes(&mut text);
        }
        if self.sky.is_map() {
            starlight::add_constants(&mut text);
        }
        if !self.view.properties().traces {
            ErrorMap::add_constants(&mut text);
        }
        add_u32(&mut text, "MAX_HITS", self.max_hits);
        add_u32(&mut text, "PAGE_THORNE_LEN", disk::TABLE_LEN as u32);
        add_u32(&mut text, "MAX_STEP_BUDGET", MAX_STEP_BUDGET);
        add_spectrum_constants(&mut text);
        if matches!(self.entry, Entry::Star(_)) {
            add_star_constants(&mut text);
        }
        if self.structure {
            add_constant(&mut text, "REPEATS", "bool", self.repeats);
            GpuStructure::add_constants(&mut text);
        }
        if self.medium_nodes > 0 {
            medium::add_constants(&mut text, self.medium_nodes);
        }
        if self.jet_nodes > 0 {
            jet::add_constants(&mut text, self.jet_nodes, self.knots);
        }
        if self.has_medium() {
            medium::add_min_transmission(&mut text, self.medium_nodes);
            let filters = self.entry != Entry::Passages { filters: false };
            add_constant(&mut text, "MEDIUM_FILTERS", "bool", filters);
        }
        if self.delay_nodes > 0 && !self.tracer.has_own_nodes() {
            text.push_str(&delay_nodes(self.delay_nodes));
        }
        text
    }

    /// Whether anything in the disk or the jets moves with its matter.
    fn moves(self) -> bool {
        self.structure || self.knots || self.hot_spot != HotSpotKind::None
    }
}

/// The nodes and weights of Gauss-Legendre quadrature on [0, 1]: `DELAY_NODES` and `DELAY_WEIGHTS`,
/// vectors of the type `Nodes`, and for more than four nodes a second pair.
fn delay_nodes(count: u32) -> String {
    let size = count.min(4) as usize;
    let rule = gauss_legendre(count as usize);
    let mut text = format!("alias Nodes = vec{size}<f32>;\n");
    let vector = |values: &[f64]| {
        let values: Vec<String> = values.iter().map(|x| format!("{:?}", *x as f32)).collect();
        format!("vec{size}<f32>({})", values.join(", "))
    };
    let (nodes, weights): (Vec<f64>, Vec<f64>) = rule.into_iter().unzip();
    let last = nodes.len() - size;
    for (suffix, from) in [("", 0), ("_2", last)] {
        for (name, values) in [("DELAY_NODES", &nodes), ("DELAY_WEIGHTS", &weights)] {
            let vector = vector(&values[from..from + size]);
            add_constant(&mut text, &format!("{name}{suffix}"), "Nodes", vector);
        }
    }
    add_constant(&mut text, "DELAY_MORE_NODES", "bool", last > 0);
    text
}
