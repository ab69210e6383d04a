//! The names of bright stars over the picture: every image of a star has the star's name, and an
//! image that the hole makes has its order and magnification as well.

use crate::app::controls::control::AppCommand;
use crate::app::state::overlays::Overlays;
use crate::app::state::toast::Toast;
use crate::app::ui::guides::Placement;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Stroke, Vec2, vec2};
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use lightfall_core::optics::stars::images::{NamedImage, named_images};
use lightfall_core::scene::{Camera, Scene, SkyMode};
use lightfall_platform::worker::Worker;
use lightfall_render::{DrawnScene, StarCatalogue, letterbox};

/// How many stars have their names shown.
const MAX_NAMES: usize = 50;
/// Images fainter than this have no name.
const FAINTEST: f64 = 7.0;

const SIZE: f32 = 12.0;
/// Radius of the ring around an image, and the distance of its name, in points.
const RING: f32 = 5.0;
const DISTANCE: f32 = 9.0;
const COLOUR: Color32 = Color32::from_rgb(170, 200, 255);
const SHADE: Color32 = Color32::from_black_alpha(215);

/// The images found, and the thread that looks for them.
#[derive(Resource)]
struct StarNames {
    worker: Worker<(Scene, StarCatalogue), Found>,
    asked: Option<Scene>,
    found: Option<Found>,
}

/// Images of stars, and the scene that they belong to, as [`sky_of`] gives it.
struct Found {
    sky: Scene,
    images: Vec<NamedImage>,
}

impl Default for StarNames {
    fn default() -> Self {
        let worker = Worker::serving_latest(|(sky, stars): (Scene, StarCatalogue), answers| {
            // A scene that is drawn has an observer, and so has images.
            let images = named_images(&sky, &stars, MAX_NAMES, FAINTEST).unwrap_or_default();
            answers.send(Found { sky, images });
        });
        Self {
            worker,
            asked: None,
            found: None,
        }
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<StarNames>()
        .add_systems(Update, (switch_star_names, find_images).chain())
        .add_systems(EguiPrimaryContextPass, show_star_names);
}

fn switch_star_names(
    mut commands: MessageReader<AppCommand>,
    mut overlays: ResMut<Overlays>,
    mut toast: ResMut<Toast>,
    scene: Res<DrawnScene>,
) {
    let presses = commands
        .read()
        .filter(|command| **command == AppCommand::StarNames);
    for _ in presses {
        overlays.toggle_star_names();
        toast.say(match (overlays.star_names, has_stars(&scene)) {
            (true, true) => "Star names: on",
            (true, false) => "Star names: on, but the sky shows no real stars",
            (false, _) => "Star names: off",
        });
    }
}

/// Whether the picture shows stars of the catalogue.
fn has_stars(scene: &Scene) -> bool {
    scene.sky.mode == SkyMode::Stars && scene.view.shows_light()
}

/// A scene with only what decides where images of stars are on the observer's sky. With spin it is
/// the picture that images are looked for in.
fn sky_of(scene: &Scene) -> Scene {
    let mut sky = Scene {
        hole: scene.hole,
        observer: scene.observer,
        effects: scene.effects,
        sky: scene.sky,
        ..Scene::default()
    };
    if scene.hole.spin != 0.0 && scene.effects.lensing {
        sky.camera = scene.camera;
        sky.picture.width = scene.picture.width;
        sky.picture.height = scene.picture.height;
    } else {
        let Camera {
            r,
            theta_deg,
            phi_deg,
            ..
        } = scene.camera;
        sky.camera = Camera {
            r,
            theta_deg,
            phi_deg,
            ..Camera::default()
        };
    }
    sky
}

fn find_images(
    scene: Res<DrawnScene>,
    overlays: Res<Overlays>,
    stars: Res<StarCatalogue>,
    mut names: ResMut<StarNames>,
) {
    if !overlays.shows_star_names() || !has_stars(&scene) {
        return;
    }
    if let Some(found) = names.worker.latest_answer() {
        names.found = Some(found);
    }
    let sky = sky_of(&scene);
    if names.asked.as_ref() != Some(&sky) {
        names.worker.ask((sky.clone(), *stars));
        names.asked = Some(sky);
    }
}

fn show_star_names(
    mut contexts: EguiContexts,
    window: Single<&Window, With<PrimaryWindow>>,
    scene: Res<DrawnScene>,
    overlays: Res<Overlays>,
    names: Res<StarNames>,
) -> Result {
    // Names of an earlier place of the camera would point at nothing.
    let found = names.found.as_ref().filter(|found| {
        overlays.shows_star_names() && has_stars(&scene) && found.sky == sky_of(&scene)
    });
    let Some(found) = found else {
        return Ok(());
    };
    let context = contexts.ctx_mut()?;
    let shown = letterbox(&scene.picture, window.physical_size());
    let placement = Placement::new(&scene, shown, context.pixels_per_point());
    egui::Area::new("star names".into())
        .fixed_pos(placement.picture.min)
        .interactable(false)
        .fade_in(false)
        .order(egui::Order::Background)
        .show(context, |ui| {
            let painter = ui.painter().with_clip_rect(placement.picture);
            draw(&painter, &found.images, &placement);
        });
    Ok(())
}

/// Draws a ring around each image and its name beside it, the brightest first. An image whose name
/// would cover another one is left out: next to the shadow, rings alone would only be clutter.
fn draw(painter: &Painter, images: &[NamedImage], placement: &Placement) {
    let mut taken: Vec<Rect> = Vec::new();
    for image in images {
        let Some(at) = placement.of(image.image.direction) else {
            continue;
        };
        let galley = painter.layout_no_wrap(words(image), FontId::proportional(SIZE), COLOUR);
        let place = free_place(at, galley.size(), placement.picture, &taken);
        if let Some(place) = place {
            painter.circle_stroke(at, RING, Stroke::new(1.0, COLOUR.gamma_multiply(0.7)));
            painter.rect_filled(place.expand(1.0), 2.0, SHADE);
            painter.galley(place.min, galley, COLOUR);
            taken.push(place);
        }
    }
}

/// The first place beside an image, right, left, below or above, that lies within the picture and
/// covers no other name.
fn free_place(at: Pos2, size: Vec2, picture: Rect, taken: &[Rect]) -> Option<Rect> {
    let places = [
        (Align2::LEFT_CENTER, vec2(DISTANCE, 0.0)),
        (Align2::RIGHT_CENTER, vec2(-DISTANCE, 0.0)),
        (Align2::CENTER_TOP, vec2(0.0, DISTANCE)),
        (Align2::CENTER_BOTTOM, vec2(0.0, -DISTANCE)),
    ];
    places
        .into_iter()
        .map(|(align, offset)| align.anchor_size(at + offset, size))
        .find(|place| {
            picture.contains_rect(*place) && !taken.iter().any(|other| other.intersects(*place))
        })
}

/// The star's name; of an image of higher order, or of one that is not as bright as the star, its
/// order and magnification too.
fn words(named: &NamedImage) -> String {
    let image = &named.image;
    if image.order == 0 && (0.95..1.05).contains(&image.magnification) {
        return named.name.to_owned();
    }
    format!(
        "{}, order {}, x {}",
        named.name,
        image.order,
        magnification_in_words(image.magnification)
    )
}

/// A magnification with two digits.
fn magnification_in_words(magnification: f64) -> String {
    match magnification {
        m if m >= 10.0 => format!("{m:.0}"),
        m if m >= 0.1 => format!("{m:.2}"),
        m if m >= 1e-4 => {
            let decimals = (1.0 - m.log10().floor()) as usize;
            format!("{m:.decimals$}")
        }
        m => format!("{m:.1e}"),
    }
}
