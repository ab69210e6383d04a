//! Which fields of a scene change nothing at present, and why.

use lightfall_core::scene::{AccuracySetting, Content, DiskStructure, HotSpotKind, Scene, SkyMode};

/// Why a field changes nothing in this scene, in one sentence. None if the field matters, as far as
/// the program knows.
#[must_use]
pub fn why_idle(scene: &Scene, key: &str) -> Option<&'static str> {
    let (table, field) = key.split_once('.').unwrap_or(("", key));
    let setting = scene.method.resolved().properties().setting;
    let content = scene.view.properties().content;
    let moves = matches!(field, "time" | "rate");
    let needs_structure = matches!(
        field,
        "contrast" | "scale" | "aspect" | "pitch_deg" | "lifetime" | "period" | "waves" | "seed"
    );
    // Whether the field changes nothing but light.
    let needs_light = match table {
        "hot_spot" => true,
        "effects" => field == "beaming",
        "picture" => matches!(field, "antialias" | "samples" | "tone_curve"),
        "disk" => {
            let shines = ["temperature_k", "brightness", "model", "limb", "structure"];
            moves || needs_structure || shines.contains(&field)
        }
        _ => false,
    };
    match (table, field) {
        ("disk", "enabled") => None,
        ("disk" | "hot_spot", _) if !scene.disk.enabled => Some("The disk is off."),
        ("disk", "inner") if scene.disk.follow_isco => {
            Some("The disk begins at the innermost stable orbit.")
        }
        ("disk", "tilt_deg") if scene.hole.spin != 0.0 => {
            Some("Around a hole that spins the disk lies in the equator.")
        }
        ("disk", "node_deg") if !scene.disk.is_tilted() => Some("The disk is not tilted."),
        ("disk", _) if needs_structure && scene.disk.structure == DiskStructure::None => {
            Some("The disk is smooth.")
        }
        ("disk", _) if moves && !scene.disk_moves() => {
            Some("Nothing moves in the disk: it has neither structure nor a hot spot.")
        }
        ("hot_spot", field) if field != "kind" && scene.hot_spot.kind == HotSpotKind::None => {
            Some("There is no hot spot.")
        }
        _ if needs_light && content != Content::Light => Some("This view shows no light."),
        ("effects", "doppler" | "gravitational_shift") if content == Content::Rays => {
            Some("This view shows no light.")
        }
        ("sky", "reference_theta_deg" | "reference_phi_deg") if !scene.sky.reference_star => {
            Some("The extra star is off.")
        }
        ("sky", "seed") if !scene.sky.mode.has_stars() => Some("The sky shows no stars."),
        ("sky", "ra_deg" | "dec_deg" | "roll_deg" | "magnitude_limit")
            if scene.sky.mode != SkyMode::Stars =>
        {
            Some("The sky does not show the real stars.")
        }
        ("sky", "brightness") if scene.sky.mode == SkyMode::Off && !scene.sky.reference_star => {
            Some("The sky is off.")
        }
        ("probe", field) if field != "enabled" && !scene.probe.enabled => Some("The probe is off."),
        ("picture", "levels" | "dither" | "grid_width" | "grid_height") if scene.picture.bypass => {
            Some("The pixel look is off.")
        }
        ("picture", "exposure_bias") if !scene.picture.automatic_exposure => {
            Some("The exposure is not automatic.")
        }
        ("picture", "antialias") if scene.budget_ratio() > 1.0 => Some(
            "With a budget of more than 768 steps, edges are not refined: one call could take too long.",
        ),
        ("quality", "max_error_px") if setting != AccuracySetting::MaxError => {
            Some("Only Mino time keeps a largest error: the method in use does not control it.")
        }
        ("quality", "step_scale" | "max_steps" | "max_affine" | "escape_radius" | "min_step")
            if setting != AccuracySetting::StepScale =>
        {
            Some("Only the methods that take steps use it: Verlet and Kerr-Schild.")
        }
        _ => None,
    }
}
