//! The backward error of an answer of the wrong class: one with another outcome or another number
//! of hits.

use super::backward::{PLANE_SCALES, turn_in_plane};
use super::chart::Chart;
use super::near_edge::turn_near_edge;
use super::newton::{NO_DAMPING, newton};
use super::part::{Part, bound_of_whole, miss_on_chart};
use crate::answer::{greater, is_same_class};
use crate::ray::Ray;
use crate::reference_camera::ReferenceCamera;
use glam::{DVec2, DVec3};
use lightfall_model::geometry::sphere::angle_between;
use lightfall_optics::trace::Trace;
use std::cell::{Cell, OnceCell};
use std::f64::consts::{PI, TAU};

/// The search tries directions on rings about the ray: the number of directions on each ring, the
/// factor between the radii, and the smallest and the largest radius in radians.
const SPOKES: u32 = 8;
const RING_FACTOR: f64 = 3.0;
const MIN_RING_DISTANCE: f64 = 1e-10;
const MAX_RING_DISTANCE: f64 = 0.3;
const BISECTIONS: u32 = 8;
/// The factor between successive turns along the edge.
const ALONG_FACTOR: f64 = 1.2;
/// Change of the sky's height over the disk's plane in one step along the line toward the edge, as
/// a share of the greatest height on the line: small enough to find the narrow image of a thin
/// disk. The azimuth, which changes by hundreds of radians per step next to nearly extremal holes,
/// does not decide whether a ray meets the disk.
const HEIGHT_STEP: f64 = 0.01;

/// The backward error, in radians, of an answer of the wrong class: the largest of the turn to the
/// nearest ray of its class and of the turns that explain its parts. Infinite if there is no ray of
/// its class within 0.3 rad.
pub(crate) fn class_backward_error(
    camera: &ReferenceCamera,
    ray: &Ray,
    given: &Trace,
    precision: f64,
) -> f64 {
    let search = ClassSearch::new(camera, ray, given, precision);
    let parts = Part::all(given).map(|part| search.turn_to_part(part, precision));
    search.bound(parts.fold(0.0, greater))
}

/// The search for rays of the class of an answer, around a ray of another class.
pub(super) struct ClassSearch<'a> {
    camera: &'a ReferenceCamera,
    ray: Ray,
    /// The charts of both sides of the shadow's edge, if there is one: the answer may belong to
    /// either. They are computed when needed, because finding an edge is expensive.
    charts: OnceCell<Vec<Chart>>,
    nearest: Nearest<'a>,
}

impl<'a> ClassSearch<'a> {
    /// Searches for the nearest ray of the class of an answer. A turn below `precision` ends the
    /// search.
    ///
    /// The search tries rings of directions and then bisects toward the ray, which is accurate to
    /// about a third. If it finds nothing within `precision`, it follows the line through the
    /// shadow's edge, where the images of the disk are, on both sides of the edge, and then the
    /// edge itself.
    pub(super) fn new(
        camera: &'a ReferenceCamera,
        ray: &Ray,
        given: &'a Trace,
        precision: f64,
    ) -> Self {
        let search = Self {
            camera,
            ray: *ray,
            charts: OnceCell::new(),
            nearest: Nearest::on_rings(camera, ray.direction(), given),
        };
        let nearest = &search.nearest;
        if nearest.turn() > precision {
            for chart in search.charts() {
                for side in [-1.0, 1.0] {
                    let highest = Cell::new(0.0);
                    let moved = |before: &Trace, after: &Trace| risen(before, after, &highest);
                    let line = chart.line(camera, side, nearest.turn(), HEIGHT_STEP, moved);
                    for (x, trace) in line {
                        nearest.visit(chart.at(DVec2::new(x, 0.0)), &trace);
                    }
                    along_edge(camera, chart, side, nearest);
                }
            }
        }
        search
    }

    fn charts(&self) -> &[Chart] {
        self.charts
            .get_or_init(|| Chart::both_sides(&self.camera.with_edge(&self.ray)).collect())
    }

    /// The bound of the answer's error, given the largest of the turns that explain its parts.
    pub(super) fn bound(&self, parts: f64) -> f64 {
        greater(parts, self.turn()).min(self.whole())
    }

    /// The turn to the nearest ray of the class.
    pub(super) fn turn(&self) -> f64 {
        self.nearest.turn()
    }

    /// The smallest bound of the whole answer's error by a single ray.
    pub(super) fn whole(&self) -> f64 {
        self.nearest.whole.get()
    }

    /// The smallest turn found that explains a part of the answer. The search starts at the nearest
    /// ray of the class, and goes on toward the shadow's edge if the turn is not below `precision`.
    pub(super) fn turn_to_part(&self, part: Part, precision: f64) -> f64 {
        let visit = |direction: DVec3, trace: &Trace| self.nearest.visit(direction, trace);
        let from = self.nearest.place.get().direction;
        let mut least = f64::INFINITY;
        for share in PLANE_SCALES {
            if least > precision {
                let start = (share * self.camera.scale, from);
                least = least.min(turn_in_plane(self.camera, &self.ray, part, start, &visit));
            }
        }
        if least <= precision {
            return least;
        }
        for chart in self.charts() {
            if let Some(start) = chart.place_of(from) {
                let at = miss_on_chart(self.camera, chart, part, &visit);
                least = least.min(newton(chart, &at, start, NO_DAMPING));
            }
            if least > precision {
                let bounds = [precision, least];
                least = least.min(turn_near_edge(self.camera, chart, part, bounds, &visit));
            }
        }
        least
    }
}

/// The nearest ray found whose answer has the class of the given one.
struct Nearest<'a> {
    /// The ray that is turned.
    ray: DVec3,
    given: &'a Trace,
    place: Cell<Turned>,
    /// The smallest bound of the whole answer's error by a single ray.
    whole: Cell<f64>,
}

/// A turned ray. If none was found, the turn is infinite and the direction is that of the ray.
#[derive(Clone, Copy)]
struct Turned {
    turn: f64,
    direction: DVec3,
}

impl<'a> Nearest<'a> {
    fn turn(&self) -> f64 {
        self.place.get().turn
    }

    fn is_same(&self, trace: &Trace) -> bool {
        is_same_class(trace, self.given)
    }

    /// Compares another ray.
    fn visit(&self, direction: DVec3, trace: &Trace) {
        let turn = angle_between(self.ray, direction);
        if turn < self.turn() && self.is_same(trace) {
            self.place.set(Turned { turn, direction });
        }
        if turn < self.whole.get() {
            let bound = bound_of_whole(self.given, turn, trace);
            self.whole.set(self.whole.get().min(bound));
        }
    }

    fn on_rings(camera: &ReferenceCamera, ray: DVec3, given: &'a Trace) -> Self {
        let nearest = Self {
            ray,
            given,
            place: Cell::new(Turned {
                turn: f64::INFINITY,
                direction: ray,
            }),
            whole: Cell::new(f64::INFINITY),
        };
        let (u, v) = ray.any_orthonormal_pair();
        let toward = |spoke: u32, turn: f64| {
            let (sin, cos) = (TAU * f64::from(spoke) / f64::from(SPOKES)).sin_cos();
            turn.cos() * ray + turn.sin() * (cos * u + sin * v)
        };
        let is_same = |spoke: u32, turn: f64| nearest.is_same(&camera.trace(toward(spoke, turn)));
        let bisected = |spoke: u32, ring: f64| {
            let mut bracket = [ring / RING_FACTOR, ring];
            for _ in 0..BISECTIONS {
                let middle = (bracket[0] * bracket[1]).sqrt();
                bracket[usize::from(is_same(spoke, middle))] = middle;
            }
            Turned {
                turn: bracket[1],
                direction: toward(spoke, bracket[1]),
            }
        };
        let mut ring = MIN_RING_DISTANCE;
        while ring < MAX_RING_DISTANCE && nearest.turn() == f64::INFINITY {
            for spoke in (0..SPOKES).filter(|spoke| is_same(*spoke, ring)) {
                let found = bisected(spoke, ring);
                if found.turn < nearest.turn() {
                    nearest.place.set(found);
                }
            }
            ring *= RING_FACTOR;
        }
        nearest
    }
}

/// Tries rays along the edge to one side, at the ray's own distance from the edge, until one of the
/// class is found or the turn exceeds that of the nearest. Next to the edge the images of a ring
/// are arcs much narrower than the step between two spokes.
fn along_edge(camera: &ReferenceCamera, chart: &Chart, side: f64, nearest: &Nearest) {
    let known = nearest.turn();
    let reach = known.min(MAX_RING_DISTANCE);
    // Beyond half a turn about the centre the line returns.
    let farthest = PI * chart.radius() / chart.scale;
    let mut place = DVec2::new(0.0, side);
    while nearest.turn() == known && place.y.abs() < farthest && chart.turn(place) < reach {
        let direction = chart.at(place);
        nearest.visit(direction, &camera.trace(direction));
        place *= ALONG_FACTOR;
    }
}

/// The change of the sky's height over the disk's plane between two answers, as a share of the
/// greatest height so far; 0 if one of them has no sky.
fn risen(before: &Trace, after: &Trace, highest: &Cell<f64>) -> f64 {
    let Some((before, after)) = before.sky.zip(after.sky) else {
        return 0.0;
    };
    highest.set(highest.get().max(after.z.abs()));
    (after.z - before.z).abs() / highest.get().max(f64::MIN_POSITIVE)
}
