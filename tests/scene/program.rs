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
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
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
        ("render -o a.xyz", "lightfall: a.xyz: unknown picture format \"xyz\"; allowed is .png\n"),
        (
            "render -o a",
            "lightfall: a: the name has no ending that says which picture format to write; allowed is .png\n",
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
}

#[test]
fn an_adapter_or_interface_that_is_not_there_is_answered_with_those_that_are() {
    let folder = tempfile::tempdir().unwrap();
    // No system has both.
    let foreign = if cfg!(windows) { "metal" } else { "dx12" };
    let by_interface = format!("--backend {foreign} (or WGPU_BACKEND) is refused");
    for (option, told) in
        [("--gpu zzz", "--gpu zzz (or WGPU_ADAPTER_NAME)"), (&format!("--backend {foreign}"), &by_interface)]
    {
        for command in ["trace --rays -", "render -o a.png", "--list-gpus", "bench --quick"] {
            let (status, answer, said) = program(folder.path(), &format!("{command} {option}"), "0,0,1");
            // Without any driver it is the driver that is missing.
            if !said.contains("no Vulkan adapter") {
                assert!(status == 2 && answer.is_empty() && said.contains(told), "{command} {option}: {said}");
            }
        }
    }
    assert!(!folder.path().join("a.png").exists());
}

#[test]
fn rays_that_are_none_are_a_bad_command_line() {
    let folder = tempfile::tempdir().unwrap();
    let line = "trace --rays - --device cpu";
    for input in ["", "\n", "er,etheta,ephi\n"] {
        let (status, told, said) = program(folder.path(), line, input);
        assert_eq!((status, told.as_str()), (2, ""));
        assert!(
            said.starts_with("lightfall: standard input: there are no rays; a ray is a line er,etheta,ephi"),
            "{said}"
        );
    }
    let (status, told, said) = program(folder.path(), line, "0,0,1\n0,0,fast\n");
    let sentence = "lightfall: standard input: line 2: ephi = \"fast\" is refused: it must be a finite number\n";
    assert_eq!((status, told.as_str(), said.as_str()), (2, "", sentence));
    assert_eq!(program(folder.path(), line, "0,0,1\n").0, 0);
}

#[test]
fn a_journey_is_checked_before_it_is_flown_and_without_a_display_its_first_moment_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let frames =
        |end: &str| format!("[[keyframe]]\ntime = 3\nr = 8\ntheta_deg = 30\n[[keyframe]]\ntime = 9\nr = {end}\n");
    fs::write(folder.path().join("mine.toml"), frames("0.9")).unwrap();
    let line = "--journey mine.toml --set picture.width=96 --set picture.height=54 --set picture.grid_width=48 --set \
                picture.grid_height=27";
    let (status, told, said) = program(folder.path(), line, "");
    assert!(status == 2 && told.is_empty(), "{said}");
    assert!(said.starts_with("lightfall: mine.toml: keyframe 2 (time = 9): camera.r = 0.9 is refused: "), "{said}");
    fs::write(folder.path().join("mine.toml"), frames("2")).unwrap();
    let (status, told, said) = program(folder.path(), line, "");
    if said.contains("no Vulkan adapter") {
        return;
    }
    assert_eq!((status, told.as_str()), (0, "lightfall-mine.png\n"), "{said}");
    assert!(said.contains("no display") && said.contains("the first moment of mine.toml"), "{said}");
    let still = "render -o still.png --set camera.r=8 --set camera.theta_deg=30";
    program(folder.path(), &line.replace("--journey mine.toml", still), "");
    let [moment, still] = ["lightfall-mine.png", "still.png"].map(|file| fs::read(folder.path().join(file)).unwrap());
    assert!(moment == still, "not the journey's first moment");
}
