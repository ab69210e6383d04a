//! Sequences: journeys, or a disk that moves, as numbered pictures.

use super::Frames;
use super::video::{Codec, EVEN_SIDES, filter_value, quoted};
use lightfall_core::numbers::number_with_comma;
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::Journey;
use std::path::{Path, PathBuf};

/// Minimum and maximum of the frames per second.
const FRAME_RATES: [f64; 2] = [0.01, 1000.0];

/// Number of digits of a frame's number if the file's name has no `#`.
const DEFAULT_DIGITS: usize = 4;

/// Reads a number of frames per second.
///
/// # Errors
/// The text is no number or out of range.
pub fn frame_rate(text: &str) -> Result<f64, String> {
    let [least, most] = FRAME_RATES;
    let rate = text
        .parse()
        .ok()
        .filter(|rate: &f64| (least..=most).contains(rate));
    rate.ok_or_else(|| {
        let allowed = format!("it must be a number from {least} to {most}, in frames per second");
        match number_with_comma(text, |rate| (least..=most).contains(&rate)) {
            Some(meant) => format!("{allowed}; did you mean {meant}?"),
            None => allowed,
        }
    })
}

/// A journey, or a scene whose disk moves, as numbered pictures.
#[derive(Clone, Debug)]
pub struct Sequence {
    /// The journey; `None` for a camera that stays where it is.
    pub journey: Option<Journey>,
    /// The first and the last of the frames. Frame k shows the scene k / fps seconds after the start.
    pub frames: Frames,
    /// Frames per second.
    pub fps: f64,
    /// The seconds in which the camera goes once around the axis, while nothing else moves; `None` if it
    /// stays.
    pub turn: Option<f64>,
    /// The folder of the files, the parts of their names before and after the number, and the
    /// number's digits.
    folder: PathBuf,
    name: [String; 2],
    digits: usize,
}

impl Sequence {
    /// A sequence of pictures whose names follow `pattern`: the last run of `#` in its file name is
    /// replaced by the frame's number, with at least as many digits. Without `#`, a dash and the
    /// number are inserted before the extension.
    ///
    /// # Errors
    /// The name is not Unicode.
    pub fn new(
        journey: Option<Journey>,
        frames: Frames,
        fps: f64,
        pattern: &Path,
    ) -> Result<Self, String> {
        let name = pattern.file_name().unwrap_or_default().to_str();
        let name = name.ok_or(format!(
            "{}: the name of a sequence must be Unicode",
            pattern.display()
        ))?;
        let (before, digits, after) = match name.rfind('#') {
            Some(last) => {
                let before = name[..last].trim_end_matches('#');
                (
                    before.to_owned(),
                    last + 1 - before.len(),
                    &name[last + 1..],
                )
            }
            None => {
                let dot = name.rfind('.').unwrap_or(name.len());
                (format!("{}-", &name[..dot]), DEFAULT_DIGITS, &name[dot..])
            }
        };
        let folder = pattern.parent().unwrap_or(Path::new("")).to_owned();
        Ok(Self {
            journey,
            frames,
            fps,
            turn: None,
            folder,
            name: [before, after.to_owned()],
            digits,
        })
    }

    /// The scene of the frame of this number, for a journey through `scene`, whose `disk.time` is
    /// that of frame 0. It is not checked.
    #[must_use]
    pub fn scene(&self, scene: &Scene, number: u32) -> Scene {
        self.scene_at(scene, f64::from(number))
    }

    /// The same at any moment, in frames: between two frames, too.
    #[must_use]
    pub fn scene_at(&self, scene: &Scene, frame: f64) -> Scene {
        let seconds = frame / self.fps;
        let mut next = scene.clone();
        match &self.journey {
            Some(journey) => {
                let mut first = scene.clone();
                journey.apply(0.0, &mut first);
                journey.apply(seconds, &mut next);
                journey.drive_clock([0.0, seconds], &first, &mut next);
            }
            None if scene.disk_moves() => next.disk.time += scene.disk.rate * seconds,
            None => {}
        }
        if let Some(turn) = self.turn {
            let azimuth = scene.camera.phi_deg + 360.0 * seconds / turn;
            next.camera.phi_deg = (azimuth + 180.0).rem_euclid(360.0) - 180.0;
        }
        next
    }

    /// The file of the frame of this number.
    #[must_use]
    pub fn file(&self, number: u32) -> PathBuf {
        let ([before, after], digits) = (&self.name, self.digits);
        self.folder
            .join(format!("{before}{number:0digits$}{after}"))
    }

    /// The number of the first frame at which the journey has ended; `None` without a journey.
    #[must_use]
    pub fn end(&self) -> Option<f64> {
        let journey = self.journey.as_ref()?;
        Some((journey.duration * self.fps).ceil())
    }

    /// A file beside the pictures: their name without the number, with this ending.
    #[must_use]
    pub fn beside(&self, ending: &str) -> PathBuf {
        let [before, _] = &self.name;
        let stem = Some(before.trim_end_matches(['-', '_', '.']))
            .filter(|stem| !stem.is_empty())
            .unwrap_or("lightfall");
        self.folder.join(format!("{stem}{ending}"))
    }

    /// The shell command line with which `ffmpeg` makes a video of pictures of this size.
    #[must_use]
    pub fn ffmpeg(&self, width: u32, height: u32) -> String {
        let name = |text: &str| text.replace('%', "%%");
        let [before, after] = &self.name;
        let folder = self.folder.to_string_lossy();
        let numbered = format!("{}%0{}d{}", name(before), self.digits, name(after));
        let input = Path::new(&name(&folder)).join(numbered);
        let output = self.beside(".mp4");
        // Common video formats need even sides.
        let even = (width % 2 + height % 2 > 0).then_some(EVEN_SIDES);
        let input = quoted(&input.display().to_string());
        let frames = format!(
            "-framerate {} -start_number {} -i {input}",
            self.fps, self.frames.first
        );
        let output = quoted(&output.display().to_string());
        if !after.to_lowercase().ends_with(".exr") {
            let filters: Vec<_> = even.into_iter().chain([BT709]).collect();
            let filters = filters.join(",");
            return format!("ffmpeg {frames} -vf '{filters}' {TAGS} -c:v libx264 -crf 16 {output}");
        }
        // Linear light gets the exposure and the tone curve of the first frame. Before the table, another
        // filter would cut light off at 1.
        let table = self.beside(".csp").display().to_string();
        let lookup = format!("lut3d={}:interp=tetrahedral", filter_value(&table));
        let colours = Codec::H264.colour_filters();
        let filters = [&*lookup, "format=gbrp16le"].into_iter();
        let filters: Vec<_> = filters.chain(even).chain([&*colours]).collect();
        format!(
            "lightfall lut --preset {} -o {} && ffmpeg -gamma 4 {frames} -vf '{}' -c:v libx264 -crf 16 {output}",
            quoted(&self.file(self.frames.first).display().to_string()),
            quoted(&table),
            filters.join(",").replace('\'', "'\\''"),
        )
    }
}

/// The filter to the matrix and the range of HD video. Without it, ffmpeg takes those of old television.
const BT709: &str = "scale=out_color_matrix=bt709:out_range=limited,format=yuv420p";
/// The tags by which players know this matrix and range.
const TAGS: &str = "-color_primaries bt709 -color_trc bt709 -colorspace bt709 -color_range tv";
