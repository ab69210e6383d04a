//! From pressed keys and buttons to what the key table says of them.

use crate::app::controls::bindings::Bindings;
use crate::app::controls::edits::edited;
use crate::app::controls::table::{Action, Command, FlightInput};
use crate::app::input::gamepad::Pads;
use crate::app::input::key_feedback::remark;
use crate::app::session::resolution::Resolution;
use crate::app::session::window::Preferences;
use crate::app::state::history::History;
use crate::app::state::toast::Toast;
use crate::app::ui::panel::Rebinding;
use crate::render::CurrentScene;
use bevy::ecs::system::SystemParam;
use bevy::input::ButtonState;
use bevy::input::keyboard::KeyboardInput;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass};
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Scene;

/// Whether the keyboard belongs to a text field, or waits for the new key of a control.
#[derive(Resource, Default)]
pub(crate) struct Typing(pub(crate) bool);

/// Keys and buttons that are held, by what they do.
#[derive(SystemParam)]
pub(crate) struct Held<'w, 's> {
    keys: Res<'w, ButtonInput<KeyCode>>,
    bindings: Res<'w, Bindings>,
    pub(crate) typing: Res<'w, Typing>,
    pub(crate) pads: Pads<'w, 's>,
}

impl Held<'_, '_> {
    /// One direction's keys against the other's: from 1 to -1.
    pub(crate) fn axis(&self, plus: FlightInput, minus: FlightInput) -> f64 {
        self.motion(plus) - self.motion(minus)
    }

    fn motion(&self, motion: FlightInput) -> f64 {
        let holds = |action| matches!(action, Action::Hold(held) if held == motion);
        // A tap that is over within a slow frame counts for that frame.
        let held = |code: &KeyCode| self.keys.pressed(*code) || self.keys.just_pressed(*code);
        let mut controls = self
            .bindings
            .iter()
            .filter(|(control, _)| holds(control.action));
        let key = !self.typing.0 && controls.any(|(_, codes)| codes.iter().any(held));
        if key { 1.0 } else { self.pads.motion(motion) }
    }
}

/// The scene, and the way to change it so that it can be undone. Every change but flying goes
/// through here.
#[derive(SystemParam)]
pub(crate) struct SceneEditor<'w> {
    scene: ResMut<'w, CurrentScene>,
    resolution: ResMut<'w, Resolution>,
    history: ResMut<'w, History>,
    notice: ResMut<'w, Toast>,
    time: Res<'w, Time<Real>>,
}

impl SceneEditor<'_> {
    /// The scene as it is meant, at its full resolution.
    pub(crate) fn meant(&self) -> Scene {
        self.resolution.meant(&self.scene)
    }

    /// The scene as it is drawn just now.
    pub(crate) fn drawn(&self) -> &Scene {
        &self.scene
    }

    /// The scene as it was loaded.
    pub(crate) fn loaded(&self) -> &Scene {
        self.history.loaded()
    }

    /// Puts a changed scene in place, or says why that cannot be, `who` asking for it.
    pub(crate) fn change(&mut self, who: &str, changed: Result<Scene, String>) {
        if let Err(reason) = self.try_change(changed) {
            self.refuse(who, &reason);
        }
    }

    /// As [`change`](Self::change), for who says it himself.
    ///
    /// # Errors
    /// Why it cannot be.
    pub(crate) fn try_change(&mut self, changed: Result<Scene, String>) -> Result<(), String> {
        let before = self.meant();
        // Where it does not go with the rest, what was changed is named, and not the rest.
        let beside = |changed: Scene| {
            before
                .with(changed.differences(&before))
                .map_err(|refusal| refusal.to_string())
        };
        let changed = changed.and_then(beside).and_then(drawable)?;
        self.history.note(&before, &changed, self.time.elapsed());
        self.accept(changed);
        Ok(())
    }

    /// As [`change`](Self::change), for a scene that is another one altogether; says whether it is
    /// in place now.
    pub(crate) fn load(&mut self, who: &str, loaded: Result<Scene, String>) -> bool {
        let loaded = loaded.and_then(drawable);
        let accepted = loaded.is_ok();
        match loaded {
            Ok(loaded) => {
                let before = self.meant();
                self.history
                    .note_loaded(&before, &loaded, self.time.elapsed());
                self.accept(loaded);
            }
            Err(reason) => self.refuse(who, &reason),
        }
        accepted
    }

    /// Takes the last change back.
    pub(crate) fn undo(&mut self) {
        let now = self.meant();
        match self.history.undo(&now) {
            None => self.notice.say("There is nothing to undo"),
            Some(Ok(undone)) => self.accept(undone),
            Some(Err(reason)) => self.refuse("Undo", &reason),
        }
    }

    /// Says something at the bottom of the window.
    pub(crate) fn say(&mut self, text: impl Into<String>) {
        self.notice.say(text);
    }

    fn accept(&mut self, changed: Drawable) {
        self.scene.0 = self.resolution.drawn(changed);
        self.notice.clear();
    }

    fn refuse(&mut self, who: &str, reason: &str) {
        self.notice.say(if who.is_empty() {
            reason.to_owned()
        } else {
            format!("{who}: {reason}")
        });
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Typing>()
        .add_message::<Command>()
        .add_systems(PreUpdate, apply.after(bevy::input::InputSystems))
        .add_systems(Update, undo)
        .add_systems(EguiPrimaryContextPass, notice_typing);
}

/// Only text fields take the keyboard: any other part of the panel that egui gives the focus to
/// loses it again, so that flying goes on.
fn notice_typing(
    mut contexts: EguiContexts,
    mut typing: ResMut<Typing>,
    rebinding: Res<Rebinding>,
) -> Result {
    let context = contexts.ctx_mut()?;
    let in_text = context.text_edit_focused();
    typing.0 = in_text || rebinding.waits();
    if !in_text && let Some(focused) = context.memory(|memory| memory.focused()) {
        context.memory_mut(|memory| memory.surrender_focus(focused));
    }
    Ok(())
}

/// Each press by itself and in its order: two that come within one slow frame are two.
fn apply(
    mut inputs: MessageReader<KeyboardInput>,
    keys: Res<ButtonInput<KeyCode>>,
    bindings: Res<Bindings>,
    typing: Res<Typing>,
    pads: Pads,
    preferences: Res<Preferences>,
    mut editor: SceneEditor,
    mut commands: MessageWriter<Command>,
) {
    let fresh = |input: &&KeyboardInput| input.state == ButtonState::Pressed && !input.repeat;
    let presses: Vec<KeyCode> = inputs
        .read()
        .filter(fresh)
        .map(|input| input.key_code)
        .collect();
    // Held at some time of the frame.
    let held = |codes: [KeyCode; 2]| keys.any_pressed(codes) || keys.any_just_pressed(codes);
    let listens = !typing.0 && !held([KeyCode::SuperLeft, KeyCode::SuperRight]);
    // Without Alt in the table, a key with Alt is the desktop's.
    let alt = held([KeyCode::AltLeft, KeyCode::AltRight]);
    let by_key = presses
        .into_iter()
        .filter(|_| listens)
        .filter_map(|code| bindings.owner(code, alt));
    let by_key = by_key.map(|control| (control, bindings.in_words(control)));
    let by_button = bindings
        .iter()
        .filter_map(|(control, _)| pads.pressed(control).map(|button| (control, button)));
    let metered = preferences.settings.follows_light();
    for (control, who) in by_key.chain(by_button) {
        if let Action::Do(command) = control.action {
            commands.write(command);
        }
        let before = editor.meant();
        let Some(changed) = edited(control, &before, editor.loaded()) else {
            continue;
        };
        match control.action {
            Action::Load(_) | Action::Turn(_) => {
                editor.load(&who, changed);
            }
            _ => {
                let remark = changed
                    .as_ref()
                    .ok()
                    .and_then(|after| remark(control, &before, after, &bindings, metered));
                editor.change(&who, changed);
                if let Some(remark) = remark {
                    editor.say(format!("{who}: {remark}"));
                }
            }
        }
    }
}

fn undo(mut commands: MessageReader<Command>, mut editor: SceneEditor) {
    for _ in commands.read().filter(|command| **command == Command::Undo) {
        editor.undo();
    }
}

/// The scene with its numbers, or why it cannot be drawn, in one sentence.
fn drawable(scene: Scene) -> Result<Drawable, String> {
    Drawable::new(scene).map_err(|reason| reason.to_string())
}
