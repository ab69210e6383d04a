//! Codecs and containers of films, and what they mean in ffmpeg's options.

use crate::PngBits;
use glam::UVec2;
use lightfall_core::optics::lut::{HighRange, Look};
use lightfall_core::words;
use std::path::Path;

words! {
    /// How the pictures of a film are encoded.
    pub enum Codec {
        /// H.264, which every player shows.
        H264 = "h264",
        /// HEVC with ten bits and a range of up to 1000 cd/m^2, for HDR screens.
        Hdr10 = "hdr10",
        /// AV1 with ten bits, for browsers.
        Av1 = "av1",
        /// ProRes 4444, for cutting.
        Prores = "prores",
    }
}

words! {
    /// The format of a film's file.
    pub enum Container {
        /// MPEG-4.
        Mp4 = "mp4",
        /// QuickTime.
        Mov = "mov",
        /// WebM.
        Webm = "webm",
    }
}

impl Container {
    /// The container of the file at `path`, which its extension decides; `None` if it is no film.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        Self::from_word(&extension)
    }

    /// The codecs that it can hold; the first one is used unless another is asked for.
    #[must_use]
    pub fn codecs(self) -> &'static [Codec] {
        match self {
            Self::Mp4 => &[Codec::H264, Codec::Hdr10, Codec::Av1],
            Self::Mov => &[Codec::Prores, Codec::H264, Codec::Hdr10],
            Self::Webm => &[Codec::Av1],
        }
    }
}

impl Codec {
    /// ffmpeg's name of the encoder.
    #[must_use]
    pub fn encoder(self) -> &'static str {
        match self {
            Self::H264 => "libx264",
            Self::Hdr10 => "libx265",
            Self::Av1 => "libsvtav1",
            Self::Prores => "prores_ks",
        }
    }

    /// How linear light is shown with it; `None` where a film has the look of the screen.
    #[must_use]
    pub fn own_look(self) -> Option<Look> {
        (self == Self::Hdr10).then(|| Look::High(HighRange::default()))
    }

    /// The format of pixels that the encoder takes.
    fn pixels(self) -> &'static str {
        match self {
            Self::H264 => "yuv420p",
            Self::Hdr10 | Self::Av1 => "yuv420p10le",
            Self::Prores => "yuv444p10le",
        }
    }

    /// Primaries, transfer and matrix, as the filter zscale names the last one.
    fn colours(self) -> [&'static str; 3] {
        match self {
            Self::Hdr10 => ["bt2020", "smpte2084", "2020_ncl"],
            _ => ["bt709", "bt709", "709"],
        }
    }

    /// The filters from levels of red, green and blue to the pixels that the encoder takes. They are rounded
    /// with noise.
    pub(crate) fn colour_filters(self) -> String {
        let [primaries, transfer, matrix] = self.colours();
        format!(
            "setparams=color_primaries={primaries}:color_trc={transfer}:colorspace=gbr:range=pc,\
             zscale=m={matrix}:r=limited:d=error_diffusion,format={}",
            self.pixels()
        )
    }

    /// The encoder's options. Their quality shows no loss beside the pictures.
    fn options(self) -> &'static [&'static str] {
        match self {
            Self::H264 => &["-preset", "slow", "-crf", "16"],
            Self::Hdr10 => &["-crf", "16", "-tag:v", "hvc1", "-x265-params", HDR10],
            Self::Av1 => &["-preset", "6", "-crf", "24"],
            Self::Prores => &["-profile:v", "4444", "-vendor", "apl0"],
        }
    }
}

/// The metadata of HDR10 (SMPTE ST 2086): a screen with the primaries of P3 and white D65, of 0.0001 to 1000
/// cd/m^2, and the brightest pixel and frame.
const HDR10: &str = "log-level=error:hdr10=1:repeat-headers=1:colorprim=bt2020:transfer=smpte2084:\
                     colormatrix=bt2020nc:range=limited:\
                     master-display=G(13250,34500)B(7500,3000)R(34000,16000)WP(15635,16450)L(10000000,1):\
                     max-cll=1000,400";

/// The filter that adds black pixels to sides that are odd, since common formats need even ones.
pub(crate) const EVEN_SIDES: &str = "pad=ceil(iw/2)*2:ceil(ih/2)*2";

/// What a film is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmForm {
    /// The format of its file.
    pub container: Container,
    /// How its pictures are encoded.
    pub codec: Codec,
    /// The size of its pictures.
    pub size: UVec2,
    /// Frames per second.
    pub fps: f64,
    /// Bits of a channel of the pictures that are given.
    pub bits: PngBits,
    /// Whether its pictures show the whole sky.
    pub is_of_whole_sky: bool,
}

impl FilmForm {
    /// The filters from pictures that are given to those that are encoded.
    #[must_use]
    pub fn filters(&self) -> String {
        let planes = match self.bits {
            PngBits::Eight => "gbrp",
            // Without it, ffmpeg may choose eight bits between the filters.
            PngBits::Sixteen => "gbrp16le",
        };
        let even = (self.size % 2).element_sum() > 0;
        let even = even.then_some(EVEN_SIDES).into_iter();
        let filters = [format!("format={planes}"), self.codec.colour_filters()];
        let filters: Vec<_> = even.chain(filters.iter().map(String::as_str)).collect();
        filters.join(",")
    }

    /// ffmpeg's options, but for the file of the film, which follows them. It reads pictures from its
    /// standard input.
    #[must_use]
    pub fn arguments(&self) -> Vec<String> {
        let UVec2 { x, y } = self.size;
        let pixels = match self.bits {
            PngBits::Eight => "rgb24",
            PngBits::Sixteen => "rgb48le",
        };
        let input = format!(
            "-v error -nostdin -y -f rawvideo -pixel_format {pixels} -video_size {x}x{y} -framerate {} -i pipe:0 -vf",
            self.fps
        );
        let mut arguments = split(&input);
        arguments.push(self.filters());
        arguments.extend(["-c:v", self.codec.encoder()].map(String::from));
        arguments.extend(self.codec.options().iter().copied().map(String::from));
        arguments.extend(self.container_options());
        arguments
    }

    /// The container that ffmpeg writes first.
    fn first_container(&self) -> Container {
        match self.container {
            // The mark of the whole sky is put into an MPEG-4, from which ffmpeg copies it.
            Container::Webm if self.is_of_whole_sky => Container::Mp4,
            container => container,
        }
    }

    fn container_options(&self) -> Vec<String> {
        let container = self.first_container();
        // The mark can be put only into a file whose index stands at the end.
        let index = if container == Container::Webm || self.is_of_whole_sky {
            ""
        } else {
            "-movflags +faststart "
        };
        split(&format!("{index}-f {}", container.word()))
    }

    /// Whether ffmpeg copies the film once more: into its own container, with its index first.
    pub(super) fn is_copied(&self) -> bool {
        // ffmpeg does not copy the mark of the whole sky into a .mov, so that it stays as it is.
        self.is_of_whole_sky && self.container != Container::Mov
    }

    /// ffmpeg's options by which it copies a film with the mark of the whole sky: those before the name of
    /// the first file, and those between the names.
    #[must_use]
    pub fn copy_arguments(&self) -> [Vec<String>; 2] {
        let index = match self.container {
            Container::Webm => "",
            Container::Mp4 | Container::Mov => "-movflags +faststart ",
        };
        let tag = match self.codec {
            Codec::Hdr10 => "-tag:v hvc1 ",
            _ => "",
        };
        [
            split("-v error -nostdin -y -i"),
            split(&format!(
                "-c copy -strict unofficial {tag}{index}-f {}",
                self.container.word()
            )),
        ]
    }
}

/// Options that are written in one line.
fn split(options: &str) -> Vec<String> {
    options.split(' ').map(String::from).collect()
}
