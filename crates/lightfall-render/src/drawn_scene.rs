//! The scene that was chosen, the frame that is drawn of it, and the two together, which is what
//! the passes read.

use crate::given_light::GivenLight;
use bevy::app::MainScheduleOrder;
use bevy::ecs::schedule::ScheduleLabel;
use bevy::prelude::*;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Frame, Part, Projection};

/// The scene as it was last chosen or flown: at its own size, with the exposure and the time of the
/// disk that it was chosen with.
#[derive(Resource, Clone, Deref, PartialEq)]
pub struct CurrentScene(pub Drawable);

/// What is drawn of the current scene: its size, its cells, its exposure and the disk's time.
#[derive(Resource, Clone, Copy, Deref, PartialEq)]
pub struct CurrentFrame(pub Frame);

/// The current scene in its frame. [`draw_scene_in_frame`] alone writes it.
#[derive(Resource, Clone, Deref, ExtractResource, PartialEq)]
pub struct DrawnScene(Drawable);

/// Pixels around a part of a picture that are drawn with it, because the search for edges looks at a
/// pixel's neighbours. An even number keeps the origin of what is drawn even.
const APRON: u32 = 2;

/// The part of the picture that is drawn; all of it by default. [`draw_scene_in_frame`] alone writes it.
#[derive(Resource, Clone, Copy, Debug, Default, ExtractResource, PartialEq)]
pub struct DrawnPart(Option<Parts>);

/// A part of a picture, and the larger one that is drawn to get it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Parts {
    wanted: Part,
    drawn: Part,
    /// The upper left corner of the wanted part within the drawn one.
    inset: UVec2,
}

impl DrawnPart {
    /// The part of a frame, with an apron where its light is not given. The apron ends at the edges of
    /// the picture, unless its columns go around.
    fn of(frame: &Frame, projection: Projection, apron: u32) -> Self {
        Self(frame.part().map(|wanted| {
            let mut origin = wanted.origin.saturating_sub(UVec2::splat(apron));
            let mut inset = wanted.origin - origin;
            let end = (wanted.origin + wanted.size + apron).min(frame.whole);
            let mut size = end - origin;
            if projection.goes_around() {
                let columns = frame.whole.x.max(1);
                origin.x = (wanted.origin.x + columns - apron % columns) % columns;
                (inset.x, size.x) = (apron, wanted.size.x + 2 * apron);
            }
            Parts {
                wanted,
                drawn: Part { origin, size },
                inset,
            }
        }))
    }

    /// The part that is drawn, with its apron; `None` for the whole picture.
    pub(super) fn drawn(&self) -> Option<Part> {
        self.0.map(|parts| parts.drawn)
    }

    /// The part that was asked for; `None` for the whole picture.
    pub(super) fn wanted(&self) -> Option<Part> {
        self.0.map(|parts| parts.wanted)
    }

    /// The place in the whole picture of the first pixel that is drawn: left of the first column where
    /// the columns go around.
    pub(super) fn first_pixel(&self) -> IVec2 {
        self.0.map_or(IVec2::ZERO, |parts| {
            parts.wanted.origin.as_ivec2() - parts.inset.as_ivec2()
        })
    }

    /// Where the part that was asked for lies in the target, which has this size in pixels.
    pub(super) fn in_target(&self, size: UVec2) -> Part {
        self.0
            .map_or(Part::whole(size), |Parts { wanted, inset, .. }| Part {
                origin: inset,
                size: wanted.size,
            })
    }
}

/// The schedule between `Update`, in which the scene changes, and `PostUpdate`, in which it is
/// prepared for the passes. The frame is written here.
#[derive(ScheduleLabel, Clone, Debug, PartialEq, Eq, Hash)]
pub struct FrameScene;

/// Begins with a scene in its own frame.
pub(super) fn insert(app: &mut App, scene: Drawable) {
    app.insert_resource(CurrentFrame(Frame::of(&scene)))
        .insert_resource(DrawnScene(scene.clone()))
        .insert_resource(CurrentScene(scene))
        .init_resource::<DrawnPart>()
        .add_plugins((
            ExtractResourcePlugin::<DrawnScene>::default(),
            ExtractResourcePlugin::<DrawnPart>::default(),
        ))
        .init_schedule(FrameScene)
        .add_systems(FrameScene, draw_scene_in_frame);
    app.world_mut()
        .resource_mut::<MainScheduleOrder>()
        .insert_after(Update, FrameScene);
}

/// Makes the scene that the passes read. Systems that write the frame come before.
pub fn draw_scene_in_frame(
    scene: Res<CurrentScene>,
    (frame, given): (Res<CurrentFrame>, Res<GivenLight>),
    (mut drawn, mut part): (ResMut<DrawnScene>, ResMut<DrawnPart>),
) {
    if scene.is_changed() || frame.is_changed() || given.is_changed() {
        drawn.set_if_neq(DrawnScene(scene.shown_in(&frame)));
        let apron = if given.is_some() { 0 } else { APRON };
        let projection = scene.camera.projection;
        part.set_if_neq(DrawnPart::of(&frame, projection, apron));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lightfall_core::scene::Scene;

    /// The margin of a part ends at the edges of the picture. Where columns go around it does not, also
    /// for a part as wide as the picture.
    #[test]
    fn a_part_has_a_margin_on_the_other_side_of_the_whole_sky() {
        let frame = Frame::of(&Scene::default()).with_whole(UVec2::new(16, 8));
        let part = |[x, y, width, height]: [u32; 4]| Part {
            origin: UVec2::new(x, y),
            size: UVec2::new(width, height),
        };
        let (flat, around) = (Projection::Perspective, Projection::Equirectangular);
        for (wanted, projection, drawn, first_pixel, inset) in [
            ([0, 2, 8, 4], flat, [0, 0, 10, 8], [0, 0], [0, 2]),
            ([0, 2, 8, 4], around, [14, 0, 12, 8], [-2, 0], [2, 2]),
            ([8, 0, 8, 4], around, [6, 0, 12, 6], [6, 0], [2, 0]),
            ([0, 4, 16, 4], around, [14, 2, 20, 6], [-2, 2], [2, 2]),
        ] {
            let frame = frame.with_part(Some(part(wanted)));
            let seen = DrawnPart::of(&frame, projection, APRON);
            assert_eq!(seen.drawn(), Some(part(drawn)), "{wanted:?}");
            assert_eq!(seen.first_pixel(), IVec2::from(first_pixel), "{wanted:?}");
            assert_eq!(seen.in_target(UVec2::ZERO).origin, UVec2::from(inset));
        }
    }
}
