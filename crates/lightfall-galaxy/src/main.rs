//! Computes the diffuse light of the Milky Way and writes it as a picture, in some minutes:
//!
//!     cargo run -p lightfall-galaxy --release -- assets/sky/milky_way.png

use lightfall_optics::cube_map::FACES;
use lightfall_optics::milky_way::MilkyWay;
use lightfall_optics::milky_way::asset::NUMBERS;
use rayon::prelude::*;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args_os()
        .nth(1)
        .ok_or("name the file to write, such as assets/sky/milky_way.png")?;
    let texels: Vec<[u8; NUMBERS]> = (0..FACES * MilkyWay::SIZE * MilkyWay::SIZE)
        .into_par_iter()
        .map(lightfall_galaxy::texel)
        .collect();
    std::fs::write(path, lightfall_galaxy::write(&texels)?)?;
    Ok(())
}
