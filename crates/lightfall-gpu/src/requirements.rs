//! The requirements of the passes. An adapter with an old driver may not meet them, and would fail
//! with a message that tells a user nothing.

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

/// The abilities of an adapter that the passes need.
#[derive(Clone, Debug)]
pub struct Abilities {
    /// Its limits.
    pub limits: Limits,
    /// Its features beyond the smallest set.
    pub flags: DownlevelFlags,
    /// Its abilities with textures of linear light.
    pub light: TextureFormatFeatures,
}

impl Abilities {
    /// What an adapter offers.
    pub fn of(adapter: &Adapter) -> Self {
        Self {
            limits: adapter.limits(),
            flags: adapter.get_downlevel_capabilities().flags,
            light: adapter.get_texture_format_features(LIGHT),
        }
    }

    /// The requirements that the adapter does not meet, each as a clause. Empty if it can be used.
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
