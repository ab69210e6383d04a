//! Pictures without a window: the window's chain of passes draws into an image, which is written to
//! a file. Also sequences of pictures.

mod alike;
mod animation;
mod brightness;
mod channels;
mod cube;
mod exr_header;
mod file;
mod headless;
mod open_exr;
mod pass_time;
mod sequence;
mod still;

pub use animation::Animation;
pub use brightness::brightness;
pub use channels::{CHANNELS, Channel, Channels, PixelRays};
pub use cube::{joined_channels, joined_light, joined_stills};
pub use file::{Format, PictureError, check_path, write_png};
pub use headless::{HeadlessOptions, check_size};
pub use open_exr::{ChannelNames, Linear, write_exr};
pub use pass_time::PassTime;
pub use sequence::{Frames, Sequence, frame_rate};
pub use still::{Still, Studio, filled, render, render_with};
