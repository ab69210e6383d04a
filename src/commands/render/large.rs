//! Pictures that are drawn in tiles: those too large to be drawn at once, PNGs with 16 bits, and the sides
//! of cubes.

use super::cube::{drawn_at_once, pictures_at_once};
use super::pictures::Pictures;
use crate::commands::cli::{Cells, RenderArgs};
use crate::commands::progress::Progress;
use crate::commands::stop::Stop;
use glam::UVec2;
use lightfall_core::scene::{MAX_PICTURE_SIDE, Projection, Scene};
use lightfall_picture::{
    Codec, Format, HeadlessOptions, MAX_UNTILED_PIXELS, PngBits, Tiles, png_sweeps,
};
use lightfall_platform::log::say;

/// How the pictures of a command line are drawn in tiles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tiling {
    pub(super) tiles: Tiles,
    pub(super) bits: PngBits,
    /// Whether a film is made of their light.
    is_film_of_light: bool,
}

/// Says how pictures of the scene are drawn in tiles; `None` if they are drawn at once. Tiles have no
/// cells, so the scene's are switched off.
pub(super) fn tiling(
    args: &RenderArgs,
    (format, codec): (Format, Option<Codec>),
    scene: &mut Scene,
) -> Result<Option<Tiling>, Stop> {
    let bits = args.bits.as_deref().and_then(PngBits::from_word);
    if let (Some(bits), Format::Apng | Format::Exr) = (bits, format) {
        return Err(Stop::refused(format!(
            "--bits {} is for a picture whose file's name ends in .png",
            bits.word()
        )));
    }
    let is_film_of_light = codec == Some(Codec::Hdr10);
    let is_sharp = !scene.has_cells() && args.shutter.is_none();
    let bits = bits.unwrap_or(if format == Format::Film && is_sharp {
        // The film rounds the levels once more. Blurred pictures have 8 bits.
        PngBits::Sixteen
    } else {
        PngBits::Eight
    });
    let is_cube = scene.camera.projection == Projection::Cube;
    // Of a cube, each side has tiles of its own.
    let size = drawn_at_once(scene).picture.size();
    let is_long = |size: UVec2| size.max_element() > MAX_PICTURE_SIDE;
    if format.holds_sequence() && is_long(scene.picture.size()) {
        let what = if args.size.is_some() {
            "--size"
        } else {
            "picture.width and picture.height"
        };
        return Err(Stop::refused(format!(
            "{what}: the pictures of {} have at most {MAX_PICTURE_SIDE} pixels to a side; numbered .png pictures \
             may be larger",
            format.noun()
        )));
    }
    if format == Format::Apng {
        return Ok(is_cube.then_some(Tiling {
            tiles: Tiles::one(size),
            bits,
            is_film_of_light,
        }));
    }
    let is_long = is_long(size);
    let has_cells = scene.has_cells() && format != Format::Exr;
    let pixels = u64::from(size.x) * u64::from(size.y);
    let is_large = is_long || pixels > MAX_UNTILED_PIXELS && !has_cells;
    if !is_large && !is_cube && (bits == PngBits::Eight || is_film_of_light) {
        return Ok(None);
    }
    if args.timings.is_some() && is_large {
        return Err(Stop::refused(format!(
            "--timings: a picture of {} x {} pixels is drawn in tiles, which are not timed; give a --size of at most \
             {MAX_PICTURE_SIDE} pixels to a side and {MAX_UNTILED_PIXELS} in all",
            size.x, size.y
        )));
    }
    if has_cells {
        let why = if is_long {
            format!("a picture of more than {MAX_PICTURE_SIDE} pixels to a side has no cells")
        } else {
            "a picture with 16 bits has no cells".to_owned()
        };
        if args.scene.cells == Some(Cells::On) {
            return Err(Stop::refused(format!("--cells on: {why}")));
        }
        say(format_args!(
            "lightfall: {why}: every pixel is shown, as with --cells off"
        ));
        scene.picture.bypass = true;
    }
    let tiles = if is_large {
        Tiles::of(size)
    } else {
        Tiles::one(size)
    };
    Ok(Some(Tiling {
        tiles,
        bits,
        is_film_of_light,
    }))
}

impl Tiling {
    /// What the studio does for these pictures. It keeps light for every picture in tiles, because a stop
    /// of a journey may switch bloom on.
    pub(super) fn options(&self, options: HeadlessOptions) -> HeadlessOptions {
        let is_png = !options.light;
        HeadlessOptions {
            light: options.light || self.tiles.count() > 1,
            levels: is_png.then_some(self.bits.top()),
            part: self
                .tiles
                .strips()
                .next()
                .and_then(|mut strip| strip.next()),
            ..options
        }
    }

    /// How often the tiles of each picture are drawn, or those of each side of a cube.
    pub(super) fn sweeps(&self, pictures: &Pictures) -> impl Iterator<Item = usize> {
        pictures.numbers().map(move |number| match pictures.format {
            Format::Png | Format::Film if !self.is_film_of_light => {
                png_sweeps(&drawn_at_once(&pictures.scene_of(number)), &self.tiles)
            }
            _ => 1,
        })
    }

    /// The progress of the pictures: one unit for each tile and sweep.
    pub(super) fn progress(&self, pictures: &Pictures) -> Progress {
        let sweeps: usize = self.sweeps(pictures).sum();
        let units = (sweeps * pictures_at_once(&pictures.scene) * self.tiles.count()) as f64;
        Progress::new("render", units, (0.02 * units).max(1.0))
    }
}
