//! The preset inside a picture.

use super::linear::{Linear, program, small};
use lightfall_core::gpu::adapters;
use lightfall_core::optics::exposure::exposed;
use lightfall_platform::storage::read_scene;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

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
    assert!(linear.texts["lightfall.unit.G"].contains("before bloom, exposure and tone mapping"));

    image::RgbImage::new(2, 2)
        .save(folder.path().join("other.png"))
        .unwrap();
    assert!(taken("other.png").unwrap_err().contains("holds no preset"));
}

/// A list of stars, and the SHA-256 that coreutils' sha256sum gives it.
const STARS: &str =
    "83.8,-5.4,4.3,-0.1,Sword\n84.1,-1.2,1.7,-0.2,\n85.2,-1.9,1.8,-0.2,\n83.0,-0.3,2.2,-0.2,\n";
const HASH: &str = "396396e74c846f00857d4ff99940a8e8d0fe04820e98ed7f6f3b0bf9e170c3dd";

/// The texts of a PNG or EXR file.
fn texts(file: &Path) -> BTreeMap<String, String> {
    if file.extension().unwrap() == "exr" {
        return Linear::read(file).texts;
    }
    let bytes = std::io::Cursor::new(fs::read(file).unwrap());
    let reader = png::Decoder::new(bytes).read_info().unwrap();
    let chunks = reader.info().utf8_text.iter();
    chunks
        .map(|chunk| (chunk.keyword.clone(), chunk.get_text().unwrap()))
        .collect()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_picture_names_the_stars_and_the_adapter_that_drew_it_and_asks_for_stars_that_are_missing() {
    let folder = tempfile::tempdir().unwrap();
    let here = |name: &str| folder.path().join(name);
    fs::create_dir(here("lists")).unwrap();
    fs::write(here("lists/mine.csv"), STARS).unwrap();
    fs::write(here("other.csv"), "83.8,-5.4,4.3,-0.1,Sword\n").unwrap();
    // What the program says on standard error of the stars of a picture.
    let asked = |options: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lightfall"));
        command.current_dir(folder.path()).arg("render");
        command.args(["--size", "64x36"]);
        let output = command.args(options.split(' ')).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{options}: {said}");
        let lines = said.lines().filter(|line| line.contains("was drawn with"));
        lines.map(str::to_owned).collect::<Vec<_>>()
    };
    for kind in ["png", "exr"] {
        for name in ["a", "b"] {
            let drawn = format!("--preset 13 --stars lists/mine.csv -o {name}.{kind}");
            assert!(asked(&drawn).is_empty());
        }
        let picture = format!("a.{kind}");
        let bytes = [&picture, &format!("b.{kind}")].map(|file| fs::read(here(file)).unwrap());
        assert!(bytes[0] == bytes[1], "{kind}: bytes differ");

        let texts = texts(&here(&picture));
        let stars = format!("mine.csv, 4 stars, sha256 {HASH}");
        assert_eq!(texts["lightfall.stars"], stars);
        assert_eq!(texts["lightfall.version"], env!("CARGO_PKG_VERSION"));
        let [adapter, driver] = ["adapter", "driver"].map(|it| &texts[&format!("lightfall.{it}")]);
        let is_it = |name: &str, its: &str| (name, its) == (adapter, driver);
        let mut listed = adapters().into_iter();
        assert!(
            listed.any(|it| is_it(&it.name.to_string(), &it.driver)),
            "{adapter}, {driver}"
        );

        let opened = format!("--preset {picture} -o again.png");
        let sentence = format!(
            "lightfall: {picture} was drawn with the stars of mine.csv (4 stars, sha256 {}…): give them with \
             --stars mine.csv",
            &HASH[..8]
        );
        assert_eq!(asked(&opened), [sentence.as_str()]);
        assert_eq!(asked(&format!("{opened} --stars other.csv")), [sentence]);
        // The bytes count, whatever the name.
        fs::write(here("same.csv"), STARS).unwrap();
        assert!(asked(&format!("{opened} --stars same.csv")).is_empty());
        assert!(asked(&format!("{opened} --set sky.mode=grid")).is_empty());
    }
    asked("--preset 13 --set sky.mode=grid --stars other.csv -o grid.png");
    asked("--preset 13 -o built-in.png");
    for file in ["grid.png", "built-in.png"] {
        assert!(
            !texts(&here(file)).contains_key("lightfall.stars"),
            "{file}"
        );
    }
}
