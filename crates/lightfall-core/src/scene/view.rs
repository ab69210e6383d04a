//! What the picture shows: the light itself, or a diagnostic of the rays.

crate::words! {
    /// What the geodesic pass shows.
    #[derive(Default)]
    pub enum View {
        /// The light itself; unfinished rays are black.
        #[default]
        Colour = "colour",
        /// The light itself, with unfinished rays in magenta.
        Unfinished = "unfinished",
        /// What becomes of each ray: its outcome, and its number of crossings of the disk.
        Classes = "classes",
        /// Largest residual of the null constraint along each ray.
        Residual = "residual",
        /// Order of the image: half-turns about the hole up to what is seen first.
        Order = "order",
        /// How long the light of the first crossing of the disk was under way, in r_s/c.
        Delay = "delay",
        /// Observed over emitted frequency of what is seen first, disk or sky.
        Redshift = "redshift",
        /// Number of steps that the method takes along each ray.
        Steps = "steps",
        /// Backward error against the reference, in pixels, on a coarse grid.
        Error = "error",
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
}

/// What distinguishes a view from the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ViewProperties {
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

impl View {
    /// The view's properties: a new view is a new row.
    #[must_use]
    pub const fn properties(self) -> ViewProperties {
        let (content, traces) = match self {
            Self::Colour | Self::Unfinished => (Content::Light, true),
            Self::Classes | Self::Residual | Self::Order | Self::Delay | Self::Steps => {
                (Content::Rays, true)
            }
            Self::Redshift => (Content::Shift, true),
            Self::Error => (Content::Rays, false),
        };
        ViewProperties {
            content,
            traces,
            delays: matches!(self, Self::Delay),
            diagnostics: matches!(self, Self::Residual | Self::Order),
        }
    }

    /// Whether the view shows the light of disk and sky, and not the colours of marks.
    #[must_use]
    pub const fn shows_light(self) -> bool {
        matches!(self.properties().content, Content::Light)
    }
}
