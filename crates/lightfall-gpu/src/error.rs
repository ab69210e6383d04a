//! Why the GPU cannot do what was asked.

use super::adapter_list::SHOW_HIDDEN;
use super::driver_advice;
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::scene::{Method, Projection};
use lightfall_optics::stars::images::InversionError;
use std::env::consts::OS;
use thiserror::Error;

/// Why the GPU cannot do what was asked. Each message is one sentence.
#[derive(Clone, Debug, Error, PartialEq)]
#[expect(missing_docs, reason = "the messages say what the fields are")]
pub enum GpuError {
    /// No graphics driver offers an adapter.
    #[error("{}", driver_advice::without_adapter(OS))]
    NoAdapter,
    /// Only hidden adapters are there, or only hidden ones have the requested name.
    #[error(
        "{}: found, but hidden, because the driver does not claim to conform to Vulkan; set {SHOW_HIDDEN}=1 to use it, \
         and let `lightfall doctor` check what it draws", .names.join("; ")
    )]
    HiddenAdapters { names: Vec<String> },
    /// There are adapters, but none of them uses the requested interface.
    #[error(
        "--backend {given} (or WGPU_BACKEND) is refused: the adapters of this machine use {}", .available.join(" or ")
    )]
    UnknownBackend {
        given: String,
        available: Vec<&'static str>,
    },
    /// There are adapters, but the request means none of them.
    #[error(
        "--gpu {given} (or WGPU_ADAPTER_NAME) is refused: it must be the number, the PCI bus id or a part of the name of one \
         of these adapters, which --list-gpus lists: {}", .adapters.join("; ")
    )]
    UnknownAdapter {
        given: String,
        adapters: Vec<String>,
    },
    /// The request means several adapters.
    #[error(
        "--gpu {given} (or WGPU_ADAPTER_NAME) is refused: it means more than one adapter; the number or the PCI bus id \
         means one of them: {}", .adapters.join("; ")
    )]
    SeveralAdapters {
        given: String,
        adapters: Vec<String>,
    },
    /// There are adapters, but none of them has what the passes need and gives a device.
    #[error(
        "no graphics adapter can be used: {}; {}", .failures.join("; "), driver_advice::with_old_driver(OS)
    )]
    NoDevice { failures: Vec<String> },
    /// The adapter provides no device, or the device failed: it is of no further use.
    #[error("the graphics device failed: {0}")]
    Device(String),
    /// The program runs in a browser, which lets no page wait for the GPU.
    #[error("not measured in a browser, where no page can wait for the graphics device")]
    InBrowser,
    /// As [`InBrowser`](Self::InBrowser), for the view that shows what is measured.
    #[error(
        "view = \"error\" is refused: in a browser no page can wait for the graphics device; the downloaded program \
         shows this view"
    )]
    ErrorsInBrowser,
    /// The method follows no rays through matter.
    #[error(
        "method = \"{}\" is refused: it meets the disk where rays cross its plane, and disk.thickness = {thickness} gives it \
         depth; auto and mino trace it", .method.word()
    )]
    MethodOfSheet { method: Method, thickness: f64 },
    /// Straight rays meet no matter with depth.
    #[error(
        "effects.lensing = false is refused: straight rays meet the disk where they cross its plane, and disk.thickness = \
         {thickness} gives it depth; disk.thickness = 0 makes it a sheet"
    )]
    StraightRays { thickness: f64 },
    /// The method follows no rays through jets.
    #[error(
        "method = \"{}\" is refused: it follows no ray through the jets of jet.enabled = true; auto and mino do",
        .0.word()
    )]
    MethodWithoutJets(Method),
    /// Straight rays pass no jets.
    #[error(
        "effects.lensing = false is refused: straight rays pass no jets, and jet.enabled = true asks for them; \
         jet.enabled = false leaves them out"
    )]
    StraightRaysWithJets,
    /// The foreground probe is not drawn in this projection, or with a shift.
    #[error(
        "probe.enabled = true is refused: the probe is drawn in perspective, and here camera.projection is \"{}\"{}; \
         probe.enabled = false leaves it out",
        .projection.word(), if *.shifted { " with a camera.shift" } else { "" }
    )]
    Probe {
        projection: Projection,
        shifted: bool,
    },
    /// The device has too little free memory.
    #[error("the graphics device has too little free memory: {0}")]
    OutOfMemory(String),
    /// A buffer is larger than the device allows.
    #[error(
        "{what} need a buffer of {bytes} bytes, and this device allows {limit}: ask for fewer pixels"
    )]
    TooLarge {
        what: &'static str,
        bytes: u64,
        limit: u64,
    },
    /// A shader does not compile. The message names the file and line if they are known.
    #[error("a shader does not compile: {0}")]
    Shader(String),
    /// The device's validation refuses a pipeline, a resource or a command.
    #[error("the graphics device refuses a request: {0}")]
    Invalid(String),
    /// The images of stars cannot be found by inversion.
    #[error(transparent)]
    Stars(#[from] InversionError),
    /// The method cannot trace this spin.
    #[error(
        "hole.spin = {spin} is refused: holes without spin are all that {} can trace, so it must be 0 (methods {} trace any spin)",
        Method::list("and", |method| !method.spins),
        Method::list("and", |method| method.spins && method.on_gpu),
        spin = .0
    )]
    Spin(f64),
    /// The camera is inside the horizon, where the method cannot start a ray.
    #[error(
        "camera.r = {r} is refused: it is inside the horizon, where methods {} cannot start a ray ({} can)",
        Method::list("and", |method| !method.inside),
        Method::list("and", |method| method.inside && method.on_gpu)
    )]
    Inside { r: f64 },
    /// The method does not run on the GPU.
    #[error(
        "method = \"{}\" is refused: it runs on the CPU only, with `trace --device cpu`, so here it must be {}",
        Method::list("and", |method| !method.on_gpu),
        Method::list("or", |method| method.on_gpu)
    )]
    MethodOfCpu,
    /// The observer cannot exist at the camera's place.
    #[error(transparent)]
    Observer(#[from] ObserverError),
}

impl GpuError {
    /// Whether the device failed. Every other error leaves the device as useful as before.
    pub fn is_device_failure(&self) -> bool {
        matches!(self, Self::Device(_))
    }

    /// The failure of a device, in the words of its driver or of wgpu.
    pub(super) fn device_failed(reason: impl std::fmt::Display) -> Self {
        Self::Device(reason.to_string())
    }
}
