//! In place of the fonts of the system, which a page in a browser cannot read.

use super::FoundFonts;

/// No fonts.
pub struct SystemFonts;

impl SystemFonts {
    /// Opens none.
    #[must_use]
    pub fn open() -> Self {
        Self
    }

    /// Finds none.
    pub fn find(&mut self, characters: &[char]) -> FoundFonts {
        FoundFonts {
            missing: characters.to_vec(),
            ..FoundFonts::default()
        }
    }
}
