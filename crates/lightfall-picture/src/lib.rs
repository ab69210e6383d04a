//! Pictures without a window: the window's chain of passes draws into an image, which is written to
//! a file. Also sequences of pictures.

mod alike;
mod animation;
mod brightness;
mod channels;
mod cube;
mod existing;
mod exr_form;
mod exr_header;
mod exr_rows;
mod file;
mod frame_file;
mod frames;
mod headless;
mod large_picture;
mod layers;
mod manifest;
mod numbered_files;
mod open_exr;
mod pass_time;
mod png_rows;
mod sequence;
mod shutter;
mod still;
mod tiles;
mod transparent;
mod video;

pub use animation::Animation;
pub use brightness::brightness;
pub use channels::{CHANNELS, Channel, Channels, PixelRays};
pub use cube::{joined_channels, joined_levels, joined_light};
pub use existing::{Found, Wanted, WantedForm, find_picture, preset_difference};
pub use exr_form::{ChannelNames, ExrCompression, ExrForm, MissingValues, Transparent};
pub use exr_rows::{exr_pixel_bytes, rows_at_once};
pub use file::{Format, PictureError, check_path, write_png};
pub use frame_file::{LightFrame, PngFrame, exr_size, png_form, read_light_frame, read_png_frame};
pub use frames::{FrameList, Frames, Shard};
pub use headless::{HeadlessOptions, check_size};
pub use large_picture::{LargePicture, exposed, png_sweeps};
pub use lightfall_render::{Captured, LIGHT_BYTES};
pub use manifest::{DeviceFacts, Manifest, ManifestError, ManifestRow};
pub use numbered_files::numbered_pictures;
pub use open_exr::{Linear, write_exr};
pub use pass_time::PassTime;
pub use png_rows::{PngBits, write_png_levels};
pub use sequence::{Sequence, frame_rate};
pub use shutter::{moments, shutter_time};
pub use still::{Still, Studio, filled, render, render_with};
pub use tiles::{MAX_UNTILED_PIXELS, Tiles};
pub use transparent::{TransparentStill, straight, write_transparent_png};
pub use video::{
    Codec, Container, Ffmpeg, Film, FilmForm, filter_value, levels_of_halves, levels_of_light,
    loop_lines, quoted,
};
