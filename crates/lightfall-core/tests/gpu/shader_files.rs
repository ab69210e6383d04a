//! Shaders linked from the files of a folder: what an edit changes, and what is said of a fault.

use lightfall_core::gpu::{Accumulation, Presentation, ShaderFiles, ShaderText, Variant};
use lightfall_core::scene::{Method, Scene, View};
use std::fs;
use std::path::{Path, PathBuf};

/// A copy of the folder of shaders that a test may change.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = fs::remove_dir_all(&folder);
        copy(
            Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../shaders")),
            &folder,
        );
        Self(folder)
    }

    /// Replaces a piece of a file's text that is there once.
    fn edit(&self, file: &str, from: &str, to: &str) {
        let path = self.0.join(file);
        let text = fs::read_to_string(&path).unwrap();
        assert_eq!(text.matches(from).count(), 1, "{file}: {from}");
        fs::write(path, text.replace(from, to)).unwrap();
    }

    fn files(&self) -> ShaderFiles {
        ShaderFiles::read(&self.0).unwrap()
    }

    fn linked(&self, text: &ShaderText) -> ShaderText {
        text.linked_from(&self.files())
    }

    /// What is said of a shader that is linked from this folder.
    fn fault(&self, text: &ShaderText) -> String {
        self.linked(text).validate().unwrap_err().to_string()
    }
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let copied = to.join(path.file_name().unwrap());
        if path.is_dir() {
            copy(&path, &copied);
        } else {
            fs::copy(&path, copied).unwrap();
        }
    }
}

#[test]
fn an_unchanged_folder_gives_the_shaders_that_are_built_in() {
    let folder = Folder::new("shaders-unchanged");
    for method in Method::on_gpu() {
        let scene = Scene {
            method,
            ..Scene::default()
        };
        let text = Variant::picture(&scene).text();
        assert_eq!(folder.linked(&text), text, "{method:?}");
    }
}

#[test]
fn an_edit_changes_the_shaders_with_its_file_and_no_others() {
    let folder = Folder::new("shaders-edited");
    folder.edit(
        "antialias/accumulate.wgsl",
        "fn accumulate(",
        "fn accumulate( ",
    );
    let text = Accumulation::shader();
    assert_ne!(folder.linked(&text).source(), text.source());
    assert_eq!(folder.linked(&text).validate(), text.validate());
    assert_eq!(
        folder.linked(&Presentation::shader()),
        Presentation::shader()
    );
}

#[test]
fn a_fault_of_an_edit_names_the_file_and_the_line() {
    let folder = Folder::new("shaders-broken");
    let text = Variant::picture(&Scene::default()).text();
    assert_eq!(text.validate(), folder.linked(&text).validate());
    let path = folder.0.join("math.wgsl");
    let math = fs::read_to_string(&path).unwrap();
    let line = math.lines().count() + 1;
    // Not WGSL, and WGSL of the wrong type.
    for (broken, said) in [
        ("fn broken( -> f32 {}\n", "expected"),
        ("fn broken() -> f32 { return true; }\n", "broken"),
    ] {
        fs::write(&path, math.clone() + broken).unwrap();
        let fault = folder.fault(&text);
        assert!(fault.starts_with(&format!("math.wgsl:{line}: ")), "{fault}");
        assert!(fault.contains(said), "{fault}");
        assert_eq!(fault.lines().count(), 1, "{fault}");
    }
}

#[test]
fn a_name_that_nothing_declares_is_a_fault_where_it_stands() {
    let folder = Folder::new("shaders-needing");
    folder.edit("spectrum.wgsl", "exp(entry.a)", "blue_light(entry.a)");
    let text = fs::read_to_string(folder.0.join("spectrum.wgsl")).unwrap();
    let line = text.lines().position(|line| line.contains("blue_light"));
    let fault = folder.fault(&Variant::picture(&Scene::default()).text());
    let place = format!("spectrum.wgsl:{}: ", line.unwrap() + 1);
    assert!(fault.starts_with(&place), "{fault}");
    assert!(fault.contains("blue_light"), "{fault}");
}

#[test]
fn a_name_that_two_files_give_must_be_chosen() {
    let folder = Folder::new("shaders-given-twice");
    let text = Variant::picture(&Scene::default()).text();
    fs::write(folder.0.join("second.wgsl"), "// Gives: bounded_light.\n").unwrap();
    let fault = folder.fault(&text);
    let expected = "needs `bounded_light`, which bounded_light.wgsl, second.wgsl give; the shader must choose one of them";
    assert!(fault.ends_with(expected), "{fault}");
    // The chosen one counts, whatever other files give.
    let other = "// Gives: light_along.\n";
    fs::write(folder.0.join("second.wgsl"), other).unwrap();
    assert_eq!(folder.linked(&text), text);
}

#[test]
fn a_file_that_is_gone_is_missed_by_those_that_need_it() {
    let folder = Folder::new("shaders-gone");
    fs::remove_file(folder.0.join("view/redshift.wgsl")).unwrap();
    let scene = Scene {
        view: View::Redshift,
        ..Scene::default()
    };
    let fault = folder.fault(&Variant::picture(&scene).text());
    assert!(fault.contains("light_along"), "{fault}");
    let missing = ShaderFiles::read(&folder.0.join("nowhere")).unwrap_err();
    assert!(missing.to_string().contains("nowhere"), "{missing}");
}

#[test]
fn files_of_other_encodings_are_read_or_named() {
    let folder = Folder::new("shaders-encoded");
    let text = Variant::picture(&Scene::default()).text();
    let path = folder.0.join("math.wgsl");
    let math = fs::read_to_string(&path).unwrap();
    let utf16 = math.encode_utf16().flat_map(u16::to_le_bytes);
    fs::write(
        &path,
        [0xff, 0xfe].into_iter().chain(utf16).collect::<Vec<u8>>(),
    )
    .unwrap();
    assert_eq!(folder.linked(&text), text);
    fs::write(&path, format!("\u{feff}{math}")).unwrap();
    assert_eq!(folder.linked(&text), text);
    fs::write(&path, b"// an angle in \xb0\n").unwrap();
    let fault = ShaderFiles::read(&folder.0).unwrap_err().to_string();
    let named = format!(
        "{} is not UTF-8 text: line 1 has the byte 0xB0",
        path.display()
    );
    assert!(fault.starts_with(&named), "{fault}");
}
