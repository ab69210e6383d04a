//! WGSL parts joined into variants: what a scene does not need is not in its shader's text, and the
//! rest is decided by `const` flags, which compilers drop.

mod prelude;

use crate::geometry::kerr::Kerr;
use crate::scene::{DiskModel, Effects, Method, Scene, SkyMode, View};

/// A shader: which parts are joined, and which flags are set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Variant {
    /// What it answers.
    pub entry: Entry,
    /// How it traces.
    pub tracer: Tracer,
    /// Whether the hole spins.
    pub spinning: bool,
    /// Whether rays of method mino pass close to the horizon, where their azimuth needs care, or
    /// begin inside.
    pub near_horizon: bool,
    /// Whether rays can meet a disk.
    pub disk: bool,
    /// What the disk's flux is; the default where none is drawn.
    pub disk_model: DiskModel,
    /// What lies at infinity; off where nothing is drawn.
    pub sky: SkyMode,
    /// Whether the reference star is in the sky.
    pub reference_star: bool,
    /// What the picture shows.
    pub view: View,
    /// Which effects there are.
    pub effects: Effects,
    /// How many crossings of the disk count: two, or one where no light to speak of passes through.
    pub most_hits: u32,
    /// Whether rays are followed beyond those.
    pub follow_beyond_hits: bool,
}

/// What a shader answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Entry {
    /// Light of a pixel: entry points `vertex` and `fragment`.
    Picture,
    /// Records of rays: entry point `rays`, in workgroups of 64.
    Rays,
    /// One vector a pixel, for the time it takes: entry points `timed`, in workgroups of 64,
    /// `vertex` and `fragment`.
    Timed,
}

/// The methods that exist as WGSL.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Tracer {
    /// Velocity Verlet; spin zero only.
    Verlet,
    /// Solved in closed form; spin zero only.
    Closed,
    /// Mino time, any spin.
    Mino,
    /// Runge-Kutta in Kerr-Schild coordinates.
    KerrSchild,
    /// Not bent at all: the choice without lensing, whatever the method.
    Straight,
}

impl Tracer {
    /// The one that answers for a scene; what no shader can do is refused by
    /// [`GpuScene`](super::GpuScene).
    fn of(scene: &Scene) -> Self {
        match scene.method {
            _ if !scene.effects.lensing => Self::Straight,
            Method::Verlet => Self::Verlet,
            Method::Mino => Self::Mino,
            Method::KerrSchild => Self::KerrSchild,
            Method::Auto if scene.hole.spin != 0.0 => Self::Mino,
            Method::Auto | Method::Closed | Method::Reference => Self::Closed,
        }
    }
}

/// Least light, as a share, for which a ray is followed beyond crossings of the disk: half of an
/// 8-bit level.
const NEGLIGIBLE: f64 = 0.002;

/// Whether rays that see something pass so close to the horizon of a spinning hole that their
/// azimuth must be summed in coordinates that are regular there. Elsewhere the pole of its rate is
/// too far off to disturb four Gaussian nodes a step, or from so far what it disturbs is too small
/// a turn of the ray. Without spin only a camera inside begins there.
fn passes_near_horizon(Scene { hole, camera, .. }: &Scene) -> bool {
    let farthest = match hole.spin.abs() {
        0.0 => 1.0,
        spin if spin > 0.999 => f64::INFINITY,
        spin if spin > 0.99 => 10.0,
        _ => 1.5,
    };
    camera.r <= farthest * Kerr { spin: hole.spin }.horizon()
}

/// A part: its file below shaders/, and its text.
type Part = (&'static str, &'static str);

macro_rules! part {
    ($file:literal) => {
        (
            $file,
            include_str!(concat!(
                env!("CARGO_MANIFEST_DIR"),
                "/../../shaders/",
                $file
            )),
        )
    };
}

/// The file name that stands for the constants written here.
const PRELUDE: &str = "constants of the variant";

impl Variant {
    /// The shader that draws the scene.
    pub fn picture(scene: &Scene) -> Self {
        let tracer = Tracer::of(scene);
        let marks = !shows_light(scene.view);
        let sky = if marks { SkyMode::Off } else { scene.sky.mode };
        Self {
            entry: Entry::Picture,
            tracer,
            spinning: scene.hole.spin != 0.0,
            near_horizon: tracer == Tracer::Mino && passes_near_horizon(scene),
            disk: scene.disk.enabled && traces(scene.view),
            disk_model: if scene.disk.enabled && !marks {
                scene.disk.model
            } else {
                DiskModel::default()
            },
            sky,
            reference_star: scene.sky.reference_star && sky != SkyMode::Off,
            view: scene.view,
            // Brightness has no meaning for marks.
            effects: Effects {
                beaming: scene.effects.beaming || marks,
                ..scene.effects
            },
            most_hits: if !marks && scene.disk.enabled && scene.disk.transmission <= NEGLIGIBLE {
                1
            } else {
                2
            },
            follow_beyond_hits: marks
                || !scene.disk.enabled
                || scene.disk.transmission.powi(2) > NEGLIGIBLE,
        }
    }

    /// The shader that traces rays through the scene and records everything about them.
    pub fn rays(scene: &Scene) -> Self {
        Self {
            entry: Entry::Rays,
            disk_model: DiskModel::default(),
            sky: SkyMode::Off,
            reference_star: false,
            view: View::Colour,
            effects: Effects {
                beaming: true,
                ..scene.effects
            },
            most_hits: 2,
            follow_beyond_hits: true,
            ..Self::picture(&Scene {
                view: View::Colour,
                ..scene.clone()
            })
        }
    }

    /// The shader that traces a picture's rays and draws nothing, to be timed.
    pub fn timed(scene: &Scene) -> Self {
        Self {
            entry: Entry::Timed,
            disk_model: DiskModel::default(),
            sky: SkyMode::Off,
            reference_star: false,
            view: View::Colour,
            ..Self::picture(&Scene {
                view: View::Colour,
                ..scene.clone()
            })
        }
    }

    /// Every variant that a scene can ask for, but that sets of effects with some switched off come
    /// under one sky only, and cameras next to the horizon see light only.
    pub fn all() -> Vec<Self> {
        let mut all = Vec::new();
        let mut scene = Scene::default();
        let disks = [(false, 0.0), (true, 0.0), (true, 0.04), (true, 1.0)];
        let methods = [
            (Method::Verlet, 0.0),
            (Method::Closed, 0.0),
            (Method::Mino, 0.0),
            (Method::Mino, 0.5),
            (Method::KerrSchild, 0.0),
            (Method::KerrSchild, 0.5),
        ];
        for ((method, spin), (enabled, transmission)) in methods
            .into_iter()
            .flat_map(|method| disks.map(|disk| (method, disk)))
        {
            (scene.method, scene.hole.spin) = (method, spin);
            (scene.disk.enabled, scene.disk.transmission) = (enabled, transmission);
            all.extend([Self::rays(&scene), Self::timed(&scene)]);
            for mode in [SkyMode::Stars, SkyMode::Grid, SkyMode::Off] {
                for reference_star in [false, true] {
                    for view in View::ALL {
                        (scene.sky.mode, scene.sky.reference_star, scene.view) =
                            (mode, reference_star, view);
                        all.push(Self::picture(&scene));
                    }
                }
            }
            (scene.sky.mode, scene.view) = (SkyMode::Stars, View::Colour);
            for set in 0..32 {
                let [lensing, doppler, beaming, gravitational_shift, aberration] =
                    std::array::from_fn(|effect| set >> effect & 1 == 1);
                scene.effects = Effects {
                    lensing,
                    doppler,
                    beaming,
                    gravitational_shift,
                    aberration,
                };
                all.extend([Self::rays(&scene), Self::picture(&scene)]);
            }
        }
        let shining: Vec<Self> = all
            .iter()
            .copied()
            .filter(|v| v.disk && shows_light(v.view) && v.entry == Entry::Picture)
            .collect();
        all.extend(shining.into_iter().map(|variant| Self {
            disk_model: DiskModel::PageThorne,
            ..variant
        }));
        let close = |variant: &Self| {
            let (tracer, view, effects) = (variant.tracer, variant.view, variant.effects);
            tracer == Tracer::Mino && view == View::Colour && effects == Effects::default()
        };
        let close: Vec<Self> = all.iter().copied().filter(close).collect();
        all.extend(close.into_iter().map(|variant| Self {
            near_horizon: true,
            ..variant
        }));
        let mut seen = std::collections::HashSet::new();
        all.retain(|variant| seen.insert(*variant));
        all
    }

    /// The whole WGSL text.
    pub fn source(self) -> String {
        let mut source = self.prelude();
        for (_, text) in self.parts() {
            source.push_str(text);
        }
        source
    }

    /// Which file, and which line of it, a line of the text comes from; both counted from 1.
    pub fn locate(self, line: usize) -> (&'static str, usize) {
        let mut first = 1;
        let mut place = (PRELUDE, line);
        let prelude = self.prelude();
        for (file, text) in std::iter::once((PRELUDE, prelude.as_str())).chain(self.parts()) {
            if line >= first {
                place = (file, line - first + 1);
            }
            first += text.lines().count();
        }
        place
    }

    /// The parts in their order.
    fn parts(self) -> Vec<Part> {
        let mut parts = vec![part!("scene.wgsl")];
        if traces(self.view) {
            parts.extend(self.tracing());
        }
        match self.entry {
            Entry::Rays => parts.push(part!("rays.wgsl")),
            Entry::Timed => parts.push(part!("timed.wgsl")),
            Entry::Picture => {
                let disk_light = self.disk && shows_light(self.view);
                if disk_light || self.sky != SkyMode::Off {
                    parts.push(part!("spectrum.wgsl"));
                }
                if disk_light {
                    parts.push(match self.disk_model {
                        DiskModel::Newtonian => part!("disk/newtonian.wgsl"),
                        DiskModel::PageThorne => part!("disk/page_thorne.wgsl"),
                    });
                    parts.push(part!("disk/emission.wgsl"));
                }
                match self.sky {
                    SkyMode::Off => parts.push(part!("sky/none.wgsl")),
                    SkyMode::Stars => parts.extend([part!("sky.wgsl"), part!("sky/stars.wgsl")]),
                    SkyMode::Grid => parts.extend([part!("sky.wgsl"), part!("sky/grid.wgsl")]),
                }
                parts.push(match self.view {
                    View::Colour | View::Unfinished => part!("view/colour.wgsl"),
                    View::Classes => part!("view/classes.wgsl"),
                    View::Residual => part!("view/residual.wgsl"),
                    View::Order => part!("view/order.wgsl"),
                    View::Redshift => part!("view/redshift.wgsl"),
                    View::Error => part!("view/error.wgsl"),
                });
                if traces(self.view) {
                    parts.push(part!("view/traced.wgsl"));
                }
                parts.push(part!("geodesic.wgsl"));
            }
        }
        parts
    }

    /// The parts that trace a ray.
    fn tracing(self) -> Vec<Part> {
        let mut parts = vec![
            part!("elementary.wgsl"),
            part!("observer.wgsl"),
            part!("shift.wgsl"),
        ];
        parts.push(if self.disk {
            part!("disk.wgsl")
        } else {
            part!("disk/none.wgsl")
        });
        match self.tracer {
            Tracer::Verlet => parts.push(part!("method/verlet.wgsl")),
            Tracer::Straight => parts.push(part!("method/straight.wgsl")),
            Tracer::Closed => parts.extend([part!("elliptic.wgsl"), part!("method/closed.wgsl")]),
            Tracer::Mino => {
                parts.extend([part!("method/mino_azimuth.wgsl"), part!("method/mino.wgsl")])
            }
            Tracer::KerrSchild => parts.push(part!("method/kerr_schild.wgsl")),
        }
        parts
    }

    /// The files below shaders/ whose text is in this one's, in their order.
    pub fn files(self) -> Vec<&'static str> {
        self.parts().into_iter().map(|(file, _)| file).collect()
    }
}

/// Whether a view shows the light of disk and sky, and not the colours of marks.
fn shows_light(view: View) -> bool {
    matches!(view, View::Colour | View::Unfinished)
}

/// Whether a view shows what its shader traces, and not what was worked out before.
fn traces(view: View) -> bool {
    view != View::Error
}
