use super::{Closest, Legs, Reach, Track};
use crate::geodesic::{PlanarArea, Tangent, wrapped};
use crate::latitude::UnsupportedFlattening;
use crate::math::{hypot, max, min, select};
use crate::{Ellipsoid, LatLon, Real};

/// Legs of up to some ten kilometres, each seen in the plane that touches the ellipsoid at the place: in
/// `f32` as exact as the places.
///
/// [`TangentPlane::local`] takes places as offsets from an origin: `f32` holds offsets to 2⁻²⁴ of themselves,
/// latitudes and longitudes only to 0.4 m. Offsets may reach over ±180°, not over a pole.
///
/// Worst errors on the Earth of distance, closest point, across and along, in metres, for a fence of this
/// size whose middle is up to 20 km from the origin, at any latitude:
///
/// | across | `f64` | `f32` |
/// |---|---|---|
/// | 100 m | 2e-9 | 6e-5 |
/// | 1 km | 3e-8 | 6e-4 |
/// | 5 km | 4e-6 | 3e-3 |
/// | 20 km | 2e-4 | 1.5e-2 |
/// | 100 km | 2.5e-2 | 6e-2 |
///
/// To the closest point the rounding of its offset is added: 2 mm in `f32`. Beyond a tenth of the radius the
/// numbers are finite and mean little.
///
/// The ends are projected on the plane, as [`PlanarArea`] does, and from the centre of the sphere of the
/// curvature at the place: geodesics are straight there, and a right angle to a line through the place is
/// one.
///
/// ```
/// use terrella::route::{Legs, Reach, TangentPlane};
/// use terrella::{Ellipsoid, LatLon};
/// let home = LatLon::new(47.397_742_f32, 8.545_594)?;
/// let plane = TangentPlane::local(Ellipsoid::WGS84, home)?;
/// // Offsets in degrees, from the difference in f64 or in whole numbers.
/// let fence = [(0.0, 0.0), (0.0, 0.02), (0.02, 0.03), (0.03, 0.0)];
/// let fence = fence.map(|(north, east)| LatLon::new(north, east).expect("in range"));
/// let drone = LatLon::new(0.01, 0.026)?;
/// let found = plane.closest_of_ring(drone, fence).expect("a ring has a place");
/// assert_eq!((found.leg, found.closest.reach), (1, Reach::Within));
/// assert!((found.closest.distance - 71.542).abs() < 0.001);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TangentPlane<T>(PlanarArea<T>);

/// A leg about an origin, from [`Legs::leg`] of [`TangentPlane`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlaneLeg<T> {
    start: LatLon<T>,
    end: LatLon<T>,
}

/// A leg as a place sees it.
struct View<T> {
    tangent: Tangent<T>,
    radius: T,
    /// The unit vector along the leg, east and north.
    way: [T; 2],
    /// The distance from the line, positive if the place is to the right.
    across: T,
    /// The start and the end along the line, from the foot.
    ends: [T; 2],
}

impl<T: Real> TangentPlane<T> {
    /// Makes the surface for places given as latitudes and longitudes.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        PlanarArea::new(ellipsoid).map(Self)
    }

    /// Makes the surface for places given as degrees north and east of an origin.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn local(ellipsoid: Ellipsoid<T>, origin: LatLon<T>) -> Result<Self, UnsupportedFlattening<T>> {
        PlanarArea::local(ellipsoid, origin).map(Self)
    }

    /// The leg about a place, in units of the radius.
    fn view(&self, place: LatLon<T>, leg: &PlaneLeg<T>) -> View<T> {
        let tangent = self.0.tangent(place);
        let radius = tangent.radius();
        let [[e, n], [east, north]] = [leg.start, leg.end].map(|end| {
            let [x, y] = tangent.seen(place, end).map(|x| x / radius);
            // From the plane to where the ray from the centre meets it; far places stay in front.
            let scale = T::ONE / max(T::ONE - (x * x + y * y), T::of(0.01)).sqrt();
            [x * scale, y * scale]
        });
        let (de, dn) = (east - e, north - n);
        let length = hypot(de, dn);
        // The line of ends that coincide leads to the north.
        let open = length == T::ZERO;
        let length = select(open, T::ONE, length);
        let way = [de / length, select(open, T::ONE, dn / length)];
        let [de, dn] = way;
        let across = n * de - e * dn;
        View {
            tangent,
            radius,
            way,
            across,
            ends: [e * de + n * dn, east * de + north * dn],
        }
    }
}

impl<T: Real> View<T> {
    /// The angle of a tangent, of less than a tenth of a radian.
    fn arc(tangent: T) -> T {
        let square = tangent * tangent;
        tangent - tangent * square * (T::of(1.0 / 3.0) - square * T::of(0.2))
    }

    /// The arc along the line from its start to a point of it.
    fn along(&self, point: T) -> T {
        let [start, _] = self.ends;
        // As seen from the centre, the line is farther than the plane.
        let far = (T::ONE + self.across * self.across).sqrt();
        (Self::arc(point / far) - Self::arc(start / far)) * self.radius
    }

    /// Metres of a point of the line from the place.
    fn distance(&self, point: T) -> T {
        Self::arc(hypot(self.across, point)) * self.radius
    }

    /// A point of the line.
    fn position(&self, place: LatLon<T>, point: T) -> LatLon<T> {
        let [de, dn] = self.way;
        // The foot is to the left of the place, if that is to the right.
        let (e, n) = (point * de - self.across * dn, point * dn + self.across * de);
        let scale = self.radius / (T::ONE + (e * e + n * n)).sqrt();
        let [lat, lon] = self.tangent.degrees([e * scale, n * scale]);
        let right = T::of(90.0);
        LatLon::within(max(min(place.lat() + lat, right), -right), wrapped(place.lon() + lon))
    }
}

/// Legs about an origin are geodesics, with the error above.
impl<T: Real> Legs<T> for TangentPlane<T> {
    type Leg = PlaneLeg<T>;

    fn leg(&self, start: LatLon<T>, end: LatLon<T>) -> PlaneLeg<T> {
        PlaneLeg { start, end }
    }

    fn length(&self, leg: &PlaneLeg<T>) -> T {
        let view = self.view(leg.start, leg);
        let [_, end] = view.ends;
        view.along(end)
    }

    fn closest_on(&self, leg: &PlaneLeg<T>, place: LatLon<T>) -> Closest<T> {
        let view = self.view(place, leg);
        let [start, end] = view.ends;
        if start > T::ZERO {
            Closest {
                distance: view.distance(start),
                position: leg.start,
                along: T::ZERO,
                reach: Reach::BeforeStart,
            }
        } else if end < T::ZERO {
            Closest {
                distance: view.distance(end),
                position: leg.end,
                along: view.along(end),
                reach: Reach::PastEnd,
            }
        } else {
            Closest {
                distance: view.distance(T::ZERO),
                position: view.position(place, T::ZERO),
                along: view.along(T::ZERO),
                reach: Reach::Within,
            }
        }
    }

    fn track_beside(&self, leg: &PlaneLeg<T>, place: LatLon<T>) -> Track<T> {
        let view = self.view(place, leg);
        Track {
            across: View::arc(view.across) * view.radius,
            along: view.along(T::ZERO),
        }
    }
}
