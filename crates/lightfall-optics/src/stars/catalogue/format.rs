//! The format of a catalogue of stars as CSV.

/// Maximum number of stars of a catalogue: 40 MB.
pub const MAX_STARS: usize = 2_000_000;

/// Maximum length of a star's name, in characters.
pub const MAX_NAME_CHARS: usize = 60;

/// The column of right ascensions in hours, which may stand in place of the first.
pub(super) const HOURS: &str = "ra_hours";

/// The columns that are read, in their order in a file without a header.
pub(super) const COLUMNS: [&str; 5] = ["ra_deg", "dec_deg", "v_mag", "b_v", "name"];
