//! Keeps the window's picture, and compares the frames after the key for more light with it.

use crate::orders::Orders;
use bevy::diagnostic::FrameCount;
use bevy::prelude::*;
use bevy::render::view::window::screenshot::{Screenshot, ScreenshotCaptured};
use watched::Order;

/// The frames that are compared: the one in which the key comes, and those after it.
const COMPARED: u32 = 4;
/// The rows that are compared, as shares of the window's height: those without title and texts.
const ROWS: [f64; 2] = [0.11, 0.62];

/// What the window showed, and whether the frames after the key differ from it.
#[derive(Resource, Default)]
pub struct KeptPicture {
    before: Option<Vec<u8>>,
    pressed: Option<u32>,
    differs: Vec<(u32, bool)>,
}

impl KeptPicture {
    /// Whether each frame after the key differs, once the picture is kept.
    pub fn differs(&self) -> Option<Vec<bool>> {
        self.before.as_ref()?;
        let mut differs = self.differs.clone();
        differs.sort_unstable();
        Some(differs.into_iter().map(|(_, differs)| differs).collect())
    }
}

pub fn plugin(app: &mut App) {
    app.init_resource::<KeptPicture>()
        .add_systems(Update, compare_frames);
}

fn compare_frames(
    mut commands: Commands,
    orders: Res<Orders>,
    keys: Res<ButtonInput<KeyCode>>,
    frame: Res<FrameCount>,
    mut kept: ResMut<KeptPicture>,
) {
    let ordered = |order| matches!(order, &Order::KeepPicture);
    if orders.new.iter().any(ordered) {
        commands.spawn(Screenshot::primary_window()).observe(
            |shot: On<ScreenshotCaptured>, mut kept: ResMut<KeptPicture>| {
                kept.before = rows(&shot.image);
            },
        );
    }
    if kept.before.is_some() && keys.just_pressed(KeyCode::Equal) {
        kept.pressed = Some(frame.0);
    }
    let later = kept.pressed.map(|pressed| frame.0 - pressed);
    if let Some(later) = later.filter(|later| *later < COMPARED) {
        commands.spawn(Screenshot::primary_window()).observe(
            move |shot: On<ScreenshotCaptured>, mut kept: ResMut<KeptPicture>| {
                let differs = rows(&shot.image) != kept.before;
                kept.differs.push((later, differs));
            },
        );
    }
}

/// The compared rows of a screenshot.
fn rows(image: &Image) -> Option<Vec<u8>> {
    let bytes = image.data.as_ref()?;
    let height = image.height() as usize;
    let [top, bottom] = ROWS.map(|share| (share * height as f64) as usize);
    let row = bytes.len() / height;
    Some(bytes[row * top..row * bottom].to_vec())
}
