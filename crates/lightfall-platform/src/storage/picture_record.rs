//! The record inside a picture: the preset that drew it, and what else decides its pixels.

use super::embedded_preset::{MAX_PIECE_BYTES, STARS_KEY, embedded_text};
use super::files::read;
use super::panorama::panorama;
use super::scene_source::MAX_PRESET_BYTES;
use bevy::render::renderer::RenderAdapterInfo;
use lightfall_core::gpu::{AdapterName, driver};
use lightfall_core::optics::sky_picture::SkyPicture;
use lightfall_core::optics::stars::Catalogue;
use lightfall_core::scene::{Output, Scene, presets};
use std::ffi::OsStr;
use std::path::Path;

/// The name of the text about the picture that the sky shows.
const SKY_KEY: &str = "lightfall.sky";

/// What stands in front of the hash in the texts about stars and the sky.
const HASH: &str = ", sha256 ";

/// What a picture file says of how its picture was drawn.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PictureRecord {
    /// The scene as a preset.
    pub preset: String,
    /// The texts beside the preset, with their names: the version of the program, the list of stars
    /// and the picture of the sky if the picture shows one, the graphics adapter and its driver. None
    /// is longer than 255 bytes.
    pub texts: Vec<(&'static str, String)>,
    /// For viewers of panoramas, in XMP, if the picture is one.
    pub panorama: Option<String>,
}

impl PictureRecord {
    /// The record of a picture of this scene, drawn on this adapter with these stars.
    #[must_use]
    pub fn new(scene: &Scene, stars: &Catalogue, adapter: Option<&RenderAdapterInfo>) -> Self {
        let file = stars.file.as_ref().filter(|_| shows_stars(scene));
        let stars = file.map(|file| {
            let count = match stars.stars().len() {
                1 => "1 star".to_owned(),
                count => format!("{count} stars"),
            };
            named(&file.name, &format!(", {count}{HASH}{}", file.sha256))
        });
        let sky = SkyPicture::of(scene).ok().flatten();
        let sky = sky.filter(|_| scene.view.shows_light()).map(|sky| {
            let [width, height] = sky.size;
            let rest = format!(", {width}x{height}{HASH}{}", sky.sha256);
            named(&sky.name, &rest)
        });
        let texts = [
            ("lightfall.version", Some(env!("CARGO_PKG_VERSION").into())),
            (STARS_KEY, stars),
            (SKY_KEY, sky),
            (
                "lightfall.adapter",
                adapter.map(|info| AdapterName::of(info).to_string()),
            ),
            ("lightfall.driver", adapter.map(|info| driver(info))),
        ];
        let kept = |(key, text): (_, Option<String>)| {
            let text = text.filter(|text| !text.is_empty())?;
            Some((key, start(&text, MAX_PIECE_BYTES).to_owned()))
        };
        Self {
            preset: scene.to_preset(),
            texts: texts.into_iter().filter_map(kept).collect(),
            panorama: panorama(scene),
        }
    }
}

/// Whether stars of the catalogue are in the scene's picture.
fn shows_stars(scene: &Scene) -> bool {
    scene.idle("sky.magnitude_limit", Output::Still).is_none()
}

/// The name of a file and the rest of the text about it, no longer than a header can hold.
fn named(name: &str, rest: &str) -> String {
    let name = name.replace(char::is_control, "\u{fffd}");
    format!("{}{rest}", start(&name, MAX_PIECE_BYTES - rest.len()))
}

/// The first bytes of a text, at most this number.
fn start(text: &str, max_bytes: usize) -> &str {
    &text[..text.floor_char_boundary(max_bytes)]
}

/// A sentence about a picture that was drawn with a list of stars, if `given` is not this list and
/// `scene`, which the picture holds, shows stars. `None` for any other file and for the name of a
/// built-in preset.
#[must_use]
pub fn missing_stars(picture: &OsStr, scene: &Scene, given: &Catalogue) -> Option<String> {
    let path = Path::new(picture);
    let is_built_in = picture.to_str().and_then(presets::find).is_some();
    // A pipe would wait for ever when it is read a second time.
    if is_built_in || !shows_stars(scene) || !path.is_file() {
        return None;
    }
    let text = embedded_text(&read(path, MAX_PRESET_BYTES).ok()?, STARS_KEY)?;
    let (list, sha256) = text.rsplit_once(HASH)?;
    let (name, count) = list.rsplit_once(", ")?;
    let is_given = given
        .file
        .as_ref()
        .is_some_and(|file| file.sha256 == sha256);
    (!is_given && !text.contains(char::is_control)).then(|| {
        format!(
            "{} was drawn with the stars of {name} ({count}, sha256 {}…): give them with --stars {name}",
            path.display(),
            start(sha256, 8)
        )
    })
}
