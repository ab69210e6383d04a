//! The thread that traces inspected rays again: at once by the f64 reference, then on a GPU device of its own, so that no
//! frame waits for it.

use crate::gpu::rays::RayKernel;
use crate::gpu::{Gpu, GpuError};
use crate::report::error::Ray;
use crate::report::inspection::Inspected;
use crate::scene::Scene;
use bevy::prelude::Resource;
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};

/// Rays to inspect: the first is the one that is meant, the others are the fan about it.
pub(super) struct Job {
    /// The scene, with the picture that was clicked on.
    pub(super) scene: Scene,
    /// The rays, and the places on the picture that they belong to, in pixels.
    pub(super) rays: Vec<(Ray, [f64; 2])>,
}

/// What is known of a job so far.
pub(super) struct Answer {
    pub(super) scene: Scene,
    /// The rays, in order.
    pub(super) rays: Vec<Inspected>,
    /// How it stands with the GPU.
    pub(super) gpu: GpuState,
}

/// How it stands with the GPU's answer.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum GpuState {
    Waiting,
    Done,
    Failed(String),
}

enum Order {
    Trace(Box<Job>),
    Copy(String),
}

/// The way to the thread and back.
#[derive(Resource)]
pub(super) struct Worker {
    orders: Sender<Order>,
    answers: Mutex<Receiver<Result<Answer, String>>>,
}

impl Worker {
    /// Starts the thread.
    pub(super) fn start() -> Self {
        let (orders, work) = channel();
        let (answer, answers) = channel();
        std::thread::spawn(move || run(&work, &answer));
        Self { orders, answers: Mutex::new(answers) }
    }

    /// Asks for rays.
    pub(super) fn trace(&self, job: Job) {
        // A thread that is gone answers nothing; the inspector then shows what it had.
        let _ = self.orders.send(Order::Trace(Box::new(job)));
    }

    /// Puts a text on the clipboard, which has to stay with whoever put it there.
    pub(super) fn copy(&self, text: String) {
        let _ = self.orders.send(Order::Copy(text));
    }

    /// The newest answer, if there is a new one; as an error, what could not be done.
    pub(super) fn answer(&self) -> Option<Result<Answer, String>> {
        let answers = self.answers.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        answers.try_iter().last()
    }
}

fn run(work: &Receiver<Order>, answer: &Sender<Result<Answer, String>>) {
    let mut device = None;
    let mut clipboard = None;
    while let Ok(mut order) = work.recv() {
        // Of several rays that were asked for in the meantime only the last is still wanted.
        loop {
            match work.try_recv() {
                Ok(next @ Order::Trace(_)) if matches!(order, Order::Trace(_)) => order = next,
                Ok(next) => {
                    serve(order, &mut device, &mut clipboard, answer);
                    order = next;
                }
                Err(TryRecvError::Empty | TryRecvError::Disconnected) => break,
            }
        }
        serve(order, &mut device, &mut clipboard, answer);
    }
}

fn serve(
    order: Order,
    device: &mut Option<Gpu>,
    clipboard: &mut Option<arboard::Clipboard>,
    answer: &Sender<Result<Answer, String>>,
) {
    let fault = match order {
        Order::Trace(job) => trace(*job, device, answer),
        Order::Copy(text) => copy(text, clipboard),
    };
    if let Err(fault) = fault {
        // Nobody listens once the window is closed.
        let _ = answer.send(Err(fault));
    }
}

/// How far out a path is drawn, in r_s.
fn farthest(scene: &Scene) -> f64 {
    3.0 * scene.camera.r + 60.0
}

fn trace(
    Job { scene, rays }: Job,
    device: &mut Option<Gpu>,
    answer: &Sender<Result<Answer, String>>,
) -> Result<(), String> {
    let legs = scene.camera.legs_from_camera();
    let inspect = || -> Result<Vec<Inspected>, String> {
        let inspected = rays.iter().map(|(ray, pixel)| {
            Inspected::new(&scene, legs * ray.direction(), Some(*pixel), farthest(&scene))
                .map_err(|error| error.to_string())
        });
        inspected.collect()
    };
    let mut inspected = inspect()?;
    let send = |rays: &[Inspected], gpu: GpuState| {
        let _ = answer.send(Ok(Answer { scene: scene.clone(), rays: rays.to_vec(), gpu }));
    };
    send(&inspected, GpuState::Waiting);
    let (Some((ray, _)), Some(first)) = (rays.first(), inspected.first_mut()) else { return Ok(()) };
    let state = match on_gpu(device, &scene, *ray) {
        Ok(trace) => {
            let height = f64::from(scene.picture.height);
            first.compare(&scene, *ray, &trace, height).map_err(|error| error.to_string())?;
            GpuState::Done
        }
        Err(error) => {
            // A device that failed is not asked again.
            *device = None;
            GpuState::Failed(error.to_string())
        }
    };
    send(&inspected, state);
    Ok(())
}

fn on_gpu(device: &mut Option<Gpu>, scene: &Scene, ray: Ray) -> Result<crate::physics::trace::Trace, GpuError> {
    let gpu = match device {
        Some(gpu) => gpu,
        none => none.insert(Gpu::headless()?),
    };
    let traces = RayKernel::new(gpu, scene)?.trace(gpu, scene, &[ray.given()])?;
    traces.into_iter().next().ok_or_else(|| GpuError::Device("it gave no answer".into()))
}

fn copy(text: String, clipboard: &mut Option<arboard::Clipboard>) -> Result<(), String> {
    let failed = |error: arboard::Error| format!("The clipboard cannot be reached: {error}");
    let board = match clipboard {
        Some(board) => board,
        none => none.insert(arboard::Clipboard::new().map_err(failed)?),
    };
    board.set_text(text).map_err(failed)
}
