//! The curve that takes light without an upper limit to the levels of a screen.

crate::words! {
    /// A tone curve: one of those that Bevy computes without a table.
    pub enum ToneCurve {
        /// Exact colours, and a short way to white.
        Neutral = "neutral": "Neutral",
        /// A long way to white, on which colours fade.
        Soft = "soft": "Soft",
        /// Film-like: more contrast, and hues that turn.
        Aces = "aces": "ACES",
        /// Colours never fade to white.
        Reinhard = "reinhard": "Reinhard",
    }
}

impl ToneCurve {
    /// Level from 0 to 1, linear, of white light: by Khronos PBR Neutral 2024, Stachowiak's display
    /// transform, the fitted curve of the Academy Color Encoding System, or Reinhard 2002 by
    /// luminance.
    pub fn level(self, light: f64) -> f64 {
        match self {
            // Without the curve's offset, which takes up to 0.04 from the darkest channel.
            Self::Neutral if light < SHOULDER => light,
            Self::Neutral => {
                let rest = 1.0 - SHOULDER;
                1.0 - rest * rest / (light + rest - SHOULDER)
            }
            Self::Soft => SOFT_WHITE * (1.0 - (-light).exp()),
            Self::Aces => film_level(light).clamp(0.0, 1.0),
            Self::Reinhard => light / (1.0 + light),
        }
    }

    /// Red, green and blue from 0 to about 1, linear, of exposed light with the primaries of Rec. 709:
    /// the twin of `toned` in shaders/tone_curve.wgsl, which names the sources. No channel of the light
    /// is below 0.
    pub fn toned(self, light: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Neutral => toned_neutrally(light),
            Self::Soft => toned_softly(light),
            Self::Aces => toned_as_film(light),
            Self::Reinhard => light.map(|channel| channel / (1.0 + luminance(light))),
        }
    }
}

/// Rec. ITU-R BT.709, item 3.2.
fn luminance(light: [f64; 3]) -> f64 {
    dot(light, [0.2126, 0.7152, 0.0722])
}

fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

/// From `a` at 0 to `b` at 1.
fn mixed(a: [f64; 3], b: [f64; 3], share: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + (b[i] - a[i]) * share)
}

fn largest(light: [f64; 3]) -> f64 {
    light.into_iter().fold(f64::NEG_INFINITY, f64::max)
}

/// The reflectance that the neutral curve subtracts, and how fast compressed light loses its colour.
const F_90: f64 = 0.04;
const K_D: f64 = 0.15;

fn toned_neutrally(light: [f64; 3]) -> [f64; 3] {
    let least = light.into_iter().fold(f64::INFINITY, f64::min);
    let offset = if least < 2.0 * F_90 {
        least - least * least / (4.0 * F_90)
    } else {
        F_90
    };
    let above = light.map(|channel| channel - offset);
    let peak = largest(above);
    if peak < SHOULDER {
        return above;
    }
    let shown_peak = ToneCurve::Neutral.level(peak);
    let colour = 1.0 / (K_D * (peak - shown_peak) + 1.0);
    let coloured = above.map(|channel| channel * shown_peak / peak);
    mixed([shown_peak; 3], coloured, colour)
}

fn toned_softly(light: [f64; 3]) -> [f64; 3] {
    let saturating = |light: f64| 1.0 - (-light).exp();
    let luma = luminance(light);
    let blue = dot(light, [-0.1146, -0.3854, 0.5]);
    let red = dot(light, [0.5, -0.4542, -0.0458]);
    let colourful = saturating(2.4 * blue.hypot(red));
    let bleach = (0.8 * (colourful - 0.7)).max(0.0);
    let scale = saturating(luma) / luma.max(1e-5);
    let by_luminance = light.map(|channel| channel * scale);
    let by_channel = mixed(light, [luma; 3], bleach * bleach).map(saturating);
    mixed(by_luminance, by_channel, colourful * colourful).map(|level| SOFT_WHITE * level)
}

/// The fitted curve of the Academy Color Encoding System.
fn film_level(light: f64) -> f64 {
    (light * (light + 0.024_578_6) - 0.000_090_537)
        / (light * (0.983_729 * light + 0.432_951) + 0.238_081)
}

fn toned_as_film(light: [f64; 3]) -> [f64; 3] {
    let film = [
        dot(light, [0.59719, 0.35458, 0.04823]),
        dot(light, [0.07600, 0.90834, 0.01566]),
        dot(light, [0.02840, 0.13383, 0.83777]),
    ];
    let shown = film.map(film_level);
    [
        dot(shown, [1.60475, -0.53108, -0.07367]),
        dot(shown, [-0.10208, 1.10813, -0.00605]),
        dot(shown, [-0.00327, -0.07276, 1.07602]),
    ]
    .map(|level| level.clamp(0.0, 1.0))
}

/// Where the neutral curve's shoulder begins.
const SHOULDER: f64 = 0.76;
/// The soft curve's white.
const SOFT_WHITE: f64 = 0.97;
