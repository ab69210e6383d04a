//! The page of the scene as a table: its sections, the label of each field, and how its value is
//! shown. A field of the scene without a row here appears in a section of its own, under its key.

/// A section of the page.
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

const fn row(key: &'static str, label: &'static str, shown: Shown) -> RowText {
    RowText { key, label, shown }
}

/// Every section, the most used first.
pub const SECTIONS: &[Section] = &[
    Section {
        title: "Camera",
        open: true,
        rows: &[
            row("camera.r", "Distance", Logarithmic(0.3, 1000.0)),
            row("camera.theta_deg", "Above the equator", AboveEquator),
            row("camera.phi_deg", "Around the hole", Linear(-180.0, 180.0)),
            row("camera.fov_deg", "Field of view", Linear(5.0, 150.0)),
            row("camera.yaw_deg", "Turn right", Linear(-180.0, 180.0)),
            row("camera.pitch_deg", "Turn up", Linear(-90.0, 90.0)),
            row("camera.roll_deg", "Roll", Linear(-180.0, 180.0)),
            row("observer.kind", "Motion", Plain),
            row("observer.velocity", "Extra velocity", Plain),
        ],
    },
    Section {
        title: "Hole",
        open: true,
        rows: &[row("hole.spin", "Spin", Plain)],
    },
    Section {
        title: "Disk",
        open: true,
        rows: &[
            row("disk.enabled", "Disk", Plain),
            row("disk.temperature_k", "Temperature", Logarithmic(1e3, 2e5)),
            row("disk.brightness", "Brightness", Logarithmic(0.01, 100.0)),
            row("disk.inner", "Inner edge", Logarithmic(0.5, 100.0)),
            row("disk.follow_isco", "At innermost orbit", Plain),
            row("disk.keep_accretion", "Keep accretion rate", Plain),
            row("disk.outer", "Outer edge", Logarithmic(1.0, 300.0)),
            row("disk.tilt_deg", "Tilt", Linear(0.0, 180.0)),
            row("disk.node_deg", "Node's azimuth", Linear(-180.0, 180.0)),
            row("disk.transmission", "Transparency", Plain),
            row("disk.edge_taper", "Soft edges", Plain),
            row("disk.model", "Brightness law", Plain),
            row("disk.limb", "Limb darkening", Plain),
            row("disk.structure", "Structure", Plain),
            row("disk.contrast", "Contrast", Plain),
            row("disk.scale", "Filaments' width", Logarithmic(0.02, 0.5)),
            row("disk.aspect", "Filaments' length", Logarithmic(1.0, 20.0)),
            row("disk.pitch_deg", "Filaments' tilt", Plain),
            row(
                "disk.lifetime",
                "Filaments' lifetime",
                Logarithmic(0.25, 4.0),
            ),
            row("disk.period", "Repeats after", Linear(0.0, 200.0)),
            row("disk.waves", "Waves", Plain),
            row("disk.seed", "Pattern", Linear(0.0, 1000.0)),
            row("disk.rate", "Clock's rate", Linear(0.0, 20.0)),
            row("disk.time", "Clock", Linear(0.0, 1000.0)),
        ],
    },
    Section {
        title: "Hot spot",
        open: false,
        rows: &[
            row("hot_spot.kind", "Hot spot", Plain),
            row("hot_spot.r", "Radius", Logarithmic(1.0, 100.0)),
            row("hot_spot.phi_deg", "Around the hole", Linear(-180.0, 180.0)),
            row("hot_spot.size", "Size", Logarithmic(0.01, 0.5)),
            row("hot_spot.strength", "Strength", Logarithmic(0.1, 100.0)),
            row(
                "hot_spot.time",
                "Time of the flare",
                Linear(-1000.0, 1000.0),
            ),
            row(
                "hot_spot.duration",
                "Length of the flare",
                Linear(0.0, 500.0),
            ),
        ],
    },
    Section {
        title: "Light",
        open: false,
        rows: &[
            row("effects.lensing", "Bending of light", Plain),
            row("effects.doppler", "Doppler shift", Plain),
            row("effects.gravitational_shift", "Gravitational shift", Plain),
            row("effects.beaming", "Beaming", Plain),
            row("effects.aberration", "Aberration", Plain),
        ],
    },
    Section {
        title: "Sky",
        open: false,
        rows: &[
            row("sky.mode", "Sky", Plain),
            row("sky.brightness", "Brightness", Logarithmic(0.01, 100.0)),
            row("sky.ra_deg", "Behind the hole: RA", Linear(0.0, 360.0)),
            row("sky.dec_deg", "Behind the hole: Dec", Linear(-90.0, 90.0)),
            row("sky.roll_deg", "Turn of the sky", Linear(-180.0, 180.0)),
            row("sky.magnitude_limit", "Faintest star", Linear(-2.0, 12.0)),
            row("sky.seed", "Star pattern", Linear(0.0, 1000.0)),
            row("sky.reference_star", "Extra star", Plain),
            row(
                "sky.reference_theta_deg",
                "Star above equator",
                AboveEquator,
            ),
            row(
                "sky.reference_phi_deg",
                "Star around the hole",
                Linear(-180.0, 180.0),
            ),
        ],
    },
    Section {
        title: "Picture",
        open: false,
        rows: &[
            row("view", "View", Plain),
            row("picture.automatic_exposure", "Auto exposure", Plain),
            row("picture.exposure_ev", "Exposure", Linear(-8.0, 8.0)),
            row("picture.exposure_bias", "Exposure bias", Linear(-3.0, 3.0)),
            row("picture.tone_curve", "Tone curve", Plain),
            row("picture.bloom", "Bloom", Plain),
            row("picture.antialias", "Smooth edges", Plain),
            row(
                "picture.samples",
                "Frames averaged",
                Logarithmic(1.0, 1024.0),
            ),
            row("picture.bypass", "Pixel look", Inverted),
            row(
                "picture.levels",
                "Tones per channel",
                Logarithmic(2.0, 256.0),
            ),
            row("picture.dither", "Dither", Plain),
            row(
                "picture.grid_width",
                "Cells across",
                Logarithmic(16.0, 8192.0),
            ),
            row(
                "picture.grid_height",
                "Cells down",
                Logarithmic(9.0, 8192.0),
            ),
            row("picture.width", "Width", Logarithmic(64.0, 8192.0)),
            row("picture.height", "Height", Logarithmic(36.0, 8192.0)),
        ],
    },
    Section {
        title: "Method and quality",
        open: false,
        rows: &[
            row("method", "Method", Plain),
            row(
                "quality.max_error_px",
                "Largest error",
                Logarithmic(1e-4, 1.0),
            ),
            row("quality.step_scale", "Step size", Logarithmic(0.1, 16.0)),
            row(
                "quality.max_steps",
                "Most steps",
                Logarithmic(64.0, 16384.0),
            ),
            row("quality.max_affine", "Longest path", Logarithmic(10.0, 1e6)),
            row(
                "quality.escape_radius",
                "Escape radius",
                Linear(0.0, 1000.0),
            ),
            row("quality.min_step", "Least step", Linear(0.0, 0.05)),
        ],
    },
    Section {
        title: "Probe",
        open: false,
        rows: &[
            row("probe.enabled", "Probe", Plain),
            row("probe.r", "Distance", Logarithmic(1.0, 1000.0)),
            row("probe.theta_deg", "Above the equator", AboveEquator),
            row("probe.phi_deg", "Around the hole", Linear(-180.0, 180.0)),
            row("probe.size", "Length", Logarithmic(0.01, 10.0)),
            row("probe.antialias", "Smooth edges", Plain),
        ],
    },
    Section {
        title: "Name and title",
        open: false,
        rows: &[row("name", "Name", Plain), row("title", "Title", Plain)],
    },
];
