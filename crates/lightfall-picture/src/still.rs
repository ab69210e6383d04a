//! Single pictures of scenes, drawn by the window's chain of passes without a window.

use super::PictureError;
use super::headless::{HeadlessOptions, MAX_UPDATES, Output, drawable, headless, update, warm_up};
use bevy::prelude::*;
use bevy::render::gpu_readback::{Readback, ReadbackComplete};
use bevy::render::renderer::RenderDevice;
use lightfall_core::scene::{Frame, Scene, fit};
use lightfall_render::{
    Capture, Captured, Comparison, ComparisonMode, CurrentFrame, CurrentScene, NEAR_PLANE, Pinned,
    ROW_ALIGNMENT,
};

/// A finished picture.
pub struct Still {
    /// Width, in pixels.
    pub width: u32,
    /// Height, in pixels.
    pub height: u32,
    /// 8-bit sRGB, rows from the top, three bytes per pixel.
    pub rgb: Vec<u8>,
}

/// Draws one scene after another at one output size, without a window.
pub struct Studio {
    pub(super) app: App,
    size: UVec2,
}

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
        let mut app = headless(scene, size, options)?;
        app.init_resource::<Finished>();
        let mut studio = Self { app, size };
        studio.settle()?;
        Ok(studio)
    }

    /// Shows a scene from the next frame on.
    ///
    /// # Errors
    /// The scene cannot be drawn.
    pub fn show(&mut self, scene: &Scene) -> Result<(), PictureError> {
        let scene = drawable(scene)?;
        let world = self.app.world_mut();
        world.resource_mut::<CurrentFrame>().0 = Frame::of(&scene);
        world.resource_mut::<CurrentScene>().0 = scene;
        Ok(())
    }

    /// The scene that is shown. Its exposure is the metered one where the exposure is automatic.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        self.app.world().resource::<CurrentScene>().scene()
    }

    /// Compares the scene with the settings of another one from the next frame on, or with nothing.
    pub fn compare(&mut self, with: Option<(&Scene, ComparisonMode)>) {
        self.app.world_mut().resource_mut::<Comparison>().0 =
            with.map(|(scene, mode)| (Pinned::new(scene), mode));
    }

    /// Draws frames until the scene is completely drawn.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn settle(&mut self) -> Result<(), PictureError> {
        warm_up(&mut self.app)
    }

    /// The picture of the next frame.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn picture(&mut self) -> Result<Still, PictureError> {
        read_back(&mut self.app, self.size)
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
            return Ok(vec![
                f32::INFINITY;
                scene.picture.width as usize
                    * scene.picture.height as usize
            ]);
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
    let picture = fit(&scene.picture, scene.picture.size(), u64::MAX);
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

#[derive(Resource, Default)]
struct Finished(Option<Vec<u8>>);

fn read_back(app: &mut App, size: UVec2) -> Result<Still, PictureError> {
    let output = app.world().resource::<Output>().0.clone();
    let reader = app
        .world_mut()
        .spawn(Readback::texture(output))
        .observe(
            |complete: On<ReadbackComplete>, mut finished: ResMut<Finished>| {
                finished.0 = Some(complete.data.clone());
            },
        )
        .id();
    for _ in 0..MAX_UPDATES {
        update(app)?;
        if let Some(bytes) = app.world_mut().resource_mut::<Finished>().0.take() {
            app.world_mut().despawn(reader);
            return Ok(still(size, &bytes));
        }
    }
    Err(PictureError::Draw(
        "it did not arrive from the graphics device".into(),
    ))
}

/// Removes the padding of rows and the alpha channel.
fn still(size: UVec2, bytes: &[u8]) -> Still {
    let row = size.x as usize * 4;
    let padded = if bytes.len() == row * size.y as usize {
        row
    } else {
        row.next_multiple_of(ROW_ALIGNMENT)
    };
    let rgb = bytes
        .chunks(padded)
        .take(size.y as usize)
        .flat_map(|line| line[..row].chunks_exact(4))
        .flat_map(|pixel| [pixel[0], pixel[1], pixel[2]])
        .collect();
    Still {
        width: size.x,
        height: size.y,
        rgb,
    }
}
