//! From pressed keys to what the key table says of them.

use super::bindings::Bindings;
use super::controls::{Action, Command, Motion};
use super::edits::edited;
use super::history::{History, drawable};
use super::notice::Notice;
use super::panel::Rebinding;
use super::remarks::remark;
use super::resolution::Resolution;
use crate::render::CurrentScene;
use crate::scene::Scene;
use bevy::ecs::system::SystemParam;
use bevy::input::ButtonState;
use bevy::input::keyboard::KeyboardInput;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass};

/// Whether the keyboard belongs to a text field, or waits for the new key of a control.
#[derive(Resource, Default)]
pub(super) struct Typing(pub(super) bool);

/// Keys that are held, by what they do.
#[derive(SystemParam)]
pub(super) struct Held<'w> {
    keys: Res<'w, ButtonInput<KeyCode>>,
    bindings: Res<'w, Bindings>,
}

impl Held<'_> {
    /// One direction's keys against the other's: 1, 0 or -1.
    pub(super) fn axis(&self, plus: Motion, minus: Motion) -> f64 {
        f64::from(self.motion(plus)) - f64::from(self.motion(minus))
    }

    fn motion(&self, motion: Motion) -> bool {
        let holds = |action| matches!(action, Action::Hold(held) if held == motion);
        // A tap that is over within a slow frame counts for that frame.
        let held = |code: &KeyCode| self.keys.pressed(*code) || self.keys.just_pressed(*code);
        self.bindings.iter().any(|(control, codes)| holds(control.action) && codes.iter().any(held))
    }
}

/// The scene, and the way to change it so that it can be undone. Every change but flying goes through here.
#[derive(SystemParam)]
pub(super) struct SceneEditor<'w> {
    scene: ResMut<'w, CurrentScene>,
    resolution: ResMut<'w, Resolution>,
    history: ResMut<'w, History>,
    notice: ResMut<'w, Notice>,
    time: Res<'w, Time<Real>>,
}

impl SceneEditor<'_> {
    /// The scene as it is meant, at its full resolution.
    pub(super) fn meant(&self) -> Scene {
        self.resolution.meant(&self.scene)
    }

    /// The scene as it is drawn just now.
    pub(super) fn drawn(&self) -> &Scene {
        &self.scene
    }

    /// The scene as it was loaded.
    pub(super) fn loaded(&self) -> &Scene {
        self.history.loaded()
    }

    /// Puts a changed scene in place, or says why that cannot be, `who` asking for it.
    pub(super) fn change(&mut self, who: &str, changed: Result<Scene, String>) {
        if let Err(reason) = self.try_change(changed) {
            self.refuse(who, &reason);
        }
    }

    /// As [`change`](Self::change), for who says it himself.
    ///
    /// # Errors
    /// Why it cannot be.
    pub(super) fn try_change(&mut self, changed: Result<Scene, String>) -> Result<(), String> {
        let changed = changed.and_then(drawable)?;
        let before = self.meant();
        self.history.note(&before, &changed, self.time.elapsed());
        self.accept(changed);
        Ok(())
    }

    /// As [`change`](Self::change), for a scene that is another one altogether.
    pub(super) fn load(&mut self, who: &str, loaded: Result<Scene, String>) {
        match loaded.and_then(drawable) {
            Ok(loaded) => {
                let before = self.meant();
                self.history.note_loaded(&before, &loaded, self.time.elapsed());
                self.accept(loaded);
            }
            Err(reason) => self.refuse(who, &reason),
        }
    }

    /// Takes the last change back.
    pub(super) fn undo(&mut self) {
        let now = self.meant();
        match self.history.undo(&now) {
            None => self.notice.say("There is nothing to undo"),
            Some(Ok(undone)) => self.accept(undone),
            Some(Err(reason)) => self.refuse("Undo", &reason),
        }
    }

    /// Says something at the bottom of the window.
    pub(super) fn say(&mut self, text: impl Into<String>) {
        self.notice.say(text);
    }

    fn accept(&mut self, changed: Scene) {
        self.scene.0 = self.resolution.drawn(changed);
        self.notice.clear();
    }

    fn refuse(&mut self, who: &str, reason: &str) {
        self.notice.say(if who.is_empty() { reason.to_owned() } else { format!("{who}: {reason}") });
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Typing>()
        .add_message::<Command>()
        .add_systems(PreUpdate, apply.after(bevy::input::InputSystems))
        .add_systems(Update, undo)
        .add_systems(EguiPrimaryContextPass, notice_typing);
}

/// Only text fields take the keyboard: any other part of the panel that egui gives the focus to loses it again, so that
/// flying goes on.
fn notice_typing(mut contexts: EguiContexts, mut typing: ResMut<Typing>, rebinding: Res<Rebinding>) -> Result {
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
    mut editor: SceneEditor,
    mut commands: MessageWriter<Command>,
) {
    let fresh = |input: &&KeyboardInput| input.state == ButtonState::Pressed && !input.repeat;
    let presses: Vec<KeyCode> = inputs.read().filter(fresh).map(|input| input.key_code).collect();
    // Held at some time of the frame.
    let held = |codes: [KeyCode; 2]| keys.any_pressed(codes) || keys.any_just_pressed(codes);
    if typing.0 || held([KeyCode::SuperLeft, KeyCode::SuperRight]) {
        return;
    }
    // Without Alt in the table, a key with Alt is the desktop's.
    let alt = held([KeyCode::AltLeft, KeyCode::AltRight]);
    for control in presses.into_iter().filter_map(|code| bindings.owner(code, alt)) {
        if let Action::Do(command) = control.action {
            commands.write(command);
        }
        let before = editor.meant();
        let Some(changed) = edited(control, &before, editor.loaded()) else { continue };
        let who = bindings.in_words(control);
        match control.action {
            Action::Load(_) => editor.load(&who, changed),
            _ => {
                let remark = changed.as_ref().ok().and_then(|after| remark(control, &before, after, &bindings));
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
