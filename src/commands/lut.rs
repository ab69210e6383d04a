//! `lightfall lut`: a lookup table that gives light the look of the program's pictures.

use super::cli::LutArgs;
use super::output::print;
use super::scene::scene;
use super::stop::Stop;
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::exposure::exposed;
use lightfall_core::optics::lut::{HighRange, Look, Lut, LutForm};
use lightfall_platform::log::say;
use lightfall_platform::storage;

/// Writes the table of a scene.
pub(super) fn lut(args: &LutArgs) -> Result<(), Stop> {
    let file = &args.out;
    let extension = file.extension().unwrap_or_default().to_string_lossy();
    let Some(form) = LutForm::from_word(&extension.to_ascii_lowercase()) else {
        return Err(Stop::refused(format!(
            "{}: the name of a table must end in .csp for ffmpeg, .clf for OpenColorIO, or .cube for DaVinci Resolve",
            file.display()
        )));
    };
    if let (Some(peak), LutForm::Cube) = (args.hdr, form) {
        return Err(Stop::refused(format!(
            "--hdr {peak}: a .cube reaches only to light 64; .csp and .clf have codes of HDR10"
        )));
    }
    let scene = scene(&args.scene)?;
    // The light meter is that of a scene that can be drawn.
    Drawable::new(scene.clone())
        .map(drop)
        .map_err(Stop::refused)?;
    storage::check_writable(file).map_err(Stop::failed)?;
    let scene = exposed(&scene);
    let look = match args.hdr {
        Some(peak) => Look::High(HighRange {
            peak: f64::from(peak),
        }),
        None => Look::of(&scene),
    };
    let table = Lut {
        look,
        exposure_ev: scene.picture.exposure_ev,
    };
    storage::write_atomically(file, table.text(form).as_bytes()).map_err(Stop::failed)?;
    print(&format!("{}\n", file.display()))?;
    say(format_args!(
        "lightfall: the table has the exposure {:.2} and the tone curve {}, and no bloom",
        scene.picture.exposure_ev,
        match look {
            Look::Screen(curve) => curve.word(),
            Look::High(_) => "of HDR10",
        }
    ));
    Ok(())
}
