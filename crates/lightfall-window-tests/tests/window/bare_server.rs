//! A display that no other program uses: its server starts anew whenever its last client leaves.

use crate::desktop::{PROGRAM, start_server};
use std::io::Read;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use watched::STATE_FILE;

/// How often the program is started.
const STARTS: u32 = 20;
/// Maximum time until the first frame.
const PATIENCE: Duration = Duration::from_secs(60);

#[test]
#[ignore = "needs a graphics adapter and Xvfb"]
fn the_window_opens_every_time_on_a_server_without_other_clients() {
    let (mut server, display) = start_server((640, 480));
    let mut failed = Vec::new();
    for start in 1..=STARTS {
        let home = tempfile::tempdir().unwrap();
        let state = home.path().join("state");
        let mut program = Command::new(PROGRAM)
            .args(["--preset", "2", "--set", "disk.enabled=false"])
            .env("DISPLAY", &display)
            .env_remove("WAYLAND_DISPLAY")
            .env("HOME", home.path())
            .env("XDG_CONFIG_HOME", home.path())
            .env(STATE_FILE, &state)
            .current_dir(home.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let began = Instant::now();
        while !state.exists() && program.try_wait().unwrap().is_none() && began.elapsed() < PATIENCE
        {
            std::thread::sleep(Duration::from_millis(20));
        }
        let opened = state.exists();
        let _ = program.kill();
        let _ = program.wait();
        if !opened {
            let mut said = String::new();
            let stderr = program.stderr.as_mut().unwrap();
            stderr.read_to_string(&mut said).unwrap();
            failed.push(format!("start {start}: {said}"));
        }
    }
    server.kill().unwrap();
    server.wait().unwrap();
    assert!(failed.is_empty(), "{failed:#?}");
}
