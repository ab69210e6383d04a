//! Characters that egui's own fonts lack: a font of the system shows them, or a sentence says that
//! there is none.

use crate::PLAIN;
use crate::desktop::{Desktop, SMALL_SCREEN, Setup};
use crate::font_folder::{font_folder, has_fontconfig};
use std::fs;
use watched::State;

/// The text of the caption.
const CAPTION: &str = "光光光";

/// Opens a journey with the caption and a list of one star, on a system with a font that has
/// `characters`. Returns what the program says and the height of the caption's letters once `so`
/// holds.
fn fly(characters: &str, so: impl Fn(&State) -> bool) -> (String, f32) {
    let (folder, configuration) = font_folder(characters);
    let path = |name: &str| folder.path().join(name).display().to_string();
    let [journey, stars] = [path("fly.toml"), path("stars.csv")];
    let text = format!(
        "schema = 1\ntitle = \"Light\"\n[[keyframe]]\ntime = 0\nr = 30\n[[keyframe]]\ntime = 600\nr = 29\n\
         [[caption]]\ntime = 0\nseconds = 60\ntext = \"{CAPTION}\"\n"
    );
    fs::write(&journey, text).unwrap();
    fs::write(&stars, "ra_deg,dec_deg,v_mag,b_v,name\n10,10,1,0.5,速\n").unwrap();
    let setup = Setup {
        screen: SMALL_SCREEN,
        variables: &[("FONTCONFIG_FILE", configuration.to_str().unwrap())],
        ..Setup::default()
    };
    let arguments = ["--preset", PLAIN, "--journey", &journey, "--stars", &stars];
    let desktop = Desktop::open_with(&setup, &arguments);
    let state = desktop.wait_for("the caption", |state| so(state) && letters(state).is_some());
    let said = desktop.stderr().replace(&path(""), "");
    (said, letters(&state).unwrap())
}

/// The height of the caption's letters.
fn letters(state: &State) -> Option<f32> {
    let caption = state.texts.iter().find(|text| text.words == CAPTION)?;
    Some(caption.place.max[1] - caption.place.min[1])
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_character_is_shown_in_a_font_of_the_system_or_a_sentence_says_that_none_has_it() {
    let sentence = "Boxes stand for letters: no font of this system has the character U+5149; install one for Han \
                    text, for example fonts-noto-cjk";
    let (said, box_height) = fly("", |state| state.mentions(sentence));
    for remark in ["fly.toml", "--stars stars.csv"].iter().zip(["光", "速"]).map(|(file, character)| {
        format!(
            "lightfall: {file}: no font of this system has the character {character}; install one for Han text, for \
             example fonts-noto-cjk\n"
        )
    }) {
        assert!(said.contains(&remark), "{said}");
    }
    if !has_fontconfig() {
        return println!("not all tried: fontconfig is not installed");
    }
    // The font's full stops are lower than boxes, which the first frames still show.
    let (said, _) = fly("光速", |state| {
        assert!(!state.mentions("Boxes stand"), "{state:?}");
        letters(state).is_some_and(|height| height < box_height / 2.0)
    });
    assert!(!said.contains("no font"), "{said}");
}
