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
            Self::Aces => {
                let level = (light * (light + 0.024_578_6) - 0.000_090_537)
                    / (light * (0.983_729 * light + 0.432_951) + 0.238_081);
                level.clamp(0.0, 1.0)
            }
            Self::Reinhard => light / (1.0 + light),
        }
    }
}

/// Where the neutral curve's shoulder begins.
const SHOULDER: f64 = 0.76;
/// The soft curve's white.
const SOFT_WHITE: f64 = 0.97;
