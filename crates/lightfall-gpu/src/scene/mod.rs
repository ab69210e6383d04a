//! The uniform: a scene turned into numbers in f64 and rounded to f32 once. Its mirror is `Scene`
//! in shaders/scene.wgsl, which says what each number means; tests/gpu/layout.rs compares the two.

mod disk;
mod hole;
mod hot_spot;
mod observer;
mod picture;
mod quality;
mod shadow;
mod sky;
mod tilt;

pub use disk::GpuDisk;
pub use hole::GpuHole;
pub use hot_spot::GpuHotSpot;
pub use observer::GpuObserver;
pub(super) use observer::time_lead;
pub use picture::{GpuPicture, MARK_BRIGHTNESS};
pub use quality::GpuQuality;
pub use shadow::GpuShadow;
pub use sky::GpuSky;
pub use tilt::GpuTilt;

use super::error::GpuError;
use encase::ShaderType;
use glam::{DMat3, UVec2};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::scene::{Frame, Method, Projection, Scene, View};
use lightfall_optics::camera_rays::CameraRays;

/// A scene in the GPU's numbers.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuScene {
    pub hole: GpuHole,
    pub observer: GpuObserver,
    pub disk: GpuDisk,
    pub shadow: GpuShadow,
    pub quality: GpuQuality,
    pub sky: GpuSky,
    pub picture: GpuPicture,
}

impl GpuScene {
    /// The numbers of a frame of the scene, where directions are (right, up, forward) of the camera.
    ///
    /// # Errors
    /// A method or spin that no shader knows, or an observer that cannot exist.
    pub fn new(scene: &Scene, frame: &Frame) -> Result<Self, GpuError> {
        Self::with_directions(scene, frame, scene.camera.tetrad_from_camera())
    }

    /// The numbers for rays whose directions are on the observer's own axes: (outward, theta, phi).
    ///
    /// # Errors
    /// As [`GpuScene::new`].
    pub fn for_rays(scene: &Scene) -> Result<Self, GpuError> {
        Self::with_directions(scene, &Frame::of(scene), DMat3::IDENTITY)
    }

    /// `tetrad_from_direction` maps the shader's directions to the observer's axes.
    fn with_directions(
        scene: &Scene,
        frame: &Frame,
        tetrad_from_direction: DMat3,
    ) -> Result<Self, GpuError> {
        let kerr = scene.kerr();
        check_method(scene, kerr)?;
        let rays = CameraRays::in_disk_frame(scene)?;
        let mut numbers = Self {
            observer: GpuObserver::new(scene, kerr, &rays, tetrad_from_direction),
            hole: GpuHole::new(kerr),
            shadow: GpuShadow::new(scene, &rays.matrix, tetrad_from_direction)?,
            disk: GpuDisk::new(scene),
            ..Self::default()
        };
        numbers.set_frame(scene, frame);
        Ok(numbers)
    }

    /// Writes the numbers that depend on the frame, too.
    pub(super) fn set_frame(&mut self, scene: &Scene, frame: &Frame) {
        let kerr = scene.kerr();
        let whole = frame.whole.max(UVec2::ONE).as_dvec2();
        self.sky = GpuSky::new(scene, whole);
        self.quality = GpuQuality::new(scene, kerr, scene.camera.pixel_angle(whole));
        self.picture = GpuPicture::new(scene, frame);
    }
}

/// Whether the scene's method has a shader that can trace its spin from its camera.
fn check_method(scene: &Scene, kerr: Kerr) -> Result<(), GpuError> {
    let method = scene.method.properties();
    if !method.on_gpu {
        return Err(GpuError::MethodOfCpu);
    }
    if !method.spins && kerr.spin != 0.0 && scene.effects.lensing {
        return Err(GpuError::Spin(kerr.spin));
    }
    let projection = scene.camera.projection;
    let shifted = projection == Projection::Perspective && scene.camera.shift != [0.0; 2];
    let in_perspective = projection.of_picture() == Projection::Perspective;
    if scene.probe.enabled && (shifted || !in_perspective) {
        return Err(GpuError::Probe {
            projection,
            shifted,
        });
    }
    if cfg!(target_arch = "wasm32") && scene.view == View::Error {
        return Err(GpuError::ErrorsInBrowser);
    }
    if scene.has_medium() {
        let (thick, thickness) = (scene.has_thick_disk(), scene.disk.thickness);
        let method = scene.resolved_method();
        match (method == Method::Mino, scene.effects.lensing) {
            (true, true) => {}
            (false, _) if thick => return Err(GpuError::MethodOfSheet { method, thickness }),
            (false, _) => return Err(GpuError::MethodWithoutJets(method)),
            (true, false) if thick => return Err(GpuError::StraightRays { thickness }),
            (true, false) => return Err(GpuError::StraightRaysWithJets),
        }
    }
    let r = scene.camera.r;
    if r <= kerr.horizon() && !method.inside {
        return Err(GpuError::Inside { r });
    }
    Ok(())
}
