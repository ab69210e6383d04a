//! What a field is where nobody sets it.

use super::{
    Camera, Disk, DiskModel, Effects, Hole, Method, Observer, ObserverKind, Picture, Probe,
    Quality, SCHEMA, Scene, Sky, SkyMode, View,
};

impl Default for Scene {
    fn default() -> Self {
        Self {
            schema: SCHEMA,
            name: "unnamed".into(),
            title: String::new(),
            method: Method::default(),
            view: View::default(),
            hole: Hole::default(),
            camera: Camera::default(),
            observer: Observer::default(),
            effects: Effects::default(),
            disk: Disk::default(),
            sky: Sky::default(),
            probe: Probe::default(),
            picture: Picture::default(),
            quality: Quality::default(),
        }
    }
}

impl Default for Hole {
    fn default() -> Self {
        Self { spin: 0.0 }
    }
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            r: 20.0,
            theta_deg: 80.0,
            phi_deg: 0.0,
            fov_deg: 60.0,
            yaw_deg: 0.0,
            pitch_deg: 0.0,
            roll_deg: 0.0,
        }
    }
}

impl Default for Observer {
    fn default() -> Self {
        Self {
            kind: ObserverKind::Static,
            velocity: [0.0; 3],
        }
    }
}

impl Default for Effects {
    fn default() -> Self {
        Self {
            lensing: true,
            doppler: true,
            beaming: true,
            gravitational_shift: true,
            aberration: true,
        }
    }
}

impl Default for Disk {
    fn default() -> Self {
        Self {
            enabled: true,
            inner: 3.0,
            follow_isco: false,
            outer: 11.0,
            model: DiskModel::Newtonian,
            temperature_k: 18_000.0,
            brightness: 1.0,
            edge_taper: 0.03,
            transmission: 0.04,
        }
    }
}

impl Default for Sky {
    fn default() -> Self {
        Self {
            mode: SkyMode::Stars,
            seed: 1,
            brightness: 1.0,
            reference_star: false,
            reference_theta_deg: 90.0,
            reference_phi_deg: 180.0,
        }
    }
}

impl Default for Probe {
    fn default() -> Self {
        Self {
            enabled: false,
            r: 20.0,
            theta_deg: 80.0,
            phi_deg: 0.0,
            size: 0.2,
            antialias: false,
        }
    }
}

impl Default for Picture {
    fn default() -> Self {
        Self {
            width: 960,
            height: 540,
            grid_width: 480,
            grid_height: 270,
            exposure_ev: 1.2,
            bloom: 0.08,
            levels: 24,
            dither: true,
            bypass: false,
        }
    }
}

impl Default for Quality {
    fn default() -> Self {
        Self {
            max_error_px: 0.05,
            step_scale: 0.85,
            max_steps: 768,
            max_affine: 2000.0,
        }
    }
}
