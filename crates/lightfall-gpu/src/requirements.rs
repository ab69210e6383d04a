//! What the passes need from an adapter. One with an old driver may offer less: opening a device on
//! it, or a pass, would fail with words that say nothing to a user.

use wgpu::{
    Adapter, DownlevelFlags, Limits, TextureFormat, TextureFormatFeatureFlags,
    TextureFormatFeatures, TextureUsages,
};

/// The format in which the passes keep light.
const LIGHT: TextureFormat = TextureFormat::Rgba16Float;
/// Light is drawn, read by the next pass, and copied for EXR files.
const USES_OF_LIGHT: TextureUsages = TextureUsages::RENDER_ATTACHMENT
    .union(TextureUsages::TEXTURE_BINDING)
    .union(TextureUsages::COPY_SRC);
/// Bloom filters light and adds it up.
const WORK_WITH_LIGHT: TextureFormatFeatureFlags =
    TextureFormatFeatureFlags::FILTERABLE.union(TextureFormatFeatureFlags::BLENDABLE);

/// What an adapter offers of the things that the passes need.
#[derive(Clone, Debug)]
pub struct Abilities {
    /// Its limits.
    pub limits: Limits,
    /// What it has beyond the smallest set of features.
    pub flags: DownlevelFlags,
    /// What can be done with textures of linear light.
    pub light: TextureFormatFeatures,
}

impl Abilities {
    /// What an adapter offers.
    #[must_use]
    pub fn of(adapter: &Adapter) -> Self {
        Self {
            limits: adapter.limits(),
            flags: adapter.get_downlevel_capabilities().flags,
            light: adapter.get_texture_format_features(LIGHT),
        }
    }

    /// What the passes need and the adapter lacks, each as a clause. Empty for an adapter that can
    /// be used.
    #[must_use]
    pub fn missing(&self) -> Vec<String> {
        let mut missing = Vec::new();
        // The passes rely on the limits that WebGPU guarantees everywhere.
        Limits::default().check_limits_with_fail_fn(
            &self.limits,
            false,
            |limit, needed, available| {
                missing.push(format!("{limit} is {available}, not {needed}"));
            },
        );
        if !self.flags.contains(DownlevelFlags::COMPUTE_SHADERS) {
            missing.push("it has no compute shaders".into());
        }
        if !self.light.allowed_usages.contains(USES_OF_LIGHT)
            || !self.light.flags.contains(WORK_WITH_LIGHT)
        {
            missing.push("it cannot draw, filter and blend textures of 16-bit floats".into());
        }
        missing
    }
}
