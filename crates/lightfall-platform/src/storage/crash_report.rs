//! The report of a crash: a file that says where a fault of the program itself was met, with what on
//! the screen, on which graphics adapter, and what the log said last.

use super::files::{create_parent_folder, write_atomically};
use super::folders::reports_folders;
use lightfall_core::scene::Scene;
use std::backtrace::Backtrace;
use std::cell::Cell;
use std::collections::VecDeque;
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use web_time::{SystemTime, UNIX_EPOCH};

/// Number of lines of the log that a report holds.
const MAX_LOG_LINES: usize = 80;

/// What a report says about the time before the crash.
struct Circumstances {
    adapter: String,
    scene: Option<Scene>,
    log: VecDeque<String>,
}

static LAST: Mutex<Circumstances> = Mutex::new(Circumstances {
    adapter: String::new(),
    scene: None,
    log: VecDeque::new(),
});

/// Changes what a report will say. Where that is not possible at the moment, nothing is changed.
fn note(change: impl FnOnce(&mut Circumstances)) {
    if let Ok(mut last) = LAST.try_lock() {
        change(&mut last);
    }
}

/// Notes the graphics adapter in use.
pub fn note_adapter(adapter: String) {
    note(|last| last.adapter = adapter);
}

/// Notes the scene that is drawn.
pub fn note_scene(scene: &Scene) {
    note(|last| last.scene = Some(scene.clone()));
}

/// Notes a line of the log.
pub fn note_log(line: String) {
    note(|last| {
        last.log.push_back(line);
        let spare = last.log.len().saturating_sub(MAX_LOG_LINES);
        last.log.drain(..spare);
    });
}

/// From now on a panic of any thread also writes a report, the first of the process only. `tell` gets
/// a sentence for the user that says where the report is.
pub fn report_panics(tell: fn(&str)) {
    static IS_FIRST: AtomicBool = AtomicBool::new(true);
    let usual = take_hook();
    set_hook(Box::new(move |panic| {
        if EXPECTS_PANIC.get() {
            return;
        }
        usual(panic);
        if IS_FIRST.swap(false, Ordering::Relaxed) {
            let message = panic.payload_as_str().unwrap_or_default();
            let fault = message.lines().next().unwrap_or("without a message");
            let sentence = match write(&text(panic)) {
                Ok(file) => format!(
                    "Lightfall has met a fault of its own ({fault}). Please send this report to its makers: {}",
                    file.display()
                ),
                Err(reason) => format!(
                    "Lightfall has met a fault of its own ({fault}), and no report could be written: {reason}"
                ),
            };
            tell(&sentence);
        }
    }));
}

thread_local! {
    /// Whether a panic of this thread is answered by [`unless_it_panics`].
    static EXPECTS_PANIC: Cell<bool> = const { Cell::new(false) };
}

/// Runs code of others that may panic for reasons of the system. A panic is neither reported nor said,
/// and gives `None`.
pub fn unless_it_panics<T>(run: impl FnOnce() -> T) -> Option<T> {
    EXPECTS_PANIC.set(true);
    let result = catch_unwind(AssertUnwindSafe(run)).ok();
    EXPECTS_PANIC.set(false);
    result
}

/// The report's text.
fn text(panic: &PanicHookInfo<'_>) -> String {
    let mut text = format!(
        "Lightfall {} on {} {}\n{panic}\n",
        env!("CARGO_PKG_VERSION"),
        std::env::consts::OS,
        std::env::consts::ARCH,
    );
    let mut add = |title: &str, lines: &str| {
        writeln!(text, "\n== {title}\n{}", lines.trim_end()).ok();
    };
    // The thread that panics may hold the lock.
    if let Ok(last) = LAST.try_lock() {
        add("graphics adapter", &last.adapter);
        let scene = last.scene.as_ref().map(Scene::to_preset);
        add("scene", &scene.unwrap_or_default());
        let log: Vec<&str> = last.log.iter().map(String::as_str).collect();
        add("end of the log", &log.join("\n"));
    }
    add("backtrace", &Backtrace::force_capture().to_string());
    text
}

/// Writes a report to a new file, in the first folder of reports that takes it. Returns the file, or
/// why the first one does not.
fn write(text: &str) -> Result<PathBuf, String> {
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    let name = format!(
        "lightfall-crash-{}.txt",
        now.map_or(0, |time| time.as_millis())
    );
    let mut fault = None;
    for folder in reports_folders() {
        let file = folder.join(&name);
        match create_parent_folder(&file).and_then(|()| write_atomically(&file, text.as_bytes())) {
            Ok(()) => return Ok(file),
            Err(error) => fault = fault.or(Some(error.to_string())),
        }
    }
    Err(fault.unwrap_or_default())
}
