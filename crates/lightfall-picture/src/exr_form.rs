//! The form of an EXR file: the names of its channels, what stands for a missing value, what is
//! transparent, and the compression.

use super::Channel;
use exr::prelude::Compression;
use lightfall_core::words;

/// The form of an EXR file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExrForm {
    /// The names of its channels.
    pub names: ChannelNames,
    /// What stands where a ray has no number.
    pub missing: MissingValues,
    /// What is transparent; `None` if the whole picture is opaque.
    pub transparent: Option<Transparent>,
    /// How its pixels are compressed.
    pub compression: ExrCompression,
}

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
    pub(super) fn of(self, channel: &Channel) -> &'static str {
        match self {
            Self::Layers => channel.name,
            Self::Version01 => channel.old_name,
        }
    }
}

words! {
    /// What stands where a ray has no number for a channel.
    pub enum MissingValues {
        /// NaN, which no measured value can be.
        Keep = "keep",
        /// Zero, for programs that spread NaN over the picture.
        Zero = "zero",
    }
}

words! {
    /// What is transparent in a picture, for a background from another program.
    pub enum Transparent {
        /// The sky: the disk, the matter and the hole stay.
        Sky = "sky",
        /// The hole.
        Hole = "hole",
    }
}

words! {
    /// How the pixels of an EXR file are compressed, without any loss.
    pub enum ExrCompression {
        /// ZIP, 16 rows at a time.
        Zip = "zip",
        /// ZIP, row by row: larger, and quicker to read in parts.
        Zips = "zips",
        /// Wavelets: good for noisy light.
        Piz = "piz",
        /// Runs of equal bytes: quick, and larger.
        Rle = "rle",
        /// No compression.
        None = "none",
    }
}

impl ExrCompression {
    /// The crate's word for it.
    pub(super) fn method(self) -> Compression {
        match self {
            Self::Zip => Compression::ZIP16,
            Self::Zips => Compression::ZIP1,
            Self::Piz => Compression::PIZ,
            Self::Rle => Compression::RLE,
            Self::None => Compression::Uncompressed,
        }
    }
}
