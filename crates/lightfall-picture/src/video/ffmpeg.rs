//! The program ffmpeg: where it is, and whether it has what a film needs.

use super::codec::Codec;
use crate::PictureError;
use lightfall_core::reason::reason;
use std::env::var_os;
use std::ffi::OsString;
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::thread;
use std::time::Duration;

/// The variable of the environment that names the program.
const VARIABLE: &str = "LIGHTFALL_FFMPEG";

/// How long an answer may take, and how many bytes it may have. A program that is not ffmpeg may never end.
const MAX_WAIT: Duration = Duration::from_secs(20);
const MAX_ANSWER: u64 = 1 << 20;

/// The filter between the colours of pictures and those of films.
const FILTER: &str = "zscale";

/// A program ffmpeg that has what a film needs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ffmpeg {
    pub(super) program: PathBuf,
}

impl Ffmpeg {
    /// Finds ffmpeg: the file that is named, that of the variable LIGHTFALL_FFMPEG, or the first one on
    /// PATH. It must have the encoder of `codec`.
    ///
    /// # Errors
    /// There is none, or it lacks the encoder or a filter. The message is a sentence.
    pub fn find(named: Option<&Path>, codec: Codec) -> Result<Self, PictureError> {
        let (origin, program) = match (named, var_os(VARIABLE).filter(|file| !file.is_empty())) {
            (Some(file), _) => ("--ffmpeg ", OsString::from(file)),
            (None, Some(file)) => ("LIGHTFALL_FFMPEG=", file),
            (None, None) => ("", "ffmpeg".into()),
        };
        let program = PathBuf::from(program);
        let found =
            |fault: &str| PictureError::Film(format!("{origin}{}: {fault}", program.display()));
        let ask = |question: &str| match answer(&program, question) {
            Ok(Some(text)) => Ok(text),
            Ok(None) => Err(found("this program does not answer as ffmpeg does")),
            Err(error) if error.kind() == ErrorKind::NotFound && origin.is_empty() => {
                Err(PictureError::Film(MISSING.into()))
            }
            Err(error) => Err(found(&format!("it cannot be run: {}", reason(&error)))),
        };
        let encoder = codec.encoder();
        if !has_word(&ask("-encoders")?, encoder) {
            let codec = codec.word();
            return Err(found(&format!(
                "this ffmpeg has no encoder {encoder}, which --codec {codec} needs"
            )));
        }
        if !has_word(&ask("-filters")?, FILTER) {
            return Err(found(&format!(
                "this ffmpeg has no filter {FILTER}, which films need"
            )));
        }
        Ok(Self { program })
    }
}

/// The error where there is no ffmpeg.
const MISSING: &str = "ffmpeg was not found; install it, name it with --ffmpeg, or draw numbered pictures with \
                       -o flight-####.png";

/// Whether a line of a list has this word as its name, which follows the flags.
fn has_word(list: &str, name: &str) -> bool {
    list.lines()
        .any(|line| line.split_whitespace().nth(1) == Some(name))
}

/// What the program writes to its standard output for an option of ffmpeg's; `None` if it fails, or says too
/// much, or nothing in time.
fn answer(program: &Path, question: &str) -> std::io::Result<Option<String>> {
    let mut child = Command::new(program)
        .args(["-hide_banner", "-v", "error", question])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()?;
    let (sender, receiver) = channel();
    if let Some(output) = child.stdout.take() {
        thread::spawn(move || {
            let mut bytes = Vec::new();
            let read = output.take(MAX_ANSWER).read_to_end(&mut bytes);
            // There is no receiver any more if the time is over.
            sender.send(read.map(|_| bytes)).ok();
        });
    }
    let bytes = receiver.recv_timeout(MAX_WAIT);
    let is_whole = matches!(&bytes, Ok(Ok(bytes)) if (bytes.len() as u64) < MAX_ANSWER);
    if !is_whole {
        child.kill().ok();
    }
    let status = child.wait()?;
    Ok(match bytes {
        Ok(Ok(bytes)) if is_whole && status.success() => {
            Some(String::from_utf8_lossy(&bytes).into_owned())
        }
        _ => None,
    })
}
