//! What a scene's camera sees, in f64: camera rays, null geodesics, the disk, frequency shifts and
//! the spectrum. The shaders are measured against these functions. The ship and what its cockpit
//! sounds like are here, too.
//!
//! Every photon is the physical, future-directed one, with E = -p_t, L = p_phi and Carter's Q per
//! unit frequency for the camera. Rays are followed backward from the camera.

pub mod apparent_hole;
pub mod camera_rays;
pub mod critical_curve;
pub mod cube_map;
pub mod delay;
pub mod disk;
pub mod echo;
pub mod exposure;
pub mod guides;
pub mod hot_spot;
pub mod limb;
pub mod lut;
pub mod medium;
pub mod milky_way;
pub mod path;
pub mod photometry;
pub mod pixel_samples;
pub mod ray_plane;
pub mod readout;
pub mod reference;
pub mod shift;
pub mod ship;
pub mod sky_picture;
pub mod sound;
pub mod spectrum;
pub mod stars;
pub mod straight;
pub mod structure;
pub mod synchrotron;
pub mod trace;
pub mod worldline;
