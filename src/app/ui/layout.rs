//! The layout of everything that lies over the picture. Each system asks for a place in the order of
//! [`Importance`]. Nothing gets a place that is taken, and what finds no place is left out.

mod order;
mod rooms;

pub(crate) use order::{Importance, plugin};

use bevy::prelude::Resource;
use bevy_egui::egui::{Align2, Pos2, Rect, Vec2, pos2, vec2};

/// Minimum room between two boxes, in points.
pub(crate) const GAP: f32 = 6.0;
/// Name of the hole's box.
const HOLE: &str = "hole";
/// Name of the place that is kept for messages.
const KEPT: &str = "kept for messages";
/// Weight of a shift sideways against one up or down.
const SIDEWAYS: f32 = 3.0;
/// Weight of the distance of a label from its place, and of a point that the label hides.
const DISTANCE_WEIGHT: f32 = 0.4;
const POINT_WEIGHT: f32 = 6.0;
/// Directions from its place in which a label may stand, the best first.
const DIRECTIONS: [Vec2; 8] = [
    vec2(1.0, 0.0),
    vec2(-1.0, 0.0),
    vec2(1.0, -0.6),
    vec2(-1.0, -0.6),
    vec2(1.0, 0.6),
    vec2(-1.0, 0.6),
    vec2(0.0, 1.0),
    vec2(0.0, -1.0),
];

/// How far a box may be from its wish.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slide {
    /// Nowhere: it is there or left out.
    Nowhere,
    /// Up or down.
    Upright,
    /// Anywhere.
    Anywhere,
}

/// Where a box would best be: this corner or edge of it at this place.
#[derive(Clone, Copy, Debug)]
pub struct Wish {
    /// The corner or the edge.
    pub anchor: Align2,
    /// Its place.
    pub at: Pos2,
    /// How far it may be from there.
    pub slide: Slide,
    /// Whether it covers the hole rather than being left out.
    pub covers_hole: bool,
}

impl Wish {
    /// The same wish for a box that covers the hole rather than being left out.
    #[must_use]
    pub fn even_over_hole(self) -> Self {
        Self {
            covers_hole: true,
            ..self
        }
    }
}

/// A box and what it is of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taken {
    /// The name of what is there.
    pub name: &'static str,
    /// Its box, in points.
    pub place: Rect,
}

/// What is where over the picture.
#[derive(Resource, Clone, Debug)]
pub struct Layout {
    bounds: Rect,
    taken: Vec<Taken>,
    /// A place that is kept free for messages until they have theirs.
    kept: Option<Rect>,
    /// Points of a drawing, which labels leave free where they can.
    drawn: Vec<Pos2>,
}

impl Default for Layout {
    fn default() -> Self {
        Self::within(Rect::NOTHING)
    }
}

impl Layout {
    /// An empty layout within these bounds.
    #[must_use]
    pub fn within(bounds: Rect) -> Self {
        Self {
            bounds,
            taken: Vec::new(),
            kept: None,
            drawn: Vec::new(),
        }
    }

    /// The part of the window between the panels, less a margin.
    #[must_use]
    pub fn bounds(&self) -> Rect {
        self.bounds
    }

    /// The boxes so far.
    #[must_use]
    pub fn taken(&self) -> &[Taken] {
        &self.taken
    }

    /// The box of this name in this frame.
    #[must_use]
    pub fn place_of(&self, name: &str) -> Option<Rect> {
        let found = self.taken.iter().find(|taken| taken.name == name);
        found.map(|taken| taken.place)
    }

    /// The part of the bounds above the buttons for fingers.
    #[must_use]
    pub fn above_touch_bar(&self) -> Rect {
        let mut room = self.bounds;
        if let Some(bar) = self.place_of("touch bar") {
            room.max.y = room.bottom().min(bar.top() - GAP);
        }
        room
    }

    /// A wish for the middle of the lower edge, above the read-outs and this much more.
    #[must_use]
    pub fn above_read_outs(&self, more: f32) -> Wish {
        let lowest = self
            .place_of("read-outs")
            .map_or(self.bounds.bottom(), |place| place.top() - GAP);
        let bottom = lowest - more;
        Wish {
            anchor: Align2::CENTER_BOTTOM,
            at: pos2(self.bounds.center().x, bottom),
            slide: Slide::Anywhere,
            covers_hole: true,
        }
    }

    /// A wish for this corner or edge of the free part of the window.
    #[must_use]
    pub fn at(&self, anchor: Align2, slide: Slide) -> Wish {
        Wish {
            anchor,
            at: anchor.pos_in_rect(&self.bounds),
            slide,
            covers_hole: false,
        }
    }

    /// Takes a place, free or not.
    pub fn take(&mut self, name: &'static str, place: Rect) {
        self.taken.push(Taken { name, place });
    }

    /// Keeps a place free for messages.
    pub fn keep_for_messages(&mut self, place: Rect) {
        self.kept = Some(place);
    }

    /// Gives the place that was kept for messages to them and to what comes after them.
    pub fn release(&mut self) {
        self.kept = None;
    }

    /// What is taken or kept.
    fn obstacles(&self) -> impl Iterator<Item = Taken> {
        let kept = self.kept.map(|place| Taken { name: KEPT, place });
        self.taken.iter().copied().chain(kept)
    }

    /// Asks labels to leave these points free.
    pub fn avoid(&mut self, points: impl IntoIterator<Item = Pos2>) {
        let bounds = self.bounds;
        let inside = points.into_iter().filter(|point| bounds.contains(*point));
        self.drawn.extend(inside);
    }

    /// Whether a box covers a part of the hole that is kept free.
    #[must_use]
    pub fn covers_hole(&self, place: Rect) -> bool {
        let mut holes = self.taken.iter().filter(|taken| taken.name == HOLE);
        holes.any(|hole| hole.place.intersects(place))
    }

    /// Whether a box lies within the bounds and covers nothing.
    #[must_use]
    pub fn is_free(&self, place: Rect) -> bool {
        self.is_free_of(place, self.obstacles())
    }

    fn is_free_of(&self, place: Rect, mut taken: impl Iterator<Item = Taken>) -> bool {
        let room = place.expand(0.5 * GAP);
        self.bounds.expand(1.0).contains_rect(place)
            && taken.all(|taken| !taken.place.intersects(room))
    }

    /// Gives a box of this size the free place that is nearest to its wish, and takes it.
    pub fn place(&mut self, name: &'static str, size: Vec2, wish: Wish) -> Option<Rect> {
        let place = self.wished(size, wish)?;
        self.take(name, place);
        Some(place)
    }

    /// The free place for a box of this size that is nearest to its wish.
    #[must_use]
    pub fn wished(&self, size: Vec2, wish: Wish) -> Option<Rect> {
        let mut taken: Vec<Taken> = self.obstacles().collect();
        let place = self.nearest(size, wish, &taken);
        if place.is_some() || !wish.covers_hole {
            return place;
        }
        taken.retain(|taken| taken.name != HOLE);
        self.nearest(size, wish, &taken)
    }

    /// The place beside taken ones that is nearest to a wish. It touches the edges of taken ones or of
    /// the bounds, so that no others need to be tried.
    fn nearest(&self, size: Vec2, wish: Wish, taken: &[Taken]) -> Option<Rect> {
        let wanted = wish.anchor.anchor_size(wish.at, size).min;
        let bounds = self.bounds;
        let (mut lefts, mut tops) = (vec![wanted.x], vec![wanted.y]);
        if wish.slide != Slide::Nowhere {
            tops.extend([bounds.top(), bounds.bottom() - size.y]);
            let beside = |taken: &Taken| {
                let Rect { min, max } = taken.place;
                [min.y - GAP - size.y, max.y + GAP]
            };
            tops.extend(taken.iter().flat_map(beside));
        }
        if wish.slide == Slide::Anywhere {
            lefts.extend([bounds.left(), bounds.right() - size.x]);
            let beside = |taken: &Taken| {
                let Rect { min, max } = taken.place;
                [min.x - GAP - size.x, max.x + GAP]
            };
            lefts.extend(taken.iter().flat_map(beside));
        }
        let places = tops
            .iter()
            .flat_map(|top| lefts.iter().map(|left| pos2(*left, *top)));
        // Whole points keep the letters sharp.
        let boxes = places.map(|place| Rect::from_min_size(place.round(), size));
        let distance = |place: &Rect| {
            let shift = (place.min - wanted).abs();
            SIDEWAYS * shift.x + shift.y
        };
        boxes
            .filter(|place| self.is_free_of(*place, taken.iter().copied()))
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    /// Gives a label of this size the best free place within a box at one of the distances from a point,
    /// and takes it.
    pub fn place_beside(
        &mut self,
        name: &'static str,
        point: Pos2,
        size: Vec2,
        distances: &[f32],
        within: Rect,
    ) -> Option<Rect> {
        let boxes = distances.iter().flat_map(|distance| {
            DIRECTIONS.map(|direction| {
                // The nearest point of the box lies at the distance from the point.
                let sign = |x: f32| if x == 0.0 { 0.0 } else { x.signum() };
                let side = 0.5 * size * vec2(sign(direction.x), sign(direction.y));
                let middle = point + *distance * direction + side;
                (*distance, Rect::from_center_size(middle, size))
            })
        });
        let cost = |(distance, place): &(f32, Rect)| {
            let hidden = self.drawn.iter().filter(|point| place.contains(**point));
            DISTANCE_WEIGHT * distance + POINT_WEIGHT * hidden.count() as f32
        };
        let free = boxes.filter(|(_, place)| within.contains_rect(*place) && self.is_free(*place));
        let (_, place) = free.min_by(|a, b| cost(a).total_cmp(&cost(b)))?;
        self.take(name, place);
        Some(place)
    }
}
