//! Straight lines of sight: where one meets the ground, and how high it is above it.

use crate::math::{max, min, select};
use crate::position::InvalidDirection;
use crate::{Direction, Ecef, Ellipsoid, Real};

/// A straight line that starts at a point and goes on one way: of a camera, a radar, a laser.
///
/// ```
/// use terrella::{Ecef, Ellipsoid, Meeting, Ray};
/// let earth = Ellipsoid::<f64>::WGS84;
/// let eye = Ecef::new(7_000_000.0, 0.0, 0.0)?;
/// let down = Ray::new(eye, [-2.0, 0.0, 0.0])?;
/// let Meeting::Enters(distance) = earth.meet(&down, 0.0) else { unreachable!() };
/// assert!((distance - 621_863.0).abs() < 1e-8);
/// assert!((down.at(distance).x() - 6_378_137.0).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ray<T = f64> {
    start: [T; 3],
    way: [T; 3],
}

impl<T: Real> Ray<T> {
    /// Creates the ray from a point along a vector of any length, in Earth axes.
    ///
    /// # Errors
    /// [`InvalidDirection`] if the vector is zero, or a component infinite or NaN.
    pub fn new(start: Ecef<T>, [x, y, z]: [T; 3]) -> Result<Self, InvalidDirection<T>> {
        Ok(Self {
            start: start.to_array(),
            way: Direction::new(x, y, z)?.to_array(),
        })
    }

    /// Creates the ray from a point through another.
    ///
    /// # Errors
    /// [`InvalidDirection`] if the two are one point, or so far apart that their difference overflows.
    pub fn through(start: Ecef<T>, other: Ecef<T>) -> Result<Self, InvalidDirection<T>> {
        let [x, y, z] = start.to_array();
        let [to_x, to_y, to_z] = other.to_array();
        Self::new(start, [to_x - x, to_y - y, to_z - z])
    }

    /// Returns where the ray starts.
    #[must_use]
    pub fn start(&self) -> Ecef<T> {
        let [x, y, z] = self.start;
        Ecef::within(x, y, z)
    }

    /// Returns the direction.
    #[must_use]
    pub fn direction(&self) -> Direction<T> {
        let [x, y, z] = self.way;
        Direction::within(x, y, z)
    }

    /// Returns the point of the ray at a distance from its start, in metres.
    #[must_use]
    pub fn at(&self, distance: T) -> Ecef<T> {
        let [x, y, z] = self.start;
        let [a, b, c] = self.way;
        Ecef::within(x + distance * a, y + distance * b, z + distance * c)
    }
}

/// How a ray meets a surface: from [`Ellipsoid::meet`]. Distances are from the ray's start, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Meeting<T> {
    /// It passes by, or leads away.
    Misses,
    /// It touches the surface without going in, to within rounding.
    Touches(T),
    /// It comes from outside and goes in.
    Enters(T),
    /// It starts inside, or on the surface, and comes out.
    Leaves(T),
}

impl<T: Real> Meeting<T> {
    /// Returns the distance to the first place of the surface, or `None` for [`Misses`](Self::Misses).
    #[must_use]
    pub fn distance(self) -> Option<T> {
        match self {
            Self::Misses => None,
            Self::Touches(distance) | Self::Enters(distance) | Self::Leaves(distance) => Some(distance),
        }
    }
}

impl<T: Real> Ellipsoid<T> {
    /// Returns how a ray meets the surface at a height above the ellipsoid, in metres: where a camera sees the
    /// ground, if the ground has that height.
    ///
    /// The place is [`Ray::at`] the distance; [`to_geodetic`](Self::to_geodetic) gives its latitude and
    /// longitude. From an eye up to 10⁷ m high, the place is within 1e-8 m (`f64`) or 5 m (`f32`) of the
    /// surface, if the ray meets it at 3° or more.
    ///
    /// For a height other than 0 the surface is not an ellipsoid. The meeting with the ellipsoid whose axes
    /// are longer by the height is corrected by Newton's method; whether there is a meeting is told by that
    /// ellipsoid, which is off by 2e-6 of the height on the Earth.
    ///
    /// # Cases
    /// [`Meeting::Misses`] also for a height at which the ellipsoid would have no size.
    #[doc(alias = "ray intersection")]
    #[doc(alias = "pick")]
    #[must_use]
    pub fn meet(self, ray: &Ray<T>, height: T) -> Meeting<T> {
        let (a, b) = (self.a() + height, self.b() + height);
        if !(a > T::ZERO && b > T::ZERO && a.is_finite() && b.is_finite()) {
            return Meeting::Misses;
        }
        let scaled = |[x, y, z]: [T; 3]| [x / a, y / a, z / b];
        let (start, way) = (scaled(ray.start), scaled(ray.way));
        let square = |v: [T; 3]| dot(v, v);
        let (along, speed) = (dot(start, way), square(way));
        let length = square(start).sqrt();
        // |start|² − 1.
        let beyond = (length - T::ONE) * (length + T::ONE);
        // The difference of along² and speed · beyond: with the cross product nothing large cancels but at a
        // tangent.
        let rest = speed - square(cross(start, way));
        let allowed = T::of(16.0) * T::EPSILON * speed;
        let corrected = |distance: T| self.at_height(ray, distance, height);
        if beyond > T::of(4.0) * T::EPSILON {
            if along >= T::ZERO || rest < -allowed {
                return Meeting::Misses;
            }
            if rest <= allowed {
                return Meeting::Touches(-along / speed);
            }
            return Meeting::Enters(corrected(beyond / (rest.sqrt() - along)));
        }
        let root = max(rest, T::ZERO).sqrt();
        let far = if along > T::ZERO {
            -beyond / (along + root)
        } else {
            (root - along) / speed
        };
        Meeting::Leaves(corrected(max(far, T::ZERO)))
    }

    /// A distance along a ray, so changed that the height there is the given one.
    fn at_height(self, ray: &Ray<T>, distance: T, height: T) -> T {
        if height == T::ZERO {
            return distance;
        }
        let mut found = distance;
        for _ in 0..4 {
            let (rise, slope) = self.rise(ray, found);
            let step = (height - rise) / slope;
            // At a tangent the slope is 0: then the first distance is the best.
            found += select(step.abs() <= height.abs(), step, T::ZERO);
        }
        found
    }

    /// The height of a point of a ray, and how much it rises for a metre.
    fn rise(self, ray: &Ray<T>, distance: T) -> (T, T) {
        let place = self.to_geodetic(ray.at(distance));
        (place.height(), dot(place.lat_lon().to_direction().to_array(), ray.way))
    }

    /// Returns the height above the ellipsoid of the lowest place on the straight line between two points, in
    /// metres: the line of sight is free if that is above the ground. It is negative if the ellipsoid is in
    /// the way.
    ///
    /// Straight lines of light are bent by air; a common remedy is an Earth larger by 7/6.
    ///
    /// The worst error for points up to 1000 km high and 30° apart is 4 nm (`f64`) or 1.5 m (`f32`).
    ///
    /// ```
    /// use terrella::{Ellipsoid, Geodetic, LatLon};
    /// let earth = Ellipsoid::<f64>::WGS84;
    /// let at = |lat, lon, height| Geodetic::new(LatLon::new(lat, lon).unwrap(), height).unwrap();
    /// let (mast, boat) = (earth.to_ecef(at(54.0, 7.0, 50.0)), earth.to_ecef(at(54.0, 7.4, 10.0)));
    /// let lowest = earth.clearance(mast, boat);
    /// assert!((lowest - 9.113).abs() < 1e-3);
    /// ```
    #[doc(alias = "line of sight")]
    #[doc(alias = "intervisibility")]
    #[must_use]
    pub fn clearance(self, from: Ecef<T>, to: Ecef<T>) -> T {
        let ends = min(self.to_geodetic(from).height(), self.to_geodetic(to).height());
        let Ok(ray) = Ray::through(from, to) else {
            return ends;
        };
        let ([x, y, z], [to_x, to_y, to_z]) = (from.to_array(), to.to_array());
        let apart = [to_x - x, to_y - y, to_z - z];
        let whole = dot(apart, apart).sqrt();
        let scaled = |[x, y, z]: [T; 3]| [x / self.a(), y / self.a(), z / self.b()];
        let (start, way) = (scaled(ray.start), scaled(ray.way));
        // Nearest to the centre, with the ellipsoid stretched to a sphere: there the line is nearly level.
        let clipped = |distance: T| min(max(distance, T::ZERO), whole);
        let mut lowest = clipped(-(dot(start, way) / dot(way, way)));
        for _ in 0..3 {
            let (height, slope) = self.rise(&ray, lowest);
            // The slope grows by the curvature of the ground below.
            let curvature = T::ONE / (self.a() + height);
            lowest = clipped(lowest - slope / curvature);
        }
        min(ends, self.rise(&ray, lowest).0)
    }
}

fn dot<T: Real>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> T {
    a * x + b * y + c * z
}

fn cross<T: Real>([ax, ay, az]: [T; 3], [bx, by, bz]: [T; 3]) -> [T; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}
