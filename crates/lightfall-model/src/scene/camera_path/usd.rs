//! A camera path as a camera in USD, in the text form .usda.
//!
//! Attributes as in USD's documentation of UsdGeomCamera and UsdGeomXformable: a matrix is applied to row
//! vectors, so its first three rows are the camera's axes right, up and back, and the fourth one is its
//! place.

use super::{CameraPath, Station, number, pose, shift};
use glam::{DVec2, DVec3};
use std::io::{self, Write};

/// Height of the camera's film, in tenths of a unit, as focal lengths are. Only their ratio counts.
const FILM_HEIGHT: f64 = 0.24;

/// Nearest and farthest thing that the camera shows, in units. The second one reaches beyond the hole from
/// wherever the camera is.
const NEAR: f64 = 0.01;
const FAR: f64 = 1e5;
const FAR_PER_R: f64 = 10.0;

impl CameraPath {
    /// Writes the path as USD: a camera under /World whose transform and focal length have a value in each
    /// frame. A unit of length is r_s, and z is up. A shift of the picture moves the film the other way.
    ///
    /// # Errors
    /// `out` cannot be written.
    pub fn write_usd(&self, out: &mut impl Write) -> io::Result<()> {
        let frame = |station: Option<&Station>| station.map_or(0, |station| station.frame);
        let [start, end] = [self.stations.first(), self.stations.last()].map(frame);
        let fps = self.fps;
        let radii = self.stations.iter().map(|station| station.camera.r);
        let far = radii.fold(FAR, |far, r| far.max(FAR_PER_R * r));
        let width = FILM_HEIGHT * self.aspect;
        write!(
            out,
            "#usda 1.0
(
    defaultPrim = \"World\"
    doc = \"Camera path by Lightfall. A unit is the Schwarzschild radius of the hole, which is at the origin with its \
             spin along z.\"
    endTimeCode = {end}
    framesPerSecond = {fps}
    metersPerUnit = 1
    startTimeCode = {start}
    timeCodesPerSecond = {fps}
    upAxis = \"Z\"
)

def Xform \"World\"
{{
    def Camera \"camera\"
    {{
        float2 clippingRange = ({NEAR}, {far})
        token projection = \"perspective\"
        float horizontalAperture = {width}
        float verticalAperture = {FILM_HEIGHT}
"
        )?;
        self.write_samples(out, "float focalLength", |station| {
            let half = 0.5 * station.camera.fov_deg.to_radians();
            number(0.5 * FILM_HEIGHT / half.tan())
        })?;
        let is_shifted = |station: &Station| shift(&station.camera) != DVec2::ZERO;
        if self.stations.iter().any(is_shifted) {
            self.write_samples(out, "float horizontalApertureOffset", |station| {
                number(-FILM_HEIGHT * shift(&station.camera).x)
            })?;
            self.write_samples(out, "float verticalApertureOffset", |station| {
                number(-FILM_HEIGHT * shift(&station.camera).y)
            })?;
        }
        self.write_samples(out, "matrix4d xformOp:transform", |station| {
            let (place, axes) = pose(&station.camera);
            let row = |v: DVec3, last: u32| {
                format!(
                    "({}, {}, {}, {last})",
                    number(v.x),
                    number(v.y),
                    number(v.z)
                )
            };
            let rows = [
                row(axes.x_axis, 0),
                row(axes.y_axis, 0),
                row(axes.z_axis, 0),
                row(place, 1),
            ];
            format!("( {} )", rows.join(", "))
        })?;
        write!(
            out,
            "        uniform token[] xformOpOrder = [\"xformOp:transform\"]
    }}
}}
"
        )
    }

    /// Writes the value of an attribute in each frame.
    fn write_samples(
        &self,
        out: &mut impl Write,
        attribute: &str,
        value: impl Fn(&Station) -> String,
    ) -> io::Result<()> {
        writeln!(out, "        {attribute}.timeSamples = {{")?;
        for station in &self.stations {
            writeln!(out, "            {}: {},", station.frame, value(station))?;
        }
        writeln!(out, "        }}")
    }
}
