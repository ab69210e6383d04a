//! A display of the test's own: Xvfb, the program's window on it, keys by xdotool, pictures from the X server.

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{ConnectionExt, ImageFormat};
use x11rb::rust_connection::RustConnection;

/// Screen large enough for the default window.
const SCREEN: (u16, u16) = (1500, 900);
/// Time a software renderer may need for a first picture, or for one more.
const PATIENCE: Duration = Duration::from_secs(60);

/// What the screen shows.
#[derive(Clone, PartialEq)]
pub struct Shot {
    pub width: usize,
    pub height: usize,
    bgrx: Vec<u8>,
}

impl Shot {
    pub fn pixel(&self, x: usize, y: usize) -> [u8; 3] {
        let at = 4 * (y * self.width + x);
        [self.bgrx[at + 2], self.bgrx[at + 1], self.bgrx[at]]
    }

    /// Share of the pixels of a rectangle that differ from another shot's.
    pub fn changed(&self, other: &Self, x: std::ops::Range<usize>, y: std::ops::Range<usize>) -> f64 {
        let count = x.len() * y.len();
        let differ = y.flat_map(|y| x.clone().map(move |x| (x, y)));
        differ.filter(|&(x, y)| self.pixel(x, y) != other.pixel(x, y)).count() as f64 / count as f64
    }

    /// Number of different colours.
    pub fn colours(&self) -> usize {
        let pixels = (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)));
        pixels.map(|(x, y)| self.pixel(x, y)).collect::<std::collections::BTreeSet<_>>().len()
    }
}

/// The display, and the program on it; both end with this value.
pub struct Desktop {
    server: Child,
    program: Child,
    /// When the program was started.
    pub started: Instant,
    /// The user's home, with an empty folder for pictures and one for settings.
    pub home: tempfile::TempDir,
    display: String,
    connection: RustConnection,
    root: u32,
    window: String,
}

impl Desktop {
    /// Opens a display and the program's window on it. None, with the reason printed, where that is impossible and not
    /// required.
    pub fn open(arguments: &[&str]) -> Option<Self> {
        Self::open_program(Path::new(env!("CARGO_BIN_EXE_lightfall")), arguments)
    }

    /// As [`open`](Self::open), with a settings file.
    pub fn open_with_settings(settings: &str, arguments: &[&str]) -> Option<Self> {
        Self::open_prepared(&[("settings.toml", settings.to_owned())], arguments)
    }

    /// As [`open`](Self::open), with files beside the settings.
    pub fn open_prepared(files: &[(&str, String)], arguments: &[&str]) -> Option<Self> {
        Self::start(Path::new(env!("CARGO_BIN_EXE_lightfall")), files, arguments)
    }

    /// As [`open`](Self::open), for another program with a window of the same name.
    pub fn open_program(program: &Path, arguments: &[&str]) -> Option<Self> {
        Self::start(program, &[], arguments)
    }

    fn start(program: &Path, files: &[(&str, String)], arguments: &[&str]) -> Option<Self> {
        for tool in ["Xvfb", "xdotool"] {
            if Command::new("sh")
                .args(["-c", &format!("command -v {tool}")])
                .output()
                .is_ok_and(|out| out.status.success())
            {
                continue;
            }
            let required = std::env::var_os("LIGHTFALL_REQUIRE_GPU").is_some_and(|value| value == "1");
            assert!(!required, "{tool} is missing; ./check installs it");
            println!("skipped: no {tool}");
            return None;
        }
        let mut server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-nolisten", "tcp", "-screen", "0", &format!("{}x{}x24", SCREEN.0, SCREEN.1)])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut number = String::new();
        BufReader::new(server.stdout.take().unwrap()).read_line(&mut number).unwrap();
        let display = format!(":{}", number.trim());
        let home = tempfile::tempdir().unwrap();
        std::fs::create_dir(home.path().join("Pictures")).unwrap();
        let config = home.path().join("config");
        std::fs::create_dir_all(config.join("lightfall")).unwrap();
        for (name, text) in files {
            std::fs::write(config.join("lightfall").join(name), text).unwrap();
        }
        let said = std::fs::File::create(home.path().join("said")).unwrap();
        let started = Instant::now();
        let program = Command::new(program)
            .args(arguments)
            .env("DISPLAY", &display)
            .env_remove("WAYLAND_DISPLAY")
            .env("HOME", home.path())
            .env("XDG_CONFIG_HOME", config)
            .stderr(said)
            .spawn()
            .unwrap();
        let (connection, screen) = x11rb::connect(Some(&display)).unwrap();
        let root = connection.setup().roots[screen].root;
        let mut desktop = Self { server, program, started, home, display, connection, root, window: String::new() };
        desktop.window = desktop.wait_for_window();
        // No window manager runs here, so nobody else gives the window the keyboard.
        desktop.xdotool(&["windowfocus", "--sync", &desktop.window.clone()]);
        Some(desktop)
    }

    fn xdotool(&self, arguments: &[&str]) -> String {
        let output = Command::new("xdotool").args(arguments).env("DISPLAY", &self.display).output().unwrap();
        // A search without a result is no failure of the tool.
        assert!(output.status.success() || arguments[0] == "search", "xdotool {arguments:?} failed");
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

    pub fn running(&mut self) -> bool {
        self.program.try_wait().unwrap().is_none()
    }

    /// Turns the mouse wheel away from the hand by one notch.
    pub fn wheel(&self) {
        self.xdotool(&["click", "4"]);
    }

    /// How long it takes, from now, until the screen passes the condition.
    pub fn until(&self, what: &str, condition: impl Fn(&Shot) -> bool) -> Duration {
        let start = Instant::now();
        while !condition(&self.shot()) {
            assert!(start.elapsed() < PATIENCE, "{what}: the screen did not come to show it");
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

    /// What the program has said on standard error.
    pub fn said(&self) -> String {
        std::fs::read_to_string(self.home.path().join("said")).unwrap()
    }

    /// Memory that the program holds, in bytes.
    pub fn memory(&self) -> usize {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.program.id())).unwrap();
        let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).unwrap();
        1024 * line.trim().trim_end_matches(" kB").parse::<usize>().unwrap()
    }

    /// Clicks with the left button at a place of the window.
    pub fn click(&self, x: i32, y: i32) {
        self.xdotool(&["mousemove", &x.to_string(), &y.to_string()]);
        // The program sees the pointer before it sees the button, as from a hand.
        std::thread::sleep(Duration::from_millis(150));
        self.xdotool(&["click", "1"]);
    }

    /// Types a text.
    pub fn type_text(&self, text: &str) {
        self.xdotool(&["type", "--delay", "60", text]);
    }

    pub fn resize(&self, width: i32, height: i32) {
        self.xdotool(&["windowsize", &self.window, &width.to_string(), &height.to_string()]);
    }

    /// Takes the window from the screen, or puts it back.
    pub fn minimise(&self, away: bool) {
        self.xdotool(&[if away { "windowunmap" } else { "windowmap" }, "--sync", &self.window]);
        if !away {
            self.xdotool(&["windowfocus", "--sync", &self.window]);
        }
    }

    /// The text on the clipboard; none while it holds no text.
    pub fn clipboard(&self) -> Option<String> {
        use x11rb::protocol::Event;
        use x11rb::protocol::xproto::{AtomEnum, CreateWindowAux, WindowClass};
        let connection = &self.connection;
        let atom = |name: &str| connection.intern_atom(false, name.as_bytes()).unwrap().reply().unwrap().atom;
        let [clipboard, text, property] = ["CLIPBOARD", "UTF8_STRING", "LIGHTFALL_TEST"].map(atom);
        let window = connection.generate_id().unwrap();
        let aux = CreateWindowAux::new();
        connection.create_window(0, window, self.root, 0, 0, 1, 1, 0, WindowClass::INPUT_ONLY, 0, &aux).unwrap();
        connection.convert_selection(window, clipboard, text, property, x11rb::CURRENT_TIME).unwrap();
        connection.flush().unwrap();
        let start = Instant::now();
        let given = loop {
            match connection.poll_for_event().unwrap() {
                Some(Event::SelectionNotify(notify)) => break notify.property != x11rb::NONE,
                _ if start.elapsed() > Duration::from_secs(5) => break false,
                _ => std::thread::sleep(Duration::from_millis(5)),
            }
        };
        let bytes = given.then(|| {
            let reply = connection.get_property(true, window, property, AtomEnum::ANY, 0, 1 << 20).unwrap();
            reply.reply().unwrap().value
        });
        connection.destroy_window(window).unwrap();
        bytes.map(|bytes| String::from_utf8(bytes).unwrap())
    }

    /// Presses and lets go of a key, named as X names it.
    pub fn press(&self, key: &str) {
        self.xdotool(&["key", "--delay", "60", key]);
    }

    /// Presses a key while another one is held, so slowly that a busy machine has a frame in which both are.
    pub fn chord(&self, held: &str, key: &str) {
        let pause = || std::thread::sleep(Duration::from_millis(400));
        self.xdotool(&["keydown", held]);
        pause();
        self.xdotool(&["key", key]);
        pause();
        self.xdotool(&["keyup", held]);
    }

    /// Holds a key down for a while.
    pub fn hold(&self, key: &str, time: Duration) {
        self.xdotool(&["keydown", key]);
        std::thread::sleep(time);
        self.xdotool(&["keyup", key]);
    }

    pub fn look(&self, right: i32, down: i32) {
        self.xdotool(&["mousemove_relative", "--", &right.to_string(), &down.to_string()]);
    }

    pub fn title(&self) -> String {
        self.xdotool(&["getwindowname", &self.window])
    }

    pub fn shot(&self) -> Shot {
        let (width, height) = SCREEN;
        let image = self
            .connection
            .get_image(ImageFormat::Z_PIXMAP, self.root, 0, 0, width, height, !0)
            .unwrap()
            .reply()
            .unwrap();
        Shot { width: width.into(), height: height.into(), bgrx: image.data }
    }

    /// The screen once two looks in a row, well apart, are the same and pass the condition.
    pub fn settled(&self, what: &str, condition: impl Fn(&Shot) -> bool) -> Shot {
        let start = Instant::now();
        let mut last = self.shot();
        loop {
            std::thread::sleep(Duration::from_millis(1200));
            let now = self.shot();
            if now == last && condition(&now) {
                return now;
            }
            assert!(start.elapsed() < PATIENCE, "{what}: the picture did not come to rest as expected");
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
