//! Pictures of linear light as OpenEXR files, with the data of their rays in
//! [`CHANNELS`](super::CHANNELS).

use super::file::PictureError;
use super::{Channel, Channels, exr_header};
use exr::meta::attribute::{Chromaticities, EnvironmentMap};
use exr::prelude::*;
use glam::DVec2;
use lightfall_core::scene::{Projection, Scene};
use lightfall_core::words;
use lightfall_platform::storage::{PictureRecord, preset_pieces, write_atomically};
use lightfall_render::Captured;
use std::io::Cursor;
use std::path::Path;

/// The meaning of the light's own channels.
const LIGHT: [(&str, &str); 2] = [
    (
        "RGB",
        "linear light with the primaries of Rec. 709, before exposure, bloom and tone mapping; white paper is 1",
    ),
    (
        "A",
        "the share of the pixel within a fisheye picture's circle, by which RGB is multiplied; else 1 everywhere, because \
         dark things hide what is behind them",
    ),
];

words! {
    /// The names of the channels in an EXR file.
    pub enum ChannelNames {
        /// One scalar or vector per layer, as in `hit1_radius.Y`.
        Layers = "layers",
        /// Those of version 0.1, as in `hit1.r`, which Blender and Krita do not read.
        Version01 = "0.1",
    }
}

impl ChannelNames {
    /// The name of a channel in the file.
    fn of(self, channel: &Channel) -> &'static str {
        match self {
            Self::Layers => channel.name,
            Self::Version01 => channel.old_name,
        }
    }
}

/// A picture of linear light.
#[derive(Clone, Debug)]
pub struct Linear<'a> {
    /// The scene it shows.
    pub scene: &'a Scene,
    /// Its record.
    pub record: PictureRecord,
    /// Its light.
    pub light: Captured,
    /// The channels of its rays.
    pub channels: &'a Channels,
    /// The numbers of those channels.
    pub samples: Vec<Vec<f32>>,
    /// The channels' names in the file.
    pub names: ChannelNames,
    /// The revision of the program, if it is known.
    pub commit: Option<&'a str>,
    /// Frames per second, if the picture is part of a sequence.
    pub fps: Option<f64>,
}

/// Writes an EXR picture: half floats for light, floats for the rest, with lossless compression. The
/// same picture gives the same bytes. The file appears under its name only when it is complete.
///
/// # Errors
/// The encoding failed, or the file cannot be written.
pub fn write_exr(path: &Path, picture: Linear) -> std::result::Result<(), PictureError> {
    let size = Vec2(picture.light.size.x as usize, picture.light.size.y as usize);
    let attributes = attributes(&picture);
    let image = Image {
        attributes: ImageAttributes {
            chromaticities: Some(rec_709()),
            ..ImageAttributes::with_size(size)
        },
        layer_data: Layer {
            size,
            attributes,
            encoding: Encoding {
                compression: Compression::ZIP16,
                blocks: Blocks::ScanLines,
                line_order: LineOrder::Increasing,
            },
            channel_data: channels(picture),
        },
    };
    let fault = |reason: String| PictureError::Encode {
        path: path.into(),
        reason,
    };
    // The file is encoded in memory and written at once, so that an interruption leaves no partial
    // file.
    let mut bytes = Vec::new();
    image
        .write()
        .to_buffered(Cursor::new(&mut bytes))
        .map_err(|error| fault(error.to_string()))?;
    // The encoder keeps attributes in a hash map, so their order would differ in every run.
    exr_header::sort_attributes(&mut bytes)
        .ok_or_else(|| fault("its header cannot be read".into()))?;
    Ok(write_atomically(path, &bytes)?)
}

fn channels(picture: Linear) -> AnyChannels<FlatSamples> {
    let size = picture.light.size;
    let coverage = |number: usize| {
        let [x, y] = [number % size.x as usize, number / size.x as usize].map(|i| i as f64 + 0.5);
        let camera = &picture.scene.camera;
        f16::from_f64(camera.coverage(DVec2::new(x, y), size.as_dvec2()))
    };
    let light = ["R", "G", "B", "A"]
        .into_iter()
        .enumerate()
        .map(|(i, name)| {
            let value = |(number, pixel): (usize, &[u16; 4])| {
                if name == "A" {
                    coverage(number)
                } else {
                    f16::from_bits(pixel[i])
                }
            };
            let values = picture.light.rgba.iter().enumerate().map(value);
            AnyChannel::new(name, FlatSamples::F16(values.collect()))
        })
        .collect::<Vec<_>>();
    let rest = picture
        .channels
        .list()
        .iter()
        .zip(picture.samples)
        .map(|(channel, samples)| {
            let name = picture.names.of(channel);
            let samples = if picture.names == ChannelNames::Version01 && channel.was_count() {
                FlatSamples::U32(samples.into_iter().map(|count| count as u32).collect())
            } else {
                FlatSamples::F32(samples)
            };
            AnyChannel::new(name, samples)
        });
    AnyChannels::sort(light.into_iter().chain(rest).collect())
}

fn attributes(picture: &Linear) -> LayerAttributes {
    let version = env!("CARGO_PKG_VERSION");
    let units = picture
        .channels
        .list()
        .iter()
        .map(|channel| (picture.names.of(channel), channel.about));
    let method = method(picture.scene).to_owned();
    let mut texts = vec![("lightfall.method".to_owned(), method)];
    let beside_preset = picture.record.texts.iter();
    texts.extend(beside_preset.map(|(name, text)| ((*name).to_owned(), text.clone())));
    texts.extend(
        picture
            .commit
            .map(|commit| ("lightfall.commit".into(), commit.into())),
    );
    texts.extend(preset_pieces(&picture.record.preset));
    texts.extend(
        LIGHT
            .into_iter()
            .chain(units)
            .map(|(name, about)| (format!("lightfall.unit.{name}"), about.to_owned())),
    );
    // The version of the channels' names.
    let names = AttributeValue::I32(match picture.names {
        ChannelNames::Layers => 2,
        ChannelNames::Version01 => 1,
    });
    LayerAttributes {
        software_name: Some(text(&format!("lightfall {version}"))),
        environment_map: match picture.scene.camera.projection {
            Projection::Equirectangular => Some(EnvironmentMap::LatitudeLongitude),
            Projection::Cube => Some(EnvironmentMap::Cube),
            Projection::Perspective | Projection::Fisheye => None,
        },
        wrap_mode_name: (picture.scene.camera.projection == Projection::Equirectangular)
            .then(|| text("periodic,clamp")),
        frames_per_second: picture.fps.map(|fps| ((fps * 1000.0).round() as i32, 1000)),
        other: texts
            .into_iter()
            .map(|(name, value)| (name, AttributeValue::Text(text(&value))))
            .chain([("lightfall.channels".to_owned(), names)])
            .map(|(name, value)| (Text::from(name.as_str()), value))
            .collect(),
        ..LayerAttributes::default()
    }
}

/// A header text in UTF-8, which readers expect. The crate's own conversion accepts Latin-1 only.
fn text(text: &str) -> Text {
    Text::from_slice_unchecked(text.as_bytes())
}

/// The method that traced the light, with `auto` resolved.
fn method(scene: &Scene) -> &'static str {
    if scene.effects.lensing {
        scene.resolved_method().word()
    } else {
        "straight lines, without lensing"
    }
}

/// The primaries of Rec. 709 and sRGB with white D65 (Rec. ITU-R BT.709, item 1.4).
fn rec_709() -> Chromaticities {
    Chromaticities {
        red: Vec2(0.64, 0.33),
        green: Vec2(0.30, 0.60),
        blue: Vec2(0.15, 0.06),
        white: Vec2(0.3127, 0.3290),
    }
}
