//! Text fields get every key after a click into them, however slow the frames are.

use crate::PLAIN;
use crate::desktop::Desktop;
use watched::{Order, State};

/// Seconds of a frame: longer than a click and the first letters after it.
const SLOW: f64 = 0.9;
/// What follows the hole's mass in its field.
const UNIT: &str = " suns";

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn what_is_typed_right_after_a_click_into_a_field_goes_to_the_field() {
    let desktop = Desktop::open(&["--preset", PLAIN]);
    desktop.first_picture();
    desktop.press("p");
    desktop.click("Presets");
    let hint = "Name of a new preset";
    let before = desktop.wait_for("the field", |state| state.shows(hint));
    let [x, y] = before.place_of(hint).unwrap().map(|at| at as i32);
    desktop.order(&Order::Slow(SLOW));
    desktop.click_at_once(x, y);
    // L, S and Z are controls, and S flies.
    desktop.type_text("Lesson 1 z");
    let typed = desktop.wait_for("the name", |state| state.shows("Lesson 1 z"));
    assert!(typed.changed_since(&before).is_empty(), "{typed:?}");

    // A number field that is not a text field before it is clicked, in frames of every length.
    for (seconds, number) in [(SLOW, "5712"), (0.15, "6823")] {
        desktop.order(&Order::Slow(0.0));
        desktop.click("Read-outs");
        let place = desktop.wait_for("the mass", |state| state.shows(UNIT));
        let place = place.place_of(UNIT);
        let [x, y] = place.unwrap().map(|at| at as i32);
        desktop.order(&Order::Slow(seconds));
        desktop.click_at_once(x, y);
        desktop.type_text(number);
        desktop.press_at_once("Return");
        // The unit is beside the number while the field is not edited.
        let is_set = |state: &State| state.texts.iter().any(|text| text.words == number);
        let typed = desktop.wait_for(number, |state| is_set(state) && state.shows(UNIT));
        assert!(typed.changed_since(&before).is_empty(), "{typed:?}");
    }

    // A key after a click on a button of the panel acts.
    desktop.order(&Order::Slow(SLOW));
    let [x, y] = desktop.state().place_of("Machine").unwrap();
    desktop.click_at_once(x as i32, y as i32);
    desktop.press_at_once("F2");
    desktop.wait_for("F2", |state| state.scene["disk.enabled"] == false);
}
