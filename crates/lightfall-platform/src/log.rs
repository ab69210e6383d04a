//! What the program logs, and what it says on standard error.

use crate::storage::note_log;
use bevy::log::LogPlugin;
use bevy::log::tracing::field::Field;
use bevy::log::tracing::{Event, Subscriber};
use bevy::log::tracing_subscriber::Layer;
use bevy::log::tracing_subscriber::layer::Context;
use bevy::utils::default;
use std::fmt::{Debug, Display};
use std::io::{Write, stderr};

/// Writes a line to standard error. A line that cannot be written is dropped, because standard error
/// may be closed or full; `eprintln!` would panic.
pub fn say(line: impl Display) {
    writeln!(stderr().lock(), "{line}").ok();
}

/// A log of warnings and errors on standard error. RUST_LOG can change the level.
pub fn quiet_log() -> LogPlugin {
    LogPlugin {
        filter: "error,lightfall=warn".into(),
        level: bevy::log::Level::WARN,
        custom_layer: |_| Some(Box::new(LogNotes)),
        ..default()
    }
}

/// Notes the log for the report of a crash.
struct LogNotes;

impl<S: Subscriber> Layer<S> for LogNotes {
    fn on_event(&self, event: &Event<'_>, _: Context<'_, S>) {
        let mut line = format!(
            "{} {}:",
            event.metadata().level(),
            event.metadata().target()
        );
        event.record(&mut |field: &Field, value: &dyn Debug| {
            let name = field.name();
            if name == "message" {
                line.push_str(&format!(" {value:?}"));
            } else {
                line.push_str(&format!(" {name}={value:?}"));
            }
        });
        note_log(line);
    }
}
