//! What the passes are asked to draw: a scene, how many frames of it are averaged, and how many of
//! them are drawn.

use crate::chain::Chain;
use crate::comparison::{ComparedScene, ComparisonLayout};
use crate::progress::{Drawn, Progress, SharedDrawn};
use crate::resting_frames::{QuickFrames, RestingFrames};
use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::scene::{Frame, Part, Scene};

/// Extra frames that a foreground is drawn before its picture is kept. Meshes and materials reach
/// the GPU some frames after they are made, the lamps' clusters are sized by what an earlier frame
/// needed, and Bevy does not report when either is done.
const FOREGROUND_FRAMES: u32 = 8;

/// Whether the scene is drawn in every frame, changed or not: for measurements.
#[derive(Resource, Clone, Copy, Default, ExtractResource)]
pub struct AlwaysDraw(pub bool);

/// The picture to draw. Every change makes a new request with a number of its own, so that a late
/// frame cannot be taken for the answer to a newer request.
#[derive(Resource, Clone, ExtractResource)]
pub(super) struct DrawRequest {
    pub(super) scene: Scene,
    /// The part of its picture that is drawn; `None` for all of it.
    pub(super) part: Option<Part>,
    /// The pinned scene that is compared with it.
    pub(super) compared: Option<(Scene, ComparisonLayout)>,
    /// How many frames are averaged.
    frames: u32,
    /// Whether a frame outside the mean is drawn first.
    first_alone: bool,
    /// Which frames refine edges with fewer rays.
    quick: QuickFrames,
    /// How many frames draw the foreground before the first one that counts.
    foreground_frames: u32,
    number: u64,
    /// The number of the first of the requests that differ in the disk's time only. While the
    /// disk's clock runs, every frame has a request of its own, of which none is known to be drawn
    /// before the next one comes.
    look: u64,
    drawn: SharedDrawn,
}

impl DrawRequest {
    pub(super) fn new(
        (scene, part): (&Scene, Option<Part>),
        compared: &ComparedScene,
        resting: RestingFrames,
    ) -> Self {
        let chain = Chain::of(scene).comparing(compared);
        let frames = resting.of(&chain);
        Self {
            frames,
            first_alone: resting.has_first(&chain, frames),
            quick: resting.quick,
            foreground_frames: if chain.probe { FOREGROUND_FRAMES } else { 0 },
            scene: scene.without_presentation(),
            part,
            compared: compared.without_presentation(),
            number: 0,
            look: 0,
            drawn: default(),
        }
    }

    /// A request for another picture, which replaces this one's.
    pub(super) fn next(
        &self,
        drawn: (&Scene, Option<Part>),
        compared: &ComparedScene,
        resting: RestingFrames,
    ) -> Self {
        let next = Self::new(drawn, compared, resting);
        let number = self.number + 1;
        let same_look = next.scene.without_clock() == self.scene.without_clock();
        Self {
            number,
            look: if same_look { self.look } else { number },
            drawn: self.drawn.clone(),
            ..next
        }
    }

    /// How much of it is drawn.
    fn drawn(&self) -> Drawn {
        let drawn = *self.drawn.lock();
        if drawn.request == self.number {
            return drawn;
        }
        Drawn {
            request: self.number,
            look: drawn.look,
            has_picture: drawn.has_picture,
            ..Drawn::default()
        }
    }

    /// Counts a frame. `complete` says whether it has drawn all of the scene.
    pub(super) fn count_frame(&self, complete: bool) {
        let mut drawn = self.drawn();
        if !complete {
            drawn.in_a_row = 0;
        } else {
            (drawn.begun, drawn.look) = (true, Some(self.look));
            if drawn.in_a_row < self.foreground_frames {
                drawn.in_a_row += 1;
            } else {
                drawn.frames = self.all_frames().min(drawn.frames + 1);
                drawn.has_picture = true;
            }
        }
        *self.drawn.lock() = drawn;
    }

    /// The number of frames until all is drawn.
    fn all_frames(&self) -> u32 {
        self.frames + u32::from(self.first_alone)
    }

    /// Width and height of what is drawn of the picture, in pixels.
    pub(super) fn picture_size(&self) -> UVec2 {
        self.part
            .map_or(self.scene.picture.size(), |part| part.size)
    }

    /// The number of the next frame among those that are averaged; `None` for a frame that is shown
    /// as it is. After the last one it is drawn again, which leaves the mean as it is.
    pub(super) fn averaged_frame(&self) -> Option<u32> {
        if self.frames == 1 {
            return None;
        }
        let next = self.drawn().frames;
        next.min(self.all_frames() - 1)
            .checked_sub(u32::from(self.first_alone))
    }

    /// A frame of the picture as the sample that comes next.
    pub(super) fn next_sample(&self, frame: Frame) -> Frame {
        match self.averaged_frame() {
            Some(sample) => frame.with_sample(sample, self.frames),
            None => frame,
        }
    }

    /// Whether the edges of the next frame are refined with fewer rays.
    pub(super) fn is_quick(&self) -> bool {
        match self.quick {
            QuickFrames::None => false,
            QuickFrames::First => self.first_alone && !self.drawn().begun,
            QuickFrames::All => true,
        }
    }

    /// How far it is drawn; `ready` says whether its shaders are compiled.
    pub(super) fn progress(&self, ready: bool) -> Progress {
        let drawn = self.drawn();
        if drawn.frames >= self.all_frames() {
            Progress::Done
        } else if !ready {
            Progress::Compiling
        } else if drawn.look == Some(self.look) {
            Progress::Averaging(drawn.frames)
        } else {
            Progress::Rough
        }
    }

    /// Whether there is a picture, of this or an earlier request.
    pub(super) fn has_picture(&self) -> bool {
        self.drawn().has_picture
    }

    /// Asks for the same picture again, because the one that was drawn is lost.
    pub(super) fn forget_picture(&self) {
        *self.drawn.lock() = Drawn::default();
    }
}
