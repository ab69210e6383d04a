//! The GPU without Bevy: shader variants joined from WGSL parts, the scene as a uniform, a device
//! without a window, and rays traced on it.

mod accumulation;
mod adapter;
mod adapter_list;
mod adapter_request;
mod antialias;
mod background_device;
pub mod bindings;
mod bloom;
mod buffer;
mod call_size;
mod development;
mod device;
mod difference;
mod drawable;
pub mod driver_advice;
mod error;
mod error_map;
mod fallback;
mod inputs;
mod jet;
pub mod kernel;
mod layers;
mod medium;
pub mod passages;
mod presentation;
mod print;
pub mod rays;
mod read_back;
mod requirements;
mod scene;
mod shader;
mod sky_texture;
mod starlight;
pub mod stars;
mod structure;
pub mod timing;

pub use accumulation::Accumulation;
pub use adapter::{AdapterName, Choice, check_adapter, chosen, named_by_environment, prefer};
pub use adapter_list::{Listed, about_hidden_adapters, adapters, driver, kind, numbered};
pub use adapter_request::requested_place;
pub use antialias::{EdgeTraits, Edges};
pub use background_device::with_background_device;
pub use bloom::{Bloom, BloomLevels};
pub use call_size::{bands, max_pixels_of_call};
pub use development::{Developer, Development};
pub use device::Gpu;
pub use difference::Difference;
pub use drawable::{Drawable, Undrawable};
pub use error::GpuError;
pub use error_map::{ERROR_MAP_SIZE, ErrorMap};
pub use fallback::{WorkingAdapter, working_adapter};
pub use inputs::Inputs;
pub use jet::{GpuJet, GpuJetWaves, GpuPatterns};
pub use layers::Layers;
pub use medium::GpuThickDisk;
pub use presentation::Presentation;
pub use print::Print;
pub use read_back::read_back;
pub use requirements::Abilities;
pub use scene::{
    GpuDisk, GpuHole, GpuHotSpot, GpuObserver, GpuPicture, GpuQuality, GpuScene, GpuShadow, GpuSky,
    GpuTilt, MARK_BRIGHTNESS,
};
pub use shader::{Entry, ShaderFault, ShaderFiles, ShaderText, Tracer, Variant};
pub use sky_texture::SkyTexture;
pub use starlight::GpuStarlight;
pub use structure::{GpuGroup, GpuRing, GpuStructure};
