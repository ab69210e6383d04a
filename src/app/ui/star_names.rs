//! The names of bright stars over the picture. Every image of a star has the star's name; an image
//! that the hole makes also has its order and magnification.

use crate::app::state::overlays::Overlays;
use crate::app::state::preferences::Preferences;
use crate::app::ui::guides::Placement;
use crate::app::ui::layout::{Importance, Layout};
use crate::app::ui::picture_in_window::{PictureInWindow, SceneSide};
use crate::app::ui::screen::{Screen, draw_below_boxes};
use bevy::prelude::*;
use bevy_egui::EguiPrimaryContextPass;
use bevy_egui::egui::{Color32, FontId, Painter, Rect, Stroke};
use lightfall_core::optics::stars::images::{NamedImage, named_images};
use lightfall_core::scene::Scene;
use lightfall_platform::worker::Follower;
use lightfall_render::{ComparedScene, DrawnScene, StarCatalogue};

/// Largest number of stars with names.
const MAX_NAMES: usize = 50;
/// Magnitude of the faintest image that has a name.
const FAINTEST: f64 = 7.0;

const SIZE: f32 = 12.0;
/// Radius of the ring around an image, and the distance of its name, in points.
const RING: f32 = 5.0;
const DISTANCE: f32 = 9.0;
const COLOUR: Color32 = Color32::from_rgb(170, 200, 255);
const SHADE: Color32 = Color32::from_black_alpha(215);

/// The thread that finds the images of stars in a scene, as [`sky_of`] gives it.
#[derive(Resource)]
struct StarNames(Follower<Scene, Vec<NamedImage>>);

pub(crate) fn plugin(app: &mut App) {
    let stars = *app.world().resource::<StarCatalogue>();
    // A drawn scene has an observer, and so has images.
    let names = Follower::new(move |sky| {
        named_images(sky, &stars, MAX_NAMES, FAINTEST).unwrap_or_default()
    });
    app.insert_resource(StarNames(names))
        .add_systems(Update, find_images)
        .add_systems(
            EguiPrimaryContextPass,
            show_star_names.in_set(Importance::StarNames),
        );
}

/// Whether the picture shows stars of the catalogue.
pub(super) fn has_stars(scene: &Scene) -> bool {
    scene.sky.has_star_points() && scene.view.shows_light()
}

/// A scene with only the fields that decide where images of stars are on the observer's sky. With
/// spin these include the picture, because images are searched for within it.
fn sky_of(scene: &Scene) -> Scene {
    let mut sky = Scene {
        hole: scene.hole,
        observer: scene.observer,
        effects: scene.effects,
        sky: scene.sky.clone(),
        ..Scene::default()
    };
    if scene.hole.spin != 0.0 && scene.effects.lensing {
        sky.camera = scene.camera;
        sky.picture.width = scene.picture.width;
        sky.picture.height = scene.picture.height;
    } else {
        sky.camera.r = scene.camera.r;
        sky.camera.theta_deg = scene.camera.theta_deg;
        sky.camera.phi_deg = scene.camera.phi_deg;
    }
    sky
}

fn find_images(
    (scene, compared): (Res<DrawnScene>, Res<ComparedScene>),
    overlays: Res<Overlays>,
    mut names: ResMut<StarNames>,
) {
    let scene = compared.drawn_current(&scene);
    if overlays.shows_star_names() && has_stars(scene) {
        names.0.follow(sky_of(scene));
    }
}

fn show_star_names(
    mut screen: Screen,
    picture: PictureInWindow,
    overlays: Res<Overlays>,
    (names, preferences): (Res<StarNames>, Res<Preferences>),
) {
    let scene = picture.scene();
    // Names of an earlier place of the camera would point at nothing.
    let found = names
        .0
        .newest()
        .filter(|(sky, _)| overlays.star_names && has_stars(scene) && *sky == sky_of(scene));
    let (Some((context, layout)), Some((_, images))) = (screen.texts(), found) else {
        return;
    };
    let placement = picture.placement(context);
    let shown = picture.shown_part(SceneSide::Current, context);
    draw_below_boxes(context, "star names", shown, |painter| {
        let named = |image: &NamedImage| match preferences.settings.simple_words {
            true => simple_words(image),
            false => words(image),
        };
        draw(painter, images, named, &placement, shown, layout);
    });
}

/// Draws a ring around each image in the part `shown` of the window and its name beside it, the brightest
/// first. An image whose name has no room is left out: many rings without names next to the shadow would
/// be clutter.
fn draw(
    painter: &Painter,
    images: &[NamedImage],
    words: impl Fn(&NamedImage) -> String,
    placement: &Placement,
    shown: Rect,
    layout: &mut Layout,
) {
    for image in images {
        let at = placement.of(image.image.direction);
        let Some(at) = at.filter(|at| shown.contains(*at)) else {
            continue;
        };
        let galley = painter.layout_no_wrap(words(image), FontId::proportional(SIZE), COLOUR);
        let place = layout.place_beside("star name", at, galley.size(), &[DISTANCE], shown);
        if let Some(place) = place {
            painter.circle_stroke(at, RING, Stroke::new(1.0, COLOUR.gamma_multiply(0.7)));
            painter.rect_filled(place.expand(1.0), 2.0, SHADE);
            painter.galley(place.min, galley, COLOUR);
        }
    }
}

/// The star's name. An image of higher order, or one that is not as bright as the star, also has its
/// order and magnification.
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

/// The star's name, and which of its images it is.
fn simple_words(named: &NamedImage) -> String {
    match named.image.order {
        0 => named.name.to_owned(),
        order => format!("{}, image {}", named.name, order + 1),
    }
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
