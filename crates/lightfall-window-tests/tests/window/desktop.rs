//! A display for one test: Xvfb, the watched program's window on it, keys by xdotool, pictures from
//! the X server, and states from the program.

use crate::shot::Shot;
use std::cell::{Cell, RefCell};
use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::time::{Duration, Instant};
use watched::{Order, STATE_FILE, State};
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{ConnectionExt, ImageFormat};
use x11rb::rust_connection::RustConnection;

/// The watched program.
pub const PROGRAM: &str = env!("CARGO_BIN_EXE_lightfall-watched");

/// Maximum time to wait: a software renderer on a busy machine may need seconds for a frame, and a
/// minute for a new shader.
const PATIENCE: Duration = Duration::from_secs(120);
/// Time between two looks at a state: less than a frame takes.
const POLL: Duration = Duration::from_millis(10);
/// A picture that was drawn for so many frames in a row is on the screen, and the systems that
/// follow its last change have run.
const RESTED: u32 = 5;
/// Frames between two looks at a picture at rest.
const APART: u32 = 2;
/// Frames within which a key has done what it does.
const PROMPT: u32 = 3;

/// A screen on which the window is a quarter as large, for tests about something else than the
/// window's own places: a software renderer draws it in a third of the time.
pub const SMALL_SCREEN: (u16, u16) = (800, 600);

/// What a display and its program are given.
pub struct Setup<'a> {
    /// The size of the screen: large enough for the default window.
    pub screen: (u16, u16),
    /// Files beside the settings, each with its name and text.
    pub files: &'a [(&'a str, String)],
    /// Variables of the environment.
    pub variables: &'a [(&'a str, &'a str)],
}

impl Default for Setup<'_> {
    fn default() -> Self {
        Self {
            screen: (1500, 900),
            files: &[],
            variables: &[],
        }
    }
}

/// The display and the program on it. Dropping this value ends both.
pub struct Desktop {
    server: Child,
    pub program: Child,
    orders: RefCell<ChildStdin>,
    /// The number of orders given.
    ordered: Cell<u32>,
    /// When the program was started.
    pub started: Instant,
    /// The user's home, with an empty folder for pictures and one for settings.
    pub home: tempfile::TempDir,
    display: String,
    pub connection: RustConnection,
    pub root: u32,
    screen: (u16, u16),
    pub window: String,
}

/// Starts an X server with a screen of this size. Returns it with the name of its display.
pub fn start_server((width, height): (u16, u16)) -> (Child, String) {
    let mut server = Command::new("Xvfb")
        .args(["-displayfd", "1", "-nolisten", "tcp", "-screen", "0"])
        .arg(format!("{width}x{height}x24"))
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut number = String::new();
    BufReader::new(server.stdout.take().unwrap())
        .read_line(&mut number)
        .unwrap();
    (server, format!(":{}", number.trim()))
}

impl Desktop {
    /// Opens a display and the program's window on it.
    pub fn open(arguments: &[&str]) -> Self {
        Self::open_with(&Setup::default(), arguments)
    }

    /// As [`open`](Self::open), on a small screen.
    pub fn open_small(arguments: &[&str]) -> Self {
        let setup = Setup {
            screen: SMALL_SCREEN,
            ..Setup::default()
        };
        Self::open_with(&setup, arguments)
    }

    /// As [`open`](Self::open), with a settings file.
    pub fn open_with_settings(settings: &str, arguments: &[&str]) -> Self {
        let setup = Setup {
            files: &[("settings.toml", settings.to_owned())],
            ..Setup::default()
        };
        Self::open_with(&setup, arguments)
    }

    /// As [`open_small`](Self::open_small), with variables of the environment.
    pub fn open_with_variables(variables: &[(&str, &str)], arguments: &[&str]) -> Self {
        let setup = Setup {
            screen: SMALL_SCREEN,
            variables,
            ..Setup::default()
        };
        Self::open_with(&setup, arguments)
    }

    /// As [`open`](Self::open), with all of a setup.
    pub fn open_with(setup: &Setup, arguments: &[&str]) -> Self {
        // A disk that moves never comes to rest; tests of its clock set a rate.
        let mut arguments = arguments.to_vec();
        if !arguments.iter().any(|word| word.starts_with("disk.rate=")) {
            arguments.extend(["--set", "disk.rate=0"]);
        }
        for tool in ["Xvfb", "xdotool"] {
            let found = Command::new("sh")
                .args(["-c", &format!("command -v {tool}")])
                .output()
                .is_ok_and(|out| out.status.success());
            assert!(found, "{tool} is missing; ./check installs it");
        }
        let (server, display) = start_server(setup.screen);
        let home = tempfile::tempdir().unwrap();
        std::fs::create_dir(home.path().join("Pictures")).unwrap();
        let config = home.path().join("config");
        std::fs::create_dir_all(config.join("lightfall")).unwrap();
        for (name, text) in setup.files {
            let file = config.join("lightfall").join(name);
            std::fs::create_dir_all(file.parent().unwrap()).unwrap();
            std::fs::write(file, text).unwrap();
        }
        let stderr = std::fs::File::create(home.path().join("stderr")).unwrap();
        let started = Instant::now();
        let mut program = Command::new(PROGRAM)
            .args(arguments)
            .env("DISPLAY", &display)
            .env_remove("WAYLAND_DISPLAY")
            .env("HOME", home.path())
            .env("XDG_CONFIG_HOME", config)
            .env(STATE_FILE, home.path().join("state.json"))
            .envs(setup.variables.iter().copied())
            .stdin(Stdio::piped())
            .stderr(stderr)
            .spawn()
            .unwrap();
        let (connection, number) = x11rb::connect(Some(&display)).unwrap();
        let root = connection.setup().roots[number].root;
        let mut desktop = Self {
            server,
            orders: RefCell::new(program.stdin.take().unwrap()),
            ordered: Cell::new(0),
            program,
            started,
            home,
            display,
            connection,
            root,
            screen: setup.screen,
            window: String::new(),
        };
        desktop.window = desktop.wait_for_window();
        // No window manager runs here, so nobody else gives the window the keyboard.
        desktop.xdotool(&["windowfocus", "--sync", &desktop.window.clone()]);
        desktop.wait("a first state", || desktop.read_state().is_some());
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
        loop {
            // A window that is not shown yet cannot have the keyboard.
            let found = self.xdotool(&["search", "--onlyvisible", "--name", "Lightfall"]);
            if let Some(window) = found.lines().next() {
                return window.to_owned();
            }
            assert!(self.running(), "the program ended: {}", self.stderr());
            assert!(self.started.elapsed() < PATIENCE, "no window");
            std::thread::sleep(POLL);
        }
    }

    pub fn running(&mut self) -> bool {
        self.program.try_wait().unwrap().is_none()
    }

    /// Waits for the program to end by itself.
    #[track_caller]
    pub fn ended(&mut self) -> std::process::ExitStatus {
        let start = Instant::now();
        loop {
            if let Some(status) = self.program.try_wait().unwrap() {
                return status;
            }
            assert!(start.elapsed() < PATIENCE, "the program still runs");
            std::thread::sleep(POLL);
        }
    }

    /// Ends a test whose program still runs and has reported no error.
    #[track_caller]
    pub fn end_without_error(mut self) {
        let stderr = self.stderr();
        let has_failed = ["ERROR", "panicked"]
            .iter()
            .any(|word| stderr.contains(word));
        assert!(self.running() && !has_failed, "{stderr}");
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

    pub fn title(&self) -> String {
        self.xdotool(&["getwindowname", &self.window])
    }

    /// The part of the screen that the window covers.
    pub fn shot(&self) -> Shot {
        let (width, height) = self.size();
        let width = width.min(self.screen.0.into()) as u16;
        let height = height.min(self.screen.1.into()) as u16;
        let image = self
            .connection
            .get_image(ImageFormat::Z_PIXMAP, self.root, 0, 0, width, height, !0)
            .unwrap()
            .reply()
            .unwrap();
        Shot::new(width.into(), height.into(), image.data)
    }

    fn read_state(&self) -> Option<State> {
        let bytes = std::fs::read(self.home.path().join("state.json")).ok()?;
        Some(serde_json::from_slice(&bytes).unwrap())
    }

    /// The state after the last frame.
    pub fn state(&self) -> State {
        self.read_state().unwrap()
    }

    /// Waits for a state, and returns it.
    #[track_caller]
    pub fn wait_for(&self, what: &str, so: impl Fn(&State) -> bool) -> State {
        let start = Instant::now();
        loop {
            let state = self.state();
            if so(&state) {
                return state;
            }
            assert!(
                start.elapsed() < PATIENCE,
                "{what} does not come: {state:#?} {}",
                self.stderr()
            );
            std::thread::sleep(POLL);
        }
    }

    /// The state so many frames later.
    #[track_caller]
    pub fn later(&self, frames: u32) -> State {
        let last = self.state().frame + frames;
        self.wait_for("more frames", |state| state.frame >= last)
    }

    /// Waits until something is so that no state says.
    #[track_caller]
    pub fn wait(&self, what: &str, so: impl Fn() -> bool) {
        let start = Instant::now();
        while !so() {
            assert!(
                start.elapsed() < PATIENCE,
                "{what} does not come: {}",
                self.stderr()
            );
            std::thread::sleep(POLL);
        }
    }

    /// Gives an order, and does not wait for the program.
    pub fn give(&self, order: &Order) {
        let line = serde_json::to_string(order).unwrap();
        writeln!(self.orders.borrow_mut(), "{line}").unwrap();
        self.ordered.set(self.ordered.get() + 1);
    }

    /// Gives an order, and returns the first state after it was obeyed.
    #[track_caller]
    pub fn order(&self, order: &Order) -> State {
        self.give(order);
        let ordered = self.ordered.get();
        self.wait_for("the order", |state| state.orders >= ordered)
    }

    /// Presses and lets go of a key, named as X names it, and returns the state when the key has done
    /// what it does.
    #[track_caller]
    pub fn press(&self, key: &str) -> State {
        let before = self.state().keys;
        self.press_at_once(key);
        let pressed = self.wait_for(key, |state| state.keys > before).frame;
        self.wait_for(key, |state| state.frame >= pressed + PROMPT)
    }

    /// How long it takes, from now, until the screen passes the condition.
    #[track_caller]
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

    /// The screen once all of the first picture is drawn.
    #[track_caller]
    pub fn first_picture(&self) -> Shot {
        self.settled("the first picture", |_| true)
    }

    /// The screen once the picture is drawn, two looks in a row are the same, and the condition
    /// holds.
    #[track_caller]
    pub fn settled(&self, what: &str, condition: impl Fn(&Shot) -> bool) -> Shot {
        let start = Instant::now();
        let mut last = None;
        loop {
            let state = self.wait_for(what, |state| state.rested >= RESTED);
            let now = self.shot();
            if last.as_ref() == Some(&now) && condition(&now) {
                return now;
            }
            assert!(
                start.elapsed() < PATIENCE,
                "{what}: the picture did not come to rest as expected: {}",
                self.stderr()
            );
            last = Some(now);
            self.wait_for(what, |later| later.frame >= state.frame + APART);
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
