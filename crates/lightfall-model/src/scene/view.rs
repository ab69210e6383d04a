//! What the picture shows: the light itself, or a diagnostic of the rays.

crate::words! {
    /// What the geodesic pass shows.
    pub enum View {
        /// What the camera sees.
        Colour = "colour": "Light",
        /// Rays that ran out of steps are magenta.
        Unfinished = "unfinished": "Light, unfinished marked",
        /// Sky, hole or disk, and how often the ray crosses the disk.
        Classes = "classes": "Fate of each ray",
        /// How far each ray strays from being light-like.
        Residual = "residual": "Residual",
        /// Half-turns of the ray about the hole.
        Order = "order": "Order of the image",
        /// How long the light of the disk was under way.
        Delay = "delay": "Delay of the light",
        /// Observed over emitted frequency.
        Redshift = "redshift": "Redshift",
        /// How many steps each ray takes.
        Steps = "steps": "Steps",
        /// Difference from the reference, in pixels.
        Error = "error": "Error",
        /// Optical depth of the matter on each ray.
        Depth = "depth": "Optical depth",
        /// How many places of the matter each ray asks for their light.
        Samples = "samples": "Samples of the matter",
        /// How much the light of the matter changes with twice the samples.
        LightError = "light-error": "Error of the light",
    }
}

/// What a view's colours stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// The light of disk and sky.
    Light,
    /// The shift of that light, without its brightness.
    Shift,
    /// A property of the rays, whatever light they carry.
    Rays,
    /// What matter with depth does to the rays, or how well its light is computed.
    Matter,
}

/// A colour of a view as its shader has it (linear sRGB), and its meaning.
pub type Swatch = ([f32; 3], &'static str);

/// What distinguishes a view from the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewProperties {
    /// What it shows, as its key says.
    pub words: &'static str,
    /// What its legend says over the swatches; empty for the light itself, which has no legend.
    pub legend: &'static str,
    /// The colours of its legend.
    pub swatches: &'static [Swatch],
    /// What its colours stand for.
    pub content: Content,
    /// Whether the shader traces the rays it shows; otherwise it shows numbers computed
    /// beforehand.
    pub traces: bool,
    /// Whether it shows how long the light of the disk was under way.
    pub delays: bool,
    /// Whether it shows what a ray's record contains only where it is asked for: the residual, and
    /// the half-turns.
    pub diagnostics: bool,
}

const BLACK: [f32; 3] = [0.0; 3];
const MAGENTA: [f32; 3] = [1.0, 0.0, 1.0];

/// The colours of counts, of steps or of samples.
const COUNTS: &[Swatch] = &[
    (BLACK, "none"),
    ([0.0200, 0.0029, 0.0729], "4 or fewer"),
    ([0.1139, 0.0127, 0.0927], "8"),
    ([0.2946, 0.0343, 0.1159], "16"),
    ([0.5366, 0.0914, 0.1450], "32"),
    ([0.7844, 0.2188, 0.1857], "64"),
    ([0.9592, 0.4607, 0.2474], "128"),
    ([0.9642, 0.8686, 0.3441], "256 or more"),
    (MAGENTA, "unfinished"),
];
/// The colours of errors, by powers of ten.
const ERRORS: [[f32; 3]; 5] = [
    [0.0273, 0.0090, 0.1511],
    [0.0080, 0.1104, 0.2716],
    [0.0246, 0.3181, 0.3356],
    [0.2431, 0.6151, 0.2757],
    [0.9615, 0.9322, 0.0480],
];

/// The light.
const LIGHT: ViewProperties = ViewProperties {
    words: "light",
    legend: "",
    swatches: &[],
    content: Content::Light,
    traces: true,
    delays: false,
    diagnostics: false,
};

/// What views of rays have in common.
const RAYS: ViewProperties = ViewProperties {
    content: Content::Rays,
    ..LIGHT
};

/// What views of matter with depth have in common.
const MATTER: ViewProperties = ViewProperties {
    content: Content::Matter,
    ..LIGHT
};

impl View {
    /// The view's properties: a new view is a new row.
    pub const fn properties(self) -> ViewProperties {
        match self {
            Self::Colour => LIGHT,
            Self::Unfinished => ViewProperties {
                words: "unfinished rays in magenta",
                legend: "Rays left unfinished",
                swatches: &[(MAGENTA, "unfinished: out of steps, or not a number")],
                ..LIGHT
            },
            Self::Classes => ViewProperties {
                words: "ray classes",
                legend: "Where each ray comes from, and how often it meets the disk between its edges",
                swatches: &[
                    ([0.0, 0.02, 0.16], "from the sky"),
                    ([0.02, 0.20, 0.75], "from the sky, meets the disk once"),
                    ([0.30, 0.75, 1.0], "from the sky, meets it twice"),
                    ([0.06, 0.02, 0.0], "ends at the horizon"),
                    ([0.60, 0.15, 0.0], "ends at the horizon, meets it once"),
                    ([1.0, 0.65, 0.05], "ends at the horizon, meets it twice"),
                    (MAGENTA, "unfinished"),
                ],
                ..RAYS
            },
            Self::Residual => ViewProperties {
                words: "residual of the null constraint",
                legend: "Residual of the null constraint (not the error)",
                swatches: &[
                    (BLACK, "1e-8 or less"),
                    ([0.10, 0.01, 0.25], "1e-6"),
                    ([0.75, 0.12, 0.04], "1e-4"),
                    ([0.95, 0.65, 0.02], "1e-2"),
                    ([1.0, 1.0, 1.0], "1 or more"),
                ],
                diagnostics: true,
                ..RAYS
            },
            Self::Order => ViewProperties {
                words: "order of the image",
                legend: "Order of the image; the sky is darker than the disk",
                swatches: &[
                    ([0.20, 0.20, 0.20], "0: direct light"),
                    ([0.79, 0.35, 0.0], "1: a half-turn about the hole"),
                    ([0.0, 0.17, 0.45], "2 half-turns"),
                    ([0.95, 0.95, 0.95], "3 or more"),
                    (BLACK, "no light: the ray ends at the horizon"),
                    (MAGENTA, "unfinished"),
                ],
                diagnostics: true,
                ..RAYS
            },
            Self::Delay => ViewProperties {
                words: "delay of the disk's light",
                legend: "How long the light of the disk was under way; a band every 2 r_s/c",
                swatches: &[
                    ([0.9969, 0.8660, 0.4176], "10 r_s/c less, or even less"),
                    ([0.8501, 0.3482, 0.2012], "as long as from beside the hole"),
                    ([0.4797, 0.1187, 0.1321], "10 r_s/c more"),
                    ([0.1521, 0.0360, 0.1154], "20 r_s/c more"),
                    ([0.0093, 0.0010, 0.1150], "30 r_s/c more, or even more"),
                    (BLACK, "no disk"),
                    (MAGENTA, "unfinished"),
                ],
                delays: true,
                ..RAYS
            },
            Self::Redshift => ViewProperties {
                words: "redshift g",
                legend: "g = observed / emitted frequency, of disk or sky",
                swatches: &[
                    ([0.01, 0.04, 0.40], "g = 2 or more"),
                    ([0.10, 0.40, 0.95], "g = 1.41, blueshifted"),
                    ([0.90, 0.90, 0.90], "g = 1"),
                    ([0.90, 0.30, 0.03], "g = 0.71, redshifted"),
                    ([0.25, 0.01, 0.01], "g = 0.5 or less"),
                    (BLACK, "no light: the ray ends at the horizon"),
                ],
                content: Content::Shift,
                ..LIGHT
            },
            Self::Steps => ViewProperties {
                words: "heat map of steps",
                legend: "Steps of the method along each ray",
                swatches: COUNTS,
                ..RAYS
            },
            Self::Error => ViewProperties {
                words: "backward error",
                legend: "Backward error: the rotation that would explain a ray's error; one ray per block",
                swatches: &[
                    (ERRORS[0], "1e-4 px or less"),
                    (ERRORS[1], "1e-3 px"),
                    (ERRORS[2], "1e-2 px"),
                    (ERRORS[3], "0.1 px"),
                    (ERRORS[4], "1 px or more"),
                    (MAGENTA, "too large to measure"),
                    (BLACK, "nothing seen: the hole"),
                    ([0.05, 0.05, 0.05], "not known yet"),
                ],
                traces: false,
                ..RAYS
            },
            Self::Depth => ViewProperties {
                words: "optical depth",
                legend: "Optical depth of the matter along each ray",
                swatches: &[
                    (BLACK, "no matter"),
                    ([0.0022, 0.0108, 0.0672], "0.01 or less"),
                    ([0.0682, 0.1465, 0.1859], "0.1"),
                    ([0.3733, 0.4992, 0.4540], "1"),
                    (
                        [0.8530, 0.9053, 0.8279],
                        "5 or more: nothing is seen behind",
                    ),
                    (MAGENTA, "unfinished"),
                ],
                ..MATTER
            },
            Self::Samples => ViewProperties {
                words: "samples of the matter",
                legend: "Places of the matter that each ray asks for their light",
                swatches: COUNTS,
                ..MATTER
            },
            Self::LightError => ViewProperties {
                words: "error of the light",
                legend: "Change of the matter's light with twice the samples, as a share of it",
                swatches: &[
                    (ERRORS[0], "1e-4 or less"),
                    (ERRORS[1], "1e-3"),
                    (ERRORS[2], "1e-2"),
                    (ERRORS[3], "0.1"),
                    (ERRORS[4], "1 or more"),
                    (BLACK, "no matter"),
                    (MAGENTA, "unfinished"),
                ],
                ..MATTER
            },
        }
    }

    /// Whether the view shows the light of disk and sky, and not the colours of marks.
    pub const fn shows_light(self) -> bool {
        matches!(self.properties().content, Content::Light)
    }

    /// Whether the view needs to know how bright sources are. The number of samples does, because a ray
    /// ends where the light in front outshines what may come from behind.
    pub const fn needs_light(self) -> bool {
        self.shows_light() || matches!(self, Self::LightError | Self::Samples)
    }

    /// Whether the view shows what matter with depth does to rays.
    pub const fn shows_matter(self) -> bool {
        matches!(self.properties().content, Content::Matter)
    }
}
