//! One picture of a scene, by the very chain of the window, with no window.

use super::PictureError;
use super::headless::{HeadlessOptions, MAX_UPDATES, Output, drawable, headless, update, warm_up};
use crate::render::{AlwaysDraw, Capture, Captured, CurrentScene, NEAR_PLANE, ROW_ALIGNMENT};
use bevy::diagnostic::DiagnosticsStore;
use bevy::prelude::*;
use bevy::render::gpu_readback::{Readback, ReadbackComplete};
use bevy::render::renderer::RenderDevice;
use lightfall_core::scene::Scene;
use std::collections::BTreeMap;
use std::time::Instant;

/// A finished picture.
pub struct Still {
    /// Width, in pixels.
    pub width: u32,
    /// Height, in pixels.
    pub height: u32,
    /// 8-bit sRGB, rows from the top, three bytes a pixel.
    pub rgb: Vec<u8>,
}

/// GPU time of one pass.
#[derive(Clone, Debug, PartialEq)]
pub struct PassTime {
    /// Name of the pass.
    pub pass: String,
    /// Median over the timed frames, in milliseconds.
    pub median_ms: f64,
    /// The same over frames in which nothing changed; zero where the pass did not run in them.
    pub kept_ms: f64,
}

/// The chain without a window, drawing one scene after another at one output size.
pub struct Studio {
    app: App,
    size: UVec2,
}

impl Studio {
    /// Draws a first scene, and can time its passes; later scenes come from the same device and its
    /// compiled passes.
    ///
    /// # Errors
    /// A size the device can't do, or a chain that failed.
    pub fn open(scene: &Scene, size: UVec2) -> Result<Self, PictureError> {
        Self::equipped(
            scene,
            size,
            HeadlessOptions {
                timed: true,
                light: false,
            },
        )
    }

    /// Draws a first scene, equipped for what is to be made of it and those to come.
    ///
    /// # Errors
    /// As [`Studio::open`].
    pub fn equipped(
        scene: &Scene,
        size: UVec2,
        equipment: HeadlessOptions,
    ) -> Result<Self, PictureError> {
        let mut app = headless(scene, size, equipment)?;
        app.init_resource::<Finished>();
        let mut studio = Self { app, size };
        studio.settle()?;
        Ok(studio)
    }

    /// Shows a scene from the next frame on.
    ///
    /// # Errors
    /// A scene that cannot be drawn.
    pub fn show(&mut self, scene: &Scene) -> Result<(), PictureError> {
        self.app.world_mut().resource_mut::<CurrentScene>().0 = drawable(scene)?;
        Ok(())
    }

    /// Draws frames until the scene is drawn whole.
    ///
    /// # Errors
    /// A chain that failed.
    pub fn settle(&mut self) -> Result<(), PictureError> {
        warm_up(&mut self.app)
    }

    /// The picture of the next frame.
    ///
    /// # Errors
    /// A chain that failed.
    pub fn picture(&mut self) -> Result<Still, PictureError> {
        read_back(&mut self.app, self.size)
    }

    /// The linear light that the scene now shown was drawn with, before bloom, exposure and tone
    /// mapping; of a studio that keeps light.
    ///
    /// # Errors
    /// A chain that failed, or a studio that keeps no light.
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

    /// Distance of the foreground from the camera's plane, in r_s, at the middle of each pixel of
    /// the scene now shown, rows from the top; infinite where there is none. Of a studio that keeps
    /// light.
    ///
    /// # Errors
    /// As [`Studio::light`].
    pub fn depth(&mut self) -> Result<Vec<f32>, PictureError> {
        let scene = self.app.world().resource::<CurrentScene>().scene().clone();
        if !scene.probe.enabled {
            return Ok(vec![
                f32::INFINITY;
                scene.picture.width as usize
                    * scene.picture.height as usize
            ]);
        }
        // A pixel of several samples has several depths, which no device copies: it is drawn again
        // with one.
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

    /// Draws the scene `frames` more times to tell each pass's GPU time, and as many frames in
    /// which nothing changes. A device without timestamps gives an empty list.
    ///
    /// # Errors
    /// A chain that failed.
    pub fn time(&mut self, frames: usize) -> Result<Vec<PassTime>, PictureError> {
        self.app.world_mut().resource_mut::<AlwaysDraw>().0 = true;
        let drawn = medians(&mut self.app, frames)?;
        self.app.world_mut().resource_mut::<AlwaysDraw>().0 = false;
        let kept = medians(&mut self.app, frames)?;
        let times = drawn.into_iter().map(|(pass, median_ms)| {
            let kept_ms = kept.get(&pass).copied().unwrap_or_default();
            PassTime {
                pass,
                median_ms,
                kept_ms,
            }
        });
        Ok(times.collect())
    }
}

/// Draws one picture of the scene at the given output size. The same scene and size give the same
/// bytes.
///
/// # Errors
/// A size the device can't do, or a chain that failed.
pub fn render(scene: &Scene, size: UVec2) -> Result<Still, PictureError> {
    Studio::equipped(scene, size, HeadlessOptions::default())?.picture()
}

/// Like [`render`], with the GPU time of each pass, see [`Studio::time`].
///
/// # Errors
/// As [`render`].
pub fn render_timed(
    scene: &Scene,
    size: UVec2,
    frames: usize,
) -> Result<(Still, Vec<PassTime>), PictureError> {
    let mut studio = Studio::open(scene, size)?;
    Ok((studio.picture()?, studio.time(frames)?))
}

/// Frames until what the device measured has arrived.
const LATEST_MEASUREMENT: usize = 6;

/// Median GPU time of each pass that runs in the next frames, in milliseconds.
fn medians(app: &mut App, frames: usize) -> Result<BTreeMap<String, f64>, PictureError> {
    for _ in 0..LATEST_MEASUREMENT {
        update(app)?;
    }
    let mut samples: BTreeMap<String, Vec<f64>> = default();
    for _ in 0..frames {
        let begin = Instant::now();
        update(app)?;
        for diagnostic in app.world().resource::<DiagnosticsStore>().iter() {
            let path = diagnostic.path().as_str();
            let pass = path
                .strip_prefix("render/")
                .and_then(|path| path.strip_suffix("/elapsed_gpu"));
            // What a pass took when it last ran stays there.
            let fresh = diagnostic
                .measurement()
                .filter(|measurement| measurement.time >= begin);
            if let (Some(pass), Some(measurement)) = (pass, fresh) {
                samples
                    .entry(pass.into())
                    .or_default()
                    .push(measurement.value);
            }
        }
    }
    let median = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    Ok(samples
        .into_iter()
        .map(|(pass, values)| (pass, median(values)))
        .collect())
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

/// Drops the padding of rows and the alpha channel.
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
