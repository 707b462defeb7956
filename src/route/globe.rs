//! Edges on an ellipsoid or a sphere, and the meridian of a place.

use super::{Crossing, EdgeCrossing, EdgeDistance, Legs};
use crate::geodesic::{
    Area, Geodesic, GeodesicError, GreatCircle, Inverse, Karney, between_poles, longitude_difference, wrapped,
};
use crate::math::{DoubleWord, atan2, max, min, sin_cos, sin_cos_degrees};
use crate::{LatLon, Real};

/// Shortest lines on a body.
struct Globe<'a, M, T> {
    method: &'a M,
    /// The largest radius of the body.
    radius: T,
}

/// A line between two corners, seen from one of them.
struct Leg<T> {
    azimuth: T,
    length: T,
}

/// How far from an edge a place may be and yet be on it, in radii: at a distance of so many radii from the
/// corner.
fn tolerance<T: Real>(distance: T) -> T {
    // In f64 the errors of azimuths and distances on the Earth: 15 nm. In f32 azimuths are rounded to 1e-6 of
    // the distance.
    min(
        T::pick(2.4e-15, 1.5e-6),
        T::pick(1.0, 1e-12) + T::pick(0.0, 2e-6) * distance,
    )
}

/// The longitude of another place less that of the first: its sign is exact.
fn beside<T: Real>(place: LatLon<T>, other: LatLon<T>) -> T {
    longitude_difference(place, other).value()
}

/// Whether an edge crosses the meridian of a place, or one infinitely little east of it.
fn crosses_meridian<T: Real>([from, to]: [T; 2], step: T) -> bool {
    let (west, east) = (from < T::ZERO, to < T::ZERO);
    (west & !east & (step > T::ZERO)) | (!west & east & (step < T::ZERO))
}

/// The latitudes in degrees between which an edge runs.
fn latitudes<T: Real>(from: LatLon<T>, to: LatLon<T>) -> [T; 2] {
    let (south, north) = (min(from.lat(), to.lat()), max(from.lat(), to.lat()));
    let step = beside(from, to);
    // In degrees, twice what a place on an edge may be beside it.
    let margin = T::of(200.0) * tolerance(T::ONE);
    if step.abs() > T::of(90.0) {
        return [T::of(-91.0), T::of(91.0)];
    }
    // tan β ≤ tan β₁ sec(ω/2): the latitude rises by ½(sec(ω/2) − 1) at most. With |f| ≤ 1/9 it is less than
    // this, also as ω is not the difference of the longitudes and β not the latitude.
    let bulge = T::of(0.003) * step * step;
    let beyond = |lat: T| if lat > T::ZERO { bulge } else { T::ZERO };
    [south - beyond(-south) - margin, north + beyond(north) + margin]
}

impl<M: Geodesic<T>, T: Real> Globe<'_, M, T> {
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Inverse<T> {
        let nothing = |_: GeodesicError<T>| Inverse {
            distance: T::of(f64::NAN),
            azimuth1: T::ZERO,
            azimuth2: T::ZERO,
        };
        self.method.inverse(from, to).unwrap_or_else(nothing)
    }

    fn crossing(&self, place: LatLon<T>, from: LatLon<T>, to: LatLon<T>) -> Crossing {
        let [south, north] = latitudes(from, to);
        let sides = [beside(place, from), beside(place, to)];
        let crosses = crosses_meridian(sides, beside(from, to));
        if place.lat() > north || !(crosses || self.may_touch(place, sides)) {
            return Crossing::Apart;
        }
        let across = |across| if across { Crossing::Across } else { Crossing::Apart };
        if place.lat() < south {
            return across(crosses);
        }
        if between_poles(from, to) {
            return self.between_poles(place, [from, to], sides, crosses);
        }
        // From the corner that is nearer.
        let apart = |corner: LatLon<T>, side: T| side.abs() + (corner.lat() - place.lat()).abs();
        let [side1, side2] = sides;
        let line = self.inverse(from, to);
        let back = wrapped(line.azimuth2 + T::of(180.0));
        let (corner, azimuth) = if apart(from, side1) <= apart(to, side2) {
            (from, line.azimuth1)
        } else {
            (to, back)
        };
        let way = self.inverse(corner, place);
        let leg = Leg {
            azimuth,
            length: line.distance,
        };
        if self.touches(&leg, way) {
            return Crossing::Touching;
        }
        // The place and the other corner are on one side of the corner's meridian: azimuths from the north
        // tell their order. No edge is south of the south pole.
        let beyond = place.lat() == T::of(-90.0) || azimuth.abs() < way.azimuth1.abs();
        across(crosses && beyond)
    }

    /// Whether a place may be on an edge that does not cross its meridian: only where the meridian of a
    /// corner is that near.
    fn may_touch(&self, place: LatLon<T>, [from, to]: [T; 2]) -> bool {
        let right = T::of(90.0);
        let side = min(min(from.abs(), to.abs()), right);
        // sin λ cos φ ≥ λ/90° (90° − |φ|)/90°.
        side * (right - place.lat().abs()) <= T::of(2.0 * 8100.0) * tolerance(T::ONE)
    }

    /// Whether the end of a way is on a leg from the same corner.
    fn touches(&self, leg: &Leg<T>, way: Inverse<T>) -> bool {
        let radii = way.distance / self.radius;
        let near = tolerance(radii);
        if radii <= near {
            return true;
        }
        let length = leg.length / self.radius;
        let turn = wrapped(way.azimuth1 - leg.azimuth).abs();
        if radii > length + near || turn > T::of(90.0) {
            return false;
        }
        let ((width, _), (reduced, _), (sin, _)) = (sin_cos(radii), sin_cos(length), sin_cos_degrees(turn));
        // The azimuth of the leg is only as good as its end, divided by the reduced length.
        width.abs() * sin <= near + near * (width.abs() / max(reduced, T::of(1e-3)))
    }

    /// Edges that turn at a pole, from one of its longitudes to another, and go along the latter's meridian
    /// if they go to the other pole.
    fn between_poles(&self, place: LatLon<T>, [from, to]: [LatLon<T>; 2], sides: [T; 2], crosses: bool) -> Crossing {
        let (sin, cos) = sin_cos_degrees(place.lat());
        let [_, side] = sides;
        let (across, along) = sin_cos_degrees(side);
        // cos φ is nearly 0 at a pole; the place is beside the meridian, or the pole.
        let facing = if along > T::ZERO { across.abs() } else { T::ONE };
        let at_pole = cos <= tolerance(T::ZERO) && (sin > T::ZERO) == (from.lat() > T::ZERO);
        let beside = from.lat() != to.lat() && cos * facing <= tolerance(T::ONE);
        if at_pole || beside {
            return Crossing::Touching;
        }
        if crosses && from.lat() > T::ZERO {
            Crossing::Across
        } else {
            Crossing::Apart
        }
    }
}

/// A ring's turns round the axis, and the area between it and the equator.
struct Round<T> {
    turns: i32,
    under: DoubleWord<T>,
}

impl<T: Real> Round<T> {
    fn new(edges: impl Iterator<Item = [LatLon<T>; 2]>, under: impl Fn(LatLon<T>, LatLon<T>) -> T) -> Self {
        let mut round = Self {
            turns: 0,
            under: DoubleWord::default(),
        };
        for [from, to] in edges {
            let step = beside(from, to);
            if crosses_meridian([from.lon(), to.lon()], step) {
                round.turns = round.turns.saturating_add(if step > T::ZERO { 1 } else { -1 });
            }
            round.under.add(under(from, to));
        }
        round
    }

    /// Whether the poles are inside; `half` is half of the area of the body.
    fn ends(&self, half: T, left: bool) -> [bool; 2] {
        // What is to the left of the ring, but for the poles.
        let area = -self.under.value();
        let rounding = half * T::EPSILON * T::of(8.0);
        let north = match (self.turns, left) {
            (0, false) => area > half + rounding || area < rounding - half,
            (0, true) => area < T::ZERO,
            (turns, true) => turns > 0,
            (turns, false) if turns % 2 == 0 => false,
            (turns, false) => (turns > 0) == (area <= rounding),
        };
        [north, north ^ (self.turns % 2 != 0)]
    }
}

/// As a sphere's excess, what is between a great circle and the equator: tan(E/2) = tan(λ/2) sin((φ₁ + φ₂)/2)
/// / cos((φ₂ − φ₁)/2).
fn excess<T: Real>(from: LatLon<T>, to: LatLon<T>) -> T {
    let half = T::of(0.5);
    let turn = longitude_difference(from, to).half().value();
    let ((sin_turn, cos_turn), (sin, _)) = (sin_cos_degrees(turn), sin_cos_degrees((from.lat() + to.lat()) * half));
    let (_, cos) = sin_cos_degrees((to.lat() - from.lat()) * half);
    let (y, x) = (sin_turn * sin, cos_turn * cos);
    let halved = if x == T::ZERO && y == T::ZERO {
        // From pole to pole the edge turns at the first; between other antipodes it goes north.
        let turned = turn * T::of(core::f64::consts::PI / 180.0);
        if between_poles(from, to) {
            turned.copysign(turn * from.lat())
        } else {
            turned
        }
    } else {
        atan2(y, x)
    };
    halved + halved
}

/// Edges are geodesics of the ellipsoid. A pole has a longitude: between two corners at the same pole an edge
/// turns there. To the opposite pole it goes along the meridian of the second corner.
impl<T: Real> EdgeCrossing<T> for Karney<T> {
    type Place = LatLon<T>;

    fn northing(&self, place: LatLon<T>) -> T {
        place.lat()
    }

    fn northings(&self, from: LatLon<T>, to: LatLon<T>) -> [T; 2] {
        latitudes(from, to)
    }

    fn crossing(&self, place: LatLon<T>, from: LatLon<T>, to: LatLon<T>) -> Crossing {
        let radius = self.ellipsoid().a();
        Globe { method: self, radius }.crossing(place, from, to)
    }

    fn ends(&self, edges: impl Iterator<Item = [LatLon<T>; 2]>, left: bool) -> [bool; 2] {
        let area = Area::within(*self);
        let half = self.ellipsoid().authalic_radius_squared() * T::of(2.0 * core::f64::consts::PI);
        Round::new(edges, |from, to| area.under(from, to)).ends(half, left)
    }
}

/// Edges are great circles. Between antipodes they go over the north pole.
impl<T: Real> EdgeCrossing<T> for GreatCircle<T> {
    type Place = LatLon<T>;

    fn northing(&self, place: LatLon<T>) -> T {
        place.lat()
    }

    fn northings(&self, from: LatLon<T>, to: LatLon<T>) -> [T; 2] {
        latitudes(from, to)
    }

    fn crossing(&self, place: LatLon<T>, from: LatLon<T>, to: LatLon<T>) -> Crossing {
        let radius = self.radius();
        Globe { method: self, radius }.crossing(place, from, to)
    }

    fn ends(&self, edges: impl Iterator<Item = [LatLon<T>; 2]>, left: bool) -> [bool; 2] {
        Round::new(edges, excess).ends(T::of(2.0 * core::f64::consts::PI), left)
    }
}

macro_rules! by_legs {
    ($($surface:ident)*) => {$(
        /// The distance is that of [`Legs::closest`].
        impl<T: Real> EdgeDistance<T> for $surface<T> {
            fn edge_distance(&self, place: LatLon<T>, from: LatLon<T>, to: LatLon<T>) -> T {
                self.closest(place, from, to).distance
            }

            fn edge_at_least(&self, place: LatLon<T>, from: LatLon<T>, to: LatLon<T>) -> T {
                self.at_least(place, from, to)
            }
        }
    )*};
}

by_legs!(Karney GreatCircle);
