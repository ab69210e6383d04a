//! The celestial, the galactic and the hole's frame.

use glam::{DMat3, DVec3};

/// Right ascension and declination of the north galactic pole, and the galactic longitude of the
/// celestial north pole, in degrees, J2000 (ESA 1997, The Hipparcos and Tycho Catalogues, vol. 1,
/// eq. 1.5.10).
const GALACTIC_POLE: [f64; 2] = [192.859_48, 27.128_25];
const LONGITUDE_OF_CELESTIAL_POLE: f64 = 122.931_92;

/// The unit vector toward a right ascension and declination, or a galactic longitude and latitude
/// on galactic axes; both in degrees.
pub fn celestial_direction(ra_deg: f64, dec_deg: f64) -> DVec3 {
    let ((sin_ra, cos_ra), (sin_dec, cos_dec)) = (
        ra_deg.to_radians().sin_cos(),
        dec_deg.to_radians().sin_cos(),
    );
    DVec3::new(cos_dec * cos_ra, cos_dec * sin_ra, sin_dec)
}

/// The rotation from J2000 to galactic axes: x toward the galactic centre, z toward the north
/// galactic pole.
pub fn galactic_from_celestial() -> DMat3 {
    let [ra, dec] = GALACTIC_POLE;
    let pole = celestial_direction(ra, dec);
    // The celestial pole's direction within the galactic plane, and a quarter turn further.
    let north = (DVec3::Z - pole * pole.z).normalize();
    let after = pole.cross(north);
    let (sin, cos) = LONGITUDE_OF_CELESTIAL_POLE.to_radians().sin_cos();
    DMat3::from_cols(cos * north - sin * after, sin * north + cos * after, pole).transpose()
}

/// The rotation from J2000 to the hole's axes that puts the place (`ra_deg`, `dec_deg`) behind the
/// hole, in the direction -x.
///
/// With `roll_deg` = 0 the celestial north pole is on the side of +z, so a camera at phi = 0 sees
/// the sky as from Earth, north up and east to the left. A positive roll turns the sky that it sees
/// counterclockwise about this place. At a celestial pole, north is the direction away from
/// `ra_deg` + 180 degrees (north pole) or toward `ra_deg` (south pole).
pub fn hole_from_celestial(ra_deg: f64, dec_deg: f64, roll_deg: f64) -> DMat3 {
    let behind = celestial_direction(ra_deg, dec_deg);
    // The limits at constant right ascension, which exist at the poles too.
    let north = celestial_direction(ra_deg, dec_deg + 90.0);
    let east = north.cross(behind);
    let (sin, cos) = roll_deg.to_radians().sin_cos();
    let to = DMat3::from_cols(
        DVec3::NEG_X,
        DVec3::new(0.0, -cos, -sin),
        DVec3::new(0.0, -sin, cos),
    );
    to * DMat3::from_cols(behind, east, north).transpose()
}
