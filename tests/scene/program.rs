//! The program itself, as a shell runs it: exit status, standard output, standard error.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process;

/// What the program itself says to a command line: its exit status, standard output and standard error.
fn program(folder: &Path, line: &str, input: &str) -> (i32, String, String) {
    let mut child = process::Command::new(env!("CARGO_BIN_EXE_lightfall"))
        .args(line.split_whitespace())
        .current_dir(folder)
        .stdin(process::Stdio::piped())
        .stdout(process::Stdio::piped())
        .stderr(process::Stdio::piped())
        .spawn()
        .unwrap();
    // Who refuses a command line reads no rays.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    let output = child.wait_with_output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

#[test]
fn a_wrong_command_line_is_status_two_and_a_sentence_that_names_it() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("afile"), "").unwrap();
    for (line, sentence) in [
        ("render -o a.xyz", "lightfall: a.xyz: unknown picture format \"xyz\"; allowed are .png and .exr\n"),
        (
            "render -o a.png --aov sky",
            "lightfall: --aov is for pictures of linear light: the file's name must end in .exr\n",
        ),
        (
            "render --frames 0..1 -o nowhere/a.exr",
            "lightfall: nowhere/a-0000.exr: cannot be written: there is no such folder\n",
        ),
        (
            "render --frames 0..1 --method reference -o a.exr",
            "lightfall: method = \"reference\" is refused: it runs on the CPU only, so here it must be auto, verlet, closed, mino or kerr-schild\n",
        ),
        ("render -o nowhere/a.png", "lightfall: nowhere/a.png: cannot be written: there is no such folder\n"),
        (
            "bench --quick --out afile",
            "lightfall: --out afile: afile is a file, and this must be a folder, or one that can be made\n",
        ),
        (
            "extremes --out afile/deep",
            "lightfall: --out afile/deep: afile is a file, and this must be a folder, or one that can be made\n",
        ),
    ] {
        assert_eq!(program(folder.path(), line, ""), (2, String::new(), sentence.into()), "{line}");
    }
    let (status, _, said) = program(folder.path(), "trace --rays nofile", "");
    assert!(status == 2 && said.starts_with("lightfall: nofile: cannot be read"), "{said}");
    let (status, _, said) = program(folder.path(), "trace --rays - --gpu zzz", "0,0,1");
    // Without any driver it is the driver that is missing.
    if !said.contains("no Vulkan adapter") {
        assert!(status == 2 && said.contains("--gpu zzz") && said.contains("--list-gpus"), "{said}");
    }
}

#[test]
fn no_rays_are_no_failure_but_are_told() {
    let folder = tempfile::tempdir().unwrap();
    for input in ["", "\n", "er,etheta,ephi\n"] {
        let (status, told, said) = program(folder.path(), "trace --rays - --device cpu", input);
        assert_eq!((status, told.lines().count()), (0, 1), "{told}");
        assert!(said.starts_with("lightfall: standard input: there are no rays"), "{said}");
    }
}
