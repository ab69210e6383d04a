//! Progress of long commands: how long they will take, and how much is done.

use indicatif::{ProgressBar, ProgressStyle};
use lightfall_platform::log::say;
use std::io::IsTerminal;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::time::{Duration, Instant};

/// The estimate of the whole is given when the work has lasted at least this long.
const MIN_SAMPLE: Duration = Duration::from_secs(2);
/// Minimum time between two lines in a log.
const MIN_LINE_INTERVAL: Duration = Duration::from_secs(15);
/// Minimum share of the work between two lines in a log, and after the last one.
const MIN_LINE_SHARE: f64 = 0.05;

/// Time after which a command without a progress bar says that it goes on.
const MAX_SILENCE: Duration = Duration::from_secs(8);

/// A progress bar on standard error, with the current task and the remaining time. Nothing is drawn
/// if standard error is not a terminal.
pub(super) fn progress(length: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len}, {eta} left: {wide_msg}");
    ProgressBar::new(length as u64)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// The progress of a command that takes minutes. On a terminal it is a bar, in a log a plain line
/// now and then. Both begin by saying how long the command will take.
pub(super) struct Progress {
    command: &'static str,
    /// The work to do, in any unit, and how much of it is done.
    total: f64,
    done: f64,
    /// The work after which the time of the rest is estimated.
    sample: f64,
    began: Instant,
    estimated: bool,
    /// None in a log.
    bar: Option<ProgressBar>,
    /// Time and share of the last line of a log.
    line: (Duration, f64),
}

impl Progress {
    /// Begins a work of this amount, in any unit. `command` is its name. When the amount `sample` is
    /// done, the time of the rest is estimated.
    pub(super) fn new(command: &'static str, total: f64, sample: f64) -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let style = ProgressStyle::with_template("{bar:30} {percent} %, {prefix}: {wide_msg}");
            ProgressBar::new(1000)
                .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        });
        if let Some(bar) = &bar {
            bar.set_prefix("measuring the time it takes");
        }
        Self {
            command,
            total,
            done: 0.0,
            sample,
            began: Instant::now(),
            estimated: false,
            bar,
            line: (Duration::ZERO, 0.0),
        }
    }

    /// Says what is being done.
    pub(super) fn set_task(&self, task: String) {
        if let Some(bar) = &self.bar {
            bar.set_message(task);
            bar.tick();
        }
    }

    /// Counts work that has been done, says what it was, and shows it.
    pub(super) fn advance(&mut self, task: String, work: f64) {
        self.set_task(task);
        self.done += work;
        let elapsed = self.began.elapsed();
        let share = (self.done / self.total).clamp(0.0, 1.0);
        let left = (elapsed >= MIN_SAMPLE && self.done >= self.sample && share < 1.0)
            .then(|| elapsed.mul_f64((1.0 - share) / share));
        if let Some(left) = left
            && !self.estimated
        {
            self.estimated = true;
            self.line = (elapsed, share);
            self.say(&format!("takes about {} here", in_words(elapsed + left)));
        }
        let left = left.map(|left| format!("about {} left", in_words(left)));
        if let Some(bar) = &self.bar {
            if let Some(left) = left {
                bar.set_prefix(left);
            }
            bar.set_position((1000.0 * share) as u64);
        } else if elapsed > self.line.0 + MIN_LINE_INTERVAL
            && share > self.line.1 + MIN_LINE_SHARE
            && share < 1.0 - MIN_LINE_SHARE
        {
            self.line = (elapsed, share);
            let left = left.map_or_else(String::new, |left| format!(", {left}"));
            self.say(&format!("{:.0} % done{left}", 100.0 * share));
        }
    }

    /// Removes the bar.
    pub(super) fn finish(self) {
        if let Some(bar) = self.bar {
            bar.finish_and_clear();
        }
    }

    fn say(&self, text: &str) {
        let line = format!("lightfall: {} {text}", self.command);
        self.without_bar(|| say(&line));
    }

    /// Writes something while the bar is away.
    pub(super) fn without_bar<T>(&self, write: impl FnOnce() -> T) -> T {
        match &self.bar {
            Some(bar) => bar.suspend(write),
            None => write(),
        }
    }
}

/// Says once on standard error that work goes on, if it lasts long. The word is not given after the
/// value is dropped.
pub(super) struct LongWork {
    _ends: Sender<()>,
}

impl LongWork {
    /// Begins to wait. `message` is one sentence.
    pub(super) fn new(message: String) -> Self {
        let (ends, ended) = channel();
        std::thread::spawn(move || {
            if ended.recv_timeout(MAX_SILENCE) == Err(RecvTimeoutError::Timeout) {
                say(format_args!("lightfall: {message}"));
            }
        });
        Self { _ends: ends }
    }
}

/// A duration in words, such as `3 min`, rounded as much as an estimate deserves.
#[must_use]
pub fn in_words(duration: Duration) -> String {
    let seconds = duration.as_secs_f64();
    if seconds < 55.0 {
        format!("{:.0} s", (seconds / 5.0).ceil().max(1.0) * 5.0)
    } else if seconds < 5400.0 {
        format!("{:.0} min", (seconds / 60.0).round().max(1.0))
    } else {
        format!("{:.1} h", seconds / 3600.0)
    }
}
