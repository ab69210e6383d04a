//! The motion with the engine off: place and velocity of a geodesic, and the axes integrated beside
//! it.

use super::vectors::{carried_to, largest, largest_of};
use super::{Controls, Place, Ship, VectorConstants};
use crate::geometry::kerr::Kerr;
use crate::geometry::timelike::{Geodesic, Limit};
use glam::{DMat3, DVec3, DVec4};

/// The motion with the engine off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coast {
    pub(super) geodesic: Geodesic,
    /// T plus r minus the geodesic's ingoing time.
    time: f64,
}

impl Ship {
    pub(super) fn coast(&mut self, controls: &Controls, proper_time: f64) -> Option<Limit> {
        let mut coast = match self.coast {
            Some(coast) => coast,
            None => Coast::new(&self.place(), self.time(), self.velocity()),
        };
        let before = coast.geodesic.state.proper_time;
        let mut limit = coast.geodesic.advance(proper_time, self.limits);
        let passed = coast.geodesic.state.proper_time - before;
        // The axes go as far as the geodesic does, and past no limit of their own.
        let own_limits = std::mem::replace(&mut self.limits, [0.0, f64::INFINITY]);
        let lost = self.fly(controls, passed);
        self.limits = own_limits;
        limit = limit.or(lost);
        let place = coast.place(self.kerr);
        let u = coast.velocity(&place);
        let difference = largest_of((self.velocity() - u).to_array());
        self.error.geodesic += difference / largest(&self.state.frame);
        self.state.frame = carried_to(&self.state.frame, u);
        self.state.place = DVec4::from((coast.time(place.r), place.position));
        self.coast = Some(coast);
        limit
    }
}

impl Coast {
    fn new(place: &Place, time: f64, u: DVec4) -> Self {
        Self {
            geodesic: geodesic(place, u),
            time: time + place.r,
        }
    }

    pub(super) fn place(&self, kerr: Kerr) -> Place {
        let state = &self.geodesic.state;
        Place::at(kerr, 1.0 / state.u, self.turned(state.n))
    }

    /// The four-velocity on the Kerr-Schild frame.
    fn velocity(&self, place: &Place) -> DVec4 {
        let Geodesic { constants, state } = &self.geodesic;
        VectorConstants {
            energy: constants.energy,
            angular_momentum: constants.angular_momentum,
            radial: -state.du * place.r * place.r,
            w: self.turned(state.dn),
            mass2: 1.0,
        }
        .vector(place)
    }

    fn time(&self, r: f64) -> f64 {
        self.time + self.geodesic.state.ingoing_time - r
    }

    /// A vector of the celestial sphere with Kerr's ingoing azimuth, of one with the azimuth psi.
    fn turned(&self, v: DVec3) -> DVec3 {
        DMat3::from_rotation_z(self.geodesic.state.chi) * v
    }
}

pub(super) fn geodesic(place: &Place, u: DVec4) -> Geodesic {
    let photon = VectorConstants::new(place, u).photon(place);
    Geodesic::new(place.kerr, &photon, place.r, place.n, 0.0)
}
