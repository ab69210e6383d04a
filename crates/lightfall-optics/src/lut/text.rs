//! Lookup tables as the texts of files.

use super::{Lut, LutForm, SIDE, Shaper};
use half::f16;
use std::fmt::Write;

/// The power by which ffmpeg's decoder of EXR takes the root of light, with `-gamma 4`. ffmpeg samples the
/// shaper in equal steps, which would miss the dark part of light itself.
const ROOT: f64 = 4.0;

/// Knots of the shaper in a file for ffmpeg.
const KNOTS: usize = 4096;

/// Numbers of the table of one dimension in a file for Resolve: as many as its reader takes.
const STEPS: usize = 65_536;

impl Lut {
    /// The text of the table's file in this form.
    pub fn text(&self, form: LutForm) -> String {
        let shaper = self.look.shaper(form);
        let mut text = String::new();
        // Writing to a string does not fail.
        let _ = match form {
            LutForm::Csp => self.write_csp(shaper, &mut text),
            LutForm::Clf => self.write_clf(shaper, &mut text),
            LutForm::Cube => self.write_cube(shaper, &mut text),
        };
        text
    }

    /// Rising Sun Research's format of cineSpace.
    fn write_csp(&self, shaper: Shaper, text: &mut String) -> std::fmt::Result {
        let gain = self.exposure_ev.exp2();
        let places = (0..KNOTS).map(|knot| knot as f64 / (KNOTS - 1) as f64);
        let inputs = places
            .clone()
            .map(|place| (shaper.light(place) / gain).powf(1.0 / ROOT));
        let inputs: Vec<String> = inputs.map(|input| format!("{input:.9}")).collect();
        let outputs: Vec<String> = places.map(|place| format!("{place:.7}")).collect();
        writeln!(text, "CSPLUTV100\n3D\n")?;
        for _ in 0..3 {
            writeln!(text, "{KNOTS}\n{}\n{}", inputs.join(" "), outputs.join(" "))?;
        }
        writeln!(text, "\n{SIDE} {SIDE} {SIDE}")?;
        self.write_nodes(shaper, true, text)
    }

    /// The Academy's Common LUT Format, version 3. The shaper has a number for each half float.
    fn write_clf(&self, shaper: Shaper, text: &mut String) -> std::fmt::Result {
        let gain = self.exposure_ev.exp2();
        writeln!(
            text,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ProcessList compCLFversion=\"3\" id=\"lightfall\">\n\
             <LUT1D inBitDepth=\"32f\" outBitDepth=\"32f\" halfDomain=\"true\"><Array dim=\"65536 1\">"
        )?;
        for bits in 0..=u16::MAX {
            let light = match f16::from_bits(bits).to_f64() {
                light if light.is_nan() => 0.0,
                light => light.clamp(0.0, f16::MAX.to_f64()),
            };
            writeln!(text, "{:.8}", shaper.place(light * gain).min(1.0))?;
        }
        writeln!(
            text,
            "</Array></LUT1D>\n<LUT3D inBitDepth=\"32f\" outBitDepth=\"32f\" interpolation=\"tetrahedral\">\
             <Array dim=\"{SIDE} {SIDE} {SIDE} 3\">"
        )?;
        self.write_nodes(shaper, false, text)?;
        writeln!(text, "</Array></LUT3D>\n</ProcessList>")
    }

    /// Resolve's form of a .cube.
    fn write_cube(&self, shaper: Shaper, text: &mut String) -> std::fmt::Result {
        let most = shaper.most / self.exposure_ev.exp2();
        writeln!(
            text,
            "LUT_1D_SIZE {STEPS}\nLUT_1D_INPUT_RANGE 0.0 {most:.9}\nLUT_3D_SIZE {SIDE}\nLUT_3D_INPUT_RANGE 0.0 1.0"
        )?;
        for step in 0..STEPS {
            let light = shaper.most * step as f64 / (STEPS - 1) as f64;
            let place = shaper.place(light);
            writeln!(text, "{place:.7} {place:.7} {place:.7}")?;
        }
        self.write_nodes(shaper, true, text)
    }

    fn write_nodes(
        &self,
        shaper: Shaper,
        is_red_first: bool,
        text: &mut String,
    ) -> std::fmt::Result {
        let mut nodes = self.nodes(shaper, is_red_first);
        nodes.try_for_each(|[red, green, blue]| writeln!(text, "{red:.6} {green:.6} {blue:.6}"))
    }
}
