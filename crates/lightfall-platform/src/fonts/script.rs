//! Scripts whose characters the program's own fonts lack, by their blocks in Unicode.

/// A block of characters of one script.
pub(super) struct Script {
    first: u32,
    last: u32,
    /// The name in English.
    pub(super) name: &'static str,
    /// The code (ISO 15924).
    #[cfg_attr(
        target_arch = "wasm32",
        expect(dead_code, reason = "no fonts to ask for")
    )]
    pub(super) code: [u8; 4],
}

const fn block(first: u32, last: u32, name: &'static str, code: &[u8; 4]) -> Script {
    Script {
        first,
        last,
        name,
        code: *code,
    }
}

/// Punctuation and wide forms of Latin letters are in fonts for Han text.
const BLOCKS: [Script; 53] = [
    block(0x370, 0x3ff, "Greek", b"Grek"),
    block(0x400, 0x52f, "Cyrillic", b"Cyrl"),
    block(0x530, 0x58f, "Armenian", b"Armn"),
    block(0x590, 0x5ff, "Hebrew", b"Hebr"),
    block(0x600, 0x6ff, "Arabic", b"Arab"),
    block(0x700, 0x74f, "Syriac", b"Syrc"),
    block(0x750, 0x77f, "Arabic", b"Arab"),
    block(0x780, 0x7bf, "Thaana", b"Thaa"),
    block(0x7c0, 0x7ff, "N'Ko", b"Nkoo"),
    block(0x870, 0x8ff, "Arabic", b"Arab"),
    block(0x900, 0x97f, "Devanagari", b"Deva"),
    block(0x980, 0x9ff, "Bengali", b"Beng"),
    block(0xa00, 0xa7f, "Gurmukhi", b"Guru"),
    block(0xa80, 0xaff, "Gujarati", b"Gujr"),
    block(0xb00, 0xb7f, "Odia", b"Orya"),
    block(0xb80, 0xbff, "Tamil", b"Taml"),
    block(0xc00, 0xc7f, "Telugu", b"Telu"),
    block(0xc80, 0xcff, "Kannada", b"Knda"),
    block(0xd00, 0xd7f, "Malayalam", b"Mlym"),
    block(0xd80, 0xdff, "Sinhala", b"Sinh"),
    block(0xe00, 0xe7f, "Thai", b"Thai"),
    block(0xe80, 0xeff, "Lao", b"Laoo"),
    block(0xf00, 0xfff, "Tibetan", b"Tibt"),
    block(0x1000, 0x109f, "Myanmar", b"Mymr"),
    block(0x10a0, 0x10ff, "Georgian", b"Geor"),
    block(0x1100, 0x11ff, "Hangul", b"Hang"),
    block(0x1200, 0x139f, "Ethiopic", b"Ethi"),
    block(0x13a0, 0x13ff, "Cherokee", b"Cher"),
    block(0x1780, 0x17ff, "Khmer", b"Khmr"),
    block(0x1800, 0x18af, "Mongolian", b"Mong"),
    block(0x1c90, 0x1cbf, "Georgian", b"Geor"),
    block(0x1f00, 0x1fff, "Greek", b"Grek"),
    block(0x2d30, 0x2d7f, "Tifinagh", b"Tfng"),
    block(0x2e80, 0x303f, "Han", b"Hani"),
    block(0x3040, 0x309f, "Japanese", b"Hira"),
    block(0x30a0, 0x30ff, "Japanese", b"Kana"),
    block(0x3100, 0x312f, "Bopomofo", b"Bopo"),
    block(0x3130, 0x318f, "Hangul", b"Hang"),
    block(0x3190, 0x31ef, "Han", b"Hani"),
    block(0x31f0, 0x31ff, "Japanese", b"Kana"),
    block(0x3200, 0x9fff, "Han", b"Hani"),
    block(0xa8e0, 0xa8ff, "Devanagari", b"Deva"),
    block(0xa960, 0xa97f, "Hangul", b"Hang"),
    block(0xac00, 0xd7ff, "Hangul", b"Hang"),
    block(0xf900, 0xfaff, "Han", b"Hani"),
    block(0xfb1d, 0xfb4f, "Hebrew", b"Hebr"),
    block(0xfb50, 0xfdff, "Arabic", b"Arab"),
    block(0xfe30, 0xfe4f, "Han", b"Hani"),
    block(0xfe70, 0xfefe, "Arabic", b"Arab"),
    block(0xff00, 0xff65, "Han", b"Hani"),
    block(0xff66, 0xff9f, "Japanese", b"Kana"),
    block(0xffa0, 0xffdc, "Hangul", b"Hang"),
    block(0x2_0000, 0x3_ffff, "Han", b"Hani"),
];

impl Script {
    /// The script of a character. None for a rare one.
    pub(super) fn of(character: char) -> Option<&'static Self> {
        let code_point = u32::from(character);
        let block = BLOCKS.partition_point(|block| block.last < code_point);
        BLOCKS.get(block).filter(|block| block.first <= code_point)
    }

    /// What to install for it. Linux has packages.
    pub(super) fn example(&self) -> &'static str {
        let is_cjk = ["Han", "Japanese", "Hangul", "Bopomofo"].contains(&self.name);
        match (is_cjk, cfg!(target_os = "linux")) {
            (true, true) => "fonts-noto-cjk",
            (false, true) => "fonts-noto-core",
            (true, false) => "Noto Sans CJK",
            (false, false) => "Noto Sans",
        }
    }
}
