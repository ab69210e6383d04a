//! Pictures of linear light as OpenEXR files, with the data of their rays in
//! [`CHANNELS`](super::CHANNELS).

use super::exr_form::{ChannelNames, ExrForm, MissingValues, Transparent};
use super::file::PictureError;
use super::layers::coverage;
use super::{Channels, exr_header};
use exr::meta::attribute::{Chromaticities, EnvironmentMap};
use exr::prelude::*;
use glam::UVec2;
use lightfall_core::optics::photometry::DISK_HDR_SCALE;
use lightfall_core::scene::{Projection, Scene};
use lightfall_platform::storage::{PictureRecord, header_text, preset_pieces, write_atomically};
use lightfall_render::Captured;
use std::io::Cursor;
use std::path::Path;

/// The meaning of the light's own channels, by name.
fn about_light(transparent: Option<Transparent>) -> [(&'static str, String); 4] {
    let about = |part: &str| {
        format!(
            "linear {part}, primaries of Rec. 709, before bloom, exposure and tone mapping; white paper is 1, the disk \
             {DISK_HDR_SCALE} disk.brightness F g^4 C(gT): F relative flux, C colour of a black body per flux, luminance 1 at \
             6500 K (docs/PICTURES.md)"
        )
    };
    let opacity = match transparent {
        None => {
            "the share of the pixel within a fisheye picture's circle, by which RGB is multiplied; else 1 everywhere, \
             because dark things hide what is behind them"
        }
        Some(Transparent::Sky) => {
            "the share of the pixel's rays that do not end at the sky, whose light RGB leaves out; RGB is multiplied by it \
             (premultiplied)"
        }
        Some(Transparent::Hole) => {
            "the share of the pixel's rays that do not end in the hole; RGB is multiplied by it (premultiplied)"
        }
    };
    [
        ("R", about("red")),
        ("G", about("green")),
        ("B", about("blue")),
        ("A", opacity.into()),
    ]
}

/// A picture of linear light.
#[derive(Clone, Debug)]
pub struct Linear<'a> {
    /// The scene it shows.
    pub scene: &'a Scene,
    /// Its record.
    pub record: PictureRecord,
    /// Its light, or that of some of its rows.
    pub light: Captured,
    /// The row of the whole picture with which the light begins.
    pub first_row: u32,
    /// The channels of its rays.
    pub channels: &'a Channels,
    /// The numbers of those channels.
    pub samples: Vec<Vec<f32>>,
    /// The form of the file.
    pub form: ExrForm,
    /// The revision of the program, if it is known.
    pub commit: Option<&'a str>,
    /// Frames per second, if the picture is part of a sequence.
    pub fps: Option<f64>,
}

/// Writes an EXR picture: half floats for light, floats for the rest. The same picture gives the same
/// bytes. The file appears under its name only when it is complete.
///
/// # Errors
/// The encoding failed, or the file cannot be written.
pub fn write_exr(path: &Path, picture: Linear) -> std::result::Result<(), PictureError> {
    let size = picture.light.size;
    let image = Image {
        attributes: file_attributes(size),
        layer_data: layer(picture, size),
    };
    // The file is encoded in memory and written at once, so that an interruption leaves no partial
    // file.
    let mut bytes = Vec::new();
    image
        .write()
        .to_buffered(Cursor::new(&mut bytes))
        .map_err(|error| PictureError::encode(path, &error))?;
    // The encoder keeps attributes in a hash map, so their order would differ in every run.
    exr_header::sort_attributes(&mut bytes)
        .ok_or_else(|| PictureError::encode(path, &"its header cannot be read"))?;
    Ok(write_atomically(path, &bytes)?)
}

/// The attributes of the file of a picture of this size.
pub(super) fn file_attributes(size: UVec2) -> ImageAttributes {
    ImageAttributes {
        chromaticities: Some(rec_709()),
        ..ImageAttributes::with_size(Vec2(size.x as usize, size.y as usize))
    }
}

/// The only layer of the file of a picture of this size.
pub(super) fn layer(picture: Linear, size: UVec2) -> Layer<AnyChannels<FlatSamples>> {
    Layer {
        size: Vec2(size.x as usize, size.y as usize),
        attributes: attributes(&picture),
        encoding: Encoding {
            compression: picture.form.compression.method(),
            blocks: Blocks::ScanLines,
            line_order: LineOrder::Increasing,
        },
        channel_data: channels(picture),
    }
}

impl Linear<'_> {
    /// The same picture with other rows, from `first_row` on.
    pub(super) fn with_rows(
        &self,
        first_row: u32,
        light: Captured,
        samples: Vec<Vec<f32>>,
    ) -> Self {
        Self {
            record: self.record.clone(),
            light,
            first_row,
            samples,
            ..*self
        }
    }

    /// The same picture without rows.
    pub(super) fn without_rows(&self) -> Self {
        self.with_rows(
            0,
            Captured::empty(),
            vec![Vec::new(); self.channels.list().len()],
        )
    }
}

fn channels(picture: Linear) -> AnyChannels<FlatSamples> {
    let rows = (UVec2::new(0, picture.first_row), picture.light.size.x);
    let light = ["R", "G", "B", "A"]
        .into_iter()
        .enumerate()
        .map(|(i, name)| {
            let value = |(number, pixel): (usize, &[u16; 4])| {
                let own = f16::from_bits(pixel[i]);
                let share = || coverage(picture.scene, rows, number);
                match (name, picture.form.transparent) {
                    ("A", None) => f16::from_f64(share()),
                    ("A", Some(_)) => f16::from_f64(share() * own.to_f64()),
                    _ => own,
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
            let name = picture.form.names.of(channel);
            let was_count = picture.form.names == ChannelNames::Version01 && channel.was_count();
            let samples = match picture.form.missing {
                _ if was_count => {
                    FlatSamples::U32(samples.into_iter().map(|count| count as u32).collect())
                }
                MissingValues::Keep => FlatSamples::F32(samples),
                MissingValues::Zero => FlatSamples::F32(samples.into_iter().map(present).collect()),
            };
            AnyChannel::new(name, samples)
        });
    AnyChannels::sort(light.into_iter().chain(rest).collect())
}

/// The number, or zero in place of NaN.
fn present(number: f32) -> f32 {
    if number.is_nan() { 0.0 } else { number }
}

fn attributes(picture: &Linear) -> LayerAttributes {
    let version = env!("CARGO_PKG_VERSION");
    let units = picture
        .channels
        .list()
        .iter()
        .map(|channel| (picture.form.names.of(channel), channel.about.to_owned()));
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
        about_light(picture.form.transparent)
            .into_iter()
            .chain(units)
            .map(|(name, about)| (format!("lightfall.unit.{name}"), about)),
    );
    // The version of the channels' names.
    let names = AttributeValue::I32(match picture.form.names {
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
            .map(|(name, value)| (name, AttributeValue::Text(text(header_text(&value)))))
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
