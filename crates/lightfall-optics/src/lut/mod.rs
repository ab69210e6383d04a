//! Lookup tables for other programs: what the program's last pass makes of a picture's linear light,
//! by exposure and tone curve, without bloom.
//!
//! A table has a shaper, which spreads the dark part of light over more of its places, and a cube of
//! colours.

mod hdr;
mod text;

pub use hdr::{HDR_PEAKS, HDR_WHITE, HighRange};

use lightfall_model::scene::{Scene, ToneCurve};
use lightfall_model::words;

words! {
    /// The form of a file with a lookup table.
    pub enum LutForm {
        /// For ffmpeg, which reads the light with `-gamma 4`.
        Csp = "csp",
        /// For OpenColorIO, and so for Nuke, Gaffer and Natron.
        Clf = "clf",
        /// For DaVinci Resolve: a table of one dimension before that of three.
        Cube = "cube",
    }
}

/// Places of a cube's side.
const SIDE: usize = 65;

/// What is made of light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Look {
    /// Levels of sRGB by a tone curve.
    Screen(ToneCurve),
    /// Codes of HDR10.
    High(HighRange),
}

impl Look {
    /// The look of a scene's picture on a screen.
    pub fn of(scene: &Scene) -> Self {
        // The marks of a view have the colours of its legend.
        Self::Screen(if scene.view.shows_light() {
            scene.picture.tone_curve
        } else {
            ToneCurve::Neutral
        })
    }

    /// The codes of red, green and blue of exposed light with the primaries of Rec. 709. From 0 to 1 is
    /// what can be shown; they are not cut off there, so that a table has no bend inside its cells.
    pub fn codes(&self, light: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Screen(curve) => curve.toned(light).map(srgb),
            Self::High(range) => range.codes(light),
        }
    }

    /// The codes of a pixel's light, which are what can be shown. `gain` is two to the power of the
    /// exposure.
    pub fn shown(&self, light: [f32; 3], gain: f64) -> [f64; 3] {
        let exposed = light.map(|channel| f64::from(channel.max(0.0)) * gain);
        self.codes(exposed).map(|code| code.clamp(0.0, 1.0))
    }

    fn shaper(&self, form: LutForm) -> Shaper {
        match (self, form) {
            // The table of one dimension has equal steps of light, which would miss the dark part of more.
            (_, LutForm::Cube) => Shaper {
                detail: 7.0,
                most: 64.0,
            },
            (Self::Screen(_), _) => Shaper {
                detail: 10.0,
                most: 4096.0,
            },
            // The codes of HDR10 tell far darker light apart.
            (Self::High(_), _) => Shaper {
                detail: 17.0,
                most: 4096.0,
            },
        }
    }
}

/// sRGB's level of a linear one (IEC 61966-2-1, equations 5 and 6), going on below 0 as a line.
pub(crate) fn srgb(linear: f64) -> f64 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    }
}

/// From exposed light to places of a table: s(x) = log2(1 + 2^d x) / log2(1 + 2^d m), which is 1 at the
/// most light m.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Shaper {
    detail: f64,
    most: f64,
}

impl Shaper {
    fn place(self, light: f64) -> f64 {
        (light * self.detail.exp2()).ln_1p() / (self.most * self.detail.exp2()).ln_1p()
    }

    fn light(self, place: f64) -> f64 {
        let whole = (self.most * self.detail.exp2()).ln_1p();
        (place * whole).exp_m1() / self.detail.exp2()
    }
}

/// A lookup table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lut {
    /// What it makes of light.
    pub look: Look,
    /// The exposure of the light before that, in powers of two.
    pub exposure_ev: f64,
}

impl Lut {
    /// The codes at the places of the cube. `is_red_first` says whether red or blue changes from one to the
    /// next.
    fn nodes(&self, shaper: Shaper, is_red_first: bool) -> impl Iterator<Item = [f64; 3]> {
        let look = self.look;
        let light = (0..SIDE).map(|i| shaper.light(i as f64 / (SIDE - 1) as f64));
        let light: Vec<f64> = light.collect();
        (0..SIDE * SIDE * SIDE).map(move |number| {
            let [slow, middle, fast] =
                [number / (SIDE * SIDE), number / SIDE % SIDE, number % SIDE];
            let [red, blue] = if is_red_first {
                [fast, slow]
            } else {
                [slow, fast]
            };
            look.codes([light[red], light[middle], light[blue]])
        })
    }
}
