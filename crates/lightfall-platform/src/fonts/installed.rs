//! The fonts installed on the system. DirectWrite, CoreText or fontconfig say which one comes first
//! for a script; fontconfig's library is opened at run time, and where it is missing there are no
//! fonts.

use super::script::Script;
use super::{FoundFonts, SystemFont};
use crate::storage::unless_it_panics;
use fontique::{
    CharmapIndex, Collection, FallbackKey, FamilyId, FamilyInfo, FontStyle, FontWeight, FontWidth,
    GenericFamily, Language,
};

/// The fonts of the system, and those of them that were asked for.
pub struct SystemFonts {
    /// None where the system has no font at all.
    collection: Option<Collection>,
    found: Vec<(SystemFont, CharmapIndex)>,
}

impl SystemFonts {
    /// Asks the system which fonts it has, which takes from some milliseconds up to seconds.
    #[must_use]
    pub fn open() -> Self {
        Self {
            // fontique 0.9 panics where fontconfig has no font.
            collection: unless_it_panics(Collection::default),
            found: Vec::new(),
        }
    }

    /// Finds a font for each of these characters.
    pub fn find(&mut self, characters: &[char]) -> FoundFonts {
        let mut answer = FoundFonts::default();
        let language = language_of(characters);
        for character in characters {
            if self.found.iter().any(|font| has(font, *character)) {
                continue;
            }
            match self.font_with(*character, language.as_ref()) {
                Some(font) => {
                    answer.fonts.push(font.0.clone());
                    self.found.push(font);
                }
                None => answer.missing.push(*character),
            }
        }
        answer
    }

    /// The font that the system prefers for the script of a character or, if it lacks the character,
    /// the first other one that has it.
    fn font_with(
        &mut self,
        character: char,
        language: Option<&Language>,
    ) -> Option<(SystemFont, CharmapIndex)> {
        let collection = self.collection.as_mut()?;
        let mut families: Vec<FamilyId> = Vec::new();
        if let Some(script) = Script::of(character) {
            let key = FallbackKey::new(fontique::Script::from_bytes(script.code), language);
            families.extend(collection.fallback_families(key));
        }
        // fontconfig's list of families without serifs goes on with all families that have further
        // characters.
        families.extend(collection.generic_families(GenericFamily::SansSerif));
        families.into_iter().find_map(|id| {
            let font = ordinary_font(&collection.family(id)?)?;
            has(&font, character).then_some(font)
        })
    }
}

/// The language of a text whose Han characters have forms of their own in it.
fn language_of(characters: &[char]) -> Option<Language> {
    let is_of = |name| {
        let mut scripts = characters.iter().filter_map(|c| Script::of(*c));
        scripts.any(|script| script.name == name)
    };
    let code = match (is_of("Japanese"), is_of("Hangul")) {
        (true, _) => "ja",
        (false, true) => "ko",
        (false, false) => return None,
    };
    Language::parse(code).ok()
}

/// The upright font of ordinary weight and width of a family.
fn ordinary_font(family: &FamilyInfo) -> Option<(SystemFont, CharmapIndex)> {
    let (width, style, weight) = (FontWidth::NORMAL, FontStyle::Normal, FontWeight::NORMAL);
    let font = family.match_font(width, style, weight, false)?;
    let axes = font.synthesis(width, style, weight);
    let axes = axes.variation_settings().iter();
    let system_font = SystemFont {
        name: family.name().to_owned(),
        data: Box::leak(Box::new(font.load(None)?)).data(),
        index: font.index(),
        axes: axes
            .map(|(tag, value)| (tag.to_be_bytes(), *value))
            .collect(),
    };
    Some((system_font, font.charmap_index()))
}

fn has((font, charmap): &(SystemFont, CharmapIndex), character: char) -> bool {
    let charmap = charmap.charmap(font.data);
    charmap
        .and_then(|charmap| charmap.map(character))
        .is_some_and(|glyph| glyph != 0)
}
