//! The scene and its tables of fields. Each field is declared once, with its meaning, which is both
//! its documentation and its help, its type, its default, and for a number its range and unit:
//!
//! ```text
//! /// Angle from the disk normal.
//! theta_deg: f64 = 80.0, POLAR, "degrees";
//! ```

use serde::{Deserialize, Serialize};

use super::field::Field;
use super::matter::MAX_THICKNESS;
use super::promises::MEDIUM_LIGHT;
use super::range::Range;
use super::value::FieldValue;
use super::{
    ARTICLE_MAX_STEPS, DiskModel, DiskStructure, HotSpotKind, LimbDarkening, MAX_FILE_SIDE,
    MAX_PICTURE_SIDE, MAX_RADIUS, MAX_STEP_BUDGET, Method, ObserverKind, Projection, SCHEMA,
    SkyFrame, SkyMode, ToneCurve, View,
};

/// A radius in the disk.
pub(super) const EDGE: Range = Range::above(0.0, 1e6);
/// From pole to pole.
pub(super) const POLAR: Range = Range::closed(0.0, 180.0);
/// From the south pole of the sky to the north pole.
const LATITUDE: Range = Range::closed(-90.0, 90.0);
/// A turn either way.
pub(super) const TURN: Range = Range::closed(-360.0, 360.0);
/// A share of a whole.
const SHARE: Range = Range::closed(0.0, 1.0);
/// An artistic scale of light.
const SCALE: Range = Range::closed(0.0, 1e3);
/// A side of a picture.
const SIDE: Range = Range::closed(1.0, MAX_FILE_SIDE as f64);
/// A side of the presentation grid.
const GRID_SIDE: Range = Range::closed(1.0, MAX_PICTURE_SIDE as f64);
/// A radius where a camera may be around some hole; `limits` narrows it to where the scene's
/// observer exists.
const CAMERA: Range = Range::closed(0.1, MAX_RADIUS);
/// A vertical field of view, from a millionth of a radian up.
const FIELD_OF_VIEW: Range = Range::closed(1e-6_f64.to_degrees(), MAX_FIELD_OF_VIEW_DEG);
/// The largest vertical field of view, in degrees.
pub(super) const MAX_FIELD_OF_VIEW_DEG: f64 = 179.0;
/// The largest field of view of a fisheye picture, in degrees.
pub(super) const MAX_FISHEYE_DEG: f64 = 360.0;

/// Declares a table: the struct with its defaults, and the rows of its fields in the field table.
/// `in (camera)` is the table's name in a preset; the scene itself has none, and holds the tables.
macro_rules! table {
    (
        $(#[$attribute:meta])*
        pub struct $Table:ident in $table:tt {
            $(
                $(#[doc = $about:literal])+
                $field:ident: $type:ty = $default:expr $(, $range:expr, $unit:literal)?;
            )+
            $(tables: $($(#[doc = $inner_about:literal])+ $inner:ident: $Inner:ty;)+)?
        }
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        #[serde(deny_unknown_fields, default)]
        pub struct $Table {
            $($(#[doc = $about])+ pub $field: $type,)+
            $($($(#[doc = $inner_about])+ pub $inner: $Inner,)+)?
        }

        impl Default for $Table {
            fn default() -> Self {
                Self {
                    $($field: $default,)+
                    $($($inner: Default::default(),)+)?
                }
            }
        }

        impl $Table {
            /// The rows of this table's own fields.
            pub(super) const FIELDS: &'static [Field] = &[$(
                Field::new(
                    (
                        table!(@key $table $field),
                        <$type as FieldValue>::KIND$(.within($range))?,
                        concat!($($unit)?),
                        concat!($($about),+),
                    ),
                    |scene| FieldValue::to_value(&table!(@place scene $table $field)),
                    |scene, value| match FieldValue::from_value(value) {
                        Some(value) => {
                            table!(@place scene $table $field) = value;
                            true
                        }
                        None => false,
                    },
                ),
            )+];
        }
    };
    (@key () $field:ident) => { stringify!($field) };
    (@key ($table:ident) $field:ident) => { concat!(stringify!($table), ".", stringify!($field)) };
    (@place $scene:ident () $field:ident) => { $scene.$field };
    (@place $scene:ident ($table:ident) $field:ident) => { $scene.$table.$field };
}

table! {
    /// Everything that decides a picture.
    pub struct Scene in () {
        /// Version of the preset format.
        schema: u32 = SCHEMA, Range::closed(SCHEMA as f64, SCHEMA as f64), "";
        /// Short name.
        name: String = "unnamed".into();
        /// One line that says what there is to see.
        title: String = String::new();
        /// How light is traced.
        method: Method = Method::default();
        /// What is shown: the light, the light with rays without an answer in magenta, or a
        /// diagnostic.
        view: View = View::default();
        tables:
        /// The hole.
        hole: Hole;
        /// Where the camera is and where it looks.
        camera: Camera;
        /// How the camera moves through the place where it is.
        observer: Observer;
        /// Which effects there are; without one of them the physics is broken on purpose.
        effects: Effects;
        /// The thin disk.
        disk: Disk;
        /// A hot spot in the disk.
        hot_spot: HotSpot;
        /// The two jets.
        jet: Jet;
        /// What lies at infinity.
        sky: Sky;
        /// The foreground probe.
        probe: Probe;
        /// The way from light to pixels.
        picture: Picture;
        /// Accuracy against time.
        quality: Quality;
    }
}

table! {
    /// The black hole; its Schwarzschild radius is the unit of length.
    #[derive(Copy)]
    pub struct Hole in (hole) {
        /// chi = a/M; positive turns with the disk.
        spin: f64 = 0.0, Range::between(-1.0, 1.0), "";
    }
}

table! {
    /// Where the camera is and where it looks. With yaw, pitch and roll zero it looks at the hole's
    /// centre, with decreasing theta up and growing phi to the right.
    ///
    /// `r`, `theta_deg` and `phi_deg` are Boyer-Lindquist; at and inside the horizon `phi_deg` is
    /// Kerr's ingoing azimuth.
    #[derive(Copy)]
    pub struct Camera in (camera) {
        /// Boyer-Lindquist radius of the camera, outside the horizon unless observer.kind is rain.
        r: f64 = 20.0, CAMERA, "r_s";
        /// Angle from the z axis: the spin axis, and the normal of a disk that is not tilted.
        theta_deg: f64 = 80.0, POLAR, "degrees";
        /// Azimuth.
        phi_deg: f64 = 0.0, TURN, "degrees";
        /// Vertical field of view of a perspective picture.
        fov_deg: f64 = 60.0, FIELD_OF_VIEW, "degrees";
        /// Turn to the right, away from the hole's centre.
        yaw_deg: f64 = 0.0, TURN, "degrees";
        /// Turn upward, after the yaw.
        pitch_deg: f64 = 0.0, TURN, "degrees";
        /// Turn clockwise about the line of sight, after the pitch.
        roll_deg: f64 = 0.0, TURN, "degrees";
        /// Turn upward after the roll, which flying leaves as it is: a dome looks up while its
        /// audience faces the hole.
        tilt_deg: f64 = 0.0, TURN, "degrees";
        /// How the picture shows directions.
        projection: Projection = Projection::default();
        /// Field of view of a fisheye picture, across its circle.
        fisheye_deg: f64 = 180.0, Range::closed(1.0, MAX_FISHEYE_DEG), "degrees";
        /// Diameter of a fisheye picture's circle, as a share of the picture's shorter side.
        circle: f64 = 1.0, Range::closed(0.5, 4.0), "";
        /// Where the line of sight crosses a perspective or fisheye picture, from its middle: to the
        /// right and upward.
        shift: [f64; 2] = [0.0; 2], Range::FINITE, "picture heights";
    }
}

table! {
    /// How the camera moves. The components of `velocity` point outward, toward growing theta and
    /// toward growing phi.
    #[derive(Copy)]
    pub struct Observer in (observer) {
        /// How the camera moves.
        kind: ObserverKind = ObserverKind::default();
        /// One more boost, in the observer's frame.
        velocity: [f64; 3] = [0.0; 3], Range::FINITE, "c";
    }
}

table! {
    /// Which effects there are. Switching one off breaks the physics on purpose, to show what the
    /// effect does: without `lensing` rays are straight lines of flat space; without `beaming` a
    /// shift changes colour only; without `aberration` directions are those of an observer with
    /// zero angular momentum.
    #[derive(Copy, Eq, Hash)]
    pub struct Effects in (effects) {
        /// Whether light is bent; off breaks the physics on purpose.
        lensing: bool = true;
        /// Whether motion shifts light; off breaks the physics on purpose.
        doppler: bool = true;
        /// Whether a shift changes the brightness by g^4; off breaks the physics on purpose.
        beaming: bool = true;
        /// Whether potentials shift light; off breaks the physics on purpose.
        gravitational_shift: bool = true;
        /// Whether motion displaces directions; off breaks the physics on purpose.
        aberration: bool = true;
    }
}

table! {
    /// The thin emitting disk: in the equatorial plane, or tilted around a hole without spin.
    #[derive(Copy)]
    pub struct Disk in (disk) {
        /// Whether there is a disk.
        enabled: bool = true;
        /// Inner edge; never inside the innermost stable circular orbit.
        inner: f64 = 3.0, EDGE, "r_s";
        /// Whether the inner edge is the innermost stable circular orbit, whatever disk.inner says.
        follow_isco: bool = false;
        /// Outer edge; outside the innermost stable circular orbit.
        outer: f64 = 11.0, EDGE, "r_s";
        /// Angle between the disk's normal and the z axis; 0 around a hole that spins.
        tilt_deg: f64 = 0.0, POLAR, "degrees";
        /// Azimuth of the ascending node, where the orbits of a tilted disk cross the equator
        /// upward; azimuths in the disk are counted on from there.
        node_deg: f64 = 0.0, TURN, "degrees";
        /// Radial profile of the flux.
        model: DiskModel = DiskModel::default();
        /// Whether the disk keeps its accretion rate when its inner edge moves, as if temperature_k
        /// and brightness were given for an edge at 3 r_s; else its largest flux stays the same.
        keep_accretion: bool = false;
        /// Temperature scale: T = temperature_k F^(1/4); a hotter disk keeps its total flux, ever
        /// less of it visible.
        temperature_k: f64 = 18_000.0, Range::closed(100.0, 1e6), "K";
        /// Artistic scale of the emission.
        brightness: f64 = 1.0, SCALE, "";
        /// Width of the fade at each edge, as a fraction of its radius; emission and opacity fade
        /// together.
        edge_taper: f64 = 0.03, Range::closed(0.0, 0.5), "";
        /// Share of the light from behind that passes through, for a disk without thickness.
        transmission: f64 = 0.0, SHARE, "";
        /// Height over radius, at four times the inner edge; 0 for a sheet without thickness.
        thickness: f64 = 0.0, Range::closed(0.0, MAX_THICKNESS), "";
        /// Optical depth of a disk with thickness, along its normal.
        depth: f64 = 12.0, Range::closed(0.1, 200.0), "";
        /// Power of the radius with which the height over the radius grows.
        flare: f64 = 0.0, Range::closed(-1.0, 1.0), "";
        /// Width of the fade at the outer edge of a disk with thickness, as a fraction of its radius.
        outer_taper: f64 = 0.45, Range::closed(0.0, 0.9), "";
        /// Standard deviation of the logarithm of the density of a disk with thickness and structure.
        lumps: f64 = 1.4, Range::closed(0.0, 2.0), "";
        /// Where its matter is dense, the structure is bright at 0, dark at 1, and even at 0.5.
        lanes: f64 = 0.0, Range::closed(0.0, 1.0), "";
        /// How the surface's brightness depends on the angle at which it is seen.
        limb: LimbDarkening = LimbDarkening::default();
        /// Whether light of the disk that gravity bends back to it heats it: by 1 % of its flux
        /// around a hole without spin, and by a quarter at spin 0.998.
        returning: bool = false;
        /// Structure of the light: a statistical model of turbulence, carried and sheared by the
        /// rotation. Streaks multiply contrast by 5/3 (to 1.5 at most), scale by 5/7 (to 0.02 at
        /// least), aspect by 2.4 (to 20 at most), pitch_deg by 8/15, and lifetime by 1.5 (to 4 at
        /// most).
        structure: DiskStructure = DiskStructure::default();
        /// Standard deviation of the logarithm of the structure's flux.
        contrast: f64 = 0.6, Range::closed(0.0, 1.5), "";
        /// Width of the structure's filaments, as a share of the radius.
        scale: f64 = 0.07, Range::closed(0.02, 0.5), "";
        /// Length of the filaments over their width.
        aspect: f64 = 5.0, Range::closed(1.0, 20.0), "";
        /// Angle by which the filaments trail behind the orbits, in the middle of their lives.
        pitch_deg: f64 = 15.0, Range::closed(0.0, 45.0), "degrees";
        /// How long the filaments live.
        lifetime: f64 = 1.0, Range::closed(0.25, 4.0), "orbits";
        /// Time after which the structure repeats, at least 2; 0 if it never does. Filaments then
        /// live for whole parts of it, at most for all of it. A hot spot does not repeat.
        period: f64 = 0.0, Range::closed(0.0, 1e6), "r_s/c";
        /// Number of waves in each ring of the structure, rounded down to a multiple of four.
        waves: u32 = 24, Range::closed(12.0, 48.0), "waves";
        /// Number that chooses the random pattern of the structure.
        seed: u32 = 1, Range::closed(0.0, u32::MAX as f64), "";
        /// Clock of the disk: Boyer-Lindquist's time at the camera; inside the horizon Kerr's
        /// ingoing time.
        time: f64 = 0.0, Range::closed(-1e9, 1e9), "r_s/c";
        /// How far the disk's clock goes on in one second of a window or of a sequence.
        rate: f64 = 4.0, Range::closed(0.0, 1e3), "r_s/c";
    }
}

table! {
    /// A spot of the disk that shines more brightly and moves with the matter.
    #[derive(Copy)]
    pub struct HotSpot in (hot_spot) {
        /// Whether there is a hot spot, and whether the rotation shears it.
        kind: HotSpotKind = HotSpotKind::default();
        /// Radius of the spot's middle.
        r: f64 = 4.5, EDGE, "r_s";
        /// Azimuth of the spot's middle in the disk at hot_spot.time.
        phi_deg: f64 = 0.0, TURN, "degrees";
        /// Standard deviation of the spot, as a share of its radius.
        size: f64 = 0.08, Range::closed(0.01, 0.5), "";
        /// How much the spot's middle adds to the flux, in units of the disk's flux there.
        strength: f64 = 8.0, SCALE, "";
        /// Time on the disk's clock at which the spot is at hot_spot.phi_deg and brightest.
        time: f64 = 0.0, Range::closed(-1e9, 1e9), "r_s/c";
        /// Standard deviation in time of the spot's brightness; 0 for a spot that always shines.
        duration: f64 = 0.0, Range::closed(0.0, 1e9), "r_s/c";
    }
}

table! {
    /// Two jets of matter that shines in magnetic fields, along the axis on both sides of the disk.
    #[derive(Copy)]
    pub struct Jet in (jet) {
        /// Whether there are jets.
        enabled: bool = false;
        /// Artistic scale of the jets' emission.
        brightness: f64 = 1.0, SCALE, "";
        /// How wide the jets are: r^0.88 (1 - cos theta) of their outermost streamlines, with r in
        /// r_s. The radius of a jet is sqrt(2 jet.width) r^0.56.
        width: f64 = 0.3, Range::closed(0.05, 1.0), "";
        /// How fast the matter becomes far out: its velocity times its Lorentz factor.
        speed: f64 = 1.5, Range::closed(0.1, 20.0), "c";
        /// Radius at which the jets have faded.
        length: f64 = 40.0, Range::closed(5.0, 200.0), "r_s";
        /// How uneven the emission is: strands of the sheath, and knots that move outward along the
        /// spine. Smooth at 0.
        knots: f64 = 1.0, Range::closed(0.0, 1.5), "";
        /// Frequency at which the spectrum of the matter at 10 r_s falls off, over that of green
        /// light, 540 THz: the matter is whiter near the hole, and reddens as it cools outward.
        colour: f64 = 0.4, Range::closed(0.1, 20.0), "";
    }
}

table! {
    /// What lies at infinity.
    pub struct Sky in (sky) {
        /// What is drawn at infinity.
        mode: SkyMode = SkyMode::default();
        /// File of a picture of the whole sky, twice as wide as high, in EXR, HDR, PNG or JPEG: what
        /// the mode `picture` shows.
        picture: String = String::new();
        /// Axes of this picture: its middle is at longitude 0, and longitudes grow to the left.
        frame: SkyFrame = SkyFrame::default();
        /// Whether this picture is seen from outside, so that its longitudes grow to the right.
        mirror: bool = false;
        /// Whether the stars of the catalogue are drawn in front of this picture.
        stars: bool = false;
        /// Which stars: in mode `stars` those that are fainter than the catalogue's.
        seed: u32 = 1, Range::closed(0.0, u32::MAX as f64), "";
        /// Scale of the sky's light.
        brightness: f64 = 1.0, SCALE, "";
        /// Right ascension (J2000) of the place in the sky that is behind the hole, as seen from
        /// azimuth 0 in the equatorial plane.
        ra_deg: f64 = 266.0, TURN, "degrees";
        /// Declination (J2000) of the same place.
        dec_deg: f64 = -29.0, LATITUDE, "degrees";
        /// Turn of the sky about this place; at 0 the celestial north pole is on the side of the z
        /// axis.
        roll_deg: f64 = 0.0, TURN, "degrees";
        /// Faintest stars that are drawn as points, if the picture can show them; the Milky Way
        /// holds the light of all others.
        magnitude_limit: f64 = 12.0, Range::closed(-2.0, 12.0), "mag";
        /// Whether one bright star is added, in any mode but `off`.
        reference_star: bool = false;
        /// The reference star's angle from the z axis.
        reference_theta_deg: f64 = 90.0, POLAR, "degrees";
        /// The reference star's azimuth.
        reference_phi_deg: f64 = 180.0, TURN, "degrees";
    }
}

table! {
    /// A small craft, drawn by ordinary projection in front of the traced light.
    #[derive(Copy)]
    pub struct Probe in (probe) {
        /// Whether the foreground probe is there.
        enabled: bool = false;
        /// Radius where the probe hovers.
        r: f64 = 20.0, Range::above(1.0, MAX_RADIUS), "r_s";
        /// The probe's angle from the z axis.
        theta_deg: f64 = 80.0, POLAR, "degrees";
        /// The probe's azimuth.
        phi_deg: f64 = 0.0, TURN, "degrees";
        /// Length of the probe's body.
        size: f64 = 0.2, Range::above(0.0, 1e3), "r_s";
        /// Whether the probe's edges are smoothed, by four samples a pixel.
        antialias: bool = false;
    }
}

table! {
    /// The way from light to pixels.
    #[derive(Copy)]
    pub struct Picture in (picture) {
        /// Width of the picture; a window draws it as wide as the window is.
        width: u32 = 960, SIDE, "pixels";
        /// Height of the picture.
        height: u32 = 540, SIDE, "pixels";
        /// Columns of cells, not more than picture.width; a window shows as many as it has room
        /// for.
        grid_width: u32 = 480, GRID_SIDE, "cells";
        /// Rows of cells, not more than picture.height; a window shows about as many.
        grid_height: u32 = 270, GRID_SIDE, "cells";
        /// Exposure; with picture.automatic_exposure where it begins, and where nothing is seen.
        exposure_ev: f64 = 1.2, Range::closed(-20.0, 20.0), "powers of two";
        /// Whether a light meter chooses the exposure.
        automatic_exposure: bool = false;
        /// What is added to the exposure that the light meter chooses.
        exposure_bias: f64 = 0.0, Range::closed(-5.0, 5.0), "powers of two";
        /// Curve from light to the levels of the screen; views of rays have the neutral one.
        tone_curve: ToneCurve = ToneCurve::default();
        /// Strength of the bloom; zero leaves it out.
        bloom: f64 = 0.08, SHARE, "";
        /// Whether more rays are traced where edges pass: 4 or 16 a pixel, 64 at the shadow's edge.
        antialias: bool = true;
        /// How many frames are averaged, each with its rays at other places in their pixels, for a
        /// still or while a window's picture rests.
        samples: u32 = 1, Range::closed(1.0, 1024.0), "frames";
        /// How many levels a channel is rounded to.
        levels: u32 = 24, Range::closed(2.0, 256.0), "levels";
        /// Whether a 4x4 Bayer pattern spreads the rounding error.
        dither: bool = true;
        /// Whether the pixel treatment is left out.
        bypass: bool = false;
    }
}

table! {
    /// Accuracy against time. An error is stated in pixels of the picture: the turn of a pixel's
    /// ray that would explain it.
    #[derive(Copy)]
    pub struct Quality in (quality) {
        /// Largest error of a ray, for method mino.
        max_error_px: f64 = 0.05, Range::closed(1e-4, 1.0), "pixels";
        /// Largest error of the light of matter with depth, which 95 of 100 pixels hold, as a share
        /// of the light.
        max_error_light: f64 = MEDIUM_LIGHT, Range::closed(1e-4, 1.0), "";
        /// Scale of the step rule of verlet and kerr-schild: 1.55 cheap, 0.85 balanced, 0.45 high.
        /// Above 0.85 other limits of kerr-schild's steps decide.
        step_scale: f64 = 0.85, Range::above(0.0, 16.0), "";
        /// Most steps of verlet and kerr-schild: 128 cheap, 256 balanced, 768 high. With more than
        /// 768 no edges are refined, because one call of the GPU could take too long.
        max_steps: u32 = ARTICLE_MAX_STEPS, Range::closed(1.0, MAX_STEP_BUDGET as f64), "steps";
        /// Most affine length of verlet and kerr-schild.
        max_affine: f64 = 2000.0, Range::above(0.0, 1e9), "r_s";
        /// Radius beyond which an outgoing ray of verlet and kerr-schild counts as escaped, never
        /// less than camera.r and disk.outer; 0 for 1.15 camera.r or three times disk.outer,
        /// whichever is larger. A ray ends before it, without an answer, after quality.max_affine
        /// or quality.max_steps.
        escape_radius: f64 = 0.0, Range::closed(0.0, 1e9), "r_s";
        /// Least step of the step rule of verlet and kerr-schild, unless another limit is smaller;
        /// 0 for the article's, 0.018 and 0.008.
        min_step: f64 = 0.0, Range::closed(0.0, 1.0), "r_s";
    }
}
