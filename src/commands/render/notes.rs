//! What `lightfall render` says before it draws: what will not be seen, and which options change nothing.

use super::large::Tiling;
use super::pictures::Pictures;
use super::with_size;
use crate::commands::cli::RenderArgs;
use crate::commands::scene::note_missing_stars;
use crate::commands::unused::{Suspect, note_idle_preset, note_unused};
use glam::UVec2;
use lightfall_core::optics::stars::Catalogue;
use lightfall_core::scene::{Output, Picture, Scene, SkyMode, fit};
use lightfall_picture::Format;
use lightfall_platform::log::say;
use wgpu::DeviceType;

/// Says what will not be seen, and which options change nothing. Returns those of which only the pictures can
/// tell.
pub(super) fn note_all(
    args: &RenderArgs,
    pictures: &Pictures,
    tiling: Option<&Tiling>,
    stars: &Catalogue,
) -> Vec<Suspect> {
    let scene = &pictures.scene;
    if tiling.is_none()
        && pictures.format != Format::Exr
        && args.size.is_some()
        && args.scene.cells.is_none()
    {
        note_cells(&scene.shown_picture());
    }
    note_unseen_stars(args, scene);
    note_darkness(scene);
    let suspects = note_unused_options(args, pictures);
    note_missing_stars(&args.scene, scene, stars);
    suspects
}

/// Warns that `--stars` has no effect here.
fn note_unseen_stars(args: &RenderArgs, scene: &Scene) {
    let idle = scene.idle("sky.ra_deg", Output::Still);
    if let (Some(file), Some(idle)) = (&args.scene.stars, idle) {
        say(format_args!(
            "lightfall: --stars {} changes nothing: {}; --set {} shows it",
            file.display(),
            idle.why,
            idle.remedy
        ));
    }
}

/// Says that a picture whose size was asked for has cells that are larger than a pixel.
fn note_cells(picture: &Picture) {
    let grid = fit(picture, picture.size(), u64::MAX).grid();
    let pixels = picture.height.div_ceil(grid.y.max(1));
    if !picture.bypass && pixels > 1 {
        say(format_args!(
            "lightfall: the picture is shown in {} x {} cells of {pixels} pixels to a side; --cells off shows every pixel",
            grid.x, grid.y
        ));
    }
}

/// Says that nothing in the scene emits light, and what would bring some.
fn note_darkness(scene: &Scene) {
    if scene.view.shows_light() && !scene.shines() {
        let (disk, sky) = (&scene.disk, &scene.sky);
        let options = |needed: [(bool, &'static str); 2]| {
            let needed = needed.into_iter().filter(|(needed, _)| *needed);
            needed.map(|(_, set)| set).collect::<Vec<_>>().join(" ")
        };
        let disk = options([
            (!disk.enabled, "--set disk.enabled=true"),
            (disk.brightness == 0.0, "--set disk.brightness=1"),
        ]);
        let sky = options([
            (sky.mode == SkyMode::Off, "--set sky.mode=stars"),
            (sky.brightness == 0.0, "--set sky.brightness=1"),
        ]);
        say(format_args!(
            "lightfall: nothing shines in this scene; {disk} or {sky} brings light"
        ));
    }
}

/// What is said of a picture of this size that takes long, on an adapter of this kind.
#[must_use]
pub fn still_drawing(size: UVec2, kind: Option<DeviceType>) -> String {
    let UVec2 { x, y } = size;
    let why = match kind {
        Some(DeviceType::Cpu) => "; without a graphics card a large picture takes minutes",
        // A graphics card is slow while its driver compiles.
        _ => "",
    };
    format!("still drawing {x} x {y} pixels{why}")
}

/// Says which options change nothing, and returns those of which only the pictures can tell.
fn note_unused_options(args: &RenderArgs, pictures: &Pictures) -> Vec<Suspect> {
    note_idle_preset(args.scene.preset.as_deref(), &pictures.scene);
    let output = match (pictures.format, &pictures.sequence) {
        (Format::Exr, _) => Output::Linear,
        (_, Some(_)) => Output::Sequence,
        (_, None) => Output::Still,
    };
    let sized = |without| with_size(args, without);
    let suspects = note_unused(&args.scene, &pictures.scene, output, sized, |without| {
        let sequence = pictures.sequence.as_ref()?;
        let same =
            |number| sequence.scene(without, number) == sequence.scene(&pictures.scene, number);
        pictures.numbers().all(same).then(|| {
            "the journey decides it; --journey none keeps the camera where the scene has it".into()
        })
    });
    if output == Output::Still {
        suspects
    } else {
        Vec::new()
    }
}
