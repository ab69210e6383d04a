//! The search for the backward error: for the smallest turn of a ray after which the reference gives
//! a method's answer.
//!
//! It is Newton's method in two coordinates. A *chart* gives the rays around one ray such coordinates,
//! with the ray at zero: the tangent plane or, near the edge of the shadow, the logarithm of the
//! distance to the edge and the position along it, in which answers are nearly linear. An answer has
//! several *parts*, its sky and its hits, and each is searched for by itself: on the plane first, then
//! on the chart of the edge, and for an answer of another class from the nearest ray of that class. A
//! [thorough](thorough::ThoroughSearch) search starts from every place of a grid about the edge.

pub(crate) mod backward;
mod chart;
pub(crate) mod class;
pub(crate) mod edge;
mod grid;
mod near_edge;
mod newton;
mod part;
pub(crate) mod thorough;
pub(crate) mod turns;
