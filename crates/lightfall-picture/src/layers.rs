//! The layers of a picture's light: what the sky, the stars, the disk, matter with depth and the probe add
//! to a pixel, and their shares of it. Each is a picture of its own, drawn with the rays of the whole one.

use super::channels::Value;
use super::exr_form::{ExrForm, Transparent};
use super::{Channel, Channels, PictureError, Studio};
use exr::prelude::f16;
use glam::{DVec2, UVec2};
use lightfall_core::gpu::Layers;
use lightfall_core::scene::{Part, Scene, SkyMode};

/// Red, green, blue and the share of a pixel, for each pixel.
type Pixels = Vec<[f32; 4]>;

/// A layer, as an EXR picture can hold it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layer {
    source: Source,
    /// Its channels: red, green, blue and its share, or its share alone.
    pub(super) channels: &'static [Channel],
    /// Whether a scene has it.
    is_in: fn(&Scene) -> bool,
}

/// Where a layer comes from.
#[derive(Clone, Copy, Debug)]
enum Source {
    /// Traced light.
    Traced(Layers),
    /// The foreground, in front of traced light.
    Foreground,
}

macro_rules! light {
    ($name:literal, $what:literal) => {
        &[
            light!($name, ".R", "linear red of ", $what),
            light!($name, ".G", "linear green of ", $what),
            light!($name, ".B", "linear blue of ", $what),
            light!($name, ".A", "share of the pixel's rays that end at ", $what),
        ]
    };
    ($name:literal, $component:literal, $part:literal, $what:literal) => {
        Channel {
            name: concat!($name, $component),
            old_name: concat!($name, $component),
            about: concat!($part, $what),
            value: Value::Layer,
        }
    };
}

/// The number of layers.
const COUNT: usize = 7;

/// The layers, in the order in which they are drawn. All light of them is that of the picture, and the
/// shares of all of them make a whole.
static LAYERS: [Layer; COUNT] = [
    Layer {
        source: Source::Traced(Layers::SKY),
        channels: light!("light_sky", "the sky, without stars that are points"),
        is_in: |scene| scene.sky.mode != SkyMode::Off,
    },
    Layer {
        source: Source::Traced(Layers::STARS),
        channels: light!("light_stars", "stars that are points"),
        is_in: |scene| scene.sky.has_star_points(),
    },
    Layer {
        source: Source::Traced(Layers::HIT1),
        channels: light!("light_hit1", "the first crossing of the disk"),
        is_in: has_thin_disk,
    },
    Layer {
        source: Source::Traced(Layers::HIT2),
        channels: light!("light_hit2", "the second crossing of the disk"),
        is_in: has_thin_disk,
    },
    Layer {
        source: Source::Traced(Layers::VOLUME),
        channels: light!("light_volume", "matter with depth: a thick disk, and jets"),
        is_in: Scene::has_medium,
    },
    Layer {
        source: Source::Foreground,
        channels: light!("light_probe", "the foreground probe"),
        is_in: |scene| scene.probe.enabled,
    },
    Layer {
        source: Source::Traced(Layers::HOLE),
        channels: &[Channel {
            name: "cover_hole.Y",
            old_name: "cover_hole.Y",
            about: "share of the pixel's rays that end in the hole, or at no source because the method gave up",
            value: Value::Layer,
        }],
        is_in: |_| true,
    },
];

fn has_thin_disk(scene: &Scene) -> bool {
    scene.disk.enabled && !scene.has_thick_disk()
}

impl Channels {
    /// These channels and those of all layers that any of the scenes has.
    #[must_use]
    pub fn with_layers_of(mut self, scenes: impl IntoIterator<Item = Scene>) -> Self {
        let mut is_there = [false; COUNT];
        for scene in scenes {
            for (there, layer) in is_there.iter_mut().zip(&LAYERS) {
                *there |= (layer.is_in)(&scene);
            }
        }
        let layers = LAYERS.iter().zip(is_there).filter(|(_, there)| *there);
        self.add_layers(layers.map(|(layer, _)| layer));
        self
    }

    /// The share of the hole alone.
    pub(super) fn of_hole() -> Self {
        let mut channels = Self::default();
        channels.add_layers(LAYERS.iter().skip(COUNT - 1));
        channels
    }

    /// What is drawn for the picture's own light: `None` if the picture's own shader draws it.
    #[must_use]
    pub fn drawn_layers(&self, form: ExrForm) -> Option<Layers> {
        match form.transparent {
            Some(Transparent::Sky) => Some(Layers::ALL.without(Layers::SKY).without(Layers::STARS)),
            Some(Transparent::Hole) => Some(Layers::ALL.without(Layers::HOLE)),
            // By the shader of the layers, so that they add up to it, but for the rounding.
            None => (!self.layers().is_empty()).then_some(Layers::ALL),
        }
    }
}

impl Studio {
    /// Draws the layers of what is shown, and returns the numbers of their channels, rows from the top. The
    /// studio must keep light.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn layers(&mut self, channels: &Channels) -> Result<Vec<Vec<f32>>, PictureError> {
        if channels.layers().is_empty() {
            return Ok(Vec::new());
        }
        let shown = self.shown_layers();
        let scene = self.scene().clone();
        let foreground = if scene.probe.enabled {
            Some(self.layer_pixels(&scene, Layers::NONE)?)
        } else {
            None
        };
        let mut numbers = Vec::new();
        for layer in channels.layers() {
            let pixels = match (layer.source, &foreground) {
                (Source::Traced(layers), _) => {
                    let mut pixels = self.layer_pixels(&scene, layers)?;
                    // The foreground is drawn before what is traced, and so is in every layer.
                    for (pixel, before) in pixels.iter_mut().zip(foreground.iter().flatten()) {
                        for (value, before) in pixel.iter_mut().zip(before) {
                            *value -= before;
                        }
                    }
                    pixels
                }
                (Source::Foreground, Some(foreground)) => foreground.clone(),
                (Source::Foreground, None) => {
                    let size = self.shown_part(&scene).size.as_usizevec2();
                    vec![[0.0; 4]; size.element_product()]
                }
            };
            // A layer of one channel is the share alone.
            let first = 4 - layer.channels.len();
            let component =
                |at: usize| -> Vec<f32> { pixels.iter().map(|pixel| pixel[at]).collect() };
            numbers.extend((first..4).map(component));
        }
        self.show_layers(shown);
        Ok(numbers)
    }

    /// Draws some layers of the scene that is shown. Light and shares are those within the circle of a
    /// fisheye picture.
    fn layer_pixels(&mut self, scene: &Scene, layers: Layers) -> Result<Pixels, PictureError> {
        self.show_layers(Some(layers));
        let light = self.light()?;
        let rows = (self.shown_part(scene).origin, light.size.x);
        let pixels = light.rgba.iter().enumerate().map(|(at, pixel)| {
            let pixel = pixel.map(|bits| f16::from_bits(bits).to_f32());
            let [red, green, blue, share] = pixel;
            [red, green, blue, coverage(scene, rows, at) as f32 * share]
        });
        Ok(pixels.collect())
    }

    /// The part of a scene's picture that is shown.
    fn shown_part(&self, scene: &Scene) -> Part {
        self.part.unwrap_or(Part::whole(scene.picture.size()))
    }
}

/// The share of a pixel that lies within the circle of a fisheye picture. `at` counts the pixels along rows of
/// so many columns, which begin at `origin` in the whole picture.
pub(super) fn coverage(scene: &Scene, (origin, columns): (UVec2, u32), at: usize) -> f64 {
    let columns = columns.max(1) as usize;
    let within = DVec2::new((at % columns) as f64, (at / columns) as f64);
    let place = origin.as_dvec2() + within + 0.5;
    scene
        .camera
        .coverage(place, scene.picture.size().as_dvec2())
}
