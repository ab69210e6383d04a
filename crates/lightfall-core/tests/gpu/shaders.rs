//! The text of every variant, without a GPU.

use lightfall_core::gpu::{Entry, Variant};
use lightfall_core::scene::{SkyMode, View};

#[test]
fn naga_accepts_every_variant() {
    let failures: Vec<String> = Variant::all()
        .into_iter()
        .filter_map(|variant| check(variant).err())
        .collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Parses and validates, as wgpu does before it hands a shader to a driver; the fault is told with
/// its file and line.
fn check(variant: Variant) -> Result<(), String> {
    let source = variant.source();
    let at = |line: Option<u32>, message: String| {
        let (file, line) = variant.locate(line.unwrap_or(1) as usize);
        format!("{variant:?}\n{file}:{line}: {message}")
    };
    let module = naga::front::wgsl::parse_str(&source).map_err(|error| {
        at(
            error.location(&source).map(|place| place.line_number),
            error.emit_to_string(&source),
        )
    })?;
    naga::valid::Validator::new(
        naga::valid::ValidationFlags::all(),
        naga::valid::Capabilities::default(),
    )
    .validate(&module)
    .map_err(|error| {
        at(
            error.location(&source).map(|place| place.line_number),
            error.emit_to_string(&source),
        )
    })?;
    let entries: Vec<&str> = module
        .entry_points
        .iter()
        .map(|entry| entry.name.as_str())
        .collect();
    let expected: &[&str] = match variant.entry {
        Entry::Picture => &["vertex", "fragment"],
        Entry::Rays => &["rays"],
        Entry::Timed => &["timed", "vertex", "fragment"],
    };
    if entries == expected {
        Ok(())
    } else {
        Err(at(None, format!("entry points are {entries:?}")))
    }
}

#[test]
fn no_variant_needs_a_preprocessor() {
    for variant in Variant::all() {
        let source = variant.source();
        let line = source
            .lines()
            .position(|line| line.trim_start().starts_with('#'));
        assert_eq!(
            line.map(|line| variant.locate(line + 1)),
            None,
            "{variant:?}"
        );
    }
}

#[test]
fn a_line_of_a_variant_is_found_in_its_file() {
    for variant in Variant::all() {
        for (index, line) in variant.source().lines().enumerate() {
            let (file, number) = variant.locate(index + 1);
            let Ok(text) = std::fs::read_to_string(format!(
                "{}/../../shaders/{file}",
                env!("CARGO_MANIFEST_DIR")
            )) else {
                assert!(
                    line.starts_with("const "),
                    "only constants come from no file: {line}"
                );
                continue;
            };
            assert_eq!(text.lines().nth(number - 1), Some(line), "{file}:{number}");
        }
    }
}

#[test]
fn what_a_scene_does_not_need_is_not_in_its_text() {
    for variant in Variant::all() {
        let source = variant.source();
        let pictures = variant.entry == Entry::Picture;
        let sky = pictures && variant.sky != SkyMode::Off;
        assert_eq!(source.contains("fn hermite"), variant.disk, "{variant:?}");
        let light = matches!(variant.view, View::Colour | View::Unfinished);
        let spectrum = pictures && light && (variant.disk || sky);
        assert_eq!(
            source.contains("var<uniform> spectrum"),
            spectrum,
            "{variant:?}"
        );
        assert_eq!(source.contains("fn spot_radius"), sky, "{variant:?}");
        let relativistic = variant.disk_model == lightfall_core::scene::DiskModel::PageThorne;
        assert_eq!(
            source.contains("var<uniform> page_thorne"),
            relativistic,
            "{variant:?}"
        );
        assert!(!relativistic || pictures && variant.disk, "{variant:?}");
        // What shows errors that are known already traces nothing.
        let traces = !pictures || variant.view != View::Error;
        assert_eq!(source.contains("fn trace("), traces, "{variant:?}");
        assert_eq!(
            source.contains("var<uniform> errors"),
            !traces,
            "{variant:?}"
        );
    }
}
