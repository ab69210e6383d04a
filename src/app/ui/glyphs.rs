//! Characters that egui's own fonts lack, such as those of Chinese or Arabic texts. Every text that is
//! drawn is looked through, and fonts of the system that have a new character are added to egui's; where
//! there is none, the toast says so. Latin texts never ask for a font of the system.

use crate::app::state::toast::Toast;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiFullOutput, EguiPostUpdateSet, EguiPrimaryContextPass, egui};
use egui::epaint::text::{FontInsert, FontPriority, InsertFontFamily, VariationCoords};
use egui::{FontData, FontDefinitions, FontFamily, FontTweak};
use lightfall_platform::fonts::{
    FoundFonts, SystemFont, SystemFonts, missing_sentence, script_name,
};
use lightfall_platform::worker::Worker;
use skrifa::{FontRef, MetadataProvider};
use std::collections::HashSet;

/// Largest number of characters that the toast lists: it has room for two lines below a caption.
const MAX_LISTED: usize = 2;

/// The characters that were drawn, and the thread that finds fonts for those that egui's lack.
#[derive(Resource, Default)]
struct Glyphs {
    seen: HashSet<char>,
    /// None before the first such character.
    finder: Option<Worker<Vec<char>, FoundFonts>>,
    /// The scripts that the toast has named.
    named: HashSet<&'static str>,
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Glyphs>()
        .add_systems(EguiPrimaryContextPass, add_found_fonts)
        .add_systems(
            PostUpdate,
            look_for_characters
                .after(EguiPostUpdateSet::EndPass)
                .before(EguiPostUpdateSet::ProcessOutput),
        );
}

/// The characters of texts that egui's own fonts lack.
#[must_use]
pub fn lacking(texts: &[&str]) -> Vec<char> {
    let mut seen = HashSet::new();
    let characters = texts.iter().flat_map(|text| text.chars());
    without_glyph(characters.filter(|c| !c.is_ascii() && seen.insert(*c)))
}

/// Those of these characters that egui's own fonts lack.
fn without_glyph(characters: impl Iterator<Item = char>) -> Vec<char> {
    let mut characters = characters.filter(|c| !is_invisible(*c)).peekable();
    if characters.peek().is_none() {
        return Vec::new();
    }
    let own = FontDefinitions::default();
    let names = own.families.get(&FontFamily::Proportional);
    let data = names.into_iter().flatten().map(|name| &own.font_data[name]);
    let fonts = data.filter_map(|data| FontRef::from_index(&data.font, data.index).ok());
    let charmaps: Vec<_> = fonts.map(|font| font.charmap()).collect();
    let has = |c: char| charmaps.iter().any(|charmap| charmap.map(c).is_some());
    characters.filter(|c| !has(*c)).collect()
}

/// Whether egui shows nothing for a character: controls of the text's direction, of joining and of
/// forms, and spaces that it makes itself.
fn is_invisible(character: char) -> bool {
    character.is_control()
        || matches!(
            u32::from(character),
            0x2009 | 0x200b..=0x200f | 0x202a..=0x202f | 0x2060..=0x206f | 0xfe00..=0xfe0f | 0xfeff | 0xe_0100..=0xe_01ef
        )
}

fn look_for_characters(outputs: Query<&EguiFullOutput>, mut glyphs: ResMut<Glyphs>) {
    let mut new = Vec::new();
    for output in outputs.iter().filter_map(|output| output.0.as_ref()) {
        for clipped in &output.shapes {
            collect(&clipped.shape, &mut glyphs.seen, &mut new);
        }
    }
    let new = without_glyph(new.into_iter());
    if !new.is_empty() {
        let finder = glyphs.finder.get_or_insert_with(|| {
            let mut fonts = None;
            Worker::serving_all(move |characters: Vec<char>, answers| {
                answers.send(
                    fonts
                        .get_or_insert_with(SystemFonts::open)
                        .find(&characters),
                );
            })
        });
        finder.ask(new);
    }
}

/// Collects the characters of a shape that were not seen before.
fn collect(shape: &egui::Shape, seen: &mut HashSet<char>, new: &mut Vec<char>) {
    match shape {
        egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, seen, new)),
        egui::Shape::Text(text) => {
            let characters = text.galley.text().chars();
            new.extend(characters.filter(|c| !c.is_ascii() && seen.insert(*c)));
        }
        _ => {}
    }
}

fn add_found_fonts(
    mut contexts: EguiContexts,
    mut glyphs: ResMut<Glyphs>,
    mut toast: ResMut<Toast>,
) -> Result {
    let Some(found) = glyphs.finder.as_ref().and_then(Worker::next_answer) else {
        return Ok(());
    };
    let context = contexts.ctx_mut()?;
    for font in found.fonts {
        context.add_font(insertion(font));
    }
    let mut is_news = false;
    for character in &found.missing {
        is_news |= glyphs.named.insert(script_name(*character));
    }
    let number = |character| format!("U+{:04X}", u32::from(character));
    if let Some(sentence) = missing_sentence(&found.missing, MAX_LISTED, number).filter(|_| is_news)
    {
        toast.add(&format!("Boxes stand for letters: {sentence}"));
    }
    Ok(())
}

/// A font of the system as the last of both of egui's families.
fn insertion(font: SystemFont) -> FontInsert {
    let mut data = FontData::from_static(font.data).tweak(FontTweak {
        coords: VariationCoords::new(font.axes),
        ..default()
    });
    data.index = font.index;
    let families =
        [FontFamily::Proportional, FontFamily::Monospace].map(|family| InsertFontFamily {
            family,
            priority: FontPriority::Lowest,
        });
    FontInsert::new(
        &format!("{} of the system", font.name),
        data,
        families.into(),
    )
}
