use super::angle::{latitude_difference, longitude_difference};
use super::nearly_round;
use crate::latitude::UnsupportedFlattening;
use crate::math::{DoubleWord, atan2_degrees, hypot, select};
use crate::{Ellipsoid, LatLon, Real};

/// Areas of fields of up to some hundred kilometres, in the tangent plane: in `f32` as exact as the corners.
///
/// [`Area`](super::Area) adds the areas between the edges and the equator, which are far larger than a field:
/// in `f32` nothing of the field is left. Here only differences from the polygon's first corner count.
/// [`PlanarArea::local`] takes corners as offsets from an origin: `f32` holds offsets to 2⁻²⁴ of themselves,
/// latitudes and longitudes only to 0.4 m. Corners may be anywhere, also at a pole and round it.
///
/// For a perimeter P and corners at most D apart, D ≤ R/5, the error is at most P D (r + 0.038 e² (D/R)² +
/// 0.032 (D/R)⁴), with R = a(1 − f)² and r = 3·10⁻¹⁶ (`f32`: 1.2·10⁻⁷). The largest errors seen, as a part of
/// the area, of fields about as wide as long, with their middle 0 to 200 km from the origin, at latitudes 0
/// to 89.9:
///
/// | across | `f64` | `f32` |
/// |---|---|---|
/// | 6 m to 20 km | 10⁻⁸ | 5·10⁻⁷ |
/// | 100 km | 3·10⁻⁷ | 6·10⁻⁷ |
/// | 200 km | 10⁻⁶ | 10⁻⁶ |
///
/// Corners are projected orthographically on the tangent plane at the first one. The triangle of that corner
/// and the edge from b to c has the area ½ b × c in the plane, and ½ b × c (1 + (b² + c² + (c − b)²)/(8MN))
/// on the ellipsoid: edges are straight in the gnomonic projection of the sphere with the same curvature
/// 1/(MN), and the integral of its areal scale over the triangle is this polynomial, to the second order.
///
/// ```
/// use terrella::geodesic::PlanarArea;
/// use terrella::{Ellipsoid, LatLon};
/// let home = LatLon::new(47.397_742_f32, 8.545_594)?;
/// let area = PlanarArea::local(Ellipsoid::WGS84, home)?;
/// // Offsets in degrees, from the difference in f64 or in whole numbers.
/// let mut field = area.polygon();
/// for (north, east) in [(0.0, 0.0), (0.0, 0.000_8), (0.000_5, 0.000_9), (0.000_6, 0.0)] {
///     field.add(LatLon::new(north, east)?);
/// }
/// assert!((field.area() - 3944.617).abs() < 0.004);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlanarArea<T> {
    ellipsoid: Ellipsoid<T>,
    /// The latitude that those of the corners are counted from.
    origin: T,
}

/// The area of a polygon whose edges are geodesics, from [`PlanarArea::polygon`]: add its corners in order,
/// then ask.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlanarPolygon<T> {
    area: PlanarArea<T>,
    first: Option<(LatLon<T>, Tangent<T>)>,
    /// The last corner, east and north of the first in metres.
    last: [T; 2],
    doubled: DoubleWord<T>,
}

/// The ellipsoid about a polygon's first corner.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Tangent<T> {
    /// The distance from the axis, by powers 1, u, u², u³ of the radians u to the north.
    axis: [T; 4],
    /// The distance to the north in the tangent plane, by powers u, u², u³.
    north: [T; 3],
    sin: T,
    /// 1/(8MN), an eighth of the curvature.
    curvature: T,
}

impl<T: Real> PlanarArea<T> {
    /// Makes the area measure of an ellipsoid, for corners given as latitudes and longitudes.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        nearly_round(ellipsoid).map(|ellipsoid| Self::within(ellipsoid, T::ZERO))
    }

    /// Makes the area measure of an ellipsoid, for corners given as degrees north and east of an origin.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn local(ellipsoid: Ellipsoid<T>, origin: LatLon<T>) -> Result<Self, UnsupportedFlattening<T>> {
        nearly_round(ellipsoid).map(|ellipsoid| Self::within(ellipsoid, origin.lat()))
    }

    /// For an ellipsoid known to be nearly round, and the latitude that those of the corners are counted
    /// from.
    pub(crate) const fn within(ellipsoid: Ellipsoid<T>, origin: T) -> Self {
        Self { ellipsoid, origin }
    }

    /// Makes a polygon without corners; [`PlanarPolygon::add`] adds them one by one.
    #[must_use]
    pub fn polygon(&self) -> PlanarPolygon<T> {
        PlanarPolygon {
            area: *self,
            first: None,
            last: [T::ZERO; 2],
            doubled: DoubleWord::default(),
        }
    }

    pub(crate) fn tangent(&self, place: LatLon<T>) -> Tangent<T> {
        let half = T::of(0.5);
        let third = T::of(1.0 / 3.0);
        let (s, c) = DoubleWord::sum(self.origin, place.lat()).sin_cos_degrees();
        let e2 = self.ellipsoid.e2();
        let w2 = T::ONE - e2 * s * s;
        // M = a(1 − e²)/W³, N = a/W, (N cos φ)′ = −M sin φ, M′ = 3Me² sin φ cos φ/W².
        let n = self.ellipsoid.a() / w2.sqrt();
        let m = n * (T::ONE - e2) / w2;
        let rise = T::of(3.0) * e2 / w2;
        let m1 = m * rise * s * c;
        let m2 = half * m * rise * (c * c - s * s + T::of(5.0) / T::of(3.0) * rise * s * s * c * c);
        Tangent {
            axis: [
                n * c,
                -m * s,
                -half * (m * c + m1 * s),
                third * ((half * m - m2) * s - m1 * c),
            ],
            // ∫M(φ + u) cos u du.
            north: [m, half * m1, third * (m2 - half * m)],
            sin: s,
            curvature: T::of(0.125) / (m * n),
        }
    }
}

impl<T: Real> PlanarPolygon<T> {
    /// Adds a corner.
    pub fn add(&mut self, corner: LatLon<T>) {
        let Some((first, tangent)) = self.first else {
            self.first = Some((corner, self.area.tangent(corner)));
            return;
        };
        self.reach(&tangent, tangent.seen(first, corner));
    }

    /// Adds a corner other than the first, by its place in the plane.
    #[inline(always)]
    pub(crate) fn reach(&mut self, tangent: &Tangent<T>, [east, north]: [T; 2]) {
        let [e, n] = self.last;
        let (de, dn) = (east - e, north - n);
        let squares = (e * e + n * n) + (east * east + north * north) + (de * de + dn * dn);
        let doubled = e * dn - n * de;
        self.doubled.add(doubled + doubled * (squares * tangent.curvature));
        self.last = [east, north];
    }

    /// Returns the area in m², positive if the corners run counter-clockwise, negative if clockwise; 0 for
    /// fewer than three corners.
    #[must_use]
    pub fn area(&self) -> T {
        T::of(0.5) * self.doubled.value()
    }
}

impl<T: Real> Tangent<T> {
    /// An eighth of the curvature.
    pub(crate) const fn curvature(&self) -> T {
        self.curvature
    }

    /// East and north of the first corner in the tangent plane, in metres.
    #[inline(always)]
    pub(crate) fn seen(&self, first: LatLon<T>, corner: LatLon<T>) -> [T; 2] {
        self.plane(latitude_difference(first, corner), longitude_difference(first, corner))
    }

    /// Northward and eastward degrees from the first corner to a place in the tangent plane, given as metres
    /// east and north: the inverse of [`Self::seen`].
    pub(crate) fn degrees(&self, [east, north]: [T; 2]) -> [T; 2] {
        let (one, half) = (T::ONE, T::of(0.5));
        let [axis, ..] = self.axis;
        let [m, q, r] = self.north;
        // 1/N, cos φ, and how far the surface falls below the plane.
        let w = T::of(8.0) * self.curvature * m;
        let cos = axis * w;
        let up = -half * (north * north / m + east * east * w);
        // Outward from the axis; the distance from the axis less that of the first corner, without
        // cancellation.
        let out = up * cos - north * self.sin;
        let distance = hypot(axis + out, east);
        let sum = distance + axis;
        let sum = select(sum > T::ZERO, sum, one);
        let rise = ((axis + axis + out) * out + east * east) / sum;
        // Along the meridian: u from its polynomial.
        let meridian = (north * cos + up * self.sin) * cos - rise * self.sin;
        let mut u = meridian / m;
        u = meridian / (m + u * (q + u * r));
        u = meridian / (m + u * (q + u * r));
        let lon = atan2_degrees(east, axis + out);
        [u * T::of(180.0 / core::f64::consts::PI), lon]
    }

    /// The radius of the sphere with the curvature at the first corner.
    pub(crate) fn radius(&self) -> T {
        (T::of(0.125) / self.curvature).sqrt()
    }

    /// East and north in the tangent plane in metres, of a place so far north and east of the first corner.
    #[inline(always)]
    fn plane(&self, lat: DoubleWord<T>, lon: DoubleWord<T>) -> [T; 2] {
        let u = lat.value() * T::of(core::f64::consts::PI / 180.0);
        let (sin, cos) = lon.half().sin_cos_degrees();
        let [p, q, r, s] = self.axis;
        let axis = p + u * (q + u * (r + u * s));
        let [p, q, r] = self.north;
        let meridian = u * (p + u * (q + u * r));
        let across = (axis + axis) * sin;
        [across * cos, meridian + across * sin * self.sin]
    }
}
