//! From pressed keys and buttons to the controls that they are bound to.

use super::clicks::hold_keys_after_click;
use super::gamepad::Pads;
use super::held::ClaimedKeys;
use super::second_press::{SecondPress, WAIT};
use super::typing::{MouseOverPanel, Typing, types_numbers};
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::{Action, AppCommand, Control, FlightInput, Modifier};
use crate::app::controls::edits::edited;
use crate::app::controls::empty_view::why_empty;
use crate::app::controls::helm::{button_at_helm, key_at_helm};
use crate::app::controls::key_feedback::remark;
use crate::app::controls::lesson::{button_in_lesson, key_in_lesson};
use crate::app::controls::statement::statement;
use crate::app::state::helm::{CommandSender, Helm};
use crate::app::state::lessons::LessonUnderWay;
use crate::app::state::missions::AskedQuestion;
use crate::app::state::scene_editor::SceneEditor;
use bevy::input::ButtonState;
use bevy::input::keyboard::KeyboardInput;
use bevy::prelude::*;

pub(crate) fn plugin(app: &mut App) {
    app.add_message::<AppCommand>()
        .init_resource::<ClaimedKeys>()
        .add_systems(
            PreUpdate,
            apply_pressed_controls.after(hold_keys_after_click),
        )
        .add_systems(Update, undo_last_change);
}

/// Applies each press in its order. Two presses within one slow frame are two. Those after a click on
/// the user interface wait for the next frame, which knows whether a text field has the keyboard.
pub(super) fn apply_pressed_controls(
    mut inputs: MessageReader<KeyboardInput>,
    keys: Res<ButtonInput<KeyCode>>,
    bindings: Res<Bindings>,
    (typing, over_panel): (Res<Typing>, Res<MouseOverPanel>),
    (lesson, asked): (Res<LessonUnderWay>, Res<AskedQuestion>),
    mut claimed: ResMut<ClaimedKeys>,
    pads: Pads,
    mut editor: SceneEditor,
    mut commands: CommandSender,
    mut waiting: Local<Vec<(KeyCode, Option<Modifier>)>>,
    (time, mut second_press): (Res<Time<Real>>, Local<SecondPress>),
) {
    let listens = !typing.has_keyboard && !held(&keys, [KeyCode::SuperLeft, KeyCode::SuperRight]);
    let inputs: Vec<&KeyboardInput> = inputs.read().collect();
    let new = pressed_with_modifiers(inputs.iter().copied(), &keys);
    claimed.0.retain(|code| keys.pressed(*code));
    let claims = |(code, modifier): &&(KeyCode, Option<Modifier>)| {
        modifier.is_some() && bindings.owner(*code, *modifier).is_some()
    };
    for (code, modifier) in new.iter().filter(claims) {
        claimed.0.push(*code);
        // Ctrl alone flies down.
        let keys = modifier.iter().flat_map(|modifier| modifier.keys());
        claimed
            .0
            .extend(keys.filter(|key| thrusts(*key, &bindings)));
    }
    let at_once = typing.keys_before_click.map_or(new.len(), |before| {
        let before = inputs.iter().take(before);
        before.filter(|input| is_press(input)).count()
    });
    let mut presses = std::mem::take(&mut *waiting);
    presses.extend(&new[..at_once]);
    waiting.extend(&new[at_once..]);
    let by_panel = |(code, modifier): &(KeyCode, Option<Modifier>)| {
        over_panel.keeps(*code) && modifier.is_none()
    };
    if listens && presses.iter().any(by_panel) {
        editor.say("The mouse is over the panel: click a field to type a number");
    }
    // They type the answer, whether or not its field has the keyboard.
    let asks = lesson.asks || asked.question().is_some();
    let kept = |press: &(KeyCode, Option<Modifier>)| {
        by_panel(press) || asks && types_numbers(press.0) && press.1.is_none()
    };
    let has_ship = commands.helm.has_ship();
    let on_mission = *commands.helm == Helm::Mission;
    let [key_action, button_action]: [fn(&Control) -> Action; 2] = if has_ship {
        [key_at_helm, button_at_helm]
    } else if lesson.is_flown {
        [key_in_lesson, button_in_lesson]
    } else {
        [usual_action, usual_action]
    };
    // A key that goes on with a lesson does not fly, too.
    let goes_on = |(code, modifier): &&(KeyCode, Option<Modifier>)| {
        let control = bindings.pressed(*code, *modifier);
        control.is_some_and(|it| matches!(key_action(it), Action::Do(AppCommand::GoOn)))
    };
    let going_on: Vec<KeyCode> = presses
        .iter()
        .filter(goes_on)
        .map(|(code, _)| *code)
        .collect();
    claimed.0.extend(going_on);
    let by_key = presses
        .into_iter()
        .filter(|press| listens && !kept(press))
        .filter_map(|(code, modifier)| bindings.pressed(code, modifier))
        .map(|control| (control, key_action(control), bindings.label_of(control)));
    let by_button = bindings
        .iter()
        .filter_map(|(control, _)| Some((control, button_action(control), pads.pressed(control)?)));
    for (control, action, input) in by_key.chain(by_button) {
        if !commands.kiosk.allows(action) {
            continue;
        }
        match action {
            // Shift is a gear, too: whoever flies means the key without it.
            Action::Do(AppCommand::TakeControls) if is_thrusting(&keys, &bindings) => {
                commands.send(AppCommand::LetGo);
            }
            Action::Do(AppCommand::FaceBack) if is_thrusting(&keys, &bindings) => {
                commands.send(AppCommand::Face);
            }
            Action::Do(command) => commands.send(command),
            // A wrong digit is near W and Q, and a mission cannot be taken up again.
            Action::Load(_) | Action::StepPreset(_)
                if on_mission && !second_press.confirms(control.id, time.elapsed()) =>
            {
                let words = format!("{input} leaves the mission: press {input} again");
                editor.say_for(WAIT, words);
            }
            _ => apply(control, &input, &mut editor, &bindings),
        }
    }
}

/// What a control does while the hands fly the camera.
fn usual_action(control: &Control) -> Action {
    control.action
}

/// Whether a key that pushes is held.
fn is_thrusting(keys: &ButtonInput<KeyCode>, bindings: &Bindings) -> bool {
    keys.get_pressed().any(|key| thrusts(*key, bindings))
}

/// Whether a key pushes while it is held.
fn thrusts(key: KeyCode, bindings: &Bindings) -> bool {
    let pushes = |action: Action| matches!(action, Action::Hold(input) if FlightInput::THRUST.contains(&input));
    bindings
        .iter()
        .any(|(control, codes)| pushes(control.action) && codes.contains(&key))
}

/// Whether one of the keys was held at any time of the frame.
fn held(keys: &ButtonInput<KeyCode>, codes: [KeyCode; 2]) -> bool {
    keys.any_pressed(codes) || keys.any_just_pressed(codes)
}

/// Whether a message says that a key went down.
fn is_press(input: &KeyboardInput) -> bool {
    input.state.is_pressed() && !input.repeat
}

/// The keys pressed in this frame, each with the modifier that was held at that moment. In a slow
/// frame a modifier may be pressed, used and released.
pub(crate) fn pressed_with_modifiers<'a>(
    inputs: impl Iterator<Item = &'a KeyboardInput>,
    keys: &ButtonInput<KeyCode>,
) -> Vec<(KeyCode, Option<Modifier>)> {
    let at_start = |code: &KeyCode| {
        keys.just_released(*code) || keys.pressed(*code) && !keys.just_pressed(*code)
    };
    let mut down: Vec<KeyCode> = Modifier::ALL
        .into_iter()
        .flat_map(Modifier::keys)
        .filter(at_start)
        .collect();
    let mut presses = Vec::new();
    for input in inputs.filter(|input| !input.repeat) {
        let code = input.key_code;
        if input.state == ButtonState::Released {
            down.retain(|held| *held != code);
            continue;
        }
        // A modifier does not modify itself, so that a control can be bound to it.
        let modifier = Modifier::ALL.into_iter().find(|modifier| {
            let own = modifier.keys();
            !own.contains(&code) && own.iter().any(|key| down.contains(key))
        });
        presses.push((code, modifier));
        down.push(code);
    }
    presses
}

/// Changes the scene as a control says, if it changes scenes. `input` is the key or button's name.
fn apply(control: &Control, input: &str, editor: &mut SceneEditor, bindings: &Bindings) {
    if let Action::StepPreset(places) = control.action {
        return editor.step_preset(input, places);
    }
    let before = editor.scene();
    let Some(changed) = edited(control, &before, editor.loaded()) else {
        return;
    };
    if matches!(control.action, Action::Load(_)) {
        editor.load(input, Ok(changed));
        return;
    }
    let shows_other = changed.view != before.view;
    if let Some(reason) = why_empty(changed.view, &changed).filter(|_| shows_other) {
        let view = changed.view.properties().words;
        editor.say(format!("View {view} has nothing to show. {reason}"));
        return;
    }
    if editor.change(input, changed) {
        let after = editor.scene();
        let remark = remark(control, &before, &after, bindings);
        let says: Vec<String> = [statement(control, &after), remark]
            .into_iter()
            .flatten()
            .collect();
        editor.say(says.join(" · "));
    }
}

pub(crate) fn undo_last_change(mut commands: MessageReader<AppCommand>, mut editor: SceneEditor) {
    for _ in 0..AppCommand::Undo.count(&mut commands) {
        editor.undo();
    }
}
