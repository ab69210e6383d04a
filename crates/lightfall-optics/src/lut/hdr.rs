//! Codes of HDR10: light of up to thousands of nits, with the primaries of Rec. 2020.

/// The luminance of light 1, in cd/m^2: that of diffuse white in HDR (Rep. ITU-R BT.2408-7, table 1).
pub const HDR_WHITE: f64 = 203.0;

/// Least and most peaks of a screen, in cd/m^2: above white, up to the end of the code.
pub const HDR_PEAKS: [u32; 2] = [300, 10_000];

/// The end of the code, in cd/m^2.
const CODE_PEAK: f64 = 10_000.0;

/// From the primaries of Rec. 709 to those of Rec. 2020 (Rec. ITU-R BT.2087-0, annex 2).
const REC_2020: [[f64; 3]; 3] = [
    [0.6274, 0.3293, 0.0433],
    [0.0691, 0.9195, 0.0114],
    [0.0164, 0.0880, 0.8956],
];

/// The range of an HDR screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HighRange {
    /// Its peak, in cd/m^2: one of [`HDR_PEAKS`] or between them.
    pub peak: f64,
}

impl Default for HighRange {
    fn default() -> Self {
        Self { peak: 1000.0 }
    }
}

impl HighRange {
    /// The codes, from 0 to 1, of red, green and blue of exposed light with the primaries of Rec. 709.
    /// The largest channel is rolled off, and the others with it, so that hues stay.
    pub fn codes(&self, light: [f64; 3]) -> [f64; 3] {
        let nits = REC_2020.map(|row| {
            let channel: f64 = row
                .iter()
                .zip(light)
                .map(|(share, light)| share * light)
                .sum();
            HDR_WHITE * channel.max(0.0)
        });
        let largest = nits.into_iter().fold(0.0, f64::max);
        if largest == 0.0 {
            return [0.0; 3];
        }
        let shown = nits_of(self.rolled_off(code_of(largest.min(CODE_PEAK))));
        nits.map(|channel| code_of(channel * shown / largest))
    }

    /// A code on this screen (Rep. ITU-R BT.2390-11, section 5.4.1, with black 0 and a source of the whole
    /// code): a line up to the knee, and a Hermite spline to the peak.
    fn rolled_off(&self, code: f64) -> f64 {
        let peak = code_of(self.peak);
        let knee = 1.5 * peak - 0.5;
        if code < knee || knee >= 1.0 {
            return code;
        }
        let t = (code - knee) / (1.0 - knee);
        let (square, cube) = (t * t, t * t * t);
        (2.0 * cube - 3.0 * square + 1.0) * knee
            + (cube - 2.0 * square + t) * (1.0 - knee)
            + (3.0 * square - 2.0 * cube) * peak
    }
}

/// Numbers of the code (Rec. ITU-R BT.2100-2, table 4).
const M1: f64 = 2610.0 / 16_384.0;
const M2: f64 = 2523.0 / 4096.0 * 128.0;
const C1: f64 = 3424.0 / 4096.0;
const C2: f64 = 2413.0 / 4096.0 * 32.0;
const C3: f64 = 2392.0 / 4096.0 * 32.0;

/// The perceptual quantizer's code, from 0 to 1, of a luminance in cd/m^2.
fn code_of(nits: f64) -> f64 {
    let y = (nits / CODE_PEAK).powf(M1);
    ((C1 + C2 * y) / (1.0 + C3 * y)).powf(M2)
}

/// The luminance of a code, in cd/m^2.
fn nits_of(code: f64) -> f64 {
    let x = code.powf(1.0 / M2);
    CODE_PEAK * ((x - C1).max(0.0) / (C2 - C3 * x)).powf(1.0 / M1)
}
