//! What the passes are asked to draw: a scene, how many frames of it are averaged, and how many of
//! them are drawn.

use crate::chain::Chain;
use crate::comparison::{ComparedScene, ComparisonLayout};
use crate::progress::Progress;
use crate::resting_frames::RestingFrames;
use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::scene::Scene;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

/// Whether the scene is drawn in every frame, changed or not: for measurements.
#[derive(Resource, Clone, Copy, Default, ExtractResource)]
pub struct AlwaysDraw(pub bool);

/// The picture to draw. Every change makes a new request with a flag of its own, so that a late
/// "drawn" cannot be taken for the answer to a newer request.
#[derive(Resource, Clone, ExtractResource)]
pub struct DrawRequest {
    pub(super) scene: Scene,
    /// The pinned scene that is compared with it.
    pub(super) compared: Option<(Scene, ComparisonLayout)>,
    /// How many frames are averaged.
    frames: u32,
    /// Whether a frame that counts for no mean comes first.
    first_alone: bool,
    /// Whether that frame is drawn without refined edges.
    first_rough: bool,
    /// Whether a frame has drawn it, with or without refined edges. A foreground is drawn for some
    /// frames more before the first one counts, and their edges are refined.
    begun: Arc<AtomicBool>,
    /// How many frames have drawn all of it; shared by the main and the render world.
    drawn: Arc<AtomicU32>,
    /// Whether a frame has drawn the scene at some time of the disk; shared by the requests that
    /// differ in that time only. While the disk's clock runs, every frame has a request of its own,
    /// of which none is known to be drawn before the next one comes.
    shown: Arc<AtomicBool>,
    /// Whether there is a picture, of this or an earlier request. All requests share it.
    pub(super) has_picture: Arc<AtomicBool>,
}

impl DrawRequest {
    pub(super) fn new(scene: &Scene, compared: &ComparedScene, resting: RestingFrames) -> Self {
        let chain = Chain::of(scene).comparing(compared);
        let frames = resting.of(&chain);
        Self {
            frames,
            first_alone: resting.has_first(&chain, frames),
            first_rough: resting.first_rough,
            scene: scene.without_presentation(),
            compared: compared.without_presentation(),
            begun: default(),
            drawn: default(),
            shown: default(),
            has_picture: default(),
        }
    }

    /// A request for another picture, which replaces this one's.
    pub(super) fn next(
        &self,
        scene: &Scene,
        compared: &ComparedScene,
        resting: RestingFrames,
    ) -> Self {
        let next = Self::new(scene, compared, resting);
        let shown = if next.scene.without_clock() == self.scene.without_clock() {
            Arc::clone(&self.shown)
        } else {
            default()
        };
        Self {
            shown,
            has_picture: Arc::clone(&self.has_picture),
            ..next
        }
    }

    pub(super) fn mark_shown(&self) {
        self.begun.store(true, Ordering::Release);
        self.shown.store(true, Ordering::Release);
    }

    pub(super) fn count_frame(&self) {
        self.mark_shown();
        let drawn = self.drawn.load(Ordering::Acquire) + 1;
        self.drawn
            .store(drawn.min(self.all_frames()), Ordering::Release);
        self.has_picture.store(true, Ordering::Release);
    }

    /// The number of frames until all is drawn.
    fn all_frames(&self) -> u32 {
        self.frames + u32::from(self.first_alone)
    }

    /// How many frames are averaged.
    pub(super) fn averaged_frames(&self) -> u32 {
        self.frames
    }

    /// Width and height of the picture, in pixels.
    pub(super) fn picture_size(&self) -> UVec2 {
        self.scene.picture.size()
    }

    /// The number of the next frame among those that are averaged; `None` for a frame that is shown
    /// as it is. After the last one it is drawn again, which leaves the mean as it is.
    pub(super) fn averaged_frame(&self) -> Option<u32> {
        if self.frames == 1 {
            return None;
        }
        let next = self.drawn.load(Ordering::Acquire);
        next.min(self.all_frames() - 1)
            .checked_sub(u32::from(self.first_alone))
    }

    /// Whether the edges of the next frame are refined.
    pub(super) fn refines_edges(&self) -> bool {
        let is_first = self.first_alone && !self.begun.load(Ordering::Acquire);
        !(is_first && self.first_rough)
    }

    /// How far it is drawn; `ready` says whether its shaders are compiled.
    pub(super) fn progress(&self, ready: bool) -> Progress {
        let drawn = self.drawn_frames();
        if drawn >= self.all_frames() {
            Progress::Done
        } else if !ready {
            Progress::Compiling
        } else if self.shown.load(Ordering::Acquire) {
            Progress::Averaging(drawn)
        } else {
            Progress::Rough
        }
    }

    /// How many frames have drawn all of it.
    pub fn drawn_frames(&self) -> u32 {
        self.drawn.load(Ordering::Acquire)
    }

    /// Asks for the same picture again, because the one that was drawn is lost.
    pub(super) fn forget_picture(&self) {
        self.begun.store(false, Ordering::Release);
        self.drawn.store(0, Ordering::Release);
        self.shown.store(false, Ordering::Release);
        self.has_picture.store(false, Ordering::Release);
    }
}
