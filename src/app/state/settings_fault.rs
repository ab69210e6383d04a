//! Why a settings file is not used, and what becomes of it.

use lightfall_platform::storage::{exists, rename};
use std::path::Path;
use thiserror::Error;

/// Why a settings file is not used: a clause without the file's name.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum SettingsFault {
    /// A newer Lightfall has written it.
    #[error(
        "version = {version} is that of a newer Lightfall, and this one reads versions up to {known}"
    )]
    Newer {
        /// The file's version.
        version: i64,
        /// The newest version that this program reads.
        known: i64,
    },
    /// The file cannot be read, or something in it is wrong.
    #[error("{0}")]
    Wrong(String),
}

/// A settings file that is not used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unused {
    /// Why, what became of it, and what to do.
    pub sentence: String,
    /// Whether the file is to stay as it is, because a newer Lightfall will read it again.
    pub stays: bool,
}

impl Unused {
    /// Renames a broken file. Leaves one of a newer version as it is.
    pub(super) fn new(file: &Path, fault: &SettingsFault) -> Self {
        let stays = matches!(fault, SettingsFault::Newer { .. });
        let outcome = if stays {
            "the file stays as it is, default settings are used, and changes of settings are not saved; update \
             Lightfall, or rename the file"
                .into()
        } else {
            set_aside(file)
        };
        Self {
            sentence: format!("{}: {fault}; {outcome}", file.display()),
            stays,
        }
    }
}

/// Renames a broken file, so that nothing the user wrote is lost, and says how that went.
fn set_aside(file: &Path) -> String {
    let names = (1..1000).map(|number| file.with_extension(format!("broken-{number}.toml")));
    let Some(aside) = names.into_iter().find(|name| !exists(name)) else {
        return "default settings are used".into();
    };
    match rename(file, &aside) {
        Ok(()) => format!(
            "it is kept as {}, and default settings are used",
            aside.display()
        ),
        Err(_) => "default settings are used".into(),
    }
}
