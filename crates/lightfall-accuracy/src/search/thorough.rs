//! A thorough search for the turn that explains an answer near the edge of the shadow. It traces
//! thousands of rays, so it is for the few rays whose error is too large after the usual search.

use super::backward::explaining_turn;
use super::chart::Chart;
use super::class::ClassSearch;
use super::grid::Grid;
use super::part::Part;
use super::turns::{Explained, TurnBounds, Turns};
use crate::answer::{is_complete, is_same_class};
use crate::ray::Ray;
use crate::reference_camera::ReferenceCamera;
use glam::DVec2;
use lightfall_optics::trace::Trace;

/// A search around one ray, from a grid of the reference's answers on both sides of the shadow's
/// edge.
pub struct ThoroughSearch<'a> {
    camera: &'a ReferenceCamera,
    ray: Ray,
    /// The true answer to the ray.
    truth: Trace,
    /// Empty if there is no edge.
    grids: Vec<Grid<'a>>,
}

impl<'a> ThoroughSearch<'a> {
    pub(crate) fn new(
        camera: &'a ReferenceCamera,
        ray: &Ray,
        truth: &Trace,
        bounds: TurnBounds,
    ) -> Self {
        let ray = camera.with_edge(ray);
        let grid = |chart: Chart| Grid::new(camera, chart, bounds);
        Self {
            camera,
            ray,
            truth: *truth,
            grids: Chart::both_sides(&ray).map(grid).collect(),
        }
    }

    /// The backward error, in radians, of an answer to the ray, as
    /// [`Truth::judge`](crate::Truth::judge) defines it, but at most the upper bound.
    pub fn judge(&self, given: &Trace, bounds: TurnBounds) -> f64 {
        if !is_complete(given) {
            return f64::INFINITY;
        }
        let class = (!is_same_class(&self.truth, given))
            .then(|| ClassSearch::new(self.camera, &self.ray, given, bounds.target));
        let mut turns = Turns::default();
        let mut whole = f64::INFINITY;
        for part in Part::all(given) {
            let found = self.explain(given, part, class.as_ref(), bounds);
            turns.add(part, found.part);
            whole = whole.min(found.whole);
        }
        if let Some(class) = class {
            // The nearest ray of the class may be one of the grid.
            let on_grid = self.grids.iter().map(|grid| grid.turn_to_class(given));
            turns.class = on_grid.fold(class.turn(), f64::min);
            whole = whole.min(class.whole());
            if turns.largest().min(whole) > bounds.target {
                let upper_bound = turns.largest().min(bounds.upper_bound);
                turns = self.follow_sky(given, bounds.target, upper_bound, turns);
            }
        }
        // A single ray may explain the whole answer better than one ray for each part.
        turns.largest().min(whole).min(bounds.upper_bound)
    }

    /// The turns that explain an answer with a sky and with hits on a ring so narrow that no ray of
    /// the grid meets it: the rays that explain the sky lead to those that meet the ring. `turns`
    /// are those found so far.
    fn follow_sky(&self, given: &Trace, target: f64, upper_bound: f64, mut turns: Turns) -> Turns {
        let Some(sky) = given.sky.filter(|_| given.hits.iter().any(Option::is_some)) else {
            return turns;
        };
        for grid in &self.grids {
            for start in grid.nearest_starts(Part::Sky(sky), upper_bound) {
                if turns.largest() > target {
                    turns = turns.min(grid.turns_along_sky(given, sky, start));
                }
            }
        }
        turns
    }

    /// Searches for the ray that explains a part of an answer. `class` is the search for rays of
    /// the answer's class, if that is not the ray's own.
    fn explain(
        &self,
        given: &Trace,
        part: Part,
        class: Option<&ClassSearch>,
        TurnBounds {
            target,
            upper_bound,
        }: TurnBounds,
    ) -> Explained {
        let forward = part.miss(&self.truth).map_or(f64::INFINITY, DVec2::length);
        if forward <= target {
            return Explained {
                part: forward,
                whole: f64::INFINITY,
            };
        }
        let usual = match class {
            Some(class) => class.turn_to_part(part, target),
            None => explaining_turn(self.camera, &self.ray, (part, forward), target),
        };
        let mut least = Explained {
            part: usual.min(upper_bound),
            whole: f64::INFINITY,
        };
        for grid in &self.grids {
            least = grid.explain(given, part, target, least);
        }
        least
    }
}
