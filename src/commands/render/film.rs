//! Films of the pictures: checked before they are drawn, and given to ffmpeg one by one.

use super::large::Tiling;
use crate::commands::cli::{Cells, FilmArgs, RenderArgs, first_given};
use crate::commands::stop::Stop;
use lightfall_core::optics::lut::Look;
use lightfall_core::scene::{Projection, Scene};
use lightfall_picture as picture;
use lightfall_picture::{
    Captured, Channels, Codec, Container, Ffmpeg, Film, FilmForm, Format, LargePicture,
    PictureError, PngBits, Still, Studio,
};
use lightfall_platform::log::say;
use std::path::Path;

/// The codec of a film at `path`, which its name and the options decide.
pub(in crate::commands) fn codec_of(path: &Path, args: &FilmArgs) -> Result<Codec, Stop> {
    let asked = args.codec.as_deref().and_then(Codec::from_word);
    let Some(container) = Container::of(path) else {
        return Err(Stop::refused(format!(
            "{}: the name of a film must end in .mp4, .mov or .webm",
            path.display()
        )));
    };
    let codecs = container.codecs();
    match asked {
        Some(codec) if !codecs.contains(&codec) => {
            let words: Vec<_> = codecs.iter().map(|codec| codec.word()).collect();
            Err(Stop::refused(format!(
                "--codec {}: a .{} can hold {}",
                codec.word(),
                container.word(),
                words.join(", ")
            )))
        }
        Some(codec) => Ok(codec),
        None => Ok(codecs[0]),
    }
}

/// The codec of the film that the options ask for, and ffmpeg, which has it; `None` if the file is none. HDR10
/// shows light itself, so the scene's cells are switched off for it.
pub(super) fn codec(
    args: &RenderArgs,
    format: Format,
    scene: &mut Scene,
) -> Result<Option<(Codec, Ffmpeg)>, Stop> {
    if format != Format::Film {
        let given = [
            ("--codec", args.film.codec.is_some()),
            ("--ffmpeg", args.film.ffmpeg.is_some()),
        ];
        return match first_given(given) {
            Some(option) => Err(Stop::refused(format!(
                "{option} is for a film: the file's name must end in .mp4, .mov or .webm"
            ))),
            None => Ok(None),
        };
    }
    let codec = codec_of(&args.out, &args.film)?;
    let size = scene.picture.size();
    if scene.camera.projection == Projection::Equirectangular && (size % 2).element_sum() > 0 {
        return Err(Stop::refused(format!(
            "--size: a film of the whole sky has even sides, and not {}x{}",
            size.x, size.y
        )));
    }
    if codec == Codec::Hdr10 {
        if scene.camera.projection == Projection::Cube {
            return Err(Stop::refused(
                "--codec hdr10: a film of the sides of a cube has no HDR; --codec h264 has the same pictures",
            ));
        }
        if args.bits.is_some() {
            return Err(Stop::refused("--bits: a film in HDR10 has ten bits"));
        }
        if scene.has_cells() {
            if args.scene.cells == Some(Cells::On) {
                return Err(Stop::refused("--cells on: a film in HDR10 has no cells"));
            }
            scene.picture.bypass = true;
        }
        if scene.picture.bloom > 0.0 {
            say("lightfall: a film in HDR10 shows every pixel, and has no bloom");
        }
    }
    let ffmpeg = Ffmpeg::find(args.film.ffmpeg.as_deref(), codec)?;
    Ok(Some((codec, ffmpeg)))
}

/// Films the pictures of a command line.
pub(super) struct FilmMaker {
    form: FilmForm,
    ffmpeg: Ffmpeg,
    /// What is made of light; `None` where the passes make levels.
    look: Option<Look>,
    /// Begun with the first picture.
    film: Option<Film>,
}

impl FilmMaker {
    /// A film of the scene's pictures.
    pub(super) fn new(
        args: &RenderArgs,
        (codec, ffmpeg): (Codec, Ffmpeg),
        scene: &Scene,
        tiling: Option<&Tiling>,
    ) -> Self {
        let look = codec.own_look();
        let bits = match (look, tiling) {
            (Some(_), _) => PngBits::Sixteen,
            (None, Some(tiling)) => tiling.bits,
            (None, None) => PngBits::Eight,
        };
        let form = FilmForm {
            container: Container::of(&args.out).unwrap_or_default(),
            codec,
            size: scene.picture.size(),
            fps: args.fps,
            bits,
            is_of_whole_sky: scene.camera.projection == Projection::Equirectangular,
        };
        Self {
            form,
            ffmpeg,
            look,
            film: None,
        }
    }

    /// Whether the film is made of light, and not of levels.
    pub(super) fn is_of_light(&self) -> bool {
        self.look.is_some()
    }

    /// Adds a picture.
    pub(super) fn add_still(&mut self, still: &Still, file: &Path) -> Result<(), PictureError> {
        self.begun(file)?.add_bytes(&still.rgb)
    }

    /// Adds the light of a scene's picture to a film of light.
    pub(super) fn add_light(
        &mut self,
        light: &Captured,
        scene: &Scene,
        file: &Path,
    ) -> Result<(), PictureError> {
        let Some(look) = self.look else {
            return Ok(());
        };
        let exposure_ev = scene.picture.exposure_ev;
        let levels = picture::levels_of_halves(&light.rgba, look, exposure_ev);
        self.add_levels(&levels, file)
    }

    /// Draws a picture in tiles and adds it.
    pub(super) fn add_large(
        &mut self,
        studio: &mut Studio,
        large: &mut LargePicture,
        file: &Path,
    ) -> Result<(), Stop> {
        if self.is_of_light() {
            let (light, ..) = large.light(studio, &Channels::default())?;
            return Ok(self.add_light(&light, large.scene, file)?);
        }
        let film = self.begun(file)?;
        Ok(large.draw_rows(studio, file, &mut |rows| film.add(rows))?)
    }

    /// Adds a picture of these levels.
    pub(super) fn add_levels(&mut self, levels: &[u16], file: &Path) -> Result<(), PictureError> {
        self.begun(file)?.add(levels)
    }

    fn begun(&mut self, file: &Path) -> Result<&mut Film, PictureError> {
        match &mut self.film {
            Some(film) => Ok(film),
            none => Ok(none.insert(Film::begin(file, self.form, &self.ffmpeg)?)),
        }
    }

    /// Ends the film, whose file then has its name.
    pub(super) fn finish(self) -> Result<(), PictureError> {
        self.film.map_or(Ok(()), Film::finish)
    }
}
