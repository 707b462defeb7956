use super::auxiliary::nearly_round;
use super::degrees::{Split, latitude_difference, longitude_difference};
use super::sum::Sum;
use crate::latitude::UnsupportedFlattening;
use crate::{Ellipsoid, LatLon, Real};

/// Areas of fields, to some hundred kilometres across: in `f32` as exact as the corners.
///
/// [`Area`](super::Area) sums the areas between each edge and the equator. What a field is less than these it
/// loses to rounding, in `f32` all of it. Here only differences from the polygon's first corner count.
/// [`Self::local`] takes corners as offsets from an origin, which single precision holds to 2⁻²⁴ of
/// themselves, where it holds latitudes and longitudes to 0.4 m. Corners may be anywhere, at a pole and round
/// it, too.
///
/// For a perimeter P and corners at most D apart, D ≤ R/5, an error is at most P D (r + 0.038 e² (D/R)² +
/// 0.032 (D/R)⁴), R = a(1 − f)², r = 3·10⁻¹⁶ in `f64` and 1.2·10⁻⁷ in `f32`. Of fields about as wide as long,
/// their middle 0 to 200 km from the origin, at latitudes 0 to 89.9, the largest seen were, as a part of the
/// area,
///
/// | across | `f64` | `f32` |
/// |---|---|---|
/// | 6 m to 20 km | 10⁻⁸ | 5·10⁻⁷ |
/// | 100 km | 3·10⁻⁷ | 6·10⁻⁷ |
/// | 200 km | 10⁻⁶ | 10⁻⁶ |
///
/// Corners are projected orthographically on the tangent plane at the first one. The triangle of that corner
/// and the edge from b to c has the area ½ b × c there, and ½ b × c (1 + (b² + c² + (c − b)²)/(8MN)) on the
/// ellipsoid: on a sphere of the same curvature 1/(MN) edges are straight in the gnomonic projection, and the
/// integral of its areal scale over the triangle is, to the second order, this polynomial.
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

/// A polygon of geodesics: add its corners in order, then ask for its area. From [`PlanarArea::polygon`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlanarPolygon<T> {
    area: PlanarArea<T>,
    first: Option<(LatLon<T>, Tangent<T>)>,
    /// The last corner, east and north of the first in metres.
    last: [T; 2],
    doubled: Sum<T>,
}

/// The ellipsoid about a polygon's first corner.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Tangent<T> {
    /// Of 1, u, u², u³ with u in radians north: the distance from the axis.
    axis: [T; 4],
    /// Of u, u², u³: the distance to the north in the tangent plane.
    north: [T; 3],
    sin: T,
    /// 1/(8MN), an eighth of the curvature.
    curvature: T,
}

impl<T: Real> PlanarArea<T> {
    /// For places given as latitudes and longitudes.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        nearly_round(ellipsoid).map(|ellipsoid| Self::within(ellipsoid, T::ZERO))
    }

    /// For places given as degrees north and east of an origin.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn local(ellipsoid: Ellipsoid<T>, origin: LatLon<T>) -> Result<Self, UnsupportedFlattening<T>> {
        nearly_round(ellipsoid).map(|ellipsoid| Self::within(ellipsoid, origin.lat()))
    }

    /// For an ellipsoid known to be nearly round, and the latitude that those of the places are counted from.
    pub(crate) const fn within(ellipsoid: Ellipsoid<T>, origin: T) -> Self {
        Self { ellipsoid, origin }
    }

    /// A polygon whose corners are added one by one.
    #[must_use]
    pub fn polygon(&self) -> PlanarPolygon<T> {
        PlanarPolygon {
            area: *self,
            first: None,
            last: [T::ZERO; 2],
            doubled: Sum::default(),
        }
    }

    fn tangent(&self, place: LatLon<T>) -> Tangent<T> {
        let half = T::of(0.5);
        let third = T::of(1.0 / 3.0);
        let (s, c) = Split::sum(self.origin, place.lat()).sin_cos();
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
        let [east, north] = tangent.plane(latitude_difference(first, corner), longitude_difference(first, corner));
        let [e, n] = self.last;
        let (de, dn) = (east - e, north - n);
        let squares = (e * e + n * n) + (east * east + north * north) + (de * de + dn * dn);
        let doubled = e * dn - n * de;
        self.doubled.add(doubled + doubled * (squares * tangent.curvature));
        self.last = [east, north];
    }

    /// The area in m², positive if the corners run counter-clockwise, negative if clockwise.
    #[must_use]
    pub fn area(&self) -> T {
        T::of(0.5) * self.doubled.value()
    }
}

impl<T: Real> Tangent<T> {
    /// East and north in the tangent plane in metres, of a place so far north and east of the first corner.
    #[inline(always)]
    fn plane(&self, lat: Split<T>, lon: Split<T>) -> [T; 2] {
        let u = (lat.angle + lat.rest) * T::of(core::f64::consts::PI / 180.0);
        let (sin, cos) = lon.half().sin_cos();
        let [p, q, r, s] = self.axis;
        let axis = p + u * (q + u * (r + u * s));
        let [p, q, r] = self.north;
        let meridian = u * (p + u * (q + u * r));
        let across = (axis + axis) * sin;
        [across * cos, meridian + across * sin * self.sin]
    }
}
