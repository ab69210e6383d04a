//! A camera path as a table.

use super::{COLUMNS, CameraPath, Station, number, pose};
use std::io::{self, Write};

impl CameraPath {
    /// Writes the path as CSV: a line of column names, and a row for each picture. Every number has the
    /// digits from which it can be read back exactly.
    ///
    /// # Errors
    /// `out` cannot be written.
    pub fn write_csv(&self, out: &mut impl Write) -> io::Result<()> {
        writeln!(out, "{}", COLUMNS.join(","))?;
        for station in &self.stations {
            self.write_row(station, out)?;
        }
        Ok(())
    }

    fn write_row(&self, station: &Station, out: &mut impl Write) -> io::Result<()> {
        let Station {
            frame,
            camera,
            turn,
            observer,
            disk_time,
            exposure_ev,
        } = station;
        let (place, _) = pose(camera);
        let before = [
            f64::from(*frame) / self.fps,
            camera.r,
            camera.theta_deg,
            camera.phi_deg,
            camera.yaw_deg,
            camera.pitch_deg,
            camera.roll_deg,
            camera.fov_deg,
            place.x,
            place.y,
            place.z,
            turn.w,
            turn.x,
            turn.y,
            turn.z,
        ];
        let [vx, vy, vz] = observer.velocity;
        let after = [vx, vy, vz, *disk_time, *exposure_ev];
        writeln!(
            out,
            "{frame},{},{},{}",
            listed(&before),
            observer.kind.word(),
            listed(&after)
        )
    }
}

/// Numbers with commas between them.
fn listed(numbers: &[f64]) -> String {
    let texts: Vec<String> = numbers.iter().map(|x| number(*x)).collect();
    texts.join(",")
}
