//! Motion of the camera (by hand, by the guided journey, in free fall, on a ship) and of the disk.

mod camera_motions;
pub(crate) mod crossing;
pub(crate) mod disk_clock;
pub(crate) mod edge_view;
pub(crate) mod facing;
pub(crate) mod flight_step;
pub(crate) mod free_fall;
pub(crate) mod hand;
pub(crate) mod journey;
pub(crate) mod journey_player;
pub(crate) mod kiosk;
pub(crate) mod lesson;
pub(crate) mod orbit_camera;
pub(crate) mod pause;
pub(crate) mod pilot;
mod pose;
pub(crate) mod ship;
pub(crate) mod steering;
pub(crate) mod stops;
pub(crate) mod zoom;
