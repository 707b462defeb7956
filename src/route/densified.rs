use core::f64::consts::PI;
use core::iter::FusedIterator;

use super::waypoints::positive;
use super::{InvalidStep, Segment};
use crate::Real;
use crate::math::{hypot, min, sin_cos_degrees};

/// Halvings from a segment to one 2²⁶ times as short.
const HALVINGS: u32 = 26;

/// Points of a [`Segment`] for a map that draws straight lines in latitude and longitude, from
/// [`Segment::densified`]: `[latitude, longitude]` in degrees. The longitude runs on beyond ±180°, so that no
/// line crosses the map; [`LatLon::new`](crate::LatLon::new) brings it back.
///
/// The points lie where the geodesic needs them, densest near the poles. Each straight line is compared with
/// the geodesic at a quarter, a half and three quarters of its part, and is halved until it is within the
/// tolerance less a tenth. It is at most 26 times halved: beside a pole a line may be longer than the
/// tolerance and still turn through half of a circle.
///
/// ```
/// use terrella::geodesic::Karney;
/// use terrella::route::Segment;
/// use terrella::{Ellipsoid, LatLon};
///
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let (tokyo, lima) = (LatLon::new(35.7_f64, 139.8)?, LatLon::new(-12.0, -77.0)?);
/// let points: Vec<_> = Segment::new(&earth, tokyo, lima).densified(10e3)?.collect();
/// assert_eq!((points[0], points.last()), ([35.7, 139.8], Some(&[-12.0, 283.0])));
/// assert_eq!(points.len(), 25);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Densified<'a, T> {
    segment: &'a Segment<T>,
    tolerance: T,
    last: Option<(T, [T; 2])>,
    step: T,
}

impl<'a, T: Real> Densified<'a, T> {
    pub(super) fn new(segment: &'a Segment<T>, tolerance: T) -> Result<Self, InvalidStep<T>> {
        let tolerance = positive(tolerance)?;
        let longest = tolerance * T::whole(1 << 24);
        if segment.length() > longest {
            return Err(InvalidStep::TooSmall(tolerance));
        }
        Ok(Self {
            segment,
            tolerance: tolerance * T::of(0.9),
            last: None,
            step: segment.length(),
        })
    }

    fn point(&self, distance: T) -> [T; 2] {
        let [lat, lon] = self.segment.line().near_unrolled(distance);
        let [from, to] = self.segment.ends();
        if distance == T::ZERO {
            return [from.lat(), from.lon()];
        }
        if distance == self.segment.length() {
            let circle = T::of(360.0);
            let circles = ((lon - to.lon()) / circle).round_ties_even();
            return [to.lat(), to.lon() + circle * circles];
        }
        [lat, lon]
    }

    /// Whether the geodesic between two of its points is near the straight line.
    fn fits(&self, start: T, ends: [[T; 2]; 2], step: T) -> bool {
        [T::of(0.25), T::of(0.5), T::of(0.75)].into_iter().all(|part| {
            let between = self.point(start + step * part);
            self.beside(ends, between) <= self.tolerance
        })
    }

    /// How far a place is from a straight line, in metres at the place's latitude.
    fn beside(&self, [[lat1, lon1], [lat2, lon2]]: [[T; 2]; 2], [lat, lon]: [T; 2]) -> T {
        let ellipsoid = self.segment.ellipsoid();
        let (sin, cos) = sin_cos_degrees(lat);
        let square = T::ONE - ellipsoid.e2() * sin * sin;
        let normal = ellipsoid.a() / square.sqrt();
        let degree = T::of(PI / 180.0);
        let north = degree * normal * (T::ONE - ellipsoid.e2()) / square;
        let east = degree * normal * cos;
        let (u, v) = ((lat2 - lat1) * north, (lon2 - lon1) * east);
        let (x, y) = ((lat - lat1) * north, (lon - lon1) * east);
        let length = u * u + v * v;
        if length == T::ZERO {
            return hypot(x, y);
        }
        let part = (x * u + y * v) / length;
        if part < T::ZERO || part > T::ONE {
            let [x, y] = if part < T::ZERO { [x, y] } else { [x - u, y - v] };
            return hypot(x, y);
        }
        (x * v - y * u).abs() / length.sqrt()
    }
}

impl<T: Real> Iterator for Densified<'_, T> {
    type Item = [T; 2];

    fn next(&mut self) -> Option<[T; 2]> {
        let length = self.segment.length();
        let Some((start, from)) = self.last else {
            let point = self.point(T::ZERO);
            self.last = Some((T::ZERO, point));
            return Some(point);
        };
        let left = length - start;
        let more = left > T::ZERO;
        if !more {
            return None;
        }
        let mut step = min(self.step + self.step, left);
        let shortest = length * T::pick(1.0 / 67_108_864.0, 1.0 / 4_194_304.0);
        for _ in 0..=HALVINGS {
            let to = self.point(if step < left { start + step } else { length });
            if step <= shortest || self.fits(start, [from, to], step) {
                break;
            }
            step *= T::of(0.5);
        }
        // No rest that is only rounding.
        let end = if left - step <= shortest { length } else { start + step };
        let point = self.point(end);
        self.step = step;
        self.last = Some((end, point));
        Some(point)
    }
}

impl<T: Real> FusedIterator for Densified<'_, T> {}
