//! The free places of a layout, for contents that take what room there is and scroll.

use super::{GAP, HOLE, Layout, Taken};
use bevy_egui::egui::{Rect, pos2};

/// The least side of a free place, in points.
const MIN_ROOM: f32 = 1.0;

impl Layout {
    /// The highest free place of at least this width, over the hole if need be. Where nothing free is so
    /// wide, the largest free place.
    #[must_use]
    pub fn room_for(&self, width: f32) -> Rect {
        let rooms = self.free_rooms(true);
        let wide = rooms.iter().filter(|room| room.width() >= width);
        let highest = wide.max_by(|a, b| a.height().total_cmp(&b.height()));
        let largest = || rooms.iter().max_by(|a, b| a.area().total_cmp(&b.area()));
        highest.or_else(largest).copied().unwrap_or(self.bounds)
    }

    /// Every free place that cannot be made larger to the left, to the right, up or down, and some that
    /// can.
    #[must_use]
    pub fn free_rooms(&self, over_hole: bool) -> Vec<Rect> {
        let bounds = self.bounds;
        let is_there = |taken: &Taken| !over_hole || taken.name != HOLE;
        let obstacles: Vec<Rect> = self
            .obstacles()
            .filter(is_there)
            .map(|taken| taken.place.expand(GAP))
            .collect();
        let lefts = std::iter::once(bounds.left()).chain(obstacles.iter().map(Rect::right));
        let rights = std::iter::once(bounds.right()).chain(obstacles.iter().map(Rect::left));
        let sides = lefts.flat_map(|left| rights.clone().map(move |right| (left, right)));
        let is_within = |(left, right): &(f32, f32)| {
            *left >= bounds.left() && *right <= bounds.right() && right - left >= MIN_ROOM
        };
        let mut rooms = Vec::new();
        for (left, right) in sides.filter(is_within) {
            let mut between: Vec<Rect> = obstacles
                .iter()
                .filter(|obstacle| obstacle.left() < right && obstacle.right() > left)
                .copied()
                .collect();
            between.sort_by(|a, b| a.top().total_cmp(&b.top()));
            let mut top = bounds.top();
            let ends = between.iter().map(|it| [it.top(), it.bottom()]);
            for [end, next] in ends.chain([[bounds.bottom(); 2]]) {
                let end = end.min(bounds.bottom());
                if end - top >= MIN_ROOM {
                    rooms.push(Rect::from_min_max(pos2(left, top), pos2(right, end)));
                }
                top = top.max(next);
            }
        }
        rooms
    }
}
