//! A journey: a guided flight through keyframes in time, applied to a scene. Plain data and its
//! interpolation.
//!
//! Every quantity has a track of its own through the keyframes that name it. A track is a monotone
//! cubic (Fritsch & Carlson 1980), so positions and speeds are continuous, nothing overshoots, and
//! the flight begins and ends at rest. Radii are interpolated in their logarithm. A quantity that
//! no keyframe names keeps its value in the scene. A keyframe's `ease` chooses another curve up to the next
//! keyframe, and its table `set` leads other fields of the scene.
//!
//! A camera path, a table of rows in CSV, is a journey, too.

mod camera_rows;
mod caption;
mod check;
mod clock;
mod draft;
mod ease;
mod error;
mod field_tracks;
mod format;
mod idle;
mod keyframe;
mod lessons;
mod load;
mod read_path;
mod read_question;
mod read_stop;
mod row;
mod save;
mod set;
mod stop;
mod subtitles;
mod switches;
mod track;
mod tracks;

pub use caption::Caption;
pub use check::Unflyable;
pub use draft::{Draft, Shown};
pub use ease::Ease;
pub use error::JourneyError;
pub use lessons::{FLIGHTS, LESSONS, built_in, is_journey};
pub use load::load;
pub use read_path::{CameraPathError, load_camera_path};
pub use stop::{InspectorView, SideBySide, Stop};
pub use subtitles::{SubtitleFormat, Subtitles};
pub use switches::Switches;
pub use track::Track;

use self::camera_rows::CameraRows;
use self::clock::Clock;
use self::field_tracks::FieldTracks;
use self::keyframe::Keyframe;
use self::tracks::Tracks;
use super::presets::{DEFAULT as DEFAULT_PRESET, PRESETS, Preset};
use super::{Camera, ObserverKind, Question, Scene};
use crate::geometry::kerr::Kerr;
use crate::geometry::sphere::wrap_degrees;

/// The built-in journey, part of the program itself.
pub const DEFAULT: &str = include_str!("../../../../assets/journeys/default.toml");

/// A guided flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Journey {
    /// One line that says where the flight leads.
    pub title: String,
    /// What a teacher can show with it, in one line. Empty: nothing is said.
    pub teaches: String,
    /// What the card at the end says. Empty: the title alone.
    pub ending: String,
    /// The built-in preset in which the window flies it. None: the scene that is shown.
    pub preset: Option<&'static Preset>,
    /// What to say about it on the way, in order of time.
    pub captions: Vec<Caption>,
    /// The moments at which it waits in the window, in order of time.
    pub stops: Vec<Stop>,
    /// Seconds from the first keyframe to the last.
    pub duration: f64,
    keyframes: Vec<Keyframe>,
    tracks: Tracks,
    /// The tracks for an observer that falls from rest at infinity.
    tracks_in_rain: Tracks,
    /// The fields that the tables `set` of keyframes lead.
    fields: FieldTracks,
    /// The rows of a camera path. None for a journey through keyframes.
    path: Option<CameraRows>,
    /// The kinds of observer, each with the time from which it holds.
    kinds: Vec<(f64, ObserverKind)>,
    /// What the keyframes say about the disk's clock.
    clock: Clock,
}

impl Journey {
    /// A journey without a way and without words, which readers of journeys fill.
    fn empty() -> Self {
        Self {
            title: String::new(),
            teaches: String::new(),
            ending: String::new(),
            preset: None,
            captions: Vec::new(),
            stops: Vec::new(),
            duration: 0.0,
            keyframes: Vec::new(),
            tracks: Tracks::default(),
            tracks_in_rain: Tracks::default(),
            fields: FieldTracks::default(),
            path: None,
            kinds: Vec::new(),
            clock: Clock::default(),
        }
    }

    /// The caption to show after `time` seconds, if any: the last that has appeared, for as long as
    /// it stays.
    pub fn caption_at(&self, time: f64) -> Option<&Caption> {
        let appeared = self
            .captions
            .partition_point(|caption| caption.time <= time);
        let caption = &self.captions[appeared.checked_sub(1)?];
        (time < caption.time + caption.seconds).then_some(caption)
    }

    /// Writes what [`lead`](Self::lead) does after `time` seconds, and what the stops up to then
    /// switch, into `scene`.
    pub fn apply(&self, time: f64, scene: &mut Scene) {
        for stop in &self.stops[..self.stops_until(time)] {
            for (key, value) in &stop.fields {
                stop::write(scene, (key, value));
            }
        }
        self.lead(time, scene);
    }

    /// The time of each keyframe or row, in seconds as in the journey's text.
    fn times(&self) -> Vec<f64> {
        match &self.path {
            Some(path) => path.times().collect(),
            None => self.keyframes.iter().map(|frame| frame.time).collect(),
        }
    }

    /// When the journey begins, in seconds as in its text.
    fn start(&self) -> f64 {
        let first = self.keyframes.first();
        first.map_or(0.0, |frame| frame.time)
    }

    /// Everything that viewers read.
    pub fn texts(&self) -> Vec<&String> {
        let mut texts = vec![&self.title, &self.teaches, &self.ending];
        texts.extend(self.captions.iter().map(|caption| &caption.text));
        for stop in &self.stops {
            texts.push(&stop.caption);
            let question = stop.question.iter();
            texts.extend(question.flat_map(Question::texts));
        }
        texts
    }

    /// The preset in which the journey is flown where no other scene is shown: the one that it names, or the
    /// default one.
    pub fn stage(&self) -> &'static Preset {
        self.preset.unwrap_or(&PRESETS[DEFAULT_PRESET - 1])
    }

    /// Writes the camera, the observer, the disk's tilt, the rate of its clock and the fields that
    /// keyframes set after `time` seconds into `scene`. Times before the first keyframe count as the
    /// first, times after the last as the last. The scene is not checked.
    /// [`drive_clock`](Self::drive_clock) writes the disk's time.
    ///
    /// A circular orbit cannot leave its plane: unless the journey itself names an observer,
    /// `orbit` becomes `static`, as when flying by hand.
    ///
    /// While the observer is `rain`, the keyframes give Kerr's ingoing azimuth, counted so that it
    /// equals Boyer-Lindquist's where the fall begins. Boyer-Lindquist's own azimuth would wind
    /// without end toward the horizon of a hole that spins.
    pub fn lead(&self, time: f64, scene: &mut Scene) {
        self.fields.apply(time, scene);
        let last = self.kinds.iter().rev().find(|(from, _)| *from <= time);
        match last.or(self.kinds.first()) {
            Some((_, kind)) => scene.observer.kind = *kind,
            None if scene.observer.kind == ObserverKind::Orbit => {
                scene.observer.kind = ObserverKind::Static
            }
            None => {}
        }
        let rain = scene.observer.kind == ObserverKind::Rain;
        let tracks = if rain {
            &self.tracks_in_rain
        } else {
            &self.tracks
        };
        tracks.apply(time, scene);
        if let Some(rate) = self.clock.rate_at(time) {
            scene.disk.rate = rate;
        }
        if let Some(path) = &self.path {
            path.finish(&mut scene.camera);
        } else if tracks.of("phi_deg").is_some() {
            let phi =
                scene.camera.phi_deg - self.azimuth_lead(time, rain, scene.kerr()).to_degrees();
            scene.camera.phi_deg = wrap_degrees(phi);
        }
    }

    /// By how much Kerr's ingoing azimuth has grown beyond Boyer-Lindquist's in all periods of
    /// `rain` up to `time`, in radians. Inside the horizon, where `camera.phi_deg` is the ingoing
    /// azimuth, the lead counts as zero.
    fn azimuth_lead(&self, time: f64, rain: bool, kerr: Kerr) -> f64 {
        let Some(radius) = self.tracks_in_rain.of("r") else {
            return 0.0;
        };
        if kerr.spin == 0.0 {
            return 0.0;
        }
        let lead = |time: f64| kerr.camera_azimuth_lead(radius.at(time).exp());
        let kinds = self.kinds.iter();
        let mut periods: Vec<_> = kinds
            .map(|(from, kind)| (*from, *kind == ObserverKind::Rain))
            .collect();
        // The first named kind also holds before its keyframe.
        match periods.first_mut() {
            Some(first) => first.0 = 0.0,
            None => periods.push((0.0, rain)),
        }
        let ends = periods.iter().skip(1).map(|(from, _)| *from);
        let falls = periods.iter().zip(ends.chain([f64::INFINITY]));
        falls
            .filter(|((from, rain), _)| *rain && *from <= time)
            .map(|((from, _), end)| lead(time.min(end)) - lead(*from))
            .sum()
    }

    /// Writes the time of a disk that moves into `next`, a scene of the time `to`, in seconds after
    /// the beginning. `before` is the scene of the time `from`, with its camera and its
    /// `disk.time`. Both have their cameras already. A keyframe that names `disk_time` sets the
    /// clock, and what passed before does not count.
    pub fn drive_clock(&self, [from, to]: [f64; 2], before: &Scene, next: &mut Scene) {
        if !next.disk_moves() {
            return;
        }
        let (start, time, r) = match self.clock.set_before(to) {
            Some((set, time)) => {
                let mut there = before.clone();
                self.lead(set, &mut there);
                (set, time, there.camera.r)
            }
            None => (from, before.disk.time, before.camera.r),
        };
        let moved = next.disk_time_lead(next.camera.r) - next.disk_time_lead(r);
        next.disk.time = time + self.clock.passed(start, to, before.disk.rate) + moved;
    }
}

/// The camera at a share, from 0 to 1, of the way from one camera to another: at rest at both ends,
/// in the logarithm of the radius, and along the shorter turn of each angle.
pub fn between(from: &Camera, to: &Camera, share: f64) -> Camera {
    let share = share.clamp(0.0, 1.0);
    let gently = share * share * (3.0 - 2.0 * share);
    let mix = |a: f64, b: f64| a + (b - a) * gently;
    let (mut from, mut camera) = (*from, *to);
    let turns: [fn(&mut Camera) -> &mut f64; 5] = [
        |camera| &mut camera.phi_deg,
        |camera| &mut camera.yaw_deg,
        |camera| &mut camera.pitch_deg,
        |camera| &mut camera.roll_deg,
        |camera| &mut camera.tilt_deg,
    ];
    // At the end the camera is exactly `to`, without rounding.
    if share < 1.0 {
        camera.r = mix(from.r.ln(), to.r.ln()).exp();
        camera.fov_deg = mix(from.fov_deg, to.fov_deg);
        camera.fisheye_deg = mix(from.fisheye_deg, to.fisheye_deg);
        camera.theta_deg = mix(from.theta_deg, to.theta_deg);
        for angle in turns {
            let (start, end) = (*angle(&mut from), *angle(&mut camera));
            *angle(&mut camera) = wrap_degrees(start + wrap_degrees(end - start) * gently);
        }
    }
    camera
}
