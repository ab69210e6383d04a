//! A film that is being made.

use super::codec::FilmForm;
use super::ffmpeg::Ffmpeg;
use super::spherical::mark_whole_sky;
use crate::{PictureError, PngBits};
use lightfall_core::reason::reason;
use lightfall_platform::storage::{NewFile, WriteError};
use std::io::{self, BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStderr, ChildStdin, Command, ExitStatus, Stdio};
use std::thread::{self, JoinHandle};

/// A film that ffmpeg encodes from the pictures that it is given. Its file appears under its name only when
/// it is complete.
#[derive(Debug)]
pub struct Film {
    path: PathBuf,
    file: NewFile,
    form: FilmForm,
    ffmpeg: Ffmpeg,
    encoder: Encoder,
}

impl Film {
    /// Begins a film.
    ///
    /// # Errors
    /// The file cannot be written, or ffmpeg does not start.
    pub fn begin(path: &Path, form: FilmForm, ffmpeg: &Ffmpeg) -> Result<Self, PictureError> {
        let file = NewFile::create(path)?;
        let mut command = Command::new(&ffmpeg.program);
        command.args(form.arguments()).arg(file.temporary_path());
        let encoder = Encoder::start(command, path)?;
        Ok(Self {
            path: path.into(),
            file,
            form,
            ffmpeg: ffmpeg.clone(),
            encoder,
        })
    }

    /// Adds the next rows of a picture, from the top: the levels of red, green and blue of each pixel. A
    /// picture follows the one before it without a gap.
    ///
    /// # Errors
    /// ffmpeg has ended.
    pub fn add(&mut self, levels: &[u16]) -> Result<(), PictureError> {
        let bytes: Vec<u8> = match self.form.bits {
            PngBits::Eight => levels.iter().map(|level| *level as u8).collect(),
            PngBits::Sixteen => levels
                .iter()
                .flat_map(|level| level.to_le_bytes())
                .collect(),
        };
        self.add_bytes(&bytes)
    }

    /// As [`Film::add`], of levels as the film's form has them.
    ///
    /// # Errors
    /// As [`Film::add`].
    pub fn add_bytes(&mut self, bytes: &[u8]) -> Result<(), PictureError> {
        let Some(input) = &mut self.encoder.input else {
            return Err(self.encoder.fault(&self.path, None));
        };
        match input.write_all(bytes) {
            Ok(()) => Ok(()),
            Err(error) => Err(self.encoder.fault(&self.path, Some(&error))),
        }
    }

    /// Ends the film, whose file then has its name.
    ///
    /// # Errors
    /// ffmpeg could not encode it, or the file cannot be written.
    pub fn finish(self) -> Result<(), PictureError> {
        let Self {
            path,
            mut file,
            form,
            ffmpeg,
            mut encoder,
        } = self;
        encoder.end(&path)?;
        if form.is_of_whole_sky {
            mark_whole_sky(file.file()).map_err(|error| WriteError::new(&path, error))?;
        }
        if form.is_copied() {
            let copy = NewFile::create(&path)?;
            let [before, between] = form.copy_arguments();
            let mut command = Command::new(&ffmpeg.program);
            command.args(before).arg(file.temporary_path());
            command.args(between).arg(copy.temporary_path());
            Encoder::start(command, &path)?.end(&path)?;
            file = copy;
        }
        Ok(file.finish()?)
    }
}

/// ffmpeg as it runs. It is ended when it is dropped.
#[derive(Debug)]
struct Encoder {
    child: Child,
    input: Option<ChildStdin>,
    said: Option<JoinHandle<Said>>,
}

/// What ffmpeg says on standard error.
#[derive(Debug, Default)]
struct Said {
    last_line: String,
    is_disk_full: bool,
}

impl Encoder {
    /// Starts ffmpeg for the film at `path`.
    fn start(mut command: Command, path: &Path) -> Result<Self, PictureError> {
        command
            // Without it, SVT-AV1 prints its version and its settings.
            .env("SVT_LOG", "1")
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped());
        // Ctrl+C is for Lightfall, which then ends ffmpeg.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn().map_err(|error| {
            PictureError::Film(format!(
                "{}: ffmpeg does not start: {}",
                path.display(),
                reason(&error)
            ))
        })?;
        let said = child.stderr.take().map(|errors| {
            let target = path.display().to_string();
            thread::spawn(move || listen(errors, &target))
        });
        Ok(Self {
            input: child.stdin.take(),
            child,
            said,
        })
    }

    /// Waits until the film is encoded.
    fn end(&mut self, path: &Path) -> Result<(), PictureError> {
        let (status, said) = self.wait();
        match status {
            Ok(status) if status.success() && !said.is_disk_full => Ok(()),
            status => Err(sentence(path, status, said)),
        }
    }

    /// Why ffmpeg takes no more pictures.
    fn fault(&mut self, path: &Path, written: Option<&io::Error>) -> PictureError {
        let (status, mut said) = self.wait();
        if let (true, Some(error)) = (said.last_line.is_empty(), written) {
            said.last_line = reason(error);
        }
        sentence(path, status, said)
    }

    fn wait(&mut self) -> (io::Result<ExitStatus>, Said) {
        // ffmpeg ends its file at the end of its input.
        self.input = None;
        let status = self.child.wait();
        let said = self.said.take().and_then(|said| said.join().ok());
        (status, said.unwrap_or_default())
    }
}

impl Drop for Encoder {
    fn drop(&mut self) {
        // An encoder that has ended cannot be ended again.
        self.child.kill().ok();
        self.child.wait().ok();
    }
}

/// Reads what ffmpeg says, and keeps its last line of importance. Its names of files are those of temporary
/// ones.
fn listen(errors: ChildStderr, target: &str) -> Said {
    let mut said = Said::default();
    // All of it has to be read, text or not: ffmpeg would wait for a full pipe.
    for line in BufReader::new(errors).split(b'\n').map_while(Result::ok) {
        let line = String::from_utf8_lossy(&line);
        let line = line.trim();
        said.is_disk_full |= line.contains("No space left on device");
        let is_repetition = line.starts_with("Last message repeated");
        if !line.is_empty() && !is_repetition && line != "Conversion failed!" {
            said.last_line = with_name(line, target);
        }
    }
    said
}

/// A line in which the name of the film stands for that of its temporary file.
fn with_name(line: &str, target: &str) -> String {
    let words = line.split(' ').map(|word| {
        let is_temporary = word.contains(".lightfall-") && word.contains(".part");
        if is_temporary {
            target.to_owned() + if word.ends_with(':') { ":" } else { "" }
        } else {
            word.to_owned()
        }
    });
    words.collect::<Vec<_>>().join(" ")
}

/// The error of a film that ffmpeg did not complete.
fn sentence(path: &Path, status: io::Result<ExitStatus>, said: Said) -> PictureError {
    if said.is_disk_full {
        let full = io::Error::other("no space is left on the disk");
        return WriteError::new(path, full).into();
    }
    let why = match status {
        _ if !said.last_line.is_empty() => said.last_line,
        Ok(status) => status.to_string(),
        Err(error) => reason(&error),
    };
    PictureError::Film(format!(
        "{}: ffmpeg ended before the film was complete: {why}",
        path.display()
    ))
}
