//! The channels that an EXR picture can have in addition to light: the data of its rays, and layers.

use super::layers::Layer;
use glam::{DVec2, Vec3};
use lightfall_core::gpu::passages::{GivenRay, GpuPassage, PassageKernel};
use lightfall_core::gpu::rays::RayKernel;
use lightfall_core::gpu::{Gpu, GpuError, Variant};
use lightfall_core::optics::disk;
use lightfall_core::optics::disk::Profile;
use lightfall_core::optics::trace::{Hit, Trace};
use lightfall_core::scene::{Disk, Scene};
use std::ops::Range;
use std::str::FromStr;

/// A channel: one number per pixel.
#[derive(Clone, Copy, Debug)]
pub struct Channel {
    /// Its name in the file: the layer, a dot, and the component. Each layer is one scalar, or a
    /// vector with the components X, Y and Z, because other programs read nothing else.
    pub name: &'static str,
    /// Its name in files of version 0.1. The part before a dot is its group.
    pub old_name: &'static str,
    /// What it means, with its unit.
    pub about: &'static str,
    pub(super) value: Value,
}

impl Channel {
    /// Whether version 0.1 wrote integers.
    #[must_use]
    pub fn was_count(&self) -> bool {
        matches!(self.value, Value::Count(_))
    }

    /// Whether a word of `--aov` means this channel: `all`, its name, its layer, its old name, or
    /// the group of its old name.
    fn is_meant(&self, word: &str) -> bool {
        let before_dot = |name: &'static str| name.split_once('.').map(|(before, _)| before);
        word == "all"
            || [self.name, self.old_name].contains(&word)
            || [self.name, self.old_name]
                .map(before_dot)
                .contains(&Some(word))
    }
}

/// The source of a channel's numbers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Value {
    /// A number of the ray through the pixel's centre, if it has one.
    Number(fn(&TracedRay) -> Option<f64>),
    /// An integer of that ray.
    Count(fn(&Trace) -> u32),
    /// A number of what the matter with depth does to that ray, if it has one.
    Matter(fn(&GpuPassage) -> Option<f64>),
    /// The foreground's depth.
    Depth,
    /// A layer of the picture's light, which is drawn and not traced ray by ray.
    Layer,
}

/// One of the means of where the light of matter with depth comes from.
fn mean(seen: &GpuPassage, of: usize) -> Option<f64> {
    (seen.luminance > 0.0).then(|| f64::from(seen.means[of]))
}

/// The optical depth of a ray's way.
fn depth(seen: &GpuPassage) -> f64 {
    // No negative zero where nothing absorbs.
    0.0 - f64::from(seen.transmission).ln()
}

/// The trace of a ray, and the disk that it may meet.
pub(super) struct TracedRay<'a> {
    trace: &'a Trace,
    disk: &'a Disk,
    profile: &'a Profile,
}

impl TracedRay<'_> {
    fn hit(&self, which: usize, part: fn(Hit) -> f64) -> Option<f64> {
        self.trace.hits[which].map(part)
    }

    fn delay(&self, which: usize) -> Option<f64> {
        self.trace.hits[which]?.delay
    }

    fn temperature(&self, which: usize) -> Option<f64> {
        self.trace.hits[which].map(|hit| disk::temperature(self.disk, self.profile.flux(hit.r)))
    }
}

macro_rules! channels {
    ($($name:literal $old:literal $kind:ident $value:expr, $about:literal;)*) => {
        [$(Channel { name: $name, old_name: $old, about: $about, value: Value::$kind($value) },)*
         Channel {
             name: "depth.Z",
             old_name: "depth",
             about: "distance of the foreground probe from the camera's plane at the pixel's centre, in r_s; infinite without a probe",
             value: Value::Depth,
         }]
    };
}

/// Every channel in addition to R, G, B and A.
pub const CHANNELS: [Channel; 25] = channels![
    "sky_direction.X" "sky.x" Number |seen| seen.trace.sky.map(|sky| sky.x),
        "x of the unit vector toward the source at infinity, in the hole's frame with the camera at azimuth camera.phi_deg";
    "sky_direction.Y" "sky.y" Number |seen| seen.trace.sky.map(|sky| sky.y), "y of the unit vector toward the source at infinity";
    "sky_direction.Z" "sky.z" Number |seen| seen.trace.sky.map(|sky| sky.z),
        "z of the unit vector toward the source at infinity, along the normal of a disk that is not tilted";
    "hit1_radius.Y" "hit1.r" Number |seen| seen.hit(0, |hit| hit.r),
        "radius of the first crossing of the disk along the backward ray, in r_s";
    "hit1_azimuth.Y" "hit1.phi" Number |seen| seen.hit(0, |hit| hit.phi), "azimuth of the first crossing in the disk, in radians, in (-pi, pi]";
    "hit1_shift.Y" "hit1.g" Number |seen| seen.hit(0, |hit| hit.g), "observed over emitted frequency of light from the first crossing";
    "hit1_temperature.Y" "hit1.T" Number |seen| seen.temperature(0),
        "temperature of the matter at the first crossing, in its own frame, in kelvin, without structure and hot spot; the observer sees g T";
    "hit1_delay.Y" "hit1.t" Number |seen| seen.delay(0),
        "time from the emission at the first crossing to its arrival, in r_s/c; missing for a camera at or inside the horizon";
    "hit2_radius.Y" "hit2.r" Number |seen| seen.hit(1, |hit| hit.r), "radius of the second crossing of the disk, in r_s";
    "hit2_azimuth.Y" "hit2.phi" Number |seen| seen.hit(1, |hit| hit.phi), "azimuth of the second crossing in the disk, in radians, in (-pi, pi]";
    "hit2_shift.Y" "hit2.g" Number |seen| seen.hit(1, |hit| hit.g), "observed over emitted frequency of light from the second crossing";
    "hit2_temperature.Y" "hit2.T" Number |seen| seen.temperature(1),
        "temperature of the matter at the second crossing, in its own frame, in kelvin, without structure and hot spot";
    "hit2_delay.Y" "hit2.t" Number |seen| seen.delay(1), "time from the emission at the second crossing to its arrival, in r_s/c";
    "outcome.Y" "outcome" Count |trace| trace.outcome as u32, "outcome of the backward ray: 0 sky, 1 captured, 2 unfinished";
    "steps.Y" "steps" Count |trace| trace.steps, "number of steps of the method; zero in closed form";
    "residual.Y" "residual" Number |seen| Some(seen.trace.residual),
        "largest normalized residual of the null constraint along the ray; zero in closed form";
    "medium_transmission.Y" "medium.T" Matter |seen| Some(seen.transmission.into()),
        "share of the light from behind that comes through the matter with depth; 1 without any";
    "medium_depth.Y" "medium.tau" Matter |seen| Some(depth(seen)),
        "optical depth of the matter along the ray; a ray ends where it sees nothing behind, and has the depth up to there";
    "medium_radius.Y" "medium.r" Matter |seen| mean(seen, 0),
        "radius from which the light of the matter comes, in r_s: a mean, weighted by luminance";
    "medium_height.Y" "medium.z" Matter |seen| mean(seen, 1),
        "height r cos(theta) above the disk's plane from which the light comes, in r_s: a mean";
    "medium_shift.Y" "medium.g" Matter |seen| mean(seen, 2), "observed over emitted frequency of this light: a mean";
    "medium_delay.Y" "medium.t" Matter |seen| mean(seen, 3).filter(|delay| !delay.is_nan()),
        "time from the emission of this light to its arrival, in r_s/c: a mean; missing for a camera at or inside the horizon";
    "medium_samples.Y" "medium.samples" Matter |seen| Some(seen.samples.into()),
        "places of the matter that the ray asked for their light";
    "medium_error.Y" "medium.error" Matter |seen| Some(seen.error.into()),
        "change of the matter's light with twice the samples, as a share of it";
];

/// A list of channels without duplicates: those of rays, in the order of [`CHANNELS`], and then those of
/// layers.
#[derive(Clone, Debug, Default)]
pub struct Channels {
    list: Vec<Channel>,
    /// The ones among them that only the word `all` means.
    unnamed: Vec<&'static str>,
    layers: Vec<Layer>,
}

impl Channels {
    /// The channels.
    #[must_use]
    pub fn list(&self) -> &[Channel] {
        &self.list
    }

    /// The channels among them whose numbers are those of rays: the first ones.
    #[must_use]
    pub fn of_rays(&self) -> &[Channel] {
        &self.list[..self.list.len() - self.of_layers().len()]
    }

    /// The channels of layers: the last ones.
    #[must_use]
    pub fn of_layers(&self) -> &[Channel] {
        let is_of_layer = |channel: &&Channel| matches!(channel.value, Value::Layer);
        let count = self.list.iter().filter(is_of_layer).count();
        &self.list[self.list.len() - count..]
    }

    /// The layers.
    pub(super) fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// Adds the channels of layers.
    pub(super) fn add_layers(&mut self, layers: impl Iterator<Item = &'static Layer>) {
        for layer in layers {
            self.layers.push(*layer);
            self.list.extend(layer.channels);
        }
    }

    /// The channels of a scene's pictures: `all` means those of matter with depth only where a scene
    /// has such matter.
    #[must_use]
    pub fn of_scene(mut self, scene: &Scene) -> Self {
        let is_idle = |channel: &Channel| {
            let of_matter = matches!(channel.value, Value::Matter(_));
            of_matter && self.unnamed.contains(&channel.name)
        };
        if !scene.has_medium() {
            self.list.retain(|channel| !is_idle(channel));
        }
        self
    }

    /// Whether the depth of the foreground is one of them.
    #[must_use]
    pub fn with_depth(&self) -> bool {
        self.list
            .iter()
            .any(|channel| matches!(channel.value, Value::Depth))
    }
}

impl FromStr for Channels {
    type Err = String;

    /// Reads a list such as `hit1,outcome`: names of channels, layers or groups, or `all`, separated
    /// by commas.
    fn from_str(text: &str) -> Result<Self, String> {
        let names: Vec<&str> = text.split(',').map(str::trim).collect();
        match names
            .iter()
            .find(|name| !CHANNELS.iter().any(|channel| channel.is_meant(name)))
        {
            Some(unknown) => {
                let all = CHANNELS.map(|channel| channel.name).join(", ");
                Err(format!(
                    "there is no channel {unknown:?}; the groups are all, sky, hit1, hit2 and medium, and the channels are {all}"
                ))
            }
            None => {
                let meant = |channel: &Channel, names: &[&str]| {
                    names.iter().any(|name| channel.is_meant(name))
                };
                let named: Vec<&str> = names
                    .iter()
                    .copied()
                    .filter(|name| *name != "all")
                    .collect();
                let list = CHANNELS
                    .into_iter()
                    .filter(|channel| meant(channel, &names));
                let unnamed = CHANNELS.iter().filter(|channel| !meant(channel, &named));
                Ok(Self {
                    list: list.collect(),
                    unnamed: unnamed.map(|channel| channel.name).collect(),
                    layers: Vec::new(),
                })
            }
        }
    }
}

/// Maximum number of rays that are traced at once, which limits the memory of their traces.
const BATCH: usize = 1 << 15;

/// Traces the rays through the pixels of pictures, on another device than the one that draws.
#[derive(Debug)]
pub struct PixelRays {
    gpu: Gpu,
    /// The shaders of the last scene. The next scene often needs the same ones.
    kernel: Option<(Variant, RayKernel)>,
    passage_kernel: Option<(Variant, PassageKernel)>,
}

impl PixelRays {
    /// Opens the device.
    ///
    /// # Errors
    /// There is no device.
    pub fn open() -> Result<Self, GpuError> {
        Ok(Self {
            gpu: Gpu::headless()?,
            kernel: None,
            passage_kernel: None,
        })
    }

    /// The numbers of the channels of rays for the scene's picture, in rows from the top, from the ray
    /// through each pixel's centre, regardless of the foreground. Missing values are NaN. `depth` is the
    /// depth of the foreground, one number per pixel.
    ///
    /// # Errors
    /// The GPU cannot trace the scene, or the device failed.
    pub fn sample(
        &mut self,
        scene: &Scene,
        channels: &Channels,
        depth: &[f32],
    ) -> Result<Vec<Vec<f32>>, GpuError> {
        self.sample_rows(scene, channels, 0..scene.picture.height, depth)
    }

    /// The same for some rows of the picture; `depth` has those rows only.
    ///
    /// # Errors
    /// As [`sample`](Self::sample).
    pub fn sample_rows(
        &mut self,
        scene: &Scene,
        channels: &Channels,
        rows: Range<u32>,
        depth: &[f32],
    ) -> Result<Vec<Vec<f32>>, GpuError> {
        let width = scene.picture.width as usize;
        let [before, end] = [rows.start, rows.end].map(|row| row as usize * width);
        let mut samples = vec![Vec::with_capacity(end - before); channels.of_rays().len()];
        let any = |is: fn(&Value) -> bool| channels.of_rays().iter().any(|c| is(&c.value));
        let traced = any(|value| matches!(value, Value::Number(_) | Value::Count(_)));
        let passed = any(|value| matches!(value, Value::Matter(_)));
        for first in (before..end).step_by(BATCH) {
            let batch = first..end.min(first + BATCH);
            let traces = if traced {
                self.trace(scene, batch.clone())?
            } else {
                Vec::new()
            };
            let passages = if passed {
                self.passages(scene, batch.clone())?
            } else {
                Vec::new()
            };
            let (profile, lit) = (Profile::new(scene), disk::lit(scene));
            let seen = || {
                traces.iter().map(|trace| TracedRay {
                    trace,
                    disk: &lit,
                    profile: &profile,
                })
            };
            for (channel, samples) in channels.of_rays().iter().zip(&mut samples) {
                match channel.value {
                    Value::Number(number) => samples.extend(
                        seen().map(|seen| number(&seen).map_or(f32::NAN, |number| number as f32)),
                    ),
                    Value::Count(count) => {
                        samples.extend(traces.iter().map(|trace| count(trace) as f32));
                    }
                    Value::Matter(number) => {
                        samples.extend(passages.iter().map(|passage| {
                            number(passage).map_or(f32::NAN, |number| number as f32)
                        }))
                    }
                    Value::Depth => {
                        samples.extend(&depth[batch.start - before..batch.end - before]);
                    }
                    // None of the channels of rays.
                    Value::Layer => {}
                }
            }
        }
        Ok(samples)
    }

    /// Traces a range of pixels, numbered along the rows.
    fn trace(&mut self, scene: &Scene, pixels: Range<usize>) -> Result<Vec<Trace>, GpuError> {
        let variant = Variant::rays(scene);
        let kernel = match self.kernel.take() {
            Some((known, kernel)) if known == variant => kernel,
            _ => RayKernel::new(&self.gpu, scene)?,
        };
        let rays: Vec<Vec3> = pixels
            .map(|pixel| direction_at(scene, pixel, DVec2::ZERO))
            .collect();
        let traces = kernel.trace_camera_rays(&self.gpu, scene, &rays);
        self.kernel = Some((variant, kernel));
        traces
    }

    /// What matter with depth does to the rays of a range of pixels, numbered along the rows.
    fn passages(
        &mut self,
        scene: &Scene,
        pixels: Range<usize>,
    ) -> Result<Vec<GpuPassage>, GpuError> {
        if !scene.has_medium() {
            return Ok(vec![GpuPassage::without_matter(); pixels.len()]);
        }
        let variant = Variant::passages(scene, true);
        let kernel = match self.passage_kernel.take() {
            Some((known, kernel)) if known == variant => kernel,
            _ => PassageKernel::of_pixels(&self.gpu, scene)?,
        };
        let rays = pixels.map(|pixel| GivenRay {
            direction: direction_at(scene, pixel, DVec2::ZERO),
            right: direction_at(scene, pixel, DVec2::X),
            below: direction_at(scene, pixel, DVec2::Y),
        });
        let passages = kernel.passages(&self.gpu, scene, rays);
        self.passage_kernel = Some((variant, kernel));
        passages
    }
}

/// The direction of a place beside the centre of a pixel, as (right, up, forward). Pixels are numbered
/// along the rows.
fn direction_at(scene: &Scene, pixel: usize, beside: DVec2) -> Vec3 {
    let width = scene.picture.width as usize;
    let corner = DVec2::new((pixel % width) as f64, (pixel / width) as f64);
    let size = scene.picture.size().as_dvec2();
    scene.camera.looking(corner + 0.5 + beside, size).as_vec3()
}
