//! What the window program remembers: the scene's history and the way to change the scene, the
//! settings, which overlays are open, and messages to the user. Nothing here reads a device, and
//! nothing draws.

pub(crate) mod disk_clock;
pub(crate) mod end_card;
pub(crate) mod file_opener;
pub(crate) mod helm;
pub(crate) mod history;
pub(crate) mod hole_in_view;
pub(crate) mod kiosk;
pub(crate) mod kiosk_round;
pub(crate) mod lesson_draft;
pub(crate) mod lesson_results;
pub(crate) mod lessons;
pub(crate) mod light_meter;
pub(crate) mod menu;
pub(crate) mod mission_results;
pub(crate) mod missions;
pub(crate) mod notice;
pub(crate) mod overlays;
pub(crate) mod paused;
pub(crate) mod preferences;
pub(crate) mod preset_row;
pub(crate) mod rebinding;
pub(crate) mod resolution;
pub(crate) mod result_file;
pub(crate) mod scene_editor;
pub(crate) mod settings;
pub(crate) mod settings_fault;
pub(crate) mod shown_picture;
pub(crate) mod sound;
pub(crate) mod title;
pub(crate) mod toast;
pub(crate) mod typed_answer;
pub(crate) mod view_point;
pub(crate) mod window_shot;

use std::time::Duration;

/// How long words over the picture take to appear and to go away.
pub(crate) const FADE: Duration = Duration::from_millis(400);

/// Maximum time, in seconds, that counts for one frame. A slower frame moves the camera and the disk
/// no farther, so that the camera stays steerable on slow machines, and nothing moves while the
/// machine sleeps.
pub(crate) const MAX_FRAME_SECONDS: f64 = 0.25;
