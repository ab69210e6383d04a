//! WGSL files linked into variants: a shader's text contains only what its scene needs. `const`
//! flags decide the rest; compilers drop what is behind a flag that is not set.

mod choices;
mod entry;
mod fault;
mod files;
mod link;
mod picture_files;
mod prelude;
pub(super) mod spectrum_constants;
mod star_images;
pub(super) mod text;
mod tracer;
#[cfg(not(target_arch = "wasm32"))]
mod validation;

pub(super) use choices::projection_file;
pub use entry::Entry;
pub use fault::ShaderFault;
pub use files::ShaderFiles;
pub(super) use link::Choice;
pub use text::ShaderText;
pub use tracer::Tracer;

use crate::jet::jet_nodes;
use crate::medium::medium_nodes;
use crate::stars::StarKernel;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::scene::{
    DiskModel, DiskStructure, Effects, HotSpotKind, LimbDarkening, Method, Projection, Scene,
    SkyMode, View,
};
use link::link;
use text::declares;

/// A shader, as the choices that determine its files and flags.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Variant {
    /// Its output.
    pub entry: Entry,
    /// The projection of its pixels.
    pub projection: Projection,
    /// Whether it looks for images of stars on the sides of a cube about the camera, in place of the
    /// picture itself.
    pub on_sides: bool,
    /// Its tracing method.
    pub tracer: Tracer,
    /// Whether the hole spins.
    pub spinning: bool,
    /// Whether rays of the methods mino and closed pass so close to the horizon that their azimuth
    /// needs the ingoing coordinates, or start inside.
    pub near_horizon: bool,
    /// Whether rays can meet a disk.
    pub disk: bool,
    /// The model of the disk's flux; the default where none is drawn.
    pub disk_model: DiskModel,
    /// Whether the disk has structure; false where none is drawn.
    pub structure: bool,
    /// Whether that structure repeats after a period.
    pub repeats: bool,
    /// The hot spot; none where none is drawn.
    pub hot_spot: HotSpotKind,
    /// Nodes of each chunk of matter with depth, or 0 without such matter.
    pub medium_nodes: u32,
    /// Nodes of each piece of the jets, or 0 without jets.
    pub jet_nodes: u32,
    /// Whether the jets have knots.
    pub knots: bool,
    /// The disk's limb darkening; none where none is drawn.
    pub limb: LimbDarkening,
    /// Nodes of the integral of the delay, or 0 if the delay is not used.
    pub delay_nodes: u32,
    /// Whether the delays of the method closed are computed for the throat of a nearly extremal
    /// hole.
    pub throat: bool,
    /// The sky; off where none is drawn.
    pub sky: SkyMode,
    /// Whether stars of the sky are drawn as points.
    pub star_points: bool,
    /// Whether the sky needs directions turned from the frame of a tilted disk.
    pub turned_sky: bool,
    /// Whether the reference star is in the sky.
    pub reference_star: bool,
    /// What the picture shows.
    pub view: View,
    /// Which effects are on.
    pub effects: Effects,
    /// The number of crossings of the disk that are recorded: two, or one where the disk is opaque.
    pub max_hits: u32,
    /// Whether rays are followed beyond those crossings.
    pub follow_beyond_hits: bool,
    /// Whether the picture's fragment also writes the traits for the search for edges.
    pub antialias: bool,
}

/// The smallest transmission of the disk for which a ray is followed beyond crossings: half of an
/// 8-bit level.
const MIN_TRANSMISSION: f64 = 0.002;

/// Whether visible rays pass so close to the horizon of a spinning hole that their azimuth must be
/// integrated in coordinates that are regular there. Elsewhere the pole of the azimuth's rate is
/// too far away to disturb four Gaussian nodes per step, or its effect is too small as seen from
/// the camera. Without spin only a camera inside is affected.
///
/// A ray in closed form has a nearby pole only where the camera is next to the horizon.
fn passes_near_horizon(tracer: Tracer, Scene { hole, camera, .. }: &Scene) -> bool {
    let farthest = match (tracer, hole.spin.abs()) {
        (Tracer::ClosedKerr, _) => 2.0,
        (Tracer::Method(Method::Mino), 0.0) => 1.0,
        (Tracer::Method(Method::Mino), spin) if spin > 0.999 => f64::INFINITY,
        (Tracer::Method(Method::Mino), spin) if spin > 0.99 => 10.0,
        (Tracer::Method(Method::Mino), _) => 1.5,
        _ => return false,
    };
    camera.r <= farthest * Kerr { spin: hole.spin }.horizon()
}

/// The smallest spin of a hole whose throat disturbs the delays of the method closed. At 0.9998 the
/// two horizons are 0.02 r_s apart. Outside of the throat's variant, delays are wrong by up to
/// 0.018 rad of the matter's turn at 0.999999, and by less than 1e-3 rad at 0.9999.
const MIN_THROAT_SPIN: f64 = 0.9998;

/// Whether rays in closed form pass through the long throat of a nearly extremal hole.
fn has_throat(tracer: Tracer, scene: &Scene) -> bool {
    tracer == Tracer::ClosedKerr && scene.hole.spin.abs() >= MIN_THROAT_SPIN
}

impl Variant {
    /// The shader that draws the scene.
    pub fn picture(scene: &Scene) -> Self {
        let tracer = Tracer::of(scene);
        let marks = !scene.view.shows_light();
        let dark = !scene.shows_sources();
        let shows_nothing = scene.view.shows_matter() && !scene.has_medium();
        let sky = if marks { SkyMode::Off } else { scene.sky.mode };
        // The largest transmission: one where the edges fade.
        let transmission = if scene.disk.edge_taper > 0.0 {
            1.0
        } else {
            scene.disk.transmission
        };
        let lit = scene.disk.enabled && !dark;
        let shines = lit && scene.view.needs_light();
        let structure = lit && scene.disk.structure != DiskStructure::None;
        let hot_spot = if lit {
            scene.drawn_hot_spot()
        } else {
            HotSpotKind::None
        };
        let knots = !dark && scene.jets_move();
        let needs_delay = structure
            || knots
            || hot_spot != HotSpotKind::None
            || scene.disk.enabled && scene.view.properties().delays;
        Self {
            entry: Entry::Picture,
            projection: scene.camera.projection.of_picture(),
            on_sides: false,
            tracer,
            spinning: scene.hole.spin != 0.0,
            near_horizon: passes_near_horizon(tracer, scene),
            disk: scene.disk.enabled && scene.view.properties().traces && !shows_nothing,
            disk_model: if shines {
                scene.disk.model
            } else {
                DiskModel::default()
            },
            structure,
            repeats: structure && scene.disk.period > 0.0,
            hot_spot,
            medium_nodes: if lit && scene.has_thick_disk() {
                medium_nodes(scene.quality.max_error_light)
            } else {
                0
            },
            jet_nodes: if !dark && scene.jet.enabled {
                jet_nodes(scene.quality.max_error_light)
            } else {
                0
            },
            knots,
            limb: if shines {
                scene.disk.limb
            } else {
                LimbDarkening::None
            },
            delay_nodes: if needs_delay { tracer.delay_nodes() } else { 0 },
            throat: needs_delay && has_throat(tracer, scene),
            sky,
            star_points: !marks && scene.sky.has_star_points(),
            turned_sky: scene.disk.is_tilted() && sky.lies_in_hole_frame(),
            reference_star: scene.sky.reference_star && sky != SkyMode::Off,
            view: scene.view,
            // Brightness has no meaning for marks.
            effects: Effects {
                beaming: scene.effects.beaming || dark,
                ..scene.effects
            },
            max_hits: if !marks && scene.disk.enabled && transmission <= MIN_TRANSMISSION {
                1
            } else {
                2
            },
            follow_beyond_hits: marks
                || !scene.disk.enabled
                || transmission.powi(2) > MIN_TRANSMISSION,
            // The number of pixels that one dispatch refines is not known in advance.
            antialias: scene.picture.antialias && !marks && scene.budget_ratio() <= 1.0,
        }
    }

    /// The shader that refines the edges of the picture that this one draws, if it finds any.
    #[must_use]
    pub fn refined(self) -> Option<Self> {
        (self.entry == Entry::Picture && self.antialias).then_some(Self {
            entry: Entry::Refine,
            antialias: false,
            ..self
        })
    }

    /// The shader that traces rays through the scene and records everything about them.
    pub fn rays(scene: &Scene) -> Self {
        let tracing = Self::tracing_only(scene);
        Self {
            entry: Entry::Rays,
            effects: Effects {
                beaming: true,
                ..scene.effects
            },
            delay_nodes: if scene.disk.enabled {
                tracing.tracer.delay_nodes()
            } else {
                0
            },
            throat: scene.disk.enabled && has_throat(tracing.tracer, scene),
            max_hits: 2,
            follow_beyond_hits: true,
            ..tracing
        }
    }

    /// The shader that traces a picture's rays and draws nothing, to be timed.
    pub fn timed(scene: &Scene) -> Self {
        Self {
            entry: Entry::Timed,
            ..Self::tracing_only(scene)
        }
    }

    /// The shader that computes a picture's light and draws nothing, to be timed.
    pub fn timed_light(scene: &Scene) -> Self {
        Self {
            entry: Entry::TimedLight,
            antialias: false,
            ..Self::picture(scene)
        }
    }

    /// The shader that follows single rays through matter with depth: with filters, those of
    /// pixels.
    pub fn passages(scene: &Scene, filters: bool) -> Self {
        let picture = Self::picture(&Scene {
            view: View::Colour,
            ..scene.clone()
        });
        Self {
            entry: Entry::Passages { filters },
            antialias: false,
            sky: SkyMode::Off,
            star_points: false,
            turned_sky: false,
            reference_star: false,
            delay_nodes: if filters {
                picture.tracer.delay_nodes()
            } else {
                picture.delay_nodes
            },
            ..picture
        }
    }

    /// The picture's variant without anything that shines.
    fn tracing_only(scene: &Scene) -> Self {
        Self {
            disk_model: DiskModel::default(),
            structure: false,
            repeats: false,
            hot_spot: HotSpotKind::None,
            medium_nodes: 0,
            jet_nodes: 0,
            knots: false,
            limb: LimbDarkening::None,
            delay_nodes: 0,
            throat: false,
            sky: SkyMode::Off,
            star_points: false,
            turned_sky: false,
            reference_star: false,
            antialias: false,
            ..Self::picture(&Scene {
                view: View::Colour,
                ..scene.clone()
            })
        }
    }

    /// The shader's text, by its parts.
    pub fn text(self) -> ShaderText {
        ShaderText::new(self.prelude(), self.entry.points(), self.choices())
    }

    /// The whole WGSL text.
    pub fn source(self) -> String {
        self.text().source()
    }

    /// The files below shaders/ whose text is in the shader's, in their order.
    pub fn files(self) -> Vec<&'static str> {
        let prelude = self.prelude();
        let is_constant = |name: &str| declares(&prelude, name);
        let (files, _) = link(
            ShaderFiles::built_in(),
            self.entry.points(),
            &self.choices(),
            is_constant,
        );
        files.into_iter().map(|file| &*file.name).collect()
    }

    /// Whether rays pass through matter with depth.
    pub(super) fn has_medium(self) -> bool {
        self.medium_nodes > 0 || self.jet_nodes > 0
    }

    /// Whether it traces rays to the images of stars.
    fn seeks_stars(self) -> bool {
        matches!(
            self.entry,
            Entry::Star(StarKernel::TraceMesh | StarKernel::RefineImage)
        )
    }
}
