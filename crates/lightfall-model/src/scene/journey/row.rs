//! One row of a camera path.

use super::format::MAX_SECONDS;
use super::read_path::{Header, PathFault};
use super::tracks::may_reach_light;
use crate::geometry::sphere::nearest_turn;
use crate::scene::fields::field;
use crate::scene::value::{Value, quoted, shortened};
use crate::scene::{Camera, ObserverKind};
use glam::{DMat3, DQuat, DVec3};

/// The largest number of a frame: nine digits, as in the names of pictures.
const MAX_FRAME: u32 = 999_999_999;

/// How far the length of a quaternion may be from 1: programs write a few digits, and a quaternion that is
/// farther away is something else.
const MAX_STRETCH: f64 = 0.01;

/// One row: where the camera is at a time. What is `None` has no column.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    /// Its line in the text, from 1.
    pub(super) line: usize,
    /// In seconds after the journey's beginning.
    pub(super) time: f64,
    pub(super) r: f64,
    pub(super) theta_deg: f64,
    /// Of any number of turns, as are the yaw and the roll.
    pub(super) phi_deg: f64,
    /// Yaw, pitch and roll, in degrees.
    pub(super) angles: [f64; 3],
    pub(super) fov_deg: Option<f64>,
    pub(super) kind: Option<ObserverKind>,
    pub(super) velocity: Option<[f64; 3]>,
    pub(super) disk_time: Option<f64>,
    pub(super) exposure_ev: Option<f64>,
}

impl Row {
    /// Reads the row of this line, after the row `before`. Frames last 1/`fps` seconds.
    pub(super) fn read(
        header: &Header,
        (line, text): (usize, &str),
        fps: f64,
        before: Option<&Self>,
    ) -> Result<Self, PathFault> {
        let cells = Cells {
            header,
            fields: header.fields(text)?,
        };
        let time = cells.time(fps, before.map(|row| row.time))?;
        let mut camera = cells.place(before)?;
        let phi_deg = camera.phi_deg;
        let angles = if header.has("yaw_deg") {
            [
                cells.number("yaw_deg")?,
                cells.number("pitch_deg")?,
                cells.number("roll_deg")?,
            ]
        } else if header.has("qw") {
            cells.turn(&mut camera)?;
            let [yaw, pitch, roll] = camera.angles();
            match before.map(|row| row.angles) {
                Some([last_yaw, _, last_roll]) => {
                    let yaw = nearest_turn(yaw, last_yaw);
                    [yaw, pitch, nearest_turn(roll, last_roll)]
                }
                None => [yaw, pitch, roll],
            }
        } else {
            [0.0; 3]
        };
        let velocity = if header.has("vx") {
            let before = before.and_then(|row| row.velocity);
            Some(cells.velocity(before)?)
        } else {
            None
        };
        Ok(Self {
            line,
            time,
            r: camera.r,
            theta_deg: camera.theta_deg,
            phi_deg,
            angles,
            fov_deg: cells.of_field("fov_deg", "camera.fov_deg")?,
            kind: cells.kind()?,
            velocity,
            disk_time: cells.of_field("disk_time", "disk.time")?,
            exposure_ev: cells.of_field("exposure_ev", "picture.exposure_ev")?,
        })
    }
}

/// The fields of one line, by their columns.
struct Cells<'a> {
    header: &'a Header,
    fields: Vec<&'a str>,
}

impl Cells<'_> {
    /// The text of a column that the header has.
    fn text(&self, column: &str) -> &str {
        let place = self.header.place(column);
        place.map_or("", |place| self.fields[place])
    }

    fn refused(&self, column: &str, allowed: impl Into<String>) -> PathFault {
        let text = self.text(column);
        PathFault::Value {
            column: column.into(),
            given: match text.parse::<f64>() {
                Ok(_) => shortened(text),
                Err(_) => quoted(text),
            },
            allowed: allowed.into(),
        }
    }

    /// The fault of columns that belong together.
    fn refused_together(&self, columns: &[&str], allowed: String) -> PathFault {
        let given: Vec<String> = columns
            .iter()
            .map(|column| shortened(self.text(column)))
            .collect();
        PathFault::Value {
            column: columns.join(","),
            given: given.join(","),
            allowed,
        }
    }

    fn number(&self, column: &str) -> Result<f64, PathFault> {
        let number = self.text(column).parse().ok();
        number
            .filter(|number: &f64| number.is_finite())
            .ok_or_else(|| self.refused(column, "a finite number"))
    }

    /// A number that the field with this key could have; none without the column.
    fn of_field(&self, column: &str, key: &str) -> Result<Option<f64>, PathFault> {
        if !self.header.has(column) {
            return Ok(None);
        }
        let Some(field) = field(key) else {
            return self.number(column).map(Some);
        };
        let number = self.text(column).parse().ok();
        number
            .filter(|number: &f64| field.kind.range().contains(*number))
            .map(Some)
            .ok_or_else(|| self.refused(column, field.allowed()))
    }

    /// The time, in seconds, which comes after that of the row before.
    fn time(&self, fps: f64, before: Option<f64>) -> Result<f64, PathFault> {
        let later = |time: f64| before.is_none_or(|before| time > before);
        if self.header.has("time_s") {
            let time = self.number("time_s")?;
            return if !(0.0..=MAX_SECONDS).contains(&time) {
                Err(self.refused(
                    "time_s",
                    format!("a number of seconds from 0 to {MAX_SECONDS}"),
                ))
            } else if !later(time) {
                Err(self.refused("time_s", "above the time of the row before"))
            } else {
                Ok(time)
            };
        }
        let frame: Option<u32> = self.text("frame").parse().ok();
        let Some(frame) = frame.filter(|frame| *frame <= MAX_FRAME) else {
            return Err(self.refused(
                "frame",
                format!("a whole number of a frame, from 0 to {MAX_FRAME}"),
            ));
        };
        let time = f64::from(frame) / fps;
        if time > MAX_SECONDS {
            let allowed = format!(
                "within {MAX_SECONDS} seconds after the beginning, at {fps} frames a second"
            );
            return Err(self.refused("frame", allowed));
        }
        if !later(time) {
            return Err(self.refused("frame", "above the number of the row before"));
        }
        Ok(time)
    }

    /// A camera at the row's place.
    fn place(&self, before: Option<&Row>) -> Result<Camera, PathFault> {
        let mut camera = Camera::default();
        if self.header.has("r") {
            let [r, theta_deg] = [("r", "camera.r"), ("theta_deg", "camera.theta_deg")]
                .map(|(column, key)| self.of_field(column, key));
            camera.r = r?.unwrap_or_default();
            camera.theta_deg = theta_deg?.unwrap_or_default();
            camera.phi_deg = self.number("phi_deg")?;
            return Ok(camera);
        }
        const COLUMNS: [&str; 3] = ["x", "y", "z"];
        let [x, y, z] = COLUMNS.map(|column| self.number(column));
        let place = DVec3::new(x?, y?, z?);
        let r = place.length();
        let range = field("camera.r").filter(|field| !field.kind.range().contains(r));
        if let Some(field) = range {
            let allowed = format!("a place whose r is {}", field.allowed());
            return Err(self.refused_together(&COLUMNS, allowed));
        }
        camera.r = r;
        camera.theta_deg = place.truncate().length().atan2(place.z).to_degrees();
        // On the axis every azimuth is the same place.
        let before = before.map(|row| row.phi_deg);
        camera.phi_deg = if place.x == 0.0 && place.y == 0.0 {
            before.unwrap_or_default()
        } else {
            let phi_deg = place.y.atan2(place.x).to_degrees();
            before.map_or(phi_deg, |before| nearest_turn(phi_deg, before))
        };
        Ok(camera)
    }

    /// Turns the camera as the row's quaternion says: that of a camera with x to the right and y up, which
    /// looks along -z.
    fn turn(&self, camera: &mut Camera) -> Result<(), PathFault> {
        const COLUMNS: [&str; 4] = ["qw", "qx", "qy", "qz"];
        let [w, x, y, z] = COLUMNS.map(|column| self.number(column));
        let turn = DQuat::from_xyzw(x?, y?, z?, w?);
        if (turn.length() - 1.0).abs() > MAX_STRETCH {
            return Err(self.refused_together(&COLUMNS, "a quaternion of length 1".into()));
        }
        let axes = DMat3::from_quat(turn.normalize());
        let world = DMat3::from_cols(axes.x_axis, axes.y_axis, -axes.z_axis);
        camera.set_orientation(camera.tetrad().transpose() * world);
        Ok(())
    }

    fn kind(&self) -> Result<Option<ObserverKind>, PathFault> {
        if !self.header.has("observer") {
            return Ok(None);
        }
        let kind = ObserverKind::from_word(self.text("observer"));
        let allowed = || format!("one of {}", ObserverKind::WORDS.join(", "));
        kind.map(Some)
            .ok_or_else(|| self.refused("observer", allowed()))
    }

    /// The velocity. On the way from the row before, too, it must be below that of light.
    fn velocity(&self, before: Option<[f64; 3]>) -> Result<[f64; 3], PathFault> {
        const COLUMNS: [&str; 3] = ["vx", "vy", "vz"];
        let [x, y, z] = COLUMNS.map(|column| self.number(column));
        let velocity = [x?, y?, z?];
        let refused = |allowed: String| self.refused_together(&COLUMNS, allowed);
        if let Some(field) = field("observer.velocity")
            && field.check_kind(&Value::Velocity(velocity)).is_err()
        {
            return Err(refused(field.allowed()));
        }
        if may_reach_light(before.unwrap_or_default(), velocity) {
            return Err(refused(
                "nearer to that of the row before: on the way there it would reach 1 c".into(),
            ));
        }
        Ok(velocity)
    }
}
