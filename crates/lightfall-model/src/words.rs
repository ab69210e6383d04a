//! Enumerations with a word for each variant, as presets, the command line and messages write it.
//!
//! [`words!`](macro@crate::words) declares the variants, their words and what the panel calls them
//! in one table, so that no variant can be without a word or missing from `ALL`.

/// How a variant is spelt and explained.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// Its word, as presets, the command line and messages write it.
    pub word: &'static str,
    /// What the panel calls it; empty for an enumeration that is no field of a scene.
    pub name: &'static str,
    /// What it means, in one line: the variant's documentation.
    pub meaning: &'static str,
}

/// An enumeration that [`words!`](macro@crate::words) declared, for code that serves all of them.
pub trait Words: Copy + 'static {
    /// How all variants are spelt and explained, in the order of their declaration.
    const CHOICES: &'static [Choice];

    /// The variant's word.
    fn word(self) -> &'static str;

    /// The variant with this word.
    fn from_word(word: &str) -> Option<Self>;
}

/// Declares an enumeration whose variants have words, and names on the panel:
/// `Variant = "word": "Name"`. A variant's documentation is also its help.
///
/// The enumeration can be copied, compared and hashed; serde writes and reads the words; its
/// default is the first variant. It gets the constants `ALL`, `WORDS` and `CHOICES`, in the order
/// of declaration, and the functions `word`, `choice`, `from_word` and `next`.
#[macro_export]
macro_rules! words {
    (
        $(#[$attribute:meta])*
        pub enum $Name:ident {
            $($(#[doc = $about:literal])+ $Variant:ident = $word:literal $(: $name:literal)?,)+
        }
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
        pub enum $Name {
            $($(#[doc = $about])+ #[serde(rename = $word)] $Variant,)+
        }

        impl $Name {
            /// Every variant, in the order of declaration.
            pub const ALL: [Self; [$($word),+].len()] = [$(Self::$Variant),+];

            /// The word of every variant, in the order of declaration.
            pub const WORDS: [&'static str; Self::ALL.len()] = [$($word),+];

            /// How every variant is spelt and explained, in the order of declaration.
            pub const CHOICES: [$crate::words::Choice; Self::ALL.len()] = [$(
                $crate::words::Choice {
                    word: $word,
                    name: concat!($($name)?),
                    meaning: $crate::words::without_full_stop(concat!($($about),+)),
                }
            ),+];

            /// How the variant is spelt and explained.
            pub const fn choice(self) -> $crate::words::Choice {
                Self::CHOICES[self as usize]
            }

            /// The variant's word, as presets, the command line and messages write it.
            pub const fn word(self) -> &'static str {
                self.choice().word
            }

            /// The variant with this word.
            pub fn from_word(word: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|variant| variant.word() == word)
            }

            /// The variant after this one; after the last comes the first.
            #[must_use]
            pub fn next(self) -> Self {
                Self::ALL[(self as usize + 1) % Self::ALL.len()]
            }
        }

        impl Default for $Name {
            fn default() -> Self {
                Self::ALL[0]
            }
        }

        impl $crate::words::Words for $Name {
            const CHOICES: &'static [$crate::words::Choice] = &$Name::CHOICES;

            fn word(self) -> &'static str {
                self.word()
            }

            fn from_word(word: &str) -> Option<Self> {
                Self::from_word(word)
            }
        }
    };
}

/// A doc comment as help. Documentation has a full stop, and a help text has none.
pub const fn without_full_stop(doc: &'static str) -> &'static str {
    let text = doc.trim_ascii();
    match text.as_bytes() {
        [.., b'.'] => text.split_at(text.len() - 1).0,
        _ => text,
    }
}
