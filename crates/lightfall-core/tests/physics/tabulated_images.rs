//! Images of stars in f64, by an independent tracer that agrees with another one to 1e-10.

use glam::DVec3;
use lightfall_core::geometry::sphere::celestial_frame;
use lightfall_core::scene::{ObserverKind, Scene};

/// A star's image in a scene that does not yet look at it.
#[derive(Clone)]
pub struct TabulatedImage {
    pub scene: Scene,
    /// The direction of the star in the hole's frame.
    pub star: DVec3,
    /// The direction of the image on the observer's axes.
    pub direction: DVec3,
    /// 1/E of the light per unit frequency.
    pub shift: f64,
    pub magnification: f64,
}

/// A scene of the table: spin, observer, velocity, r and theta.
type Place = (f64, ObserverKind, [f64; 3], f64, f64);

/// A place, a star (Boyer-Lindquist theta and phi in degrees; the camera is at phi = 0), the
/// directions and magnifications of its images, and 1/E of each.
type Row = (Place, [f64; 2], &'static [([f64; 3], f64)], &'static [f64]);

const ROWS: [Row; 6] = [
    (
        (0.0, ObserverKind::Static, [0.0; 3], 20.0, 83.0),
        [100.0, 170.0],
        &[
            ([-0.90315292, 0.12962113, 0.40928373], 1.37942),
            ([-0.95920284, -0.08535920, -0.26952497], 0.477478),
        ],
        &[1.02597835, 1.02597835],
    ),
    (
        (0.9, ObserverKind::Static, [0.0; 3], 20.0, 83.0),
        [100.0, 170.0],
        &[
            ([-0.89891347, 0.14322530, 0.41405446], 1.48225),
            ([-0.96374396, -0.09851016, -0.24797848], 0.594890),
        ],
        &[1.02597815, 1.02597815],
    ),
    (
        (0.9, ObserverKind::Static, [0.0; 3], 20.0, 83.0),
        [60.0, 250.0],
        &[
            ([-0.17271828, -0.53841840, -0.82478726], 0.950674),
            ([-0.98393023, 0.09027164, 0.15405305], 0.00519132),
        ],
        &[1.02597815, 1.02597815],
    ),
    (
        (0.998, ObserverKind::Zamo, [0.0; 3], 5.0, 75.0),
        [100.0, 170.0],
        &[
            ([-0.62494039, -0.60941759, 0.48791363], 2.73903),
            ([-0.77375790, 0.58274927, -0.24839887], 2.14299),
        ],
        &[1.12948252, 1.11177241],
    ),
    (
        (0.9, ObserverKind::Static, [0.3, 0.0, 0.6], 10.0, 60.0),
        [100.0, 170.0],
        &[
            ([-0.28755983, -0.48330540, 0.82687680], 0.693478),
            ([-0.65730712, 0.41243496, 0.63074936], 0.310359),
        ],
        &[1.32462044, 0.95477390],
    ),
    (
        (0.0, ObserverKind::Rain, [0.0; 3], 0.6, 80.0),
        [60.0, 40.0],
        &[([0.22810336, -0.54616563, 0.80602231], 1.68421)],
        &[0.77251087],
    ),
];

/// The tabulated images in a scene, with its spin, place and motion of the table.
pub fn tabulated_images(scene: &Scene) -> Vec<TabulatedImage> {
    let mut all = vec![];
    for ((spin, kind, velocity, r, theta_deg), star, images, shifts) in ROWS {
        let mut scene = scene.clone();
        scene.hole.spin = spin;
        (scene.observer.kind, scene.observer.velocity) = (kind, velocity);
        (scene.camera.r, scene.camera.theta_deg, scene.camera.phi_deg) = (r, theta_deg, 0.0);
        let [star, ..] = celestial_frame(star[0].to_radians(), star[1].to_radians());
        for ((direction, magnification), shift) in images.iter().zip(shifts) {
            all.push(TabulatedImage {
                scene: scene.clone(),
                star,
                direction: DVec3::from_array(*direction),
                shift: *shift,
                magnification: *magnification,
            });
        }
    }
    all
}
