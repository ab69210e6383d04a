//! A display for one test: Xvfb, the program's window on it, keys by xdotool, and pictures from the
//! X server.

use crate::frames::Frames;
use crate::shot::Shot;
use crate::{STATUS_BAR, TITLE};
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{ConnectionExt, ImageFormat};
use x11rb::rust_connection::RustConnection;

/// Screen large enough for the default window.
const SCREEN: (u16, u16) = (1500, 900);
/// Time that a software renderer on a busy machine may need for a first picture, or for one more.
const PATIENCE: Duration = Duration::from_secs(120);
/// A picture that stays the same for this time and this number of frames is at rest: the screen
/// shows a frame only some frames after its keys.
const REST: Duration = Duration::from_millis(1200);
pub const FRAMES: usize = 4;
/// Maximum time to wait for frames: a hidden window shows none.
const MAX_WAIT: Duration = Duration::from_secs(10);

/// The display and the program on it. Dropping this value ends both.
pub struct Desktop {
    server: Child,
    pub program: Child,
    /// When the program was started.
    pub started: Instant,
    /// The user's home, with an empty folder for pictures and one for settings.
    pub home: tempfile::TempDir,
    display: String,
    pub connection: RustConnection,
    pub root: u32,
    screen: (u16, u16),
    pub window: String,
    /// None before there is a window.
    frames: Option<Frames>,
}

impl Desktop {
    /// Opens a display and the program's window on it.
    pub fn open(arguments: &[&str]) -> Self {
        Self::open_program(Path::new(env!("CARGO_BIN_EXE_lightfall")), arguments)
    }

    /// As [`open`](Self::open), with a settings file.
    pub fn open_with_settings(settings: &str, arguments: &[&str]) -> Self {
        Self::open_prepared(&[("settings.toml", settings.to_owned())], arguments)
    }

    /// As [`open`](Self::open), with files beside the settings.
    pub fn open_prepared(files: &[(&str, String)], arguments: &[&str]) -> Self {
        Self::start(
            SCREEN,
            Path::new(env!("CARGO_BIN_EXE_lightfall")),
            files,
            arguments,
        )
    }

    /// As [`open`](Self::open), for another program with a window of the same name.
    pub fn open_program(program: &Path, arguments: &[&str]) -> Self {
        Self::start(SCREEN, program, &[], arguments)
    }

    /// As [`open_program`](Self::open_program), with a settings file.
    pub fn open_program_with_settings(program: &Path, settings: &str, arguments: &[&str]) -> Self {
        let files = [("settings.toml", settings.to_owned())];
        Self::start(SCREEN, program, &files, arguments)
    }

    /// As [`open_program`](Self::open_program), on a screen of another size.
    pub fn open_on(screen: (u16, u16), program: &Path, arguments: &[&str]) -> Self {
        Self::start(screen, program, &[], arguments)
    }

    /// As [`open`](Self::open), with these variables of the environment.
    pub fn open_with_variables(variables: &[(&str, &str)], arguments: &[&str]) -> Self {
        let program = Path::new(env!("CARGO_BIN_EXE_lightfall"));
        Self::start_with(SCREEN, program, &[], variables, arguments)
    }

    /// As [`open_program`](Self::open_program), with these variables of the environment.
    pub fn open_program_with_variables(
        program: &Path,
        variables: &[(&str, &str)],
        arguments: &[&str],
    ) -> Self {
        Self::start_with(SCREEN, program, &[], variables, arguments)
    }

    fn start(
        screen: (u16, u16),
        program: &Path,
        files: &[(&str, String)],
        arguments: &[&str],
    ) -> Self {
        Self::start_with(screen, program, files, &[], arguments)
    }

    fn start_with(
        screen: (u16, u16),
        program: &Path,
        files: &[(&str, String)],
        variables: &[(&str, &str)],
        arguments: &[&str],
    ) -> Self {
        // A disk that moves never comes to rest; tests of its clock set a rate. Other programs read
        // no scene from their arguments.
        let mut arguments = arguments.to_vec();
        let sets_rate = |argument: &&str| argument.starts_with("disk.rate=");
        let reads_scene = program == Path::new(env!("CARGO_BIN_EXE_lightfall"));
        if reads_scene && !arguments.iter().any(sets_rate) {
            arguments.extend(["--set", "disk.rate=0"]);
        }
        for tool in ["Xvfb", "xdotool"] {
            let found = Command::new("sh")
                .args(["-c", &format!("command -v {tool}")])
                .output()
                .is_ok_and(|out| out.status.success());
            assert!(found, "{tool} is missing; ./check installs it");
        }
        let mut server = Command::new("Xvfb")
            .args([
                "-displayfd",
                "1",
                "-nolisten",
                "tcp",
                "-screen",
                "0",
                &format!("{}x{}x24", screen.0, screen.1),
            ])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut number = String::new();
        BufReader::new(server.stdout.take().unwrap())
            .read_line(&mut number)
            .unwrap();
        let display = format!(":{}", number.trim());
        let home = tempfile::tempdir().unwrap();
        std::fs::create_dir(home.path().join("Pictures")).unwrap();
        let config = home.path().join("config");
        std::fs::create_dir_all(config.join("lightfall")).unwrap();
        for (name, text) in files {
            std::fs::write(config.join("lightfall").join(name), text).unwrap();
        }
        let stderr = std::fs::File::create(home.path().join("stderr")).unwrap();
        let started = Instant::now();
        let program = Command::new(program)
            .args(arguments)
            .env("DISPLAY", &display)
            .env_remove("WAYLAND_DISPLAY")
            .env("HOME", home.path())
            .env("XDG_CONFIG_HOME", config)
            .envs(variables.iter().copied())
            .stderr(stderr)
            .spawn()
            .unwrap();
        let (connection, number) = x11rb::connect(Some(&display)).unwrap();
        let root = connection.setup().roots[number].root;
        let (window, frames) = (String::new(), None);
        let mut desktop = Self {
            server,
            program,
            started,
            home,
            display,
            connection,
            root,
            screen,
            window,
            frames,
        };
        desktop.window = desktop.wait_for_window();
        desktop.frames = Some(Frames::of(
            &desktop.display,
            desktop.window.parse().unwrap(),
        ));
        // No window manager runs here, so nobody else gives the window the keyboard.
        desktop.xdotool(&["windowfocus", "--sync", &desktop.window.clone()]);
        desktop
    }

    pub fn xdotool(&self, arguments: &[&str]) -> String {
        let output = Command::new("xdotool")
            .args(arguments)
            .env("DISPLAY", &self.display)
            .output()
            .unwrap();
        // A search without a result is no failure of the tool.
        assert!(
            output.status.success() || arguments[0] == "search",
            "xdotool {arguments:?} failed"
        );
        String::from_utf8_lossy(&output.stdout).trim().to_owned()
    }

    fn wait_for_window(&mut self) -> String {
        let start = Instant::now();
        loop {
            let found = self.xdotool(&["search", "--name", "Lightfall"]);
            if let Some(window) = found.lines().next() {
                return window.to_owned();
            }
            assert!(self.running(), "the program ended before its window opened");
            assert!(start.elapsed() < PATIENCE, "no window");
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    /// Whether its window is still there.
    pub fn has_window(&self) -> bool {
        let found = self.xdotool(&["search", "--name", "Lightfall"]);
        found.lines().any(|window| window == self.window)
    }

    pub fn running(&mut self) -> bool {
        self.program.try_wait().unwrap().is_none()
    }

    /// How long it takes, from now, until the screen passes the condition.
    pub fn until(&self, what: &str, condition: impl Fn(&Shot) -> bool) -> Duration {
        let start = Instant::now();
        while !condition(&self.shot()) {
            assert!(
                start.elapsed() < PATIENCE,
                "{what}: the screen did not come to show it"
            );
        }
        start.elapsed()
    }

    /// The settings file.
    pub fn settings(&self) -> PathBuf {
        self.home.path().join("config/lightfall/settings.toml")
    }

    /// The display's name.
    pub fn display(&self) -> &str {
        &self.display
    }

    /// What the program has written to standard error.
    pub fn stderr(&self) -> String {
        std::fs::read_to_string(self.home.path().join("stderr")).unwrap()
    }

    /// Memory that the program holds, in bytes.
    pub fn memory(&self) -> usize {
        let status =
            std::fs::read_to_string(format!("/proc/{}/status", self.program.id())).unwrap();
        let line = status
            .lines()
            .find_map(|line| line.strip_prefix("VmRSS:"))
            .unwrap();
        1024 * line
            .trim()
            .trim_end_matches(" kB")
            .parse::<usize>()
            .unwrap()
    }

    /// Waits for so many frames more.
    pub fn frames(&self, count: usize) {
        let (Some(frames), start) = (&self.frames, Instant::now()) else {
            return;
        };
        let last = frames.shown() + count;
        while frames.shown() < last && start.elapsed() < MAX_WAIT {
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    /// Frames that are shown within a time.
    pub fn shown_within(&self, time: Duration) -> usize {
        let shown = || self.frames.as_ref().map_or(0, Frames::shown);
        let before = shown();
        std::thread::sleep(time);
        shown() - before
    }

    /// Waits until something is so.
    pub fn wait(&self, what: &str, so: impl Fn() -> bool) {
        let start = Instant::now();
        while !so() {
            assert!(
                start.elapsed() < PATIENCE,
                "{what} does not come: {}",
                self.stderr()
            );
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    pub fn title(&self) -> String {
        self.xdotool(&["getwindowname", &self.window])
    }

    pub fn shot(&self) -> Shot {
        let (width, height) = self.screen;
        let image = self
            .connection
            .get_image(ImageFormat::Z_PIXMAP, self.root, 0, 0, width, height, !0)
            .unwrap()
            .reply()
            .unwrap();
        Shot::new(width.into(), height.into(), image.data)
    }

    /// The screen once there is a picture, whole: more than the text at its top and bottom, and at
    /// rest.
    pub fn first_picture(&self) -> Shot {
        // On a busy machine bloom and the probe's meshes come some frames after the light.
        let lit = |shot: &Shot| {
            shot.rows(TITLE..self.size().1.saturating_sub(STATUS_BAR))
                .colours()
                > 2
        };
        self.settled("first picture", lit);
        self.settled("first picture at rest", lit)
    }

    /// The screen once two looks in a row, some frames and time apart, are the same and pass the
    /// condition.
    pub fn settled(&self, what: &str, condition: impl Fn(&Shot) -> bool) -> Shot {
        let start = Instant::now();
        let mut last = self.shot();
        loop {
            let look = Instant::now();
            self.frames(FRAMES);
            std::thread::sleep(REST.saturating_sub(look.elapsed()));
            let now = self.shot();
            if now == last && condition(&now) {
                return now;
            }
            assert!(
                start.elapsed() < PATIENCE,
                "{what}: the picture did not come to rest as expected"
            );
            last = now;
        }
    }
}

impl Drop for Desktop {
    fn drop(&mut self) {
        for child in [&mut self.program, &mut self.server] {
            // Ended already is as good as ended now.
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}
