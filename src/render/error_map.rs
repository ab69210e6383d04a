//! The grid of errors that the view `error` shows, worked out beside the frames: by a thread of its
//! own, on a GPU device beside the window's.
//!
//! While a new grid is being worked out, that of the last place stays, and it shows each as it
//! comes. A still waits.

use super::CurrentScene;
use bevy::prelude::*;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use lightfall_core::accuracy::over_picture;
use lightfall_core::gpu::{ERROR_MAP_SIZE, ErrorMap, GpuError, with_background_device};
use lightfall_core::scene::{Disk, Picture, Scene, View};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, PoisonError};

/// Whether a frame of the view `error` waits until its errors are known: for stills.
#[derive(Resource, Default)]
pub struct AwaitErrors(pub bool);

/// The errors known last.
#[derive(Resource, Clone, Default, ExtractResource)]
pub(super) struct PictureErrors {
    /// Of which scene they are.
    of: Option<Scene>,
    pub(super) cells: ErrorMap,
}

/// What was asked for last, and the way to the thread that answers; there is none before something
/// is asked.
#[derive(Resource, Default)]
pub(super) struct Work {
    asked: Option<Scene>,
    /// Whether the answer to that is still to come.
    awaited: bool,
    /// What kept it from being worked out.
    fault: Option<String>,
    worker: Option<Worker>,
}

struct Worker {
    orders: Sender<Scene>,
    answers: Mutex<Receiver<Answer>>,
}

struct Answer {
    of: Scene,
    cells: Result<ErrorMap, GpuError>,
}

impl Work {
    /// Whether the answer for the present scene is there, where one is needed.
    ///
    /// # PictureErrors
    /// What kept it from being worked out.
    pub(super) fn is_done(&self, scene: &Scene) -> Result<bool, String> {
        match &self.fault {
            _ if scene.view != View::Error => Ok(true),
            Some(fault) => Err(fault.clone()),
            None => Ok(!self.awaited && self.asked == Some(traced(scene))),
        }
    }

    fn ask(&mut self, scene: Scene) {
        let worker = self.worker.get_or_insert_with(Worker::start);
        // A thread that is gone is found out when it does not answer.
        let _ = worker.orders.send(scene.clone());
        (self.asked, self.awaited, self.fault) = (Some(scene), true, None);
    }

    /// The newest answer, if there is a new one; with `patience`, the one to what was asked last.
    fn answer(&mut self, patience: bool) -> Option<Answer> {
        let answers = self
            .worker
            .as_ref()
            .filter(|_| self.awaited)?
            .answers
            .lock();
        let answers = answers.unwrap_or_else(PoisonError::into_inner);
        if patience {
            answers
                .iter()
                .find(|answer| self.asked.as_ref() == Some(&answer.of))
        } else {
            answers.try_iter().last()
        }
    }
}

impl Worker {
    fn start() -> Self {
        let (orders, work) = channel();
        let (answer, answers) = channel();
        std::thread::spawn(move || run(&work, &answer));
        Self {
            orders,
            answers: Mutex::new(answers),
        }
    }
}

fn run(work: &Receiver<Scene>, answer: &Sender<Answer>) {
    while let Ok(order) = work.recv() {
        // Of several scenes that were asked for in the meantime only the last is still wanted.
        let of = work.try_iter().last().unwrap_or(order);
        let cells = with_background_device(|gpu| over_picture(gpu, &of, ERROR_MAP_SIZE))
            .map(|errors| ErrorMap::new(&errors));
        if answer.send(Answer { of, cells }).is_err() {
            return;
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<AwaitErrors>()
        .init_resource::<PictureErrors>()
        .init_resource::<Work>()
        .add_plugins(ExtractResourcePlugin::<PictureErrors>::default())
        .add_systems(PostUpdate, follow);
}

/// What of a scene decides where rays end, and how large its pixels are.
fn traced(scene: &Scene) -> Scene {
    let Scene {
        method,
        hole,
        camera,
        observer,
        effects,
        quality,
        ..
    } = *scene;
    let Disk {
        enabled,
        inner,
        follow_isco,
        outer,
        ..
    } = scene.disk;
    let none = Scene::default();
    let disk = Disk {
        enabled,
        inner,
        follow_isco,
        outer,
        ..none.disk
    };
    let picture = Picture {
        width: scene.picture.width,
        height: scene.picture.height,
        ..none.picture
    };
    Scene {
        method,
        hole,
        camera,
        observer,
        effects,
        quality,
        disk,
        picture,
        ..none
    }
}

/// Asks for the errors of the present scene, and takes them in when they come.
pub(super) fn follow(
    scene: Res<CurrentScene>,
    patience: Res<AwaitErrors>,
    mut work: ResMut<Work>,
    mut errors: ResMut<PictureErrors>,
) {
    if scene.view == View::Error && scene.is_changed() {
        let wanted = traced(&scene);
        if work.asked.as_ref() != Some(&wanted) {
            // The errors of another place are a picture that lags; those of another method would be
            // a lie.
            let (camera, observer) = (wanted.camera, wanted.observer);
            if errors.of.take().is_none_or(|of| {
                Scene {
                    camera,
                    observer,
                    ..of
                } != wanted
            }) {
                errors.cells = ErrorMap::default();
            }
            work.ask(wanted);
        }
    }
    if !work.awaited {
        return;
    }
    let Some(Answer { of, cells }) = work.answer(patience.0) else {
        return;
    };
    work.awaited = work.asked.as_ref() != Some(&of);
    match cells {
        Ok(cells) => {
            *errors = PictureErrors {
                of: Some(of),
                cells,
            }
        }
        Err(fault) => {
            let fault = format!("the errors of the picture could not be worked out: {fault}");
            error!("{fault}");
            work.fault = Some(fault);
        }
    }
}
