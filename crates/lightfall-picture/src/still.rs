//! Single pictures of scenes, drawn by the window's chain of passes without a window.

use super::PictureError;
use super::headless::{HeadlessOptions, MAX_UPDATES, drawable, headless};
use bevy::prelude::*;
use bevy::render::gpu_readback::{Readback, ReadbackComplete};
use bevy::render::renderer::{RenderAdapterInfo, RenderDevice};
use lightfall_core::gpu::Layers;
use lightfall_core::scene::{Frame, Part, Scene, fit};
use lightfall_platform::storage::PictureRecord;
use lightfall_render::{
    Capture, Captured, Comparison, ComparisonMode, CurrentFrame, CurrentScene, DrawnLayers,
    GivenLight, NEAR_PLANE, Pinned, Printed, Prints, StarCatalogue,
};
use wgpu::DeviceType;

/// A finished picture.
pub struct Still {
    /// Width and height, in pixels.
    pub size: UVec2,
    /// 8-bit sRGB, rows from the top, three bytes per pixel.
    pub rgb: Vec<u8>,
}

impl Still {
    /// Removes the padding of rows and the alpha channel.
    fn from_rgba(size: UVec2, bytes: &[u8]) -> Self {
        let row = size.x as usize * 4;
        let rgb = bytes
            .chunks(RenderDevice::align_copy_bytes_per_row(row))
            .flat_map(|line| line[..row].chunks_exact(4))
            .flat_map(|pixel| [pixel[0], pixel[1], pixel[2]])
            .collect();
        Self { size, rgb }
    }
}

/// Draws one scene after another at one output size, without a window.
pub struct Studio {
    pub(super) app: App,
    /// The image that the last pass writes, and its size.
    output: Handle<Image>,
    size: UVec2,
    /// The part of the scene's picture that is drawn; `None` for all of it.
    pub(super) part: Option<Part>,
}

/// The bytes that were read back.
#[derive(Resource, Default)]
struct Finished(Option<Vec<u8>>);

impl Studio {
    /// Opens a device and draws a first scene. The studio can time passes.
    ///
    /// # Errors
    /// The size is too large, or drawing failed.
    pub fn open(scene: &Scene, size: UVec2) -> Result<Self, PictureError> {
        Self::with_options(
            scene,
            size,
            HeadlessOptions {
                timed: true,
                ..HeadlessOptions::default()
            },
        )
    }

    /// Opens a device and draws a first scene, with these options.
    ///
    /// # Errors
    /// As [`Studio::open`].
    pub fn with_options(
        scene: &Scene,
        size: UVec2,
        options: HeadlessOptions,
    ) -> Result<Self, PictureError> {
        let (mut app, output) = headless(scene, size, options)?;
        app.init_resource::<Finished>();
        let mut studio = Self {
            app,
            output,
            size,
            part: options.part,
        };
        studio.settle()?;
        Ok(studio)
    }

    /// Shows a scene from the next frame on.
    ///
    /// # Errors
    /// The scene cannot be drawn.
    pub fn show(&mut self, scene: &Scene) -> Result<(), PictureError> {
        let scene = drawable(scene)?;
        let frame = Frame::of(&scene).with_part(self.part);
        let world = self.app.world_mut();
        world.resource_mut::<CurrentFrame>().0 = frame;
        world.resource_mut::<CurrentScene>().0 = scene;
        Ok(())
    }

    /// Draws a part of the picture of a scene from the next frame on.
    ///
    /// # Errors
    /// The scene cannot be drawn.
    pub fn show_part(&mut self, scene: &Scene, part: Part) -> Result<(), PictureError> {
        self.part = Some(part);
        if self.scene() != scene {
            return self.show(scene);
        }
        // The same scene needs no new numbers.
        let mut frame = self.app.world_mut().resource_mut::<CurrentFrame>();
        frame.0 = Frame::of(scene).with_part(Some(part));
        Ok(())
    }

    /// Gives the light of the part that is shown, in place of its rays, or ends doing so.
    pub fn give_light(&mut self, light: Option<Vec<u8>>) {
        let world = self.app.world_mut();
        let is_given = world
            .get_resource::<GivenLight>()
            .is_some_and(|given| given.is_some());
        // A picture without given light would be drawn again if the same were said once more.
        if light.is_none() && !is_given {
            return;
        }
        world.insert_resource(light.map_or_else(GivenLight::default, GivenLight::new));
    }

    /// Draws these layers of the scene's light from the next frame on, with their share of each pixel in
    /// alpha; with `None` all light, as a window shows it. The view must be `colour`.
    pub fn show_layers(&mut self, layers: Option<Layers>) {
        let mut drawn = self.app.world_mut().resource_mut::<DrawnLayers>();
        drawn.set_if_neq(DrawnLayers(layers));
    }

    /// The layers that are shown.
    #[must_use]
    pub fn shown_layers(&self) -> Option<Layers> {
        self.app.world().resource::<DrawnLayers>().0
    }

    /// The levels of a file of what is shown. The studio must make them.
    ///
    /// # Errors
    /// Drawing failed, or the studio makes no levels.
    pub fn levels(&mut self) -> Result<Printed, PictureError> {
        self.settle()?;
        let world = self.app.world();
        let (Some(prints), Some(device)) = (
            world.get_resource::<Prints>(),
            world.get_resource::<RenderDevice>(),
        ) else {
            return Err(PictureError::Draw(
                "nothing makes the levels of a file".into(),
            ));
        };
        prints.read(device).map_err(PictureError::Draw)
    }

    /// The scene that is shown. Its exposure is the metered one where the exposure is automatic.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        self.app.world().resource::<CurrentScene>().scene()
    }

    /// Whether the adapter is hardware or a program; `None` if no device is open.
    #[must_use]
    pub fn adapter_kind(&self) -> Option<DeviceType> {
        let info = self.app.world().get_resource::<RenderAdapterInfo>();
        info.map(|info| info.device_type)
    }

    /// The record of a picture of this scene that the studio draws.
    #[must_use]
    pub fn record(&self, scene: &Scene) -> PictureRecord {
        let world = self.app.world();
        let stars = world.resource::<StarCatalogue>();
        PictureRecord::new(scene, stars, world.get_resource())
    }

    /// Compares the scene with the settings of another one from the next frame on, or with nothing.
    pub fn compare(&mut self, with: Option<(&Scene, ComparisonMode)>) {
        let pinned = with.map(|(scene, mode)| (Pinned::new(scene), mode));
        self.show_comparison(Comparison(pinned));
    }

    /// Shows a comparison of the scene from the next frame on.
    pub fn show_comparison(&mut self, comparison: Comparison) {
        self.app.world_mut().insert_resource(comparison);
    }

    /// The picture of the next frame.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn picture(&mut self) -> Result<Still, PictureError> {
        let world = self.app.world_mut();
        let reader = world
            .spawn(Readback::texture(self.output.clone()))
            .observe(
                |complete: On<ReadbackComplete>, mut finished: ResMut<Finished>| {
                    finished.0 = Some(complete.data.clone());
                },
            )
            .id();
        for _ in 0..MAX_UPDATES {
            self.update()?;
            let world = self.app.world_mut();
            if let Some(bytes) = world.resource_mut::<Finished>().0.take() {
                world.despawn(reader);
                return Ok(Still::from_rgba(self.size, &bytes));
            }
        }
        Err(PictureError::Draw(
            "it did not arrive from the graphics device".into(),
        ))
    }

    /// The linear light of the current scene, before bloom, exposure and tone mapping. The studio
    /// must keep light.
    ///
    /// # Errors
    /// Drawing failed, or the studio keeps no light.
    pub fn light(&mut self) -> Result<Captured, PictureError> {
        self.settle()?;
        let world = self.app.world();
        let (Some(capture), Some(device)) = (
            world.get_resource::<Capture>(),
            world.get_resource::<RenderDevice>(),
        ) else {
            return Err(PictureError::Draw("nothing keeps its light".into()));
        };
        capture.read(device).map_err(PictureError::Draw)
    }

    /// Distance of the foreground from the camera's plane, in r_s, at the centre of each pixel of
    /// the current scene, rows from the top; infinite without a foreground. The studio must keep
    /// light.
    ///
    /// # Errors
    /// As [`Studio::light`].
    pub fn depth(&mut self) -> Result<Vec<f32>, PictureError> {
        let scene = self.scene().clone();
        if !scene.probe.enabled {
            let size = self.part.map_or(scene.picture.size(), |part| part.size);
            let pixels = size.as_usizevec2().element_product();
            return Ok(vec![f32::INFINITY; pixels]);
        }
        // A pixel with several samples has several depths, which cannot be copied. The scene is
        // drawn again with one sample.
        let mut single = scene.clone();
        single.probe.antialias = false;
        self.show(&single)?;
        let depth = self
            .light()?
            .depth
            .ok_or(PictureError::Draw("its depth has not been kept".into()))?;
        self.show(&scene)?;
        Ok(depth.into_iter().map(|depth| NEAR_PLANE / depth).collect())
    }
}

/// The scene as it is drawn for a picture of its own size: its cells fill the picture.
#[must_use]
pub fn filled(scene: &Scene) -> Scene {
    let picture = fit(&scene.shown_picture(), scene.picture.size(), u64::MAX);
    Scene {
        picture,
        ..scene.clone()
    }
}

/// Draws one picture of the scene at the given output size. The same scene and size give the same
/// bytes.
///
/// # Errors
/// The size is too large, or drawing failed.
pub fn render(scene: &Scene, size: UVec2) -> Result<Still, PictureError> {
    render_with(scene, size, HeadlessOptions::default())
}

/// Like [`render`], with these options.
///
/// # Errors
/// As [`render`].
pub fn render_with(
    scene: &Scene,
    size: UVec2,
    options: HeadlessOptions,
) -> Result<Still, PictureError> {
    Studio::with_options(scene, size, options)?.picture()
}
