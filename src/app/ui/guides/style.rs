//! The look, the name and the meaning of each guide.

use crate::app::ui::number::trimmed;
use bevy_egui::egui::{Color32, Pos2, Shape, Stroke, Vec2};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::schwarzschild::CRITICAL_IMPACT;
use lightfall_core::optics::guides::{Guide, Landmark, photon_shells};
use lightfall_core::optics::readout::units::Units;

/// The look of a guide's line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Style {
    pub(super) colour: Color32,
    /// Width of the line, in points.
    pub(super) width: f32,
    /// Lengths of dashes and gaps, in points. None for a solid line.
    dashes: Option<[f32; 2]>,
    /// The direction from the middle of the hole to the point of the line that its label is joined to.
    /// These directions put the labels in the order of their lines.
    pub(super) toward: Vec2,
}

const YELLOW: Color32 = Color32::from_rgb(255, 216, 92);
const GREEN: Color32 = Color32::from_rgb(98, 226, 158);
const PURPLE: Color32 = Color32::from_rgb(208, 160, 255);
const WHITE: Color32 = Color32::from_rgb(226, 230, 240);

/// Dashes of the flat guides.
const FLAT: [f32; 2] = [6.0, 5.0];

impl Style {
    /// The style of a guide. Flat guides are thin and dashed.
    pub(super) fn of(guide: &Guide) -> Self {
        let (colour, width, dashes, degrees) = match guide.landmark {
            Landmark::ShadowEdge => (YELLOW, 2.2, None, -28_f32),
            Landmark::StableOrbit => (GREEN, 2.0, None, -55.0),
            Landmark::StableOrbitAgain => (GREEN, 1.6, Some([2.5, 4.0]), 50.0),
            Landmark::Ergosphere => (PURPLE, 2.0, Some([12.0, 4.0]), 180.0),
            Landmark::Horizon => (WHITE, 1.4, None, 0.0),
            Landmark::PhotonSphere => (YELLOW, 1.4, None, 25.0),
        };
        Self {
            colour,
            width: if guide.flat { 1.4 } else { width },
            dashes: if guide.flat { Some(FLAT) } else { dashes },
            toward: Vec2::angled(degrees.to_radians()),
        }
    }

    /// A line with the style's dashes.
    pub(super) fn dashed(&self, line: &[Pos2], stroke: Stroke) -> Vec<Shape> {
        match (self.dashes, line) {
            (Some([dash, gap]), _) => Shape::dashed_line(line, stroke, dash, gap),
            // Segments end at the edges of pixels, lines do not.
            (None, [from, to]) => vec![Shape::line_segment([*from, *to], stroke)],
            (None, _) => vec![Shape::line(line.to_vec(), stroke)],
        }
    }
}

/// The name of what a guide shows.
pub(super) fn name(guide: &Guide, kerr: Kerr) -> &'static str {
    match guide.landmark {
        Landmark::ShadowEdge => "edge of the shadow",
        Landmark::StableOrbit => "innermost stable orbit",
        Landmark::StableOrbitAgain => "second image of that orbit",
        Landmark::Ergosphere => "ergosphere",
        Landmark::Horizon => "horizon",
        Landmark::PhotonSphere if kerr.spin == 0.0 => "photon sphere",
        Landmark::PhotonSphere => "photon shell",
    }
}

/// What a guide marks, in a line of the key.
pub(super) fn meaning(guide: &Guide, kerr: Kerr, units: Units) -> String {
    let in_units =
        |units: Units, radius: f64| units.length(radius, |radius| trimmed(format!("{radius:.3}")));
    // The formulas that pupils know are in r_s.
    let length = |radius: f64| match units {
        Units::Hole => in_units(units, radius),
        Units::Everyday(_) => {
            format!(
                "{} ({})",
                in_units(units, radius),
                in_units(Units::Hole, radius)
            )
        }
    };
    let (shells, circling) = match photon_shells(kerr)[..] {
        [inner, outer] => {
            // The unit once is enough.
            let [inner, outer] = [inner, outer].map(|radius| in_units(units, radius));
            let inner = inner.rsplit_once(' ').map_or(&*inner, |(number, _)| number);
            let shells = format!("{inner} to {outer}");
            let circling = format!("photon shell, {shells}");
            (shells, circling)
        }
        ref shells => {
            let shells = shells.iter().copied().map(length).collect::<String>();
            let circling = format!("photon sphere, {shells}");
            (shells, circling)
        }
    };
    match guide.landmark {
        Landmark::ShadowEdge => {
            let ring = format!("the photon ring: light that grazed the {circling}");
            if kerr.spin == 0.0 {
                let afar = length(CRITICAL_IMPACT);
                return format!("{ring}; from afar its radius is {afar}");
            }
            ring
        }
        Landmark::StableOrbit => {
            format!("no stable circular orbit inside {}", length(kerr.isco()))
        }
        Landmark::StableOrbitAgain => "by light that went on around the hole".into(),
        Landmark::Ergosphere => "nothing inside it can stand still".into(),
        Landmark::Horizon => length(kerr.horizon()),
        Landmark::PhotonSphere => shells,
    }
}

/// What a guide marks, in a line of the key that has no names.
pub(super) fn short_meaning(guide: &Guide, kerr: Kerr, units: Units) -> String {
    let meaning = meaning(guide, kerr, units);
    match guide.landmark {
        Landmark::Horizon | Landmark::PhotonSphere => format!("{}: {meaning}", name(guide, kerr)),
        _ => meaning,
    }
}
