//! The ray inspector: it traces the light of a clicked pixel again, lists its numbers and draws its
//! path.

mod chosen_rays;
mod colours;
mod drawing;
mod handout;
mod labels;
mod numbers;
mod page;
mod plane_figure;
mod projection;
mod ray_worker;
mod svg;

pub use handout::plane_handout;

use crate::app::input::pointer::locate_pointer;
use crate::app::input::touch::read_fingers;
use crate::app::state::toast::Toast;
use crate::app::ui::picture_in_window::SceneSide;
use bevy::prelude::*;
use bevy_egui::EguiPrimaryContextPass;
use chosen_rays::{inspect_chosen_pixel, inspect_ray_of_stop, note_shown_ray};
use drawing::Sketch;
use glam::DVec2;
use lightfall_core::accuracy::Ray;
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::InspectorView;
use page::show_inspector;
use ray_worker::{InspectedRays, RayJob, RayWorker};

/// What the inspector remembers, and the thread that traces for it.
#[derive(Resource)]
struct Inspector {
    worker: RayWorker,
    sketch: Sketch,
    /// Rays per side of the fan.
    fan: u32,
    /// Pixels between the rays of the fan.
    spacing: f64,
    /// Which of two compared scenes was clicked last.
    side: SceneSide,
    /// The scene and the pixel of the last click, or of the ray of a lesson's stop.
    asked: Option<(Scene, DVec2)>,
    /// The ray of a lesson's stop, which is followed until another one is clicked.
    followed: Option<InspectorView>,
    answer: Option<InspectedRays>,
    /// Height of everything below the drawing as shown last, in points.
    text_height: f32,
}

pub(crate) fn plugin(app: &mut App) {
    let inspector = Inspector {
        worker: ray_worker::start(),
        sketch: Sketch::default(),
        fan: 1,
        spacing: 12.0,
        side: SceneSide::Current,
        asked: None,
        followed: None,
        answer: None,
        text_height: 0.0,
    };
    app.insert_resource(inspector)
        .add_systems(
            Update,
            (
                inspect_chosen_pixel
                    .after(locate_pointer)
                    .after(read_fingers),
                inspect_ray_of_stop,
                (receive_rays, note_shown_ray).chain(),
            ),
        )
        .add_systems(EguiPrimaryContextPass, show_inspector);
}

impl Inspector {
    /// Asks for the ray that was clicked last and the fan around it.
    fn ask(&self) {
        let Some((scene, pixel)) = &self.asked else {
            return;
        };
        let half = i64::from(self.fan / 2);
        let offsets = (-half..=half)
            .flat_map(|y| (-half..=half).map(move |x| DVec2::new(x as f64, y as f64)));
        // The clicked ray comes first.
        let mut offsets: Vec<DVec2> = offsets.collect();
        offsets.sort_by_key(|offset| *offset != DVec2::ZERO);
        let ray = |offset: DVec2| {
            let place = *pixel + self.spacing * offset;
            let looking = scene.camera.looking(place, scene.picture.size().as_dvec2());
            (Ray::toward(looking), place.to_array())
        };
        self.worker.ask(RayJob {
            scene: scene.clone(),
            rays: offsets.into_iter().map(ray).collect(),
        });
    }
}

fn receive_rays(mut inspector: ResMut<Inspector>, mut toast: ResMut<Toast>) {
    match inspector.worker.latest_answer() {
        Some(Ok(answer)) => inspector.answer = Some(answer),
        Some(Err(fault)) => toast.say(fault),
        None => {}
    }
}
