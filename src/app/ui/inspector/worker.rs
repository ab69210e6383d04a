//! The thread that traces inspected rays again: at once by the f64 reference, then on a GPU device
//! beside the window's, so that no frame waits for it.

use bevy::prelude::Resource;
use lightfall_core::accuracy::Ray;
use lightfall_core::gpu::rays::RayKernel;
use lightfall_core::gpu::{GpuError, with_background_device};
use lightfall_core::optics::trace::Trace;
use lightfall_core::reports::inspection::Inspected;
use lightfall_core::reports::steps::StepCount;
use lightfall_core::scene::Scene;
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
    Count(Box<Scene>),
}

/// The way to the thread and back.
#[derive(Resource)]
pub(crate) struct Worker {
    orders: Sender<Order>,
    answers: Mutex<Receiver<Result<Answer, String>>>,
    counts: Mutex<Receiver<Result<StepCount, String>>>,
}

/// Where the thread's answers go.
struct Answers {
    rays: Sender<Result<Answer, String>>,
    steps: Sender<Result<StepCount, String>>,
}

impl Worker {
    /// Starts the thread.
    pub(super) fn start() -> Self {
        let (orders, work) = channel();
        let ((rays, answers), (steps, counts)) = (channel(), channel());
        std::thread::spawn(move || run(&work, &Answers { rays, steps }));
        Self {
            orders,
            answers: Mutex::new(answers),
            counts: Mutex::new(counts),
        }
    }

    /// Asks how many steps the rays of a scene's picture take.
    pub(crate) fn count(&self, scene: Scene) {
        let _ = self.orders.send(Order::Count(Box::new(scene)));
    }

    /// The newest count, if there is a new one.
    pub(crate) fn counted(&self) -> Option<Result<StepCount, String>> {
        self.counts
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
            .try_iter()
            .last()
    }

    /// Asks for rays.
    pub(super) fn trace(&self, job: Job) {
        // A thread that is gone answers nothing; the inspector then shows what it had.
        let _ = self.orders.send(Order::Trace(Box::new(job)));
    }

    /// The newest answer, if there is a new one; as an error, what could not be done.
    pub(super) fn answer(&self) -> Option<Result<Answer, String>> {
        let answers = self
            .answers
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner);
        answers.try_iter().last()
    }
}

fn run(work: &Receiver<Order>, answer: &Answers) {
    while let Ok(mut order) = work.recv() {
        // Of several rays that were asked for in the meantime only the last is still wanted.
        loop {
            match work.try_recv() {
                Ok(next @ Order::Trace(_)) if matches!(order, Order::Trace(_)) => order = next,
                Ok(next @ Order::Count(_)) if matches!(order, Order::Count(_)) => order = next,
                Ok(next) => {
                    serve(order, answer);
                    order = next;
                }
                Err(TryRecvError::Empty | TryRecvError::Disconnected) => break,
            }
        }
        serve(order, answer);
    }
}

fn serve(
    order: Order,
    Answers {
        rays: answer,
        steps,
    }: &Answers,
) {
    let fault = match order {
        Order::Trace(job) => trace(*job, answer),
        Order::Count(scene) => {
            let counted = with_background_device(|gpu| StepCount::of(gpu, &scene));
            let _ = steps.send(counted.map_err(|error| error.to_string()));
            Ok(())
        }
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

fn trace(Job { scene, rays }: Job, answer: &Sender<Result<Answer, String>>) -> Result<(), String> {
    let axes = scene.camera.tetrad_from_camera();
    let inspect = || -> Result<Vec<Inspected>, String> {
        let inspected = rays.iter().map(|(ray, pixel)| {
            Inspected::new(
                &scene,
                axes * ray.direction(),
                Some(*pixel),
                farthest(&scene),
            )
            .map_err(|error| error.to_string())
        });
        inspected.collect()
    };
    let mut inspected = inspect()?;
    let send = |rays: &[Inspected], gpu: GpuState| {
        let _ = answer.send(Ok(Answer {
            scene: scene.clone(),
            rays: rays.to_vec(),
            gpu,
        }));
    };
    send(&inspected, GpuState::Waiting);
    let (Some((ray, _)), Some(first)) = (rays.first(), inspected.first_mut()) else {
        return Ok(());
    };
    let state = match on_gpu(&scene, *ray) {
        Ok(trace) => {
            let height = f64::from(scene.picture.height);
            first
                .compare(&scene, *ray, &trace, height)
                .map_err(|error| error.to_string())?;
            GpuState::Done
        }
        Err(error) => GpuState::Failed(error.to_string()),
    };
    send(&inspected, state);
    Ok(())
}

fn on_gpu(scene: &Scene, ray: Ray) -> Result<Trace, GpuError> {
    with_background_device(|gpu| {
        let traces = RayKernel::new(gpu, scene)?.trace(gpu, scene, &[ray.given()])?;
        traces
            .into_iter()
            .next()
            .ok_or_else(|| GpuError::Device("it gave no answer".into()))
    })
}
