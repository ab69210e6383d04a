//! The GPU without Bevy: WGSL parts joined into variants, the scene as a uniform, a device without
//! a window, rays in and traces out.

mod adapter;
mod background_device;
mod device;
mod drawable;
mod error_map;
pub mod kernel;
pub mod rays;
mod scene;
mod shader;
pub mod timing;

pub use adapter::{
    AdapterName, Listed, adapters, check_adapter, chosen, kind, named_by_environment, prefer,
};
pub use background_device::with_background_device;
pub use device::Gpu;
pub use drawable::{Drawable, Undrawable};
pub use error_map::{ERROR_MAP_SIZE, ErrorMap};
pub use scene::{GpuScene, MARK_BRIGHTNESS};
pub use shader::{Entry, Tracer, Variant};

use crate::geometry::observer::ObserverError;
use thiserror::Error;

/// Why the GPU cannot do what was asked.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum GpuError {
    /// No graphics driver offers an adapter.
    #[error(
        "no Vulkan adapter was found: install a graphics driver; on Debian and Ubuntu the packages libvulkan1 and \
         mesa-vulkan-drivers give one that needs no graphics card"
    )]
    NoAdapter,
    /// There are adapters, but none through the interface that was asked for.
    #[error(
        "--backend {given} (or WGPU_BACKEND) is refused: it must be an interface that an adapter is reached through here, and \
         that is {}", .there.join(" or ")
    )]
    UnknownBackend {
        /// What was asked for.
        given: String,
        /// The interfaces that there are.
        there: Vec<&'static str>,
    },
    /// There are adapters, but none of the name that was asked for.
    #[error(
        "--gpu {given} (or WGPU_ADAPTER_NAME) is refused: it must be part of the name of one of these adapters, which \
         --list-gpus tells: {}", .names.join("; ")
    )]
    UnknownAdapter {
        /// What was asked for.
        given: String,
        /// The names of those that there are.
        names: Vec<String>,
    },
    /// The adapter gives no device, or the device failed.
    #[error("the graphics device failed: {0}")]
    Device(String),
    /// A shader that does not compile, with its file and line where these are known.
    #[error("a shader does not compile: {0}")]
    Shader(String),
    /// A spin that the method does not know.
    #[error(
        "hole.spin = {0} is refused: methods verlet and closed trace holes without spin only, so it must be 0 (methods \
         auto, mino and kerr-schild trace any spin)"
    )]
    Spin(f64),
    /// A camera inside the horizon, where the method cannot begin.
    #[error(
        "camera.r = {r} is refused: it is inside the horizon, from where methods verlet and kerr-schild cannot begin (auto, \
         mino and, without spin, closed can)"
    )]
    Inside {
        /// The camera's radius.
        r: f64,
    },
    /// A method that does not run on the GPU.
    #[error(
        "method = \"reference\" is refused: it runs on the CPU only, so here it must be auto, verlet, closed, mino or \
         kerr-schild"
    )]
    MethodOfCpu,
    /// An observer that cannot be.
    #[error(transparent)]
    Observer(#[from] ObserverError),
}
