//! The scene's fields in words: their sections and labels on the panel, how their values are shown, and
//! their names in sentences.

/// A section of the panel's page of the scene.
pub struct Section {
    /// Its heading.
    pub title: &'static str,
    /// Whether it is unfolded at first.
    pub open: bool,
    /// Its rows, the most used first.
    pub rows: &'static [RowText],
}

/// A row: one field of the scene.
pub struct RowText {
    /// The field's key.
    pub key: &'static str,
    /// What the field is called on the page.
    pub label: &'static str,
    /// How its value is shown.
    pub shown: Shown,
}

/// How a value is shown. The ends of a slider are the values that are useful; others, which the
/// field may allow, are typed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shown {
    /// As it is: a switch, words, a text, or a number between the ends of its range.
    Plain,
    /// A number on a slider.
    Linear(f64, f64),
    /// A number on a logarithmic slider.
    Logarithmic(f64, f64),
    /// An angle from the z axis, as the angle above the equator, where a disk without tilt lies.
    AboveEquator,
    /// A switch whose field says the opposite.
    Inverted,
}

use Shown::{AboveEquator, Inverted, Linear, Logarithmic, Plain};

/// Sections, open or folded at first, with rows of `"field" "label" shown`.
macro_rules! sections {
    ($($state:ident $title:literal { $($key:literal $label:literal $shown:expr;)+ })+) => {
        &[$(Section {
            title: $title,
            open: sections!(@is_open $state),
            rows: &[$(RowText { key: $key, label: $label, shown: $shown }),+],
        }),+]
    };
    (@is_open open) => { true };
    (@is_open folded) => { false };
}

/// Every section, the most used first.
pub const SECTIONS: &[Section] = sections! {
    open "Camera" {
        "camera.r" "Distance" Logarithmic(0.3, 1000.0);
        "camera.theta_deg" "Above the equator" AboveEquator;
        "camera.phi_deg" "Around the hole" Linear(-180.0, 180.0);
        "camera.fov_deg" "Field of view" Linear(5.0, 150.0);
        "camera.yaw_deg" "Turn right" Linear(-180.0, 180.0);
        "camera.pitch_deg" "Turn up" Linear(-90.0, 90.0);
        "camera.roll_deg" "Roll" Linear(-180.0, 180.0);
        "observer.kind" "Motion" Plain;
        "observer.velocity" "Extra velocity" Plain;
    }
    open "Hole" {
        "hole.spin" "Spin" Plain;
    }
    open "Disk" {
        "disk.enabled" "Disk" Plain;
        "disk.temperature_k" "Temperature" Logarithmic(1e3, 2e5);
        "disk.brightness" "Brightness" Logarithmic(0.01, 100.0);
        "disk.inner" "Inner edge" Logarithmic(0.5, 100.0);
        "disk.follow_isco" "At innermost orbit" Plain;
        "disk.keep_accretion" "Keep accretion rate" Plain;
        "disk.outer" "Outer edge" Logarithmic(1.0, 300.0);
        "disk.tilt_deg" "Tilt" Linear(0.0, 180.0);
        "disk.node_deg" "Node's azimuth" Linear(-180.0, 180.0);
        "disk.transmission" "Transparency" Plain;
        "disk.thickness" "Thickness" Plain;
        "disk.depth" "Optical depth" Logarithmic(0.1, 200.0);
        "disk.flare" "Flare" Linear(-1.0, 1.0);
        "disk.outer_taper" "Outer fade" Plain;
        "disk.lumps" "Lumps" Plain;
        "disk.lanes" "Dark lanes" Plain;
        "disk.edge_taper" "Soft edges" Plain;
        "disk.model" "Brightness law" Plain;
        "disk.limb" "Limb darkening" Plain;
        "disk.returning" "Returning light" Plain;
        "disk.structure" "Structure" Plain;
        "disk.contrast" "Contrast" Plain;
        "disk.scale" "Filaments' width" Logarithmic(0.02, 0.5);
        "disk.aspect" "Filaments' length" Logarithmic(1.0, 20.0);
        "disk.pitch_deg" "Filaments' tilt" Plain;
        "disk.lifetime" "Filaments' lifetime" Logarithmic(0.25, 4.0);
        "disk.period" "Repeats after" Linear(0.0, 200.0);
        "disk.waves" "Waves" Plain;
        "disk.seed" "Pattern" Linear(0.0, 1000.0);
        "disk.rate" "Clock's rate" Linear(0.0, 20.0);
        "disk.time" "Clock" Linear(0.0, 1000.0);
    }
    folded "Hot spot" {
        "hot_spot.kind" "Hot spot" Plain;
        "hot_spot.r" "Radius" Logarithmic(1.0, 100.0);
        "hot_spot.phi_deg" "Around the hole" Linear(-180.0, 180.0);
        "hot_spot.size" "Size" Logarithmic(0.01, 0.5);
        "hot_spot.strength" "Strength" Logarithmic(0.1, 100.0);
        "hot_spot.time" "Time of the flare" Linear(-1000.0, 1000.0);
        "hot_spot.duration" "Length of the flare" Linear(0.0, 500.0);
    }
    folded "Jets" {
        "jet.enabled" "Jets" Plain;
        "jet.brightness" "Brightness" Logarithmic(0.01, 100.0);
        "jet.width" "Width" Logarithmic(0.05, 1.0);
        "jet.speed" "Speed" Logarithmic(0.1, 20.0);
        "jet.length" "Length" Logarithmic(5.0, 200.0);
        "jet.knots" "Knots" Plain;
        "jet.colour" "Colour" Logarithmic(0.1, 20.0);
    }
    folded "Light" {
        "effects.lensing" "Bending of light" Plain;
        "effects.doppler" "Doppler shift" Plain;
        "effects.gravitational_shift" "Gravitational shift" Plain;
        "effects.beaming" "Beaming" Plain;
        "effects.aberration" "Aberration" Plain;
    }
    folded "Sky" {
        "sky.mode" "Sky" Plain;
        "sky.brightness" "Brightness" Logarithmic(0.01, 100.0);
        "sky.picture" "Picture's file" Plain;
        "sky.frame" "Picture's axes" Plain;
        "sky.mirror" "Picture mirrored" Plain;
        "sky.stars" "Catalogue's stars" Plain;
        "sky.ra_deg" "Behind the hole: RA" Linear(0.0, 360.0);
        "sky.dec_deg" "Behind the hole: Dec" Linear(-90.0, 90.0);
        "sky.roll_deg" "Turn of the sky" Linear(-180.0, 180.0);
        "sky.magnitude_limit" "Faintest star" Linear(-2.0, 12.0);
        "sky.seed" "Star pattern" Linear(0.0, 1000.0);
        "sky.reference_star" "Extra star" Plain;
        "sky.reference_theta_deg" "Star above equator" AboveEquator;
        "sky.reference_phi_deg" "Star around the hole" Linear(-180.0, 180.0);
    }
    folded "Picture" {
        "view" "View" Plain;
        "picture.automatic_exposure" "Auto exposure" Plain;
        "picture.exposure_ev" "Exposure" Linear(-8.0, 8.0);
        "picture.exposure_bias" "Exposure bias" Linear(-3.0, 3.0);
        "picture.tone_curve" "Tone curve" Plain;
        "picture.bloom" "Bloom" Plain;
        "picture.antialias" "Smooth edges" Plain;
        "picture.samples" "Frames averaged" Logarithmic(1.0, 1024.0);
        "picture.bypass" "Pixel look" Inverted;
        "picture.levels" "Tones per channel" Logarithmic(2.0, 256.0);
        "picture.dither" "Dither" Plain;
        "picture.grid_width" "Cells across" Logarithmic(16.0, 8192.0);
        "picture.grid_height" "Cells down" Logarithmic(9.0, 8192.0);
        "picture.width" "Width" Logarithmic(64.0, 8192.0);
        "picture.height" "Height" Logarithmic(36.0, 8192.0);
    }
    folded "Projection" {
        "camera.projection" "Projection" Plain;
        "camera.fisheye_deg" "Fisheye's field" Linear(30.0, 360.0);
        "camera.circle" "Fisheye's circle" Logarithmic(0.5, 4.0);
        "camera.tilt_deg" "Tilt of the picture" Linear(-90.0, 90.0);
        "camera.shift" "Shift of the picture" Plain;
    }
    folded "Method and quality" {
        "method" "Method" Plain;
        "quality.max_error_px" "Largest error" Logarithmic(1e-4, 1.0);
        "quality.max_error_light" "Error of light" Logarithmic(1e-4, 1.0);
        "quality.step_scale" "Step size" Logarithmic(0.1, 16.0);
        "quality.max_steps" "Most steps" Logarithmic(64.0, 16384.0);
        "quality.max_affine" "Longest path" Logarithmic(10.0, 1e6);
        "quality.escape_radius" "Escape radius" Linear(0.0, 1000.0);
        "quality.min_step" "Least step" Linear(0.0, 0.05);
    }
    folded "Probe" {
        "probe.enabled" "Probe" Plain;
        "probe.r" "Distance" Logarithmic(1.0, 1000.0);
        "probe.theta_deg" "Above the equator" AboveEquator;
        "probe.phi_deg" "Around the hole" Linear(-180.0, 180.0);
        "probe.size" "Length" Logarithmic(0.01, 10.0);
        "probe.antialias" "Smooth edges" Plain;
    }
    folded "Name and title" {
        "name" "Name" Plain;
        "title" "Title" Plain;
    }
};

/// Names in sentences of fields whose label does not suit one.
const NAMES: [(&str, &str); 9] = [
    ("hole.spin", "spin"),
    ("observer.kind", "observer"),
    ("effects.lensing", "lensing"),
    ("effects.doppler", "Doppler shift"),
    ("disk.enabled", "disk"),
    ("hot_spot.kind", "hot spot"),
    ("jet.enabled", "jets"),
    ("probe.enabled", "probe"),
    ("sky.mode", "sky"),
];

/// Tables whose fields need no table's name before their own.
const OBVIOUS_TABLES: [&str; 5] = ["", "effects", "observer", "picture", "quality"];

/// The name of a field in a sentence, such as `disk temperature`.
pub(crate) fn field_in_words(key: &str) -> String {
    if let Some((_, name)) = NAMES.iter().find(|(known, _)| *known == key) {
        return (*name).into();
    }
    let (table, field) = key.split_once('.').unwrap_or(("", key));
    let mut rows = SECTIONS.iter().flat_map(|section| section.rows);
    let label = rows
        .find(|row| row.key == key)
        .map_or(field, |row| row.label);
    if OBVIOUS_TABLES.contains(&table) {
        label.to_lowercase()
    } else {
        format!("{} {}", table.replace('_', " "), label.to_lowercase())
    }
}
