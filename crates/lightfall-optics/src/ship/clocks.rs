//! The clocks of a ship and of its home, and the light between them.

use super::pose::radius;
use lightfall_model::geometry::ship::Ship;

/// The radius of the shell of clocks at rest that is the ship's home, in r_s.
pub const HOME_RADIUS: f64 = 1000.0;

/// What a ship's clock, the clocks far away and those at home say, and how the light between ship and
/// home is shifted. Home is joined to the ship by the principal null rays, which without spin are the
/// radial ones. Its clocks are set to show the time of clocks far away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clocks {
    /// The ship's own, since the start of the flight, in r_s/c.
    pub own: f64,
    /// Boyer-Lindquist's t, in r_s/c; `None` at and inside the horizon. The flight of a ship that
    /// [`board`](super::board) starts outside begins at zero.
    pub far: Option<f64>,
    /// Home's clock as the ship sees it, in r_s/c: when the light that arrives left home. Also inside
    /// the horizon, where home's light still falls in.
    pub home_seen: f64,
    /// How long a signal needs from the ship to home, in r_s/c; `None` at and inside the horizon, from
    /// where none arrives.
    pub signal_delay: Option<f64>,
    /// Observed over emitted frequency of home's light on the ship.
    pub home_light: f64,
    /// Observed over emitted frequency of the ship's light at home; `None` at and inside the horizon.
    pub own_light: Option<f64>,
    /// How much time passes far away per own time, dt/dtau; `None` at and inside the horizon.
    pub far_rate: Option<f64>,
}

impl Clocks {
    /// The clocks of a ship.
    ///
    /// Light that falls in keeps v along the principal null rays, and light that goes out keeps t -
    /// r*, with r* = [`ingoing_time_lead`](lightfall_model::geometry::kerr::Kerr::ingoing_time_lead). Per unit E the ship measures the frequency l.u of
    /// the former and (P - V)/Delta of the latter (Misner, Thorne & Wheeler 1973 eq. 33.39; Carter
    /// 1968), and home sqrt(1 - 1/r).
    pub fn new(ship: &Ship) -> Self {
        let (kerr, place, constants) = (ship.kerr(), ship.place(), ship.constants());
        let r = radius(kerr, place.r);
        let outside = r > kerr.horizon();
        let lead = |r: f64| kerr.ingoing_time_lead(r);
        let far = outside.then(|| ship.time() + r - lead(r));
        let home = (1.0 - 1.0 / HOME_RADIUS).sqrt();
        let (p, v) = (constants.p(&place), constants.radial);
        let falling = place.along_null(ship.velocity());
        let rising = outside.then(|| (p - v) / kerr.delta(r));
        let delay = outside.then(|| (lead(HOME_RADIUS) - lead(r)).abs());
        // A ship that is farther out than home receives light that goes out, and sends light that
        // falls in.
        let (home_seen, received, sent) = match (rising, far, delay) {
            (Some(rising), Some(far), Some(delay)) if r > HOME_RADIUS => {
                (far - delay, rising, Some(falling))
            }
            _ => (ship.time() + r - lead(HOME_RADIUS), falling, rising),
        };
        Self {
            own: ship.proper_time(),
            far,
            home_seen,
            signal_delay: delay,
            home_light: received * home,
            own_light: sent.map(|sent| 1.0 / (sent * home)),
            far_rate: outside.then(|| {
                // u^t = (E Y - 2 M a r L)/(Sigma Delta); Bardeen, Press & Teukolsky 1972 eq. 2.9.
                let dragged = kerr.a() * r * constants.angular_momentum;
                (constants.energy * place.area() - dragged) / (place.sigma() * kerr.delta(r))
            }),
        }
    }
}

/// The time of `disk.time` along the ship's flight, as that of a fall
/// ([`Worldline::clock`](crate::worldline::Worldline::clock)): outside the horizon
/// Boyer-Lindquist's t, and at and inside it Kerr's ingoing time v.
pub fn disk_clock(ship: &Ship) -> f64 {
    let kerr = ship.kerr();
    let r = radius(kerr, ship.place().r);
    ship.time() + r - kerr.camera_time_lead(r)
}
