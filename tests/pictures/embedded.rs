//! The preset inside a picture.

use super::linear::{Linear, program, small};
use lightfall_core::optics::exposure::exposed;
use lightfall_platform::storage::read_scene;
use std::fs;

#[test]
#[ignore = "needs a graphics adapter"]
fn a_picture_holds_the_preset_that_drew_it() {
    let folder = tempfile::tempdir().unwrap();
    let taken =
        |file: &str| read_scene(&folder.path().join(file), &[]).map_err(|error| error.to_string());
    let mut scene = small(8);
    scene.title = "μέλας \"hole\", 0.1 + 0.2 — tilted".into();
    (scene.camera.theta_deg, scene.hole.spin) = (0.1 + 0.2, 1.0 / 3.0);
    // The exposure that is drawn.
    scene = exposed(&scene);
    for file in ["a.exr", "a.png"] {
        program(folder.path(), &scene, &format!("-o {file}"));
        assert_eq!(taken(file).unwrap(), scene, "{file}");
        // A broken file gives either the same scene or an error message, wherever it is cut or
        // changed.
        let whole = fs::read(folder.path().join(file)).unwrap();
        let header = &whole[..whole.len().min(10_000)];
        let broken = |bytes: &[u8]| {
            fs::write(folder.path().join("broken"), bytes).unwrap();
            taken("broken")
        };
        // The preset's last line, in front of which nothing is whole.
        let text = scene.to_preset();
        let kept = |line: &&str| !line.starts_with('#') && line.contains('=');
        let line = text.lines().rfind(kept).unwrap().as_bytes();
        let last = whole.windows(line.len()).rposition(|part| part == line);
        let last = last.unwrap();
        for place in (4..header.len()).step_by(97) {
            let cut = broken(&header[..place]);
            assert!(
                cut.is_err() || cut == Ok(scene.clone()),
                "{file}, {place} bytes of it"
            );
            assert!(place > last || cut.is_err(), "{file}, {place} bytes of it");
            let mut changed = header.to_vec();
            changed[place] ^= 0x5a;
            // The result does not matter: a panic would end the test.
            drop(broken(&changed));
        }
    }
    let linear = Linear::read(&folder.path().join("a.exr"));
    assert_eq!(linear.texts["lightfall.method"], "closed");
    assert_eq!(linear.texts["lightfall.version"], env!("CARGO_PKG_VERSION"));
    assert!(linear.texts["lightfall.unit.RGB"].contains("before exposure, bloom and tone mapping"));

    image::RgbImage::new(2, 2)
        .save(folder.path().join("other.png"))
        .unwrap();
    assert!(taken("other.png").unwrap_err().contains("holds no preset"));
}
