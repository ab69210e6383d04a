//! From pressed keys and buttons to the controls that they are bound to.

use super::gamepad::Pads;
use super::typing::{MouseOverPanel, Typing};
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::{Action, AppCommand, Control, Modifier};
use crate::app::controls::edits::edited;
use crate::app::controls::key_feedback::remark;
use crate::app::controls::statement::statement;
use crate::app::state::scene_editor::SceneEditor;
use bevy::input::ButtonState;
use bevy::input::keyboard::KeyboardInput;
use bevy::prelude::*;

pub(crate) fn plugin(app: &mut App) {
    app.add_message::<AppCommand>()
        .add_systems(
            PreUpdate,
            apply_pressed_controls.after(bevy::input::InputSystems),
        )
        .add_systems(Update, undo_last_change);
}

/// Applies each press in its order. Two presses within one slow frame are two.
fn apply_pressed_controls(
    mut inputs: MessageReader<KeyboardInput>,
    keys: Res<ButtonInput<KeyCode>>,
    bindings: Res<Bindings>,
    (typing, over_panel): (Res<Typing>, Res<MouseOverPanel>),
    pads: Pads,
    mut editor: SceneEditor,
    mut commands: MessageWriter<AppCommand>,
) {
    let is_press = |input: &&KeyboardInput| input.state == ButtonState::Pressed && !input.repeat;
    let presses: Vec<KeyCode> = inputs
        .read()
        .filter(is_press)
        .map(|input| input.key_code)
        .collect();
    // Held at any time of the frame.
    let held = |codes: [KeyCode; 2]| keys.any_pressed(codes) || keys.any_just_pressed(codes);
    let listens = !typing.0 && !held([KeyCode::SuperLeft, KeyCode::SuperRight]);
    // A modifier does not modify itself, so that a control can be bound to it.
    let modifier_of = |code: KeyCode| {
        Modifier::ALL
            .into_iter()
            .find(|modifier| held(modifier.keys()) && !modifier.keys().contains(&code))
    };
    let kept = |code: &KeyCode| over_panel.keeps(*code) && modifier_of(*code).is_none();
    if listens && presses.iter().any(kept) {
        editor.say("The mouse is over the panel: click a field to type a number");
    }
    let by_key = presses
        .into_iter()
        .filter(|code| listens && !kept(code))
        .filter_map(|code| bindings.pressed(code, modifier_of(code)))
        .map(|control| (control, bindings.label_of(control)));
    let by_button = bindings
        .iter()
        .filter_map(|(control, _)| Some((control, pads.pressed(control)?)));
    for (control, input) in by_key.chain(by_button) {
        if let Action::Do(command) = control.action {
            commands.write(command);
        } else {
            apply(control, &input, &mut editor, &bindings);
        }
    }
}

/// Changes the scene as a control says, if it changes scenes. `input` is the key or button's name.
fn apply(control: &Control, input: &str, editor: &mut SceneEditor, bindings: &Bindings) {
    let before = editor.scene();
    let Some(changed) = edited(control, &before, editor.loaded()) else {
        return;
    };
    if matches!(control.action, Action::Load(_) | Action::StepPreset(_)) {
        editor.load(input, Ok(changed));
        return;
    }
    if editor.change(input, changed) {
        let after = editor.scene();
        let remark = remark(control, &before, &after, bindings);
        let says: Vec<String> = [statement(control, &before, &after), remark]
            .into_iter()
            .flatten()
            .collect();
        editor.say(says.join(" · "));
    }
}

fn undo_last_change(mut commands: MessageReader<AppCommand>, mut editor: SceneEditor) {
    for _ in commands
        .read()
        .filter(|command| **command == AppCommand::Undo)
    {
        editor.undo();
    }
}
