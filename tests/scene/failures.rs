//! What the program says when it cannot start: without a graphics driver, a display, or a folder that
//! it may write to. Every answer is one sentence with what to do, and never a panic.
#![cfg(target_os = "linux")]

use lightfall_core::gpu::driver_advice;
use std::ffi::OsStr;
use std::fs;
use std::io::{BufRead, BufReader};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};

const PROGRAM: &str = env!("CARGO_BIN_EXE_lightfall");

/// The program with a command line, in a folder that is its home too, without a display.
fn lightfall(folder: &Path, line: &str) -> Command {
    prepared(Command::new(PROGRAM), folder, line)
}

/// The same, held to the permissions of files even as root.
fn held_to_permissions(folder: &Path, line: &str) -> Command {
    let mut command = Command::new("setpriv");
    command
        .arg("--bounding-set=-dac_override,-dac_read_search")
        .arg("--inh-caps=-dac_override,-dac_read_search")
        .arg(PROGRAM);
    if is_root() {
        prepared(command, folder, line)
    } else {
        lightfall(folder, line)
    }
}

fn is_root() -> bool {
    // Every process may look at itself.
    std::os::unix::fs::MetadataExt::uid(&fs::metadata("/proc/self").unwrap()) == 0
}

fn prepared(mut command: Command, folder: &Path, line: &str) -> Command {
    command
        .args(line.split_whitespace())
        .current_dir(folder)
        .env("HOME", folder)
        .stdin(Stdio::null());
    for variable in [
        "DISPLAY",
        "WAYLAND_DISPLAY",
        "XDG_CONFIG_HOME",
        "XDG_DATA_HOME",
        "XDG_PICTURES_DIR",
    ] {
        command.env_remove(variable);
    }
    command
}

/// Exit status, standard output and standard error.
fn said(command: &mut Command) -> (i32, String, String) {
    let Output {
        status,
        stdout,
        stderr,
    } = command.output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (status.code().unwrap(), text(stdout), text(stderr))
}

/// The program without any graphics driver: the list of drivers names a file that does not exist.
fn without_driver(command: &mut Command) -> &mut Command {
    for list in ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"] {
        command.env(list, "/nonexistent/driver.json");
    }
    command
}

/// An X server without a screen. Dropping it ends it.
struct Display {
    server: Child,
    name: String,
}

impl Display {
    fn open() -> Self {
        let mut server = Command::new("Xvfb")
            .args("-displayfd 1 -nolisten tcp -screen 0 640x360x24".split(' '))
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb is missing; ./check installs it");
        let mut number = String::new();
        BufReader::new(server.stdout.take().unwrap())
            .read_line(&mut number)
            .unwrap();
        let name = format!(":{}", number.trim());
        Self { server, name }
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        self.server.kill().ok();
        self.server.wait().ok();
    }
}

/// A folder that nobody may write to.
fn read_only_folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    set_mode(folder.path(), 0o555);
    folder
}

fn set_mode(folder: &Path, mode: u32) {
    fs::set_permissions(folder, fs::Permissions::from_mode(mode)).unwrap();
}

#[test]
fn without_a_driver_every_command_that_needs_one_ends_with_the_sentence_that_says_what_to_install()
{
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("rays"), "0,0,1\n").unwrap();
    let sentence = format!("lightfall: {}\n", driver_advice::without_adapter("linux"));
    for line in [
        "--preset 2",
        "--list-gpus",
        "render --preset 2 -o a.png",
        "render --preset 2 -o a.exr",
        "trace --rays rays",
        "bench --quick",
        "extremes",
    ] {
        let answer = said(without_driver(&mut lightfall(folder.path(), line)));
        assert_eq!(answer, (1, String::new(), sentence.clone()), "{line}");
    }
    let left = fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(left, 1, "only the file of rays");
    // What needs no driver works without one.
    let line = "trace --rays rays --device cpu";
    let (status, stdout, stderr) = said(without_driver(&mut lightfall(folder.path(), line)));
    assert_eq!((status, stdout.lines().count()), (0, 2), "{stderr}");
}

#[test]
#[ignore = "needs Xvfb"]
fn without_a_driver_no_window_is_opened_on_a_display_that_works() {
    let display = Display::open();
    let folder = tempfile::tempdir().unwrap();
    let mut command = lightfall(folder.path(), "--preset 2");
    let answer = said(without_driver(&mut command).env("DISPLAY", &display.name));
    let sentence = format!("lightfall: {}\n", driver_advice::without_adapter("linux"));
    assert_eq!(answer, (1, String::new(), sentence));
}

#[test]
#[ignore = "needs a graphics adapter"]
fn without_a_display_and_without_a_folder_for_the_picture_both_are_said_at_once() {
    let folder = read_only_folder();
    for (variables, reason) in [
        (
            &[][..],
            "neither DISPLAY nor WAYLAND_DISPLAY names one".to_owned(),
        ),
        (
            &[("DISPLAY", ":4095")],
            "the X server :4095 does not answer: ".to_owned(),
        ),
        (
            &[("WAYLAND_DISPLAY", "wayland-none")],
            "the Wayland server wayland-none does not answer".to_owned(),
        ),
    ] {
        let mut command = held_to_permissions(folder.path(), "--preset 2");
        let (status, stdout, stderr) = said(command.envs(variables.iter().copied()));
        assert_eq!((status, stdout.as_str()), (1, ""), "{stderr}");
        let start = format!("lightfall: no display ({reason}");
        let end = "lightfall-edge-on.png: cannot be written: permission denied; start the program in a folder that you may \
                   write to, or use `lightfall render -o FILE`\n";
        assert!(
            stderr.starts_with(&start) && stderr.ends_with(end) && stderr.lines().count() == 1,
            "{stderr}"
        );
    }
}

/// What `lightfall doctor` finds wrong, with these variables.
fn faults(command: &mut Command) -> Vec<String> {
    let (status, stdout, stderr) = said(without_driver(command));
    assert!(!stderr.contains("panicked"), "{stderr}");
    assert_eq!(status, 1, "{stderr}");
    let report: serde_json::Value = serde_json::from_str(&stdout).unwrap();
    let faults = report["faults"].as_array().unwrap().iter();
    // The first is the missing driver, without which the test is over in a moment.
    faults
        .skip(1)
        .map(|fault| fault.as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn folders_that_cannot_be_written_are_named_with_what_they_are_for() {
    let home = tempfile::tempdir().unwrap();
    let settings = home.path().join(".config/lightfall");
    let pictures = home.path().join("Pictures");
    for folder in [&settings, &pictures] {
        fs::create_dir_all(folder).unwrap();
        set_mode(folder, 0o555);
    }
    let line = "doctor --json";
    let found = faults(&mut held_to_permissions(home.path(), line));
    let expected = |folder: &Path, holds: &str| {
        format!(
            "{}: cannot be written (permission denied), so no {holds} can be saved; make it a folder that you may write to",
            folder.display()
        )
    };
    let all = [
        expected(&settings, "settings"),
        expected(&settings.join("presets"), "presets"),
        expected(&pictures, "pictures"),
    ];
    assert_eq!(found, all);
    for folder in [&settings, &pictures] {
        set_mode(folder, 0o755);
    }
    assert!(faults(&mut held_to_permissions(home.path(), line)).is_empty());
}

#[test]
fn a_home_that_does_not_exist_or_is_not_named_stops_nothing() {
    let folder = tempfile::tempdir().unwrap();
    for home in [Some("/nonexistent/home"), Some(""), None] {
        let set = |line: &str| {
            let mut command = held_to_permissions(folder.path(), line);
            match home {
                Some(home) => command.env("HOME", home),
                None => command.env_remove("HOME"),
            };
            command
        };
        let (status, stdout, stderr) = said(&mut set("presets list"));
        assert!(status == 0 && stdout.contains("edge-on"), "{stderr}");
        // Which folders the doctor names depends on the system's list of users, but it names them.
        let (_, stdout, stderr) = said(without_driver(&mut set("doctor --json")));
        let report: serde_json::Value = serde_json::from_str(&stdout).unwrap();
        assert_eq!(report["folders"].as_array().unwrap().len(), 3, "{stderr}");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_home_that_cannot_be_written_stops_no_picture() {
    let home = read_only_folder();
    let folder = tempfile::tempdir().unwrap();
    let line = "render --preset 2 --size 64x36 -o a.png";
    let mut command = held_to_permissions(folder.path(), line);
    let (status, stdout, stderr) = said(command.env("HOME", home.path()));
    assert_eq!((status, stdout.as_str()), (0, "a.png\n"), "{stderr}");
}

#[test]
fn settings_of_a_newer_version_are_named_by_the_doctor_and_left_alone() {
    let home = tempfile::tempdir().unwrap();
    let file = home.path().join(".config/lightfall/settings.toml");
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    let text = "version = 999\nwarp_drive = true\n";
    fs::write(&file, text).unwrap();
    let found = faults(&mut lightfall(home.path(), "doctor --json"));
    let sentence = format!(
        "{}: version = 999 is that of a newer Lightfall, and this one reads versions up to 1; update Lightfall, or rename \
         the file; until then the window uses the default settings and leaves the file as it is",
        file.display()
    );
    assert_eq!(found, [sentence]);
    assert_eq!(fs::read_to_string(&file).unwrap(), text);
}

/// A Wayland server that accepts the program and says nothing more is a fault that the program does
/// not expect: the window system panics.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_crash_of_the_program_leaves_a_report_with_adapter_and_scene_and_is_status_one() {
    let home = tempfile::tempdir().unwrap();
    let socket = home.path().join("wayland-mute");
    let server = std::os::unix::net::UnixListener::bind(&socket).unwrap();
    // Every connection is closed at once.
    std::thread::spawn(move || server.incoming().for_each(drop));
    let data = home.path().join("data");
    let blocked = home.path().join("file");
    fs::write(&blocked, "").unwrap();
    let crash = |data: &OsStr, temporary: &OsStr| {
        let mut command = lightfall(home.path(), "--preset 2 --set camera.r=12.25");
        command
            .env("WAYLAND_DISPLAY", &socket)
            .env("XDG_DATA_HOME", data)
            .env("TMPDIR", temporary);
        let (status, stdout, stderr) = said(&mut command);
        assert_eq!((status, stdout.as_str()), (1, ""), "{stderr}");
        stderr.lines().last().unwrap().to_owned()
    };
    let place = "Please send this report to its makers: ";
    for (data, temporary, expected) in [
        (&data, home.path(), data.join("lightfall")),
        // Without a folder for reports, the one for temporary files.
        (&blocked, home.path(), home.path().to_owned()),
    ] {
        let last = crash(data.as_os_str(), temporary.as_os_str());
        let (_, file) = last.split_once(place).unwrap_or_else(|| panic!("{last}"));
        assert_eq!(Path::new(file).parent(), Some(expected.as_path()), "{last}");
        let report = fs::read_to_string(file).unwrap();
        for part in [
            env!("CARGO_PKG_VERSION"),
            "Failed to build event loop",
            "== graphics adapter\n",
            "r = 12.25",
            "== end of the log",
            "== backtrace",
        ] {
            assert!(report.contains(part), "{part} is not in {report}");
        }
        let adapter = report.split("== graphics adapter\n").nth(1).unwrap();
        let adapter = adapter.lines().next().unwrap();
        assert!(
            adapter.contains('('),
            "no adapter with its interface: {adapter}"
        );
    }
    let last = crash(blocked.as_os_str(), blocked.as_os_str());
    assert!(last.contains("no report could be written: "), "{last}");
}
