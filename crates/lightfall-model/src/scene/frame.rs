//! The frame: what is drawn of a scene at one moment. The scene says what was chosen; size, part,
//! cells, sample, metered exposure and the disk's time belong to the frame.

use super::{Picture, Projection, Scene};
use glam::UVec2;

/// A part of a picture, in pixels of the whole one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Its upper left corner. Both numbers are even, so that the part has the pairs of neighbouring
    /// pixels that the whole picture has.
    pub origin: UVec2,
    /// Its width and height. In a projection whose columns go around the whole sky, the first column
    /// follows the last one.
    pub size: UVec2,
}

impl Part {
    /// All of a picture of this size.
    #[must_use]
    pub fn whole(size: UVec2) -> Self {
        Self {
            origin: UVec2::ZERO,
            size,
        }
    }
}

impl Scene {
    /// Whether the picture is shown in cells: only perspective pictures are.
    pub fn has_cells(&self) -> bool {
        !self.picture.bypass && self.camera.projection == Projection::Perspective
    }

    /// The picture as it is shown: without cells where its projection has none.
    pub fn shown_picture(&self) -> Picture {
        Picture {
            bypass: !self.has_cells(),
            ..self.picture
        }
    }
}

/// What is drawn of a scene at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Size of the whole picture, in pixels: the camera's field of view fills its height.
    pub whole: UVec2,
    /// Columns and rows of the cells in which the whole picture is shown.
    pub cells: UVec2,
    /// The upper left corner of the part that is drawn, in pixels of the whole picture.
    pub origin: UVec2,
    /// Size of the part that is drawn, in pixels.
    pub size: UVec2,
    /// Where the upper left corner of the part is drawn in the target, in pixels.
    pub corner: UVec2,
    /// Number of this sample of a picture that is the mean of several.
    pub sample: u32,
    /// How many samples are averaged.
    pub samples: u32,
    /// Exposure, in powers of two: chosen by hand or by the light meter.
    pub exposure_ev: f64,
    /// Time of the disk's clock at the camera, in r_s/c.
    pub disk_time: f64,
}

impl Frame {
    /// The frame that the scene itself describes: the whole picture in one sample.
    pub fn of(scene: &Scene) -> Self {
        let size = scene.picture.size();
        Self {
            whole: size,
            cells: scene.picture.grid(),
            origin: UVec2::ZERO,
            size,
            corner: UVec2::ZERO,
            sample: 0,
            samples: 1,
            exposure_ev: scene.picture.exposure_ev,
            disk_time: scene.disk.time,
        }
    }

    /// The frame with a whole picture of another size.
    #[must_use]
    pub fn with_whole(self, whole: UVec2) -> Self {
        Self {
            whole,
            origin: UVec2::ZERO,
            size: whole,
            ..self
        }
    }

    /// The frame of which only a part is drawn, if one is given.
    #[must_use]
    pub fn with_part(self, part: Option<Part>) -> Self {
        part.map_or(self, |Part { origin, size }| Self {
            origin,
            size,
            ..self
        })
    }

    /// The part that is drawn; `None` if it is the whole picture.
    pub fn part(&self) -> Option<Part> {
        let (origin, size) = (self.origin, self.size);
        (size != self.whole).then_some(Part { origin, size })
    }

    /// The frame drawn at another place of the target.
    #[must_use]
    pub fn at_corner(self, corner: UVec2) -> Self {
        Self { corner, ..self }
    }

    /// The frame as one of several samples that are averaged.
    #[must_use]
    pub fn with_sample(self, sample: u32, samples: u32) -> Self {
        Self {
            sample,
            samples,
            ..self
        }
    }

    /// The scene as this frame shows it: with its size, cells, exposure and time of the disk.
    pub fn shown(&self, scene: &Scene) -> Scene {
        let mut shown = scene.clone();
        let picture = &mut shown.picture;
        (picture.width, picture.height) = self.whole.into();
        (picture.grid_width, picture.grid_height) = self.cells.into();
        shown.picture.exposure_ev = self.exposure_ev;
        shown.picture.bypass = !scene.has_cells();
        shown.disk.time = self.disk_time;
        shown
    }
}
