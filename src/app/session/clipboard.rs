//! The clipboard: text fields copy, cut and paste, the ray inspector copies. A thread of its own
//! holds it, for a text has to stay with whoever copied it, and one that is asked for comes when
//! its owner gives it.

use crate::app::input::keyboard::Typing;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use bevy_egui::{
    EguiInput, EguiOutput, EguiPostUpdateSet, EguiPreUpdateSet, PrimaryEguiContext, egui,
};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, PoisonError};

enum Order {
    Copy(String),
    Paste,
}

/// The way to the thread and back.
#[derive(Resource)]
pub(crate) struct Clipboard {
    orders: Sender<Order>,
    /// Texts to paste, or what could not be done.
    answers: Mutex<Receiver<Result<String, String>>>,
}

impl Clipboard {
    fn start() -> Self {
        let (orders, work) = channel();
        let (answer, answers) = channel();
        std::thread::spawn(move || run(&work, &answer));
        Self {
            orders,
            answers: Mutex::new(answers),
        }
    }

    /// Puts a text on the clipboard.
    pub(crate) fn copy(&self, text: String) {
        self.order(Order::Copy(text));
    }

    fn order(&self, order: Order) {
        // A thread that is gone does nothing; the fields then are as they were.
        let _ = self.orders.send(order);
    }

    fn answer(&self) -> Option<Result<String, String>> {
        self.answers
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .try_recv()
            .ok()
    }
}

fn run(work: &Receiver<Order>, answer: &Sender<Result<String, String>>) {
    let mut board = None;
    while let Ok(order) = work.recv() {
        let answered = match serve(order, &mut board) {
            Ok(Some(text)) => answer.send(Ok(text)),
            Ok(None) => Ok(()),
            Err(arboard::Error::ContentNotAvailable) => {
                answer.send(Err("There is no text on the clipboard".into()))
            }
            Err(error) => answer.send(Err(format!("The clipboard cannot be reached: {error}"))),
        };
        if answered.is_err() {
            return;
        }
    }
}

fn serve(
    order: Order,
    board: &mut Option<arboard::Clipboard>,
) -> Result<Option<String>, arboard::Error> {
    let board = match board {
        Some(board) => board,
        none => none.insert(arboard::Clipboard::new()?),
    };
    match order {
        Order::Copy(text) => board.set_text(text).map(|()| None),
        Order::Paste => board.get_text().map(Some),
    }
}

pub(crate) fn plugin(app: &mut App) {
    let hear = hear
        .after(EguiPreUpdateSet::ProcessInput)
        .before(EguiPreUpdateSet::BeginPass);
    app.insert_resource(Clipboard::start())
        .add_systems(PreUpdate, hear)
        .add_systems(PostUpdate, give.after(EguiPostUpdateSet::ProcessOutput));
}

/// What a key means to a text field, beside what egui makes of it.
enum Wish {
    Copy,
    Cut,
    Paste,
}

fn wish(event: &egui::Event) -> Option<Wish> {
    let egui::Event::Key {
        key,
        pressed: true,
        modifiers,
        ..
    } = event
    else {
        return None;
    };
    let command = modifiers.command && !modifiers.alt;
    match key {
        egui::Key::Copy => Some(Wish::Copy),
        egui::Key::Cut => Some(Wish::Cut),
        egui::Key::Paste => Some(Wish::Paste),
        egui::Key::C | egui::Key::Insert if command => Some(Wish::Copy),
        egui::Key::X if command => Some(Wish::Cut),
        egui::Key::V if command => Some(Wish::Paste),
        egui::Key::Insert if modifiers.shift => Some(Wish::Paste),
        _ => None,
    }
}

/// Tells egui of copying, cutting and pasting while a text field has the keyboard.
fn hear(
    mut inputs: Query<&mut EguiInput, With<PrimaryEguiContext>>,
    typing: Res<Typing>,
    clipboard: Res<Clipboard>,
    mut notice: ResMut<Toast>,
) {
    // A text that comes when its field has been left is for no other.
    let pasted = match clipboard.answer() {
        Some(Err(fault)) => {
            notice.say(fault);
            None
        }
        answer => answer.and_then(Result::ok),
    };
    if !typing.0 {
        return;
    }
    for mut input in &mut inputs {
        for wish in input.events.iter().filter_map(wish).collect::<Vec<_>>() {
            match wish {
                Wish::Copy => input.events.push(egui::Event::Copy),
                Wish::Cut => input.events.push(egui::Event::Cut),
                Wish::Paste => clipboard.order(Order::Paste),
            }
        }
        input.events.extend(pasted.clone().map(egui::Event::Paste));
    }
}

/// Puts what was copied or cut on the clipboard.
fn give(outputs: Query<&EguiOutput, With<PrimaryEguiContext>>, clipboard: Res<Clipboard>) {
    for command in outputs
        .iter()
        .flat_map(|output| &output.platform_output.commands)
    {
        if let egui::OutputCommand::CopyText(text) = command {
            clipboard.copy(text.clone());
        }
    }
}
