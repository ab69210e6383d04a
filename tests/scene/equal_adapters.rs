//! A machine with two equal graphics adapters: Mesa's software driver, announced twice.

use crate::program::program_with;
use std::fs;
use std::path::{Path, PathBuf};

/// Two announcements of Mesa's software driver in this folder, as the list of drivers that Vulkan's loader
/// reads. `None` if the driver is not installed.
fn drivers(folder: &Path) -> Option<PathBuf> {
    let announced = fs::read_dir("/usr/share/vulkan/icd.d").ok()?;
    let software = announced
        .filter_map(|entry| Some(entry.ok()?.path()))
        .find(|path| path.to_string_lossy().contains("/lvp_icd"))?;
    let library = fs::read_to_string(software).ok()?;
    let files = ["one.json", "two.json"].map(|name| folder.join(name));
    for file in &files {
        fs::write(file, &library).unwrap();
    }
    std::env::join_paths(files).ok().map(PathBuf::from)
}

#[test]
#[ignore = "needs Mesa's software driver"]
fn equal_adapters_have_numbers_by_which_each_of_them_draws() {
    let folder = tempfile::tempdir().unwrap();
    let Some(list) = drivers(folder.path()) else {
        return;
    };
    let said = |line: &str| {
        let variables = ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"].map(|name| (name, list.as_path()));
        program_with(&variables, folder.path(), line, "0,0,1")
    };
    let (status, stdout, stderr) = said("--list-gpus");
    assert_eq!(status, 0, "{stderr}");
    let lines: Vec<&str> = stdout.lines().collect();
    let adapter = |line: &str| line.split_once(": ").unwrap().1.to_owned();
    assert_eq!(lines.len(), 2, "{stdout}");
    assert!(lines[0].starts_with("0: llvmpipe") && lines[1].starts_with("1: llvmpipe"));
    assert_eq!(adapter(lines[0]), adapter(lines[1]));

    let draw = "render --preset 2 --size 48x27 --aov steps -o";
    let pictures = ["0", "1"].map(|number| {
        let (status, _, stderr) = said(&format!("{draw} {number}.exr --gpu {number}"));
        assert_eq!(status, 0, "{number}: {stderr}");
        fs::read(folder.path().join(format!("{number}.exr"))).unwrap()
    });
    assert!(pictures[0] == pictures[1], "one driver, two pictures");

    // The name is that of both, and no third one exists.
    let several = format!(
        "lightfall: --gpu LLVM (or WGPU_ADAPTER_NAME) is refused: it means more than one adapter; the number or the PCI \
         bus id means one of them: {}; {}\n",
        lines[0], lines[1]
    );
    let none = format!(
        "lightfall: --gpu 2 (or WGPU_ADAPTER_NAME) is refused: it must be the number, the PCI bus id or a part of the name \
         of one of these adapters, which --list-gpus lists: {}; {}\n",
        lines[0], lines[1]
    );
    for command in ["--list-gpus", "trace --rays -", "render -o a.png", "doctor"] {
        for (given, sentence) in [("LLVM", &several), ("2", &none)] {
            let answer = said(&format!("{command} --gpu {given}"));
            assert_eq!(answer, (2, String::new(), sentence.clone()), "{command}");
        }
    }
    assert!(!folder.path().join("a.png").exists());
}
