//! The sources that decide a report's figures: their fingerprint tells whether figures are older
//! than the shaders, scenes and code that they measure. build.rs lists them.

/// A report's sources.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sources {
    /// The hash of their code, as eight hexadecimal digits.
    pub fingerprint: &'static str,
    /// Their paths from the top of the repository.
    pub files: &'static [&'static str],
}

/// The name, the fingerprint and the files of each report.
const ALL: &[(&str, &str, &[&str])] = include!(concat!(env!("OUT_DIR"), "/sources.rs"));

impl Sources {
    /// The sources that the program was built from, of the report with this name: that of its CSV
    /// file, without its ending. `None` if there is no such report.
    #[must_use]
    pub fn of(report: &str) -> Option<Self> {
        let found = ALL.iter().find(|(name, ..)| *name == report);
        found.map(|(_, fingerprint, files)| Self { fingerprint, files })
    }

    /// The names of the reports.
    pub fn reports() -> impl Iterator<Item = &'static str> {
        ALL.iter().map(|(name, ..)| *name)
    }
}
