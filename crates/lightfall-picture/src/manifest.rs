//! Manifests: which frames of a sequence are drawn, by which program on which machine, with the hash of each
//! file. A manifest is a text with a JSON object in each line.

use super::Studio;
use super::existing::{fields, head_of};
use bevy::render::renderer::RenderAdapterInfo;
use lightfall_platform::storage::{
    TextError, WriteError, embedded_preset, embedded_text, hash_of_file, hash_of_text, read_text,
    write_atomically,
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// The longest manifest that is read: half a kilobyte for each file of the longest sequence of cubes.
const MAX_BYTES: u64 = 1 << 29;

/// Digits of a hash.
const HASH_DIGITS: usize = 64;

/// A manifest that cannot be used. Each message is one sentence.
#[derive(Debug, thiserror::Error)]
pub enum ManifestError {
    /// It cannot be read.
    #[error("{path}: {source}")]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: TextError,
    },
    /// One of its lines is wrong.
    #[error(
        "{path}: line {line}: {fault}; a manifest that other programs have changed can be removed, and --resume writes it anew"
    )]
    Line {
        /// The file.
        path: PathBuf,
        /// The number of the line, from 1.
        line: usize,
        /// What is wrong.
        fault: String,
    },
}

/// A file of a sequence.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ManifestRow {
    /// The number of its frame.
    pub frame: u32,
    /// Its name, without a folder.
    pub file: String,
    /// The SHA-256 of its bytes, as `sha256sum` prints it.
    pub sha256: String,
    /// Its length in bytes.
    pub bytes: u64,
    /// How long drawing and writing its frame took, in seconds; `None` if it was there already.
    pub seconds: Option<f64>,
    /// The exposure of its picture, in powers of two.
    pub exposure_ev: Option<f64>,
    /// The SHA-256 of the preset that it holds.
    pub preset_sha256: String,
    /// The version of the program.
    pub version: Option<String>,
    /// The revision of the program, if it is known.
    pub commit: Option<String>,
    /// The adapter with its interface.
    pub adapter: Option<String>,
    /// The adapter's driver.
    pub driver: Option<String>,
    /// The graphics interface.
    pub backend: Option<String>,
    /// Where the adapter is on the PCI bus.
    pub pci: Option<String>,
    /// The name of the machine.
    pub host: Option<String>,
}

impl ManifestRow {
    /// The row of a picture that is there, with what its file tells: nothing of the time, of the interface, of
    /// the PCI bus and of the machine.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn of_file(frame: u32, path: &Path) -> io::Result<Self> {
        let head = head_of(&mut File::open(path)?)?;
        let preset = embedded_preset(&head).unwrap_or_default();
        let (sha256, bytes) = hash_of_file(path)?;
        let exposure = fields(&preset).remove("picture.exposure_ev");
        Ok(Self {
            frame,
            file: path
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into(),
            sha256,
            bytes,
            seconds: None,
            exposure_ev: exposure.and_then(|text| text.parse().ok()),
            preset_sha256: hash_of_text(&preset),
            version: embedded_text(&head, "lightfall.version"),
            commit: embedded_text(&head, "lightfall.commit"),
            adapter: embedded_text(&head, "lightfall.adapter"),
            driver: embedded_text(&head, "lightfall.driver"),
            backend: None,
            pci: None,
            host: None,
        })
    }

    /// What is wrong with the values of a row that has been read.
    fn fault(&self) -> Option<String> {
        let is_hash = |text: &str| {
            let is_digit = |byte: u8| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte);
            text.len() == HASH_DIGITS && text.bytes().all(is_digit)
        };
        if self.file.is_empty() || self.file.contains(['/', '\\']) {
            return Some(format!(
                "file = {:?} must be the name of a file, without a folder",
                self.file
            ));
        }
        let hashes = [
            ("sha256", &self.sha256),
            ("preset_sha256", &self.preset_sha256),
        ];
        let (name, text) = hashes.into_iter().find(|(_, text)| !is_hash(text))?;
        Some(format!(
            "{name} = {text:?} must have {HASH_DIGITS} digits from 0 to 9 and a to f"
        ))
    }
}

/// The manifest of the frames that one process draws. Its file is written anew for each row, so that it is
/// whole at all times.
#[derive(Debug)]
pub struct Manifest {
    path: PathBuf,
    /// By frame and file.
    rows: BTreeMap<(u32, String), ManifestRow>,
}

impl Manifest {
    /// Reads the manifest at `path`, which has no rows if there is no such file.
    ///
    /// # Errors
    /// It cannot be read, or a line is no row of a manifest.
    pub fn open(path: &Path) -> Result<Self, ManifestError> {
        let text = match read_text(path, MAX_BYTES) {
            Err(TextError::Unreadable(error)) if error.kind() == ErrorKind::NotFound => {
                String::new()
            }
            Err(TextError::Empty) => String::new(),
            read => read.map_err(|source| ManifestError::Unreadable {
                path: path.into(),
                source,
            })?,
        };
        let mut rows = BTreeMap::new();
        for (number, line) in text.lines().enumerate() {
            let row = read_row(line).and_then(|row| {
                let place = (row.frame, row.file.clone());
                match rows.insert(place, row) {
                    None => Ok(()),
                    Some(row) => Err(format!("there is a line for {} already", row.file)),
                }
            });
            row.map_err(|fault| ManifestError::Line {
                path: path.into(),
                line: number + 1,
                fault,
            })?;
        }
        Ok(Self {
            path: path.into(),
            rows,
        })
    }

    /// The rows, by frame.
    pub fn rows(&self) -> impl Iterator<Item = &ManifestRow> {
        self.rows.values()
    }

    /// Whether a row says of a file what its length still is.
    #[must_use]
    pub fn knows(&self, frame: u32, path: &Path) -> bool {
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        let row = self.rows.get(&(frame, file.into_owned()));
        let bytes = path.metadata().map(|data| data.len());
        row.is_some_and(|row| bytes.is_ok_and(|bytes| bytes == row.bytes))
    }

    /// Puts a row in its place.
    pub fn insert(&mut self, row: ManifestRow) {
        self.rows.insert((row.frame, row.file.clone()), row);
    }

    /// Writes the file, which holds all rows or stays as it was.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self) -> Result<(), WriteError> {
        let mut text = String::new();
        for row in self.rows.values() {
            let line = serde_json::to_string(row)
                .map_err(|error| WriteError::new(&self.path, error.into()))?;
            text += &line;
            text.push('\n');
        }
        write_atomically(&self.path, text.as_bytes())
    }
}

/// Reads a line of a manifest.
fn read_row(line: &str) -> Result<ManifestRow, String> {
    let row: ManifestRow = serde_json::from_str(line).map_err(|_| {
        "this is not a row of a manifest: an object in JSON with frame, file, sha256, bytes and preset_sha256, and with \
         seconds, exposure_ev, version, commit, adapter, driver, backend, pci and host, which may be null, and nothing else"
            .to_owned()
    })?;
    row.fault().map_or(Ok(row), Err)
}

/// What a row says of the device and the machine, beyond what the picture itself says.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DeviceFacts {
    /// The graphics interface.
    pub backend: Option<String>,
    /// The adapter's place on the PCI bus, if the interface tells it.
    pub pci: Option<String>,
    /// The machine.
    pub host: Option<String>,
}

impl Studio {
    /// What a manifest says of the device that draws and of its machine.
    #[must_use]
    pub fn device_facts(&self) -> DeviceFacts {
        let info = self.app.world().get_resource::<RenderAdapterInfo>();
        let text = |text: String| Some(text).filter(|text| !text.is_empty());
        DeviceFacts {
            backend: info.map(|info| info.backend.to_string()),
            pci: info.and_then(|info| text(info.device_pci_bus_id.clone())),
            host: lightfall_platform::host::host_name(),
        }
    }
}
