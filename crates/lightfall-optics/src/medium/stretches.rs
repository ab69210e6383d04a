//! The stretches of a ray's way on which there is matter, for whoever reads them one by one.

use super::means::{Means, Sums};
use super::passage::Passage;
use super::transfer::Piece;

/// Which matter a ray meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatterKind {
    /// A disk with thickness.
    Disk,
    /// Jets.
    Jets,
    /// Jets inside of a disk with thickness.
    DiskAndJets,
    /// A disk without thickness.
    Sheet,
}

/// A part of a ray's way with the same matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// The matter.
    pub kind: MatterKind,
    /// The radii at which the backward ray enters and leaves it, in r_s.
    pub r: [f64; 2],
    /// The same for the height r cos(theta) above the disk's plane, in r_s.
    pub height: [f64; 2],
    /// Its optical depth.
    pub depth: f64,
    /// The share of the ray's luminance that comes from it.
    pub share: f64,
    /// Where its light comes from, on average; `None` without light.
    pub means: Option<Means>,
}

/// The stretches that these pieces of a way make up, and the whole way. `kinds` are those of the
/// emitters.
pub(super) fn stretches(pieces: Vec<Piece>, kinds: &[MatterKind]) -> (Vec<Stretch>, Passage) {
    let mut joined: Vec<Piece> = Vec::new();
    for piece in pieces {
        match joined.last_mut() {
            Some(last) if follows(last, &piece) => {
                last.times[1] = piece.times[1];
                last.ends[1] = piece.ends[1];
                last.passage = last.passage.followed_by(piece.passage);
            }
            _ => joined.push(piece),
        }
    }
    let mut way = Passage::default();
    let arriving: Vec<Sums> = joined
        .iter()
        .map(|piece| {
            let arriving = (-way.depth).exp() * piece.passage.sums;
            way = way.followed_by(piece.passage);
            arriving
        })
        .collect();
    let all = way.sums.luminance();
    let parts = joined.iter().zip(arriving);
    let stretch = |(piece, arriving): (&Piece, Sums)| {
        let [near, far] = piece.ends;
        Stretch {
            kind: match piece.emitters[..] {
                [] => MatterKind::Sheet,
                [only] => kinds[only],
                _ => MatterKind::DiskAndJets,
            },
            r: [near[0], far[0]],
            height: [near[1], far[1]],
            depth: piece.passage.depth,
            share: if all > 0.0 {
                arriving.luminance() / all
            } else {
                0.0
            },
            means: piece.passage.means(),
        }
    };
    (parts.map(stretch).collect(), way)
}

/// Whether a piece goes on where the last one ends, in the same matter.
fn follows(last: &Piece, next: &Piece) -> bool {
    let gap = next.times[0] - last.times[1];
    // Times are sums of steps, whose rounding leaves gaps of this order.
    let touches = gap <= 1e-12 * (1.0 + next.times[0]);
    touches && last.emitters == next.emitters && !next.emitters.is_empty()
}
