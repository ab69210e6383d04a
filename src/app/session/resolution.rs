//! Automatic resolution: while something moves, the picture is drawn with as many pixels as hold
//! the frame rate; what stands still is drawn in full. The scene as it is meant is never touched.

use crate::app::session::frame_pacing::FramePacing;
use crate::app::session::window::Preferences;
use crate::app::state::settings::Automatic;
use crate::render::CurrentScene;
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Picture, Scene};

/// The coarsest picture, as a share of each side.
const COARSEST: f64 = 0.25;
/// Shares are multiples of this, so that sizes do not change with every frame.
const STEP: f64 = 1.0 / 16.0;
/// Frames of a movement between two looks at the clock; the first ones still wait for the full
/// picture.
const FRAMES: u32 = 4;
/// Time of a frame, in seconds, that is too long to fly by.
const SLIDE_SHOW: f64 = 0.1;
/// A frame that seems to take longer, in seconds, was none: the machine slept.
const MAX_LENGTH: f64 = 2.0;
/// A frame rate this much better than the wanted one allows a finer picture.
const SPARE: f64 = 1.35;

/// How fine the picture is drawn.
#[derive(Resource, Clone, Debug)]
pub struct Resolution {
    /// Size that is meant.
    full: UVec2,
    /// Cells that are meant.
    grid: UVec2,
    /// Size that is drawn, and cells; as they are meant unless something moves.
    drawn: UVec2,
    cells: UVec2,
    /// Share of each side that held the frame rate.
    share: f64,
    /// Frames and seconds since the share was last looked at.
    counted: (u32, f64),
}

impl Resolution {
    /// As the scene says.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let (full, grid) = sizes(&scene.picture);
        Self {
            full,
            grid,
            drawn: full,
            cells: grid,
            share: 1.0,
            counted: (0, 0.0),
        }
    }

    /// The scene as it is meant, from the one that is drawn.
    #[must_use]
    pub fn meant(&self, drawn: &Scene) -> Scene {
        let mut scene = drawn.clone();
        set_sizes(&mut scene.picture, self.full, self.grid);
        scene
    }

    /// The scene as it is drawn, from one that is meant.
    #[must_use]
    pub fn drawn(&mut self, meant: Drawable) -> Drawable {
        if (self.full, self.grid) != sizes(&meant.picture) {
            *self = Self {
                share: self.share,
                ..Self::new(&meant)
            };
        }
        self.resize(&meant).unwrap_or(meant)
    }

    /// A scene with the sizes that are drawn; none where they are the scene's own.
    fn resize(&self, scene: &Drawable) -> Option<Drawable> {
        if sizes(&scene.picture) == (self.drawn, self.cells) {
            return None;
        }
        let mut resized = scene.scene().clone();
        set_sizes(&mut resized.picture, self.drawn, self.cells);
        Drawable::new(resized)
            .inspect_err(|reason| error_once!("the picture keeps its resolution: {reason}"))
            .ok()
    }

    /// The share at which every cell has one pixel left.
    fn one_pixel_a_cell(&self) -> f64 {
        (self.grid.as_dvec2() / self.full.as_dvec2()).max_element()
    }

    /// Chooses the size for this frame. `share` of a side; the cells stay as they are as long as
    /// each has a pixel.
    fn choose(&mut self, share: f64) {
        let scaled =
            |side: UVec2, share: f64| (side.as_dvec2() * share).round().as_uvec2().max(UVec2::ONE);
        self.drawn = if share >= 1.0 {
            self.full
        } else {
            scaled(self.full, share)
        };
        self.cells = self.grid.min(self.drawn);
        if self.cells != self.grid {
            // Both sides by the same share, or cells would not be square,
            // and by a whole number, or they would not fill what the finer ones fill.
            let fits = (self.grid.as_dvec2() / self.drawn.as_dvec2())
                .max_element()
                .ceil();
            self.cells = scaled(self.grid, 1.0 / fits).min(self.drawn);
        }
    }
}

fn sizes(picture: &Picture) -> (UVec2, UVec2) {
    (
        UVec2::new(picture.width, picture.height),
        UVec2::new(picture.grid_width, picture.grid_height),
    )
}

fn set_sizes(picture: &mut Picture, size: UVec2, grid: UVec2) {
    (picture.width, picture.height) = size.into();
    (picture.grid_width, picture.grid_height) = grid.into();
}

pub(crate) fn plugin(app: &mut App) {
    // Before what prepares the picture in PostUpdate, so that no frame is drawn with the size of
    // the one before.
    app.add_systems(Update, adapt);
}

fn adapt(
    time: Res<Time<Real>>,
    pace: Res<FramePacing>,
    preferences: Res<Preferences>,
    adapter: Option<Res<RenderAdapterInfo>>,
    mut resolution: ResMut<Resolution>,
    mut scene: ResMut<CurrentScene>,
) {
    let settings = &preferences.settings;
    let slow = || {
        adapter.is_some_and(|info| {
            matches!(
                info.device_type,
                wgpu::DeviceType::Cpu | wgpu::DeviceType::IntegratedGpu
            )
        })
    };
    let wanted = match settings.automatic_resolution {
        Automatic::On => true,
        Automatic::Off => false,
        Automatic::Auto => slow(),
    };
    let adapts = wanted && pace.moving;
    if adapts && pace.frames > 1 {
        let (frames, seconds) = &mut resolution.counted;
        (*frames, *seconds) = (
            *frames + 1,
            *seconds + time.delta_secs_f64().min(MAX_LENGTH),
        );
        if *frames >= FRAMES {
            let frame = *seconds / f64::from(*frames);
            resolution.counted = (0, 0.0);
            let share = better(resolution.share, frame * settings.frame_rate);
            // Fewer pixels than cells only where flying would be a slide show.
            let finest = if frame > SLIDE_SHOW || scene.picture.bypass {
                COARSEST
            } else {
                resolution.one_pixel_a_cell()
            };
            resolution.share = share.max(finest);
        }
    } else {
        resolution.counted = (0, 0.0);
    }
    let share = if adapts { resolution.share } else { 1.0 };
    resolution.choose(share);
    if let Some(resized) = resolution.resize(&scene) {
        scene.0 = resized;
    }
}

/// The next share, where frames last `slowness` times as long as they should: time goes with the
/// number of pixels.
fn better(share: f64, slowness: f64) -> f64 {
    let wanted = if slowness > 1.0 {
        share / slowness.sqrt()
    } else if slowness * SPARE < 1.0 {
        share + STEP
    } else {
        share
    };
    ((wanted / STEP).round() * STEP).clamp(COARSEST, 1.0)
}
