//! The program as a shell runs it: exit status, standard output and standard error.

use lightfall_core::scene::presets::PRESETS;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process;
use std::time::{SystemTime, UNIX_EPOCH};

/// What the program itself says to a command line: its exit status, standard output and standard
/// error.
pub fn program(folder: &Path, line: &str, input: &str) -> (i32, String, String) {
    program_with(&[], folder, line, input)
}

/// The same with these variables of the environment.
pub fn program_with(
    variables: &[(&str, &Path)],
    folder: &Path,
    line: &str,
    input: &str,
) -> (i32, String, String) {
    let mut child = process::Command::new(env!("CARGO_BIN_EXE_lightfall"))
        .args(line.split_whitespace())
        .current_dir(folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .envs(variables.iter().copied())
        .stdin(process::Stdio::piped())
        .stdout(process::Stdio::piped())
        .stderr(process::Stdio::piped())
        .spawn()
        .unwrap();
    // A program that refuses its command line does not read standard input.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    let output = child.wait_with_output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (
        output.status.code().unwrap(),
        text(output.stdout),
        text(output.stderr),
    )
}

#[test]
fn a_wrong_command_line_is_status_two_and_a_sentence_that_names_it() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("afile"), "").unwrap();
    for (line, sentence) in [
        (
            "render -o a.xyz",
            "lightfall: a.xyz: unknown picture format \"xyz\"; allowed are .png, .apng, .exr, .mp4, .mov and .webm\n",
        ),
        (
            "render -o a.png --aov sky",
            "lightfall: --aov is for pictures of linear light: the file's name must end in .exr\n",
        ),
        (
            "render -o a.exr --bits 16",
            "lightfall: --bits 16 is for a picture whose file's name ends in .png\n",
        ),
        (
            "render -o a.png --bits 16 --cells on",
            "lightfall: --cells on: a picture with 16 bits has no cells\n",
        ),
        (
            "render -o a.png --size 8194x64 --cells on",
            "lightfall: --cells on: a picture of more than 8192 pixels to a side has no cells\n",
        ),
        (
            "render --frames 0..1 -o a.apng --size 8194x64",
            "lightfall: --size: the pictures of an .apng have at most 8192 pixels to a side; numbered .png pictures \
             may be larger\n",
        ),
        (
            "render -o a.png --size 8194x64 --timings",
            "lightfall: --timings: a picture of 8194 x 64 pixels is drawn in tiles, which are not timed; give a \
             --size of at most 8192 pixels to a side and 8847360 in all\n",
        ),
        (
            "render -o a.png --size 32768x32768",
            "lightfall: --size: picture.height = 32768 is refused: it must be an integer from 1 to 16384 pixels \
             (picture.width is 32768)\n",
        ),
        (
            "render -o a.png --exr piz",
            "lightfall: --exr is for pictures of linear light: the file's name must end in .exr\n",
        ),
        (
            "render --frames 0..1 -o a.png --bits 16 --cells off --shutter 0.5",
            "lightfall: --shutter: pictures with 16 bits, those of cubes and those that are drawn in tiles are not \
             blurred\n",
        ),
        (
            "render --frames 0..1 -o a.png --set view=order --shutter 0.5",
            "lightfall: --shutter: the colours of the view \"order\" have meanings, and a mean of them has none\n",
        ),
        (
            "render -o a.png --layers",
            "lightfall: --layers is for pictures of linear light: the file's name must end in .exr\n",
        ),
        (
            "render -o a.png --bits 16 --alpha sky",
            "lightfall: --alpha: a .png has transparent parts only with 8 bits; an .exr has them in any case\n",
        ),
        (
            "render -o a.png --cells on --alpha hole",
            "lightfall: --cells on: a picture with transparent parts has no cells\n",
        ),
        (
            "render --frames 0..1 -o a.apng --alpha sky",
            "lightfall: --alpha: an .apng has no transparent parts; numbered .png and .exr pictures may have them\n",
        ),
        (
            "render -o a.png --size 8194x64 --cells off --alpha sky",
            "lightfall: --alpha: a .png that is drawn in tiles has no transparent parts; an .exr of this size may have \
             them\n",
        ),
        (
            "render -o a.exr --alpha sky --set view=redshift",
            "lightfall: --alpha: only the view \"colour\" has light to divide, and view is \"redshift\"\n",
        ),
        (
            "render --frames 0..9 --shard 1/4 -o a.apng",
            "lightfall: --shard is for pictures in files of their own: the name must end in .png or .exr\n",
        ),
        (
            "render --frames 0..9 --resume -o a.apng",
            "lightfall: --resume is for pictures in files of their own: the name must end in .png or .exr\n",
        ),
        (
            "render --frames 0..1 -o a.apng --aov depth --nan zero",
            "lightfall: --aov is for pictures of linear light: the file's name must end in .exr\n",
        ),
        (
            "render --frames 0..1 --method reference -o a.exr",
            "lightfall: method = \"reference\" is refused: it runs on the CPU only, with `trace --device cpu`, so here it must be auto, verlet, closed, mino or kerr-schild\n",
        ),
        (
            "--preset shadow --journey layers",
            "lightfall: --preset shadow: this is a journey or a lesson, and --journey names one, too: one of the two \
             can be flown\n",
        ),
        (
            "render -o a",
            "lightfall: a: the name has no extension that says which picture format to write; allowed are .png, .apng, .exr, .mp4, .mov and .webm\n",
        ),
    ] {
        assert_eq!(
            program(folder.path(), line, ""),
            (2, String::new(), sentence.into()),
            "{line}"
        );
    }
    let (status, stdout, stderr) = program(folder.path(), "doctor --spin 3", "");
    assert!(
        status == 2 && stdout.is_empty() && stderr.starts_with("lightfall: --spin: hole.spin = 3"),
        "{stderr}"
    );
    let (status, _, stderr) = program(folder.path(), "trace --rays nofile", "");
    assert!(
        status == 2
            && stderr.starts_with("lightfall: nofile: cannot be read: there is no such file\n"),
        "{stderr}"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_error_about_an_unknown_adapter_or_interface_lists_the_available_ones() {
    let folder = tempfile::tempdir().unwrap();
    // No system has both.
    let foreign = if cfg!(windows) { "metal" } else { "dx12" };
    let by_interface = format!("--backend {foreign} (or WGPU_BACKEND) is refused");
    for (option, expected) in [
        ("--gpu zzz", "--gpu zzz (or WGPU_ADAPTER_NAME)"),
        (&format!("--backend {foreign}"), &by_interface),
    ] {
        for command in [
            "trace --rays -",
            "render -o a.png",
            "--list-gpus",
            "bench --quick",
        ] {
            let (status, stdout, stderr) =
                program(folder.path(), &format!("{command} {option}"), "0,0,1");
            // Without any driver it is the driver that is missing.
            if !stderr.contains("no Vulkan adapter") {
                assert!(
                    status == 2 && stdout.is_empty() && stderr.contains(expected),
                    "{command} {option}: {stderr}"
                );
            }
        }
    }
    assert!(!folder.path().join("a.png").exists());
}

/// A run that is stopped leaves its rows in a file. Here it is the start of a finished report.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_bench_that_was_stopped_goes_on_after_its_rows_unless_another_program_measured_them() {
    let folder = tempfile::tempdir().unwrap();
    let line = "bench --quick --scenes 5 --methods closed,mino --size 32x18 --rays 32 --out rows";
    let (table, partial) = (
        folder.path().join("rows/bench.csv"),
        folder.path().join("rows/bench.csv.partial"),
    );
    let (status, _, stderr) = program(folder.path(), line, "");
    assert_eq!(status, 0, "{stderr}");
    assert!(!partial.exists());
    let whole = fs::read_to_string(&table).unwrap();
    let rows = |text: &str| -> Vec<String> {
        let lines = text.lines().filter(|line| !line.starts_with('#'));
        lines.skip(1).map(str::to_owned).collect()
    };
    let count = rows(&whole).len();
    assert!(count > 2, "{whole}");
    let lines: Vec<&str> = whole.lines().collect();
    let stopped = lines[..lines.len() - (count - 2)].join("\n") + "\n";

    fs::write(&partial, &stopped).unwrap();
    let (status, _, stderr) = program(folder.path(), line, "");
    assert_eq!(status, 0, "{stderr}");
    assert!(stderr.contains("goes on after the 2 rows"), "{stderr}");
    let resumed = rows(&fs::read_to_string(&table).unwrap());
    // Times that were measured again would differ in some digit.
    assert_eq!(resumed[..2], rows(&whole)[..2]);
    assert_eq!(resumed.len(), count);
    assert!(!partial.exists());

    let of_another_adapter = stopped.replace("# adapter: ", "# adapter: not ");
    for (text, written, reason) in [
        (&of_another_adapter, SystemTime::now(), "adapter was not"),
        (&stopped, UNIX_EPOCH, "the program was built after them"),
    ] {
        fs::write(&partial, text).unwrap();
        let file = fs::File::options().write(true).open(&partial).unwrap();
        file.set_modified(written).unwrap();
        let (status, _, stderr) = program(folder.path(), line, "");
        assert_eq!(status, 0, "{stderr}");
        assert!(
            stderr.contains("starts anew") && stderr.contains(reason),
            "{stderr}"
        );
        assert!(!partial.exists());
    }
}

#[test]
fn missing_or_wrong_rays_are_a_bad_command_line() {
    let folder = tempfile::tempdir().unwrap();
    let line = "trace --rays - --device cpu";
    for input in ["", "\n", "er,etheta,ephi\n"] {
        let (status, stdout, stderr) = program(folder.path(), line, input);
        assert_eq!((status, stdout.as_str()), (2, ""));
        assert!(
            stderr.starts_with(
                "lightfall: standard input: there are no rays; a ray is a line er,etheta,ephi"
            ),
            "{stderr}"
        );
    }
    let (status, stdout, stderr) = program(folder.path(), line, "0,0,1\n0,0,fast\n");
    let sentence = "lightfall: standard input: line 2: ephi = \"fast\" is refused: it must be a finite number\n";
    assert_eq!(
        (status, stdout.as_str(), stderr.as_str()),
        (2, "", sentence)
    );
    assert_eq!(program(folder.path(), line, "0,0,1\n").0, 0);
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_journey_is_checked_before_it_is_flown_and_without_a_display_its_first_moment_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let frames = |end: &str| {
        format!(
            "[[keyframe]]\ntime = 3\nr = 8\ntheta_deg = 30\n[[keyframe]]\ntime = 9\nr = {end}\n"
        )
    };
    fs::write(folder.path().join("mine.toml"), frames("0.9")).unwrap();
    let line = "--journey mine.toml --spin 0 --set picture.width=96 --set picture.height=54 --set picture.grid_width=48 --set \
                picture.grid_height=27";
    let (status, stdout, stderr) = program(folder.path(), line, "");
    assert!(status == 2 && stdout.is_empty(), "{stderr}");
    assert!(
        stderr.starts_with(
            "lightfall: mine.toml: keyframe 2 (time = 9): camera.r = 0.9 is refused: "
        ),
        "{stderr}"
    );
    fs::write(folder.path().join("mine.toml"), frames("2")).unwrap();
    let (status, stdout, stderr) = program(folder.path(), line, "");
    assert_eq!(
        (status, stdout.as_str()),
        (0, "lightfall-mine.png\n"),
        "{stderr}"
    );
    assert!(
        stderr.contains("no display") && stderr.contains("the first moment of mine.toml"),
        "{stderr}"
    );
    let still = "render -o still.png --set camera.r=8 --set camera.theta_deg=30";
    program(
        folder.path(),
        &line.replace("--journey mine.toml", still),
        "",
    );
    // Their presets differ in the last digit of r, which a journey leads along by its logarithm.
    let pixels = |file: &str| image::open(folder.path().join(file)).unwrap();
    let [moment, still] = ["lightfall-mine.png", "still.png"].map(pixels);
    assert!(moment == still, "not the journey's first moment");
}

/// What the doctor says as JSON, in a home of its own.
#[cfg(target_os = "linux")]
fn examined(home: &Path, variables: &[(&str, &Path)]) -> (i32, serde_json::Value) {
    let config = home.join("config");
    let variables = [&[("HOME", home), ("XDG_CONFIG_HOME", &config)], variables].concat();
    let (status, stdout, _) = program_with(&variables, home, "doctor --json --preset 8", "");
    (status, serde_json::from_str(&stdout).unwrap())
}

#[cfg(target_os = "linux")]
#[test]
#[ignore = "needs a graphics adapter"]
fn the_doctor_reports_on_the_machine_and_changes_nothing() {
    let home = tempfile::tempdir().unwrap();
    let (status, report) = examined(home.path(), &[]);
    let adapters = report["adapters"].as_array().unwrap();
    assert_eq!(
        (status, &report["well"], &report["faults"]),
        (0, &true.into(), &serde_json::json!([])),
        "{report:#}"
    );
    assert_eq!(report["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(
        adapters
            .iter()
            .filter(|adapter| adapter["used"] == true)
            .count(),
        1
    );
    assert_eq!(report["settings"]["exists"], false);
    assert_eq!(
        report["folders"]
            .as_array()
            .unwrap()
            .iter()
            .filter(|folder| folder["wrong"].is_null())
            .count(),
        3
    );
    // The shaders of all presets and of the scene at hand.
    let shaders = &report["shaders"];
    let scenes = shaders["scenes"].as_array().unwrap();
    assert_eq!(scenes.len(), PRESETS.len() + 1);
    assert_eq!(scenes[PRESETS.len()], "extremal");
    assert_eq!(shaders["faults"], serde_json::json!([]));
    let trials = report["trials"].as_array().unwrap();
    assert_eq!(trials.len(), 2);
    for trial in trials {
        let number = |key: &str| trial[key].as_f64().unwrap();
        assert!(
            trial["holds"] == true && number("rays") >= 500.0 && number("trace_ms_1920x1080") > 0.0,
            "{trial:#}"
        );
        // An error of nothing at all would be that of nothing measured: f32 alone leaves 6e-8.
        assert!(
            number("backward_max") > 1e-8 && number("backward_max") <= number("stated_max"),
            "{trial:#}"
        );
    }
    // Drivers keep their caches; the program leaves nothing.
    let left = fs::read_dir(home.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let left: Vec<String> = left
        .filter(|name| name == "config" || name.contains("lightfall"))
        .collect();
    assert!(left.is_empty(), "{left:?}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_fault_that_the_doctor_finds_is_status_one_with_what_to_do() {
    let home = tempfile::tempdir().unwrap();
    let no_driver = home.path().join("none.json");
    let without = [
        ("VK_DRIVER_FILES", no_driver.as_path()),
        ("VK_ICD_FILENAMES", &no_driver),
    ];
    let faults_of = |variables: &[(&str, &Path)]| {
        let (status, report) = examined(home.path(), &[&without, variables].concat());
        assert_eq!((status, &report["well"]), (1, &false.into()));
        report["faults"]
            .as_array()
            .unwrap()
            .iter()
            .map(|fault| fault.as_str().unwrap().to_owned())
            .collect::<Vec<_>>()
    };
    let faults = faults_of(&[]);
    assert!(
        faults.len() == 1 && faults[0].starts_with("no Vulkan adapter was found: install"),
        "{faults:?}"
    );
    let file = home.path().join("config/lightfall/settings.toml");
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    fs::write(&file, "frame_rate = 1").unwrap();
    let faults = faults_of(&[]);
    let sentence = format!(
        "{}: frame_rate = 1 is refused: it must be a number from 5 to 240; mend or",
        file.display()
    );
    assert!(
        faults.len() == 2 && faults[1].starts_with(&sentence),
        "{faults:?}"
    );
    assert_eq!(
        fs::read_to_string(&file).unwrap(),
        "frame_rate = 1",
        "it is only looked at"
    );
    // A file where folders should be.
    let faults = faults_of(&[("XDG_CONFIG_HOME", &file)]);
    let presets = format!(
        "{}: {} is a file and no folder, so no presets",
        file.join("lightfall/presets").display(),
        file.display()
    );
    assert!(
        faults.iter().any(|fault| fault.starts_with(&presets)),
        "{faults:?}"
    );
    // For people: a name and what is found, then what to do.
    let fresh = home.path().join("fresh");
    let own = [
        &without[..],
        &[("HOME", home.path()), ("XDG_CONFIG_HOME", &fresh)],
    ]
    .concat();
    let (status, stdout, stderr) = program_with(&own, home.path(), "doctor", "");
    assert!(
        status == 1
            && stderr == "lightfall: problems found: 1; the report says what to do about each\n",
        "{stderr}"
    );
    assert!(
        stdout.contains("\nadapter     none\n")
            && stdout.contains("\nNot well:\n* no Vulkan adapter was found"),
        "{stdout}"
    );
}

#[test]
#[cfg(target_os = "linux")]
fn a_users_own_preset_is_found_by_name_and_listed() {
    let home = tempfile::tempdir().unwrap();
    let config = home.path().join("config");
    let folder = config.join("lightfall/presets");
    fs::create_dir_all(&folder).unwrap();
    fs::write(
        folder.join("my_hole.toml"),
        "schema = 1\nhole.spin = 0.25\n",
    )
    .unwrap();
    let own: [(&str, &Path); 2] = [("HOME", home.path()), ("XDG_CONFIG_HOME", &config)];
    let ask = |line: &str| program_with(&own, home.path(), line, "");
    let (status, shown, _) = ask("presets show my_hole");
    assert!(status == 0 && shown.contains("spin = 0.25"), "{shown}");
    assert!(
        ask("presets list")
            .1
            .lines()
            .last()
            .unwrap()
            .contains("my_hole")
    );
    // A built-in name stays the built-in preset's, and one that nobody has is still refused.
    fs::write(
        folder.join("edge-on.toml"),
        "schema = 1\nhole.spin = 0.25\n",
    )
    .unwrap();
    assert!(ask("presets show edge-on").1.contains("spin = 0.9"));
    assert_eq!(ask("presets show my_other").0, 2);
    // That of a lesson does not: the lesson is `--journey`'s.
    assert_eq!(ask("presets show shadow").0, 2);
    fs::write(folder.join("shadow.toml"), "schema = 1\nhole.spin = 0.25\n").unwrap();
    let (status, shown, _) = ask("presets show shadow");
    assert!(status == 0 && shown.contains("spin = 0.25"), "{shown}");
    assert!(ask("presets check shadow").1.starts_with("shadow: ok\n"));
    // What is piped can be read once.
    let lesson = fs::read_to_string("assets/journeys/shadow.toml").unwrap();
    for (text, answer) in [
        ("schema = 1\n", "ok\n"),
        (lesson.as_str(), "ok, a journey of "),
    ] {
        let (status, said, _) = program_with(&own, home.path(), "presets check /dev/stdin", text);
        assert!(status == 0 && said.contains(answer), "{said}");
    }
}
