//! Films: pictures that ffmpeg, a program of its own, encodes while they are drawn.

mod codec;
mod ffmpeg;
mod film;
mod light;
mod line;
mod spherical;

pub(crate) use codec::EVEN_SIDES;
pub use codec::{Codec, Container, FilmForm};
pub use ffmpeg::Ffmpeg;
pub use film::Film;
pub use light::{levels_of_halves, levels_of_light};
pub use line::{filter_value, loop_lines, quoted};
