//! The rules by which a field changes nothing. The first rule that applies gives the reason.

use super::idle::{Idle, Output};
use super::{
    AccuracySetting, Content, DiskModel, DiskStructure, HotSpotKind, ObserverKind, Projection,
    Scene, SkyMode, View,
};
use Output::{Linear, Rays, Sequence, Still, Window};
use glam::DVec3;

/// When fields change nothing, and why.
pub(super) struct Rule {
    /// The fields, in groups: keys, or `table.` for all fields of a table.
    keys: &'static [&'static [&'static str]],
    /// The outputs to which the rule applies.
    outputs: &'static [Output],
    /// The scenes to which it applies.
    when: fn(&Scene) -> bool,
    /// Whether other values of the field would count.
    pub(super) of_value: bool,
    /// The reason.
    pub(super) idle: Idle,
}

impl Rule {
    pub(super) fn applies(&self, scene: &Scene, key: &str, output: Output) -> bool {
        let named = |name: &&str| *name == key || (name.ends_with('.') && key.starts_with(name));
        self.keys.iter().copied().flatten().any(named)
            && self.outputs.contains(&output)
            && (self.when)(scene)
    }
}

const ALL: &[Output] = &[Window, Still, Sequence, Linear, Rays];
const PICTURES: &[Output] = &[Window, Still, Sequence, Linear];

/// A rule about fields whose every value changes nothing in these scenes.
const fn rule(
    keys: &'static [&'static [&'static str]],
    outputs: &'static [Output],
    when: fn(&Scene) -> bool,
    why: &'static str,
    remedy: &'static str,
) -> Rule {
    Rule {
        keys,
        outputs,
        when,
        of_value: false,
        idle: Idle { why, remedy },
    }
}

/// A rule about the scene's own value of a field, where another value would count.
const fn value_rule(
    keys: &'static [&'static [&'static str]],
    outputs: &'static [Output],
    when: fn(&Scene) -> bool,
    why: &'static str,
    remedy: &'static str,
) -> Rule {
    Rule {
        of_value: true,
        ..rule(keys, outputs, when, why, remedy)
    }
}

const fn always(_: &Scene) -> bool {
    true
}

fn shows_no_light(scene: &Scene) -> bool {
    !scene.view.shows_light()
}

fn shows_no_source(scene: &Scene) -> bool {
    !scene.shows_sources()
}

/// Whether the view shows where matter with depth is, and not how it shines.
fn shows_no_shine(scene: &Scene) -> bool {
    scene.view.shows_matter() && !scene.view.needs_light()
}

fn shows_rays(scene: &Scene) -> bool {
    scene.view.properties().content == Content::Rays
}

fn setting(scene: &Scene) -> AccuracySetting {
    scene.resolved_method().properties().setting
}

/// Whether the disk's structure changes neither its light nor its density.
fn has_no_contrast(scene: &Scene) -> bool {
    scene.disk.contrast == 0.0 && !(scene.has_thick_disk() && scene.disk.lumps > 0.0)
}

fn is_no_fisheye(scene: &Scene) -> bool {
    scene.camera.projection != Projection::Fisheye
}

/// Whether a file of the scene's picture has another projection than the perspective one.
fn is_not_perspective(scene: &Scene) -> bool {
    scene.camera.projection != Projection::Perspective
}

/// Whether the camera is at rest for observers with zero angular momentum, in whose frame nothing is
/// aberrated.
fn has_zero_angular_momentum(scene: &Scene) -> bool {
    let zamo = match scene.observer.kind {
        ObserverKind::Zamo => true,
        ObserverKind::Static => scene.hole.spin == 0.0,
        ObserverKind::Orbit | ObserverKind::Rain => false,
    };
    zamo && DVec3::from(scene.observer.velocity) == DVec3::ZERO
}

const TEXTS: &[&str] = &["name", "title"];
/// Where the disk is.
const DISK_SHAPE: &[&str] = &["disk.inner", "disk.follow_isco", "disk.outer"];
/// The axis of the disk and of the jets.
const AXIS: &[&str] = &["disk.tilt_deg", "disk.node_deg"];
/// How the disk shines.
const DISK_LIGHT: &[&str] = &[
    "disk.temperature_k",
    "disk.brightness",
    "disk.model",
    "disk.limb",
    "disk.returning",
    "disk.keep_accretion",
    "disk.edge_taper",
    "disk.transmission",
    "disk.structure",
];
/// The shape of a disk with thickness, and how much of it there is.
const THICKNESS: &[&str] = &[
    "disk.depth",
    "disk.flare",
    "disk.outer_taper",
    "disk.lumps",
    "disk.lanes",
];
const STRUCTURE: &[&str] = &[
    "disk.contrast",
    "disk.scale",
    "disk.aspect",
    "disk.pitch_deg",
    "disk.lifetime",
    "disk.waves",
    "disk.seed",
];
/// The time of structure and of knots.
const CLOCK: &[&str] = &["disk.time", "disk.rate"];
const PERIOD: &[&str] = &["disk.period"];
const HOT_SPOT: &[&str] = &["hot_spot."];
/// How the jets shine.
const JET_LIGHT: &[&str] = &[
    "jet.width",
    "jet.speed",
    "jet.length",
    "jet.knots",
    "jet.colour",
];
/// How bright matter is, and in which colours.
const SHINE: &[&str] = &[
    "disk.temperature_k",
    "disk.brightness",
    "disk.model",
    "disk.limb",
    "disk.returning",
    "disk.keep_accretion",
    "jet.brightness",
    "jet.colour",
    "effects.doppler",
    "effects.gravitational_shift",
];
/// What else changes light and no ray.
const OTHER_LIGHT: &[&str] = &[
    "sky.",
    "effects.beaming",
    "picture.antialias",
    "picture.samples",
];
/// The way from light to the levels of a screen.
const SCREEN: &[&str] = &[
    "picture.exposure_ev",
    "picture.automatic_exposure",
    "picture.exposure_bias",
    "picture.tone_curve",
    "picture.bloom",
    "picture.levels",
    "picture.dither",
];
const CELLS: &[&str] = &[
    "picture.bypass",
    "picture.grid_width",
    "picture.grid_height",
];
const STEPS: &[&str] = &[
    "quality.step_scale",
    "quality.max_steps",
    "quality.max_affine",
    "quality.escape_radius",
    "quality.min_step",
];

/// Every rule, the most general first.
#[rustfmt::skip]
pub(super) const RULES: &[Rule] = &[
    rule(&[TEXTS], &[Still, Sequence, Linear], always,
        "the file of the picture holds this text, and the picture does not show it", ""),
    rule(&[TEXTS], &[Rays], always, "rays carry no text", ""),
    rule(&[DISK_LIGHT, THICKNESS, &["disk.thickness"], STRUCTURE, CLOCK, PERIOD, HOT_SPOT, OTHER_LIGHT,
        &["jet.", "picture.", "probe.", "view"]], &[Rays], always, "traced rays carry no light", ""),

    rule(&[DISK_SHAPE], ALL, |scene| !scene.disk.enabled, "the disk is off", "disk.enabled=true"),
    rule(&[AXIS], ALL, |scene| !scene.disk.enabled && !scene.jet.enabled,
        "the disk is off", "disk.enabled=true"),
    rule(&[DISK_LIGHT, THICKNESS, &["disk.thickness"], STRUCTURE, HOT_SPOT], PICTURES,
        |scene| !scene.disk.enabled,
        "the disk is off", "disk.enabled=true"),
    rule(&[CLOCK, PERIOD], PICTURES, |scene| !scene.disk.enabled && !scene.jets_move(),
        "the disk is off", "disk.enabled=true"),
    rule(&[JET_LIGHT, &["jet.brightness"]], PICTURES, |scene| !scene.jet.enabled,
        "the jets are off", "jet.enabled=true"),
    rule(&[JET_LIGHT], PICTURES, |scene| scene.jet.brightness == 0.0,
        "the jets' brightness is 0", "jet.brightness=1"),
    rule(&[&["disk.inner"]], ALL, |scene| scene.disk.follow_isco,
        "the disk begins at the innermost stable orbit", "disk.follow_isco=false"),
    value_rule(&[&["disk.inner"]], ALL, |scene| scene.disk.inner < scene.kerr().isco(),
        "the disk begins at the innermost stable orbit, which lies farther out", ""),
    value_rule(&[&["disk.follow_isco"]], ALL,
        |scene| scene.disk.follow_isco && scene.disk.inner <= scene.kerr().isco(),
        "the disk begins at the innermost stable orbit in any case", "disk.inner=6"),
    rule(&[&["disk.tilt_deg"]], ALL, |scene| scene.hole.spin != 0.0,
        "around a hole that spins the disk lies in the equator", "hole.spin=0"),
    rule(&[&["disk.node_deg"]], ALL, |scene| scene.hole.spin != 0.0,
        "around a hole that spins the disk lies in the equator; hole.spin=0 with disk.tilt_deg=30 uses it", ""),
    rule(&[&["disk.node_deg"]], ALL, |scene| !scene.disk.is_tilted(),
        "the disk is not tilted", "disk.tilt_deg=30"),
    rule(&[THICKNESS], ALL, |scene| !scene.has_thick_disk(),
        "the disk has no thickness", "disk.thickness=0.06"),
    rule(&[&["quality.max_error_light"]], ALL, |scene| !scene.has_medium(),
        "the disk has no thickness, and there are no jets", "disk.thickness=0.06"),
    rule(&[HOT_SPOT], ALL, Scene::has_thick_disk,
        "only a disk without thickness has a hot spot", "disk.thickness=0"),
    rule(&[&["disk.transmission"]], ALL, Scene::has_thick_disk,
        "disk.depth decides what passes through a disk with thickness", "disk.thickness=0"),

    rule(&[&["method", "quality."]], ALL, |scene| !scene.effects.lensing,
        "without bending rays are straight lines", "effects.lensing=true"),
    rule(&[&["quality.max_error_px"]], ALL,
        |scene| setting(scene) != AccuracySetting::MaxError,
        "only Mino time keeps a largest error: the method in use does not control it", "method=mino"),
    rule(&[STEPS], ALL, |scene| setting(scene) != AccuracySetting::StepScale,
        "only the methods that take steps use it: Verlet and Kerr-Schild", "method=kerr-schild"),
    value_rule(&[&["method"]], ALL, |scene| scene.method == scene.best_method(),
        "auto, the default, means the same method", "method=mino"),
    value_rule(&[&["view"]], PICTURES, |scene| scene.view == View::Unfinished
        && scene.resolved_method().properties().answers_every_ray,
        "this method leaves no ray unfinished", "method=verlet"),
    value_rule(&[&["observer.kind"]], ALL,
        |scene| scene.observer.kind == ObserverKind::Zamo && scene.hole.spin == 0.0,
        "without spin an observer with zero angular momentum is a static one", "hole.spin=0.9"),
    rule(&[&["effects.doppler"]], PICTURES,
        |scene| !scene.disk.enabled && !scene.jet.enabled && has_zero_angular_momentum(scene),
        "neither the observer nor any matter moves", "disk.enabled=true"),
    rule(&[&["effects.aberration"]], ALL, has_zero_angular_momentum,
        "this observer has zero angular momentum, so nothing is displaced", "observer.kind=rain"),
    rule(&[&["observer.velocity"]], PICTURES,
        |scene| !scene.effects.aberration && !scene.effects.doppler,
        "motion neither displaces nor shifts light", "effects.aberration=true"),

    rule(&[DISK_LIGHT, THICKNESS, &["disk.thickness"], STRUCTURE, CLOCK, PERIOD, HOT_SPOT, &["jet."]],
        PICTURES, shows_no_source, "this view shows no light", "view=colour"),
    rule(&[SHINE], PICTURES, shows_no_shine, "this view shows no light", "view=colour"),
    rule(&[OTHER_LIGHT, SCREEN], PICTURES, shows_no_light,
        "this view shows no light", "view=colour"),
    value_rule(&[&["view"]], PICTURES, |scene| scene.view.shows_matter() && !scene.has_medium(),
        "there is no matter with depth", "disk.thickness=0.06"),
    rule(&[&["effects.doppler", "effects.gravitational_shift"]], PICTURES, shows_rays,
        "this view shows no light", "view=colour"),
    rule(&[&["disk.rate"]], &[Still, Linear], always, "a single picture shows one moment", ""),
    rule(&[STRUCTURE, &["disk.lumps", "disk.lanes"]], PICTURES,
        |scene| scene.disk.structure == DiskStructure::None,
        "the disk is smooth", "disk.structure=turbulent"),
    rule(&[PERIOD], PICTURES,
        |scene| scene.disk.structure == DiskStructure::None && !scene.jets_move(),
        "the disk is smooth", "disk.structure=turbulent"),
    rule(&[&["disk.returning"]], PICTURES, |scene| scene.disk.model == DiskModel::Newtonian,
        "only the relativistic brightness law counts light that returns to the disk",
        "disk.model=page-thorne"),
    rule(&[&["disk.returning"]], PICTURES, |scene| !scene.effects.lensing,
        "without bending no light returns to the disk", "effects.lensing=true"),
    rule(&[&["disk.returning"]], PICTURES, |scene| !scene.begins_at_isco(),
        "light that returns is known for disks that begin at the innermost stable orbit",
        "disk.follow_isco=true"),
    rule(&[CLOCK], PICTURES, |scene| !scene.disk_moves(),
        "nothing moves in the disk: it has neither structure nor a hot spot",
        "disk.structure=turbulent"),
    rule(&[&["disk.temperature_k", "disk.model", "disk.limb", "disk.returning", "disk.keep_accretion",
        "disk.structure"],
        STRUCTURE, HOT_SPOT], PICTURES, |scene| scene.disk.brightness == 0.0,
        "the disk's brightness is 0", "disk.brightness=1"),
    rule(&[CLOCK, PERIOD], PICTURES, |scene| scene.disk.brightness == 0.0 && !scene.jets_move(),
        "the disk's brightness is 0", "disk.brightness=1"),
    rule(&[&["sky.seed", "sky.ra_deg", "sky.dec_deg", "sky.roll_deg", "sky.magnitude_limit",
        "sky.reference_star", "sky.picture", "sky.frame", "sky.mirror", "sky.stars"]], PICTURES, |scene| scene.sky.brightness == 0.0,
        "the sky's brightness is 0", "sky.brightness=1"),
    rule(&[&["disk.scale", "disk.aspect", "disk.pitch_deg", "disk.lifetime", "disk.waves",
        "disk.seed"]], PICTURES, has_no_contrast,
        "the structure's contrast is 0", "disk.contrast=0.6"),
    rule(&[PERIOD], PICTURES, |scene| has_no_contrast(scene) && !scene.jets_move(),
        "the structure's contrast is 0", "disk.contrast=0.6"),
    rule(&[&["disk.lanes"]], PICTURES, |scene| scene.disk.contrast == 0.0,
        "the structure's contrast is 0", "disk.contrast=0.6"),
    rule(&[&["hot_spot.r", "hot_spot.phi_deg", "hot_spot.size", "hot_spot.time", "hot_spot.duration"]],
        PICTURES, |scene| scene.hot_spot.strength == 0.0,
        "the hot spot's strength is 0", "hot_spot.strength=8"),
    rule(&[&["hot_spot.r", "hot_spot.phi_deg", "hot_spot.size", "hot_spot.strength", "hot_spot.time",
        "hot_spot.duration"]], PICTURES, |scene| scene.hot_spot.kind == HotSpotKind::None,
        "there is no hot spot", "hot_spot.kind=sheared"),
    rule(&[&["effects.beaming"]], PICTURES,
        |scene| !scene.effects.doppler && !scene.effects.gravitational_shift,
        "no light is shifted", "effects.doppler=true"),

    rule(&[&["sky.brightness", "sky.reference_star"]], PICTURES,
        |scene| scene.sky.mode == SkyMode::Off, "the sky is off", "sky.mode=stars"),
    rule(&[&["sky.reference_theta_deg", "sky.reference_phi_deg"]], PICTURES,
        |scene| !scene.sky.reference_star || scene.sky.mode == SkyMode::Off,
        "the extra star is off", "sky.reference_star=true"),
    rule(&[&["sky.seed"]], PICTURES, |scene| !scene.sky.has_stars(),
        "the sky shows no stars", "sky.mode=stars"),
    rule(&[&["sky.picture", "sky.frame", "sky.mirror", "sky.stars"]], PICTURES,
        |scene| scene.sky.mode != SkyMode::Picture,
        "the sky is no picture from a file", "sky.mode=picture"),
    rule(&[&["sky.ra_deg", "sky.dec_deg", "sky.roll_deg"]], PICTURES,
        |scene| !scene.sky.mode.is_map(),
        "the sky does not show the real stars", "sky.mode=stars"),
    rule(&[&["sky.magnitude_limit"]], PICTURES, |scene| !scene.sky.has_star_points(),
        "the sky does not show the real stars", "sky.mode=stars"),
    rule(&[&["probe.r", "probe.theta_deg", "probe.phi_deg", "probe.size", "probe.antialias"]],
        PICTURES, |scene| !scene.probe.enabled, "the probe is off", "probe.enabled=true"),

    rule(&[&["picture.width", "picture.height"]], &[Window], always,
        "the window's size decides", ""),
    rule(&[&["camera.projection", "camera.tilt_deg", "camera.shift"]], &[Rays], always,
        "rays are given by their directions, and no picture is made", ""),
    rule(&[&["camera.fov_deg"]], &[Still, Sequence, Linear], is_not_perspective,
        "only a perspective picture has this field of view", "camera.projection=perspective"),
    rule(&[&["camera.fov_deg"]], &[Window],
        |scene| scene.camera.projection.of_picture() != Projection::Perspective,
        "only a perspective picture has this field of view", "camera.projection=perspective"),
    rule(&[&["camera.fisheye_deg", "camera.circle"]], ALL, is_no_fisheye,
        "the picture is no fisheye", "camera.projection=fisheye"),
    rule(&[&["camera.shift"]], PICTURES,
        |scene| matches!(scene.camera.projection, Projection::Equirectangular | Projection::Cube),
        "only perspective and fisheye pictures can be shifted", "camera.projection=fisheye"),
    rule(&[CELLS, &["picture.levels", "picture.dither"]], &[Window, Still, Sequence], is_not_perspective,
        "only perspective pictures are shown in cells", "camera.projection=perspective"),
    rule(&[&["picture.bloom"]], &[Still, Sequence], |scene| scene.camera.projection == Projection::Cube,
        "the sides of a cube have no bloom, which would end at their edges", "camera.projection=equirectangular"),

    rule(&[SCREEN, CELLS], &[Linear], always,
        "linear light is written as it is, before exposure, curve and cells", ""),
    rule(&[&["picture.grid_width"]], &[Window, Still, Sequence], always,
        "cells are square, so picture.grid_height decides", ""),
    rule(&[&["picture.grid_height", "picture.levels", "picture.dither"]], &[Window, Still, Sequence],
        |scene| scene.picture.bypass, "the pixel look is off", "picture.bypass=false"),
    rule(&[&["picture.exposure_bias"]], PICTURES, |scene| !scene.picture.automatic_exposure,
        "the exposure is not automatic", "picture.automatic_exposure=true"),
    value_rule(&[&["picture.exposure_ev"]], &[Window, Still, Sequence],
        |scene| scene.picture.automatic_exposure && scene.shines(),
        "the light meter chooses the exposure", "picture.automatic_exposure=false"),
    rule(&[&["picture.antialias"]], PICTURES, |scene| scene.budget_ratio() > 1.0,
        "with a budget of more than 768 steps, edges are not refined: one call could take too long",
        "quality.max_steps=768"),

    rule(&[&["hole.", "camera.", "observer.", "effects.", "method", "quality.", "picture."]],
        PICTURES, |scene| !scene.shines() && scene.view.shows_light(),
        "nothing shines in this scene", "disk.enabled=true"),
];
