//! The ray inspector: it traces the light of a clicked pixel again, lists its numbers and draws its
//! path.

mod colours;
mod drawing;
mod handout;
mod labels;
mod numbers;
mod plane_figure;
mod projection;
mod ray_worker;
mod svg;

pub use handout::plane_handout;

use crate::app::input::pointer::{PointerOverPicture, locate_pointer};
use crate::app::input::touch::{Fingers, read_fingers};
use crate::app::session::clipboard::Clipboard;
use crate::app::session::frame_pacing::FramePacing;
use crate::app::session::handout_file::save_handout;
use crate::app::state::lessons::{AskedRay, ShownRay};
use crate::app::state::overlays::{INSPECTOR_WIDTH, Overlays, Side};
use crate::app::state::preferences::Preferences;
use crate::app::state::toast::Toast;
use crate::app::ui::dock::docked;
use crate::app::ui::picture_in_window::{PictureInWindow, SceneSide};
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use colours::path_colour;
use drawing::{Sketch, Viewpoint, legend};
use glam::{DVec2, DVec3};
use lightfall_core::accuracy::Ray;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::InspectorView;
use ray_worker::{InspectedRays, RayJob, RayWorker};

/// The fans to choose from: rays per side.
const FANS: [u32; 3] = [1, 3, 5];
/// Minimum height of the drawing, as a share of the room for it and everything below it.
const MIN_DRAWING_SHARE: f32 = 0.52;

/// The viewpoints to choose from, with their names.
const VIEWPOINTS: [(Viewpoint, &str); 4] = [
    (Viewpoint::Plane, "Ray's plane"),
    (Viewpoint::Side, "Side"),
    (Viewpoint::Top, "Top"),
    (Viewpoint::Orbit, "3-D"),
];

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

/// Inspects the pixel that is clicked or tapped.
fn inspect_chosen_pixel(
    buttons: Res<ButtonInput<MouseButton>>,
    (over, fingers): (Res<PointerOverPicture>, Res<Fingers>),
    overlays: Res<Overlays>,
    picture: PictureInWindow,
    mut inspector: ResMut<Inspector>,
) {
    if !overlays.shows_inspector() {
        return;
    }
    let clicked = over.0 && buttons.just_pressed(MouseButton::Left);
    let pixel = match fingers.tap {
        Some(tap) => picture.pixel_at(tap),
        None if clicked => picture.pixel_of_mouse(),
        None => None,
    };
    if let Some((side, pixel)) = pixel
        && let Some(scene) = picture.scene_of(side)
        // Outside a fisheye picture's circle there is no ray.
        && scene.camera.coverage(pixel, scene.picture.size().as_dvec2()) > 0.0
    {
        inspector.followed = None;
        inspector.side = side;
        inspector.asked = Some((scene.clone(), pixel));
        inspector.ask();
    }
}

/// Inspects the ray that a lesson's stop asks for, and again whenever the picture has changed.
fn inspect_ray_of_stop(
    asked: Res<AskedRay>,
    (overlays, pacing): (Res<Overlays>, Res<FramePacing>),
    picture: PictureInWindow,
    mut inspector: ResMut<Inspector>,
) {
    if asked.is_changed() {
        (inspector.followed, inspector.asked) = (asked.0, None);
    }
    let Some(view) = inspector.followed else {
        return;
    };
    let scene = picture.scene();
    let is_asked = |(asked, _): &(Scene, DVec2)| asked.without_clock() == scene.without_clock();
    if !overlays.shows_inspector()
        || pacing.moving
        || inspector.asked.as_ref().is_some_and(is_asked)
    {
        return;
    }
    let size = scene.picture.size().as_dvec2();
    let pixel = match view {
        InspectorView::Closed | InspectorView::Open => None,
        InspectorView::Place(share) => Some(DVec2::from(share) * size),
        InspectorView::Toward(direction) => {
            let from_camera = scene.camera.tetrad_from_camera();
            let looking = from_camera.transpose() * DVec3::from(direction).normalize();
            scene.camera.pixel_of(looking, size)
        }
    };
    if let Some(pixel) = pixel {
        inspector.side = SceneSide::Current;
        inspector.asked = Some((scene.clone(), pixel));
        inspector.ask();
    }
}

/// Notes the direction of the ray that is shown of the present picture.
fn note_shown_ray(
    inspector: Res<Inspector>,
    picture: PictureInWindow,
    mut shown: ResMut<ShownRay>,
) {
    let is_current = |answer: &&InspectedRays| {
        inspector.side == SceneSide::Current
            && answer.scene.without_clock() == picture.scene().without_clock()
    };
    let answer = inspector.answer.as_ref().filter(is_current);
    let numbers = answer.and_then(|answer| Some(&answer.rays.first()?.numbers));
    shown.0 = numbers.map(|numbers| [numbers.er, numbers.etheta, numbers.ephi]);
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

fn show_inspector(
    mut contexts: EguiContexts,
    preferences: Res<Preferences>,
    picture: PictureInWindow,
    clipboard: Res<Clipboard>,
    mut overlays: ResMut<Overlays>,
    mut inspector: ResMut<Inspector>,
    mut toast: ResMut<Toast>,
) -> Result {
    if !overlays.shows_inspector() {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let inspector = &mut *inspector;
    // The scene that was clicked, as it is now.
    let scene = picture
        .scene_of(inspector.side)
        .unwrap_or_else(|| picture.scene());
    mark_rays(context, inspector, scene, &picture);
    docked(context, "inspector", Side::Left, INSPECTOR_WIDTH, |ui| {
        ui.horizontal(|ui| {
            ui.strong("Ray inspector");
            choose_fan(ui, inspector);
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if ui.button("×").on_hover_text("Close").clicked() {
                    overlays.inspector = false;
                }
            });
        });
        ui.separator();
        let Some(answer) = &inspector.answer else {
            ui.label("Click a point of the picture to see the path of its light.");
            return;
        };
        let Some(first) = answer.rays.first() else {
            return;
        };
        let (seen, sketch) = (&answer.scene, &mut inspector.sketch);
        ui.horizontal(|ui| {
            if ui.button("Copy text").clicked() {
                clipboard.copy(first.numbers.to_text());
                toast.say("The ray's numbers are on the clipboard, as text");
            }
            if ui.button("Copy JSON").clicked() {
                clipboard.copy(first.numbers.to_json());
                toast.say("The ray's numbers are on the clipboard, as JSON");
            }
            let hint = "The figure on white paper with its caption and numbers, as a file to print";
            if ui.button("Handout").on_hover_text(hint).clicked()
                && let Some(page) =
                    handout::handout(seen, &answer.rays, sketch, preferences.settings.units())
            {
                toast.say(save_handout(&seen.name, &page));
            }
        });
        let waits = first.numbers.gpu.is_none() && answer.gpu_fault.is_none();
        heading(ui, first, seen, scene, waits, preferences.settings.units());
        ui.horizontal(|ui| {
            for (viewpoint, name) in VIEWPOINTS {
                ui.selectable_value(&mut sketch.viewpoint, viewpoint, name);
            }
            if ui.button("Fit").clicked() {
                sketch.half_width = None;
            }
        });
        // The numbers take the room that they need, up to their share, and the drawing the rest.
        let room = ui.available_height();
        let below = inspector.text_height.min((1.0 - MIN_DRAWING_SHARE) * room);
        let height = (room - below).max(60.0);
        let size = egui::vec2(ui.available_width(), height);
        let units = preferences.settings.units();
        sketch.show(ui, seen, &answer.rays, units, size);
        let top = ui.cursor().top();
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 9.0;
            for (colour, name) in legend(sketch.viewpoint, seen, units) {
                ui.label(egui::RichText::new(name).color(colour).size(12.0));
            }
        });
        if sketch.viewpoint == Viewpoint::Plane {
            ui.label(plane_figure::explanation(seen, first, units));
        }
        ui.separator();
        let shown = egui::ScrollArea::both()
            .id_salt("numbers")
            .auto_shrink([false, true])
            .show(ui, |ui| {
                numbers::show(ui, first, seen, answer.gpu_fault.as_deref(), units);
            });
        // Next frame the drawing makes room for them.
        let wanted = shown.inner_rect.top() - top + shown.content_size.y + 8.0;
        if (inspector.text_height - wanted).abs() > 0.5 {
            inspector.text_height = wanted;
            context.request_repaint();
        }
    });
    Ok(())
}

/// Says which pixel of which picture was clicked.
fn heading(
    ui: &mut egui::Ui,
    first: &Inspected,
    seen: &Scene,
    now: &Scene,
    waits: bool,
    units: Units,
) {
    let [x, y] = first.numbers.pixel.unwrap_or_default().map(f64::floor);
    let (picture, method) = (&seen.picture, seen.resolved_method().word());
    let mut text = format!("Pixel {x}, {y} of {} x {}", picture.width, picture.height);
    if !units.are_simple() {
        text += &format!(", method {method}");
    }
    if seen != now {
        text += "; the picture has changed since";
    }
    if waits {
        text += ", waiting for the GPU";
    }
    ui.label(text);
}

fn choose_fan(ui: &mut egui::Ui, inspector: &mut Inspector) {
    let before = (inspector.fan, inspector.spacing);
    ui.label("rays");
    for fan in FANS {
        ui.selectable_value(&mut inspector.fan, fan, (fan * fan).to_string());
    }
    if inspector.fan > 1 {
        let spacing = egui::DragValue::new(&mut inspector.spacing)
            .range(0.1..=200.0)
            .speed(0.3)
            .suffix(" px");
        ui.add(spacing)
            .on_hover_text("Pixels between the rays of the fan");
    }
    if before != (inspector.fan, inspector.spacing) {
        inspector.ask();
    }
}

/// Marks the rays on the picture, unless the picture has changed since the click.
fn mark_rays(
    context: &egui::Context,
    inspector: &Inspector,
    scene: &Scene,
    picture: &PictureInWindow,
) {
    let is_shown = |answer: &&InspectedRays| answer.scene.without_clock() == scene.without_clock();
    let Some(answer) = inspector.answer.as_ref().filter(is_shown) else {
        return;
    };
    let layer = egui::LayerId::new(egui::Order::Background, "inspected".into());
    let painter = context.layer_painter(layer);
    let Some(placement) = picture.placement_of(inspector.side, context) else {
        return;
    };
    let shown = picture.shown_part(inspector.side, context);
    for (i, inspected) in answer.rays.iter().enumerate() {
        let pixel = DVec2::from_array(inspected.numbers.pixel.unwrap_or_default());
        let centre = placement.of_pixel(pixel);
        if !shown.contains(centre) {
            continue;
        }
        let (radius, width) = if i == 0 { (7.0, 2.0) } else { (3.0, 1.0) };
        for (radius, colour) in [
            (radius + 1.0, egui::Color32::BLACK),
            (radius, path_colour(inspected)),
        ] {
            painter.circle_stroke(centre, radius, egui::Stroke::new(width, colour));
        }
    }
}
