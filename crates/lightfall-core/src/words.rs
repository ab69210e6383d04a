//! Enumerations with a word for each variant, as presets, the command line and messages write it.
//!
//! [`words!`](macro@crate::words) declares the variants and their words in one table, so that no variant
//! can be without a word or missing from `ALL`.

/// An enumeration that [`words!`](macro@crate::words) declared, for code that serves all of them.
pub trait Words: Copy + 'static {
    /// The words of all variants, in the order of their declaration.
    const WORDS: &'static [&'static str];

    /// The variant's word.
    fn word(self) -> &'static str;

    /// The variant with this word.
    fn from_word(word: &str) -> Option<Self>;
}

/// Declares an enumeration whose variants have words: `Variant = "word"`.
///
/// The enumeration can be copied, compared and hashed; serde writes and reads the words. It gets
/// the constants `ALL` and `WORDS`, in the order of declaration, and the functions `word` and
/// `from_word`.
#[macro_export]
macro_rules! words {
    (
        $(#[$attribute:meta])*
        pub enum $Name:ident {
            $($(#[$variant_attribute:meta])* $Variant:ident = $word:literal,)+
        }
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
        pub enum $Name {
            $($(#[$variant_attribute])* #[serde(rename = $word)] $Variant,)+
        }

        impl $Name {
            /// Every variant, in the order of declaration.
            pub const ALL: [Self; [$($word),+].len()] = [$(Self::$Variant),+];

            /// The word of every variant, in the order of declaration.
            pub const WORDS: [&'static str; Self::ALL.len()] = [$($word),+];

            /// The variant's word, as presets, the command line and messages write it.
            #[must_use]
            pub const fn word(self) -> &'static str {
                match self {
                    $(Self::$Variant => $word,)+
                }
            }

            /// The variant with this word.
            #[must_use]
            pub fn from_word(word: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|variant| variant.word() == word)
            }
        }

        impl $crate::words::Words for $Name {
            const WORDS: &'static [&'static str] = &$Name::WORDS;

            fn word(self) -> &'static str {
                self.word()
            }

            fn from_word(word: &str) -> Option<Self> {
                Self::from_word(word)
            }
        }
    };
}
