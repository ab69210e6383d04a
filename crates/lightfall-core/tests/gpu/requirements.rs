//! What the passes need from an adapter, and what is said about one that lacks it.

use crate::adapter::gpu;
use lightfall_core::gpu::{Abilities, GpuError, adapters, driver_advice};
use wgpu::{
    DownlevelFlags, Limits, TextureFormatFeatureFlags, TextureFormatFeatures, TextureUsages,
};

/// An adapter that offers no more than what WebGPU guarantees.
fn least() -> Abilities {
    Abilities {
        limits: Limits::default(),
        flags: DownlevelFlags::compliant(),
        light: TextureFormatFeatures {
            allowed_usages: TextureUsages::RENDER_ATTACHMENT
                | TextureUsages::TEXTURE_BINDING
                | TextureUsages::COPY_SRC,
            flags: TextureFormatFeatureFlags::FILTERABLE | TextureFormatFeatureFlags::BLENDABLE,
        },
    }
}

#[test]
fn an_adapter_with_what_webgpu_guarantees_can_be_used() {
    assert_eq!(least().missing(), Vec::<String>::new());
}

/// No driver of this age is at hand, so old ones are described by what they report: the limits that
/// wgpu gives for OpenGL ES 3.0, and adapters that lack one thing each.
#[test]
fn what_an_old_driver_lacks_is_named_with_both_values() {
    let old = Abilities {
        limits: Limits::downlevel_webgl2_defaults(),
        ..least()
    };
    let missing = old.missing();
    for clause in [
        "max_storage_buffers_per_shader_stage is 0, not 8",
        "max_texture_dimension_2d is 2048, not 8192",
        "max_uniform_buffer_binding_size is 16384, not 65536",
    ] {
        assert!(missing.iter().any(|it| it == clause), "{missing:?}");
    }
    let without_compute = Abilities {
        flags: DownlevelFlags::compliant() - DownlevelFlags::COMPUTE_SHADERS,
        ..least()
    };
    assert_eq!(without_compute.missing(), ["it has no compute shaders"]);
    for light in [
        TextureFormatFeatures {
            allowed_usages: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_SRC,
            ..least().light
        },
        TextureFormatFeatures {
            flags: TextureFormatFeatureFlags::FILTERABLE,
            ..least().light
        },
        TextureFormatFeatures {
            flags: TextureFormatFeatureFlags::BLENDABLE,
            ..least().light
        },
    ] {
        let missing = Abilities { light, ..least() }.missing();
        let clause = "it cannot draw, filter and blend textures of 16-bit floats";
        assert_eq!(missing, [clause], "{light:?}");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_adapter_that_draws_here_lacks_nothing() {
    let used = gpu().info.name.clone();
    let listed = adapters();
    let listed = listed.iter().find(|it| it.name.name == used).unwrap();
    assert_eq!(listed.missing, Vec::<String>::new());
}

#[test]
fn adapters_that_cannot_be_used_are_one_sentence_with_what_to_do() {
    let error = GpuError::NoDevice {
        failures: vec![
            "Old card (vulkan): it has no compute shaders".into(),
            "Other card (dx12): the driver says no".into(),
        ],
    };
    let sentence = format!(
        "no graphics adapter can be used: Old card (vulkan): it has no compute shaders; Other card (dx12): the driver says \
         no; {}",
        driver_advice::with_old_driver(std::env::consts::OS)
    );
    assert_eq!(error.to_string(), sentence);
}

#[test]
fn every_system_is_told_which_driver_to_install() {
    for (os, missing, old) in [
        ("linux", "Vulkan", "mesa-vulkan-drivers"),
        ("freebsd", "Vulkan", "graphics driver"),
        ("windows", "Direct3D 12", "newest driver"),
        ("macos", "Metal", "update macOS"),
    ] {
        let without = driver_advice::without_adapter(os);
        assert!(
            without.contains(missing) && without.contains(": "),
            "{without}"
        );
        assert!(driver_advice::with_old_driver(os).contains(old), "{os}");
    }
    let here = driver_advice::without_adapter(std::env::consts::OS);
    assert_eq!(GpuError::NoAdapter.to_string(), here);
}
