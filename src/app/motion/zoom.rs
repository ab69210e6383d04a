//! The field of view: keys make it narrower and wider while they are held, and two fingers pinch it.

use super::orbit_camera::OrbitCamera;
use crate::app::controls::control::FlightInput;
use crate::app::input::held::HeldControls;
use crate::app::input::touch::{Fingers, read_fingers};
use crate::app::state::MAX_FRAME_SECONDS;
use crate::app::state::scene_editor::SceneEditor;
use bevy::prelude::*;
use lightfall_core::scene::{Camera, Projection};

/// The field of view, in degrees, that keys and fingers reach. The panel sets any other.
const FIELDS_OF_VIEW_DEG: [f64; 2] = [5.0, 120.0];
/// The same of a fisheye picture.
const FISHEYES_DEG: [f64; 2] = [30.0, 360.0];
/// The angle that a pixel covers changes by this power of e in a second.
const ZOOM_SPEED: f64 = 0.9;

/// The camera's field of view, in degrees, after zooming by a power of e: positive is wider. A field of view
/// beyond the range stays where it is, unless it comes nearer to the range. `None` where the picture shows
/// the whole sky.
#[must_use]
pub fn zoomed(camera: &Camera, power: f64) -> Option<f64> {
    let [narrowest, widest] = match camera.projection {
        Projection::Fisheye => FISHEYES_DEG,
        _ => FIELDS_OF_VIEW_DEG,
    };
    let field_deg = camera.field_deg()?;
    let wide = camera.widened_fov_deg(power.exp())?;
    Some(wide.clamp(narrowest.min(field_deg), widest.max(field_deg)))
}

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, zoom.after(read_fingers));
}

/// The keys and the fingers zoom. With the orbit camera, fingers change the distance instead.
fn zoom(
    held: HeldControls,
    fingers: Res<Fingers>,
    orbit: Res<OrbitCamera>,
    time: Res<Time>,
    mut editor: SceneEditor,
) {
    let seconds = time.delta_secs_f64().min(MAX_FRAME_SECONDS);
    let keys = held.axis(FlightInput::Wider, FlightInput::Narrower) * ZOOM_SPEED * seconds;
    let spread = if orbit.is_on() { 0.0 } else { fingers.spread };
    let power = keys - spread;
    if power == 0.0 {
        return;
    }
    let mut next = editor.scene();
    let Some(field_deg) = zoomed(&next.camera, power) else {
        editor.say("The picture shows the whole sky");
        return;
    };
    next.camera.set_field_deg(field_deg);
    match editor.try_change(next) {
        Ok(()) => editor.say(format!("Field of view: {field_deg:.0}°")),
        Err(reason) => editor.say(reason),
    }
}
