use super::flatness::witnesses;
use super::patch::narrow;
use super::vector::{along, difference, dot};
use super::{Base, Patches, Tile};
use crate::cube::CubeProjection;
use crate::distortion::Singular;
use crate::math::{max, select};
use crate::{Direction, Dual, Ecef, Real};

/// First and second derivatives with respect to two variables.
type Second = Dual<Dual<f64, 2>, 2>;

/// A tile as a Taylor series of the second order about its middle: another way to compute vertices in single
/// precision, without a grid in memory. The whole tile is at the height that its base has in the middle.
///
/// The coefficients are computed in double precision and rounded to single precision. A vertex relative to
/// the camera is [`origin`](Self::origin), computed once per frame, plus [`offset`](Self::offset) and, for
/// terrain, plus h·n, where h is the height above the base's middle. [`Patches::truncation`] bounds the error
/// of the series; between two adjacent tiles the gap may be twice that.
///
/// ```
/// use terrella::cube::{Balanced, CubeMap, Face};
/// use terrella::terrain::{Base, Patches, Tile};
/// use terrella::{Ecef, Ellipsoid, Shift};
///
/// let patches = Patches::new(CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Balanced)?);
/// let tile = Tile::new(Face::Front, 12, 2100, 2200)?;
/// assert!(patches.truncation(12) < 1e-3);
/// let series = patches.series(tile, Base::default())?;
/// let camera = Ecef::new(6_378_337.0, 0.0, 0.0)?;
/// let (origin, offset) = (series.origin(camera), series.offset([1.0, 1.0]));
/// let corner = patches.of(tile, Base::default()).seen_from(camera).corners()[0];
/// for k in 0..3 {
///     assert!((origin[k] + offset[k] - corner[k]).abs() < 0.05);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "Taylor series")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Series {
    anchor: [f64; 3],
    /// The coefficients of u, v, u², uv, v².
    coefficients: [[f32; 3]; 5],
}

impl Series {
    /// Returns the middle of the tile at the base's height, in metres along Earth axes.
    #[must_use]
    pub fn anchor(&self) -> Ecef<f64> {
        let [x, y, z] = self.anchor;
        Ecef::within(x, y, z)
    }

    /// Returns the coefficients of u, v, u², uv and v², in metres, for a shader that evaluates
    /// [`offset`](Self::offset).
    #[must_use]
    pub const fn coefficients(&self) -> [[f32; 3]; 5] {
        self.coefficients
    }

    /// Returns the middle of the tile relative to a camera, in metres: subtracted in double precision, then
    /// rounded to single precision.
    #[must_use]
    #[inline]
    pub fn origin(&self, camera: Ecef<f64>) -> [f32; 3] {
        difference(self.anchor, camera.to_array()).map(narrow)
    }

    /// Returns the vector from the middle of the tile to the base at (u, v) = (2s − 1, 2t − 1) ∈ [−1, 1]², in
    /// metres.
    ///
    /// The error is at most [`Patches::truncation`], scaled by the ratio of (radius of curvature + base
    /// height) to the radius of curvature, plus 3·10⁻⁷ of the vector's length.
    #[must_use]
    #[inline(always)]
    pub fn offset(&self, place: [f32; 2]) -> [f32; 3] {
        evaluate(self.coefficients, place)
    }
}

/// Evaluates u(a + u·aa) + v(b + u·ab + v·bb).
#[inline(always)]
fn evaluate<T: Real>([a, b, aa, ab, bb]: [[T; 3]; 5], [u, v]: [T; 2]) -> [T; 3] {
    let of_u = along(a, u, aa).map(|w| u * w);
    along(of_u, v, along(along(b, u, ab), v, bb))
}

impl<P: CubeProjection> Patches<P> {
    /// Returns the series of a tile; the whole tile is at the height that the base has in its middle.
    ///
    /// # Errors
    /// [`Singular`] if the projection has no derivatives in the tile's middle. This happens at level 0 on
    /// faces whose centre is the tip of a cone.
    pub fn series(&self, tile: Tile, base: Base) -> Result<Series, Singular<f64>> {
        let (anchor, coefficients) = self.expansion(tile, base.at([1, 1], 3));
        if coefficients.as_flattened().iter().all(|c| c.is_finite()) {
            Ok(Series {
                anchor,
                coefficients: coefficients.map(|vector| vector.map(narrow)),
            })
        } else {
            Err(Singular(tile.centre()))
        }
    }

    /// Returns a bound on the distance between the series of any tile of a level, on the ellipsoid, and the
    /// true ground, in metres, not counting the rounding to single precision. Returns infinity if some tile
    /// of the level has no series. A level above 30 is treated as 30.
    ///
    /// The neglected terms are of the third order: the bound falls to an eighth at each next level, until
    /// rounding dominates (4 ulps of the planet's radius, which are added). On a crease, and in the conformal
    /// cube's corners, it falls as [`flatness`](Self::flatness) does. As there, the result is the largest
    /// value in the same tiles, here at 16 points along their edges, times 1.25. A call takes a few
    /// milliseconds.
    ///
    /// ```
    /// use terrella::cube::{CubeMap, Adjusted};
    /// use terrella::terrain::Patches;
    /// use terrella::{Ellipsoid, Shift};
    ///
    /// let patches = Patches::new(CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Adjusted)?);
    /// let [coarse, fine] = [8, 9].map(|level| patches.truncation(level));
    /// assert!((coarse / fine - 8.0).abs() < 0.3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn truncation(&self, level: u8) -> f64 {
        const PARTS: u32 = 4;
        let mut most = 0.0;
        for tile in witnesses::<P>(level) {
            let (anchor, coefficients) = self.expansion(tile, 0.0);
            for n in 0..=PARTS {
                for m in 0..=PARTS {
                    if !(n % PARTS == 0 || m % PARTS == 0) {
                        continue;
                    }
                    let [foot, _] = self.ground(tile.node([m, n], PARTS));
                    let place = [m, n].map(|index| f64::from(2 * index) / f64::from(PARTS) - 1.0);
                    let apart = difference(difference(foot, anchor), evaluate(coefficients, place));
                    let square = dot(apart, apart);
                    most = max(most, select(square.is_finite(), square, f64::INFINITY));
                }
            }
        }
        1.25 * most.sqrt() + 4.0 * f64::EPSILON * self.map().shifted().ellipsoid().a()
    }

    /// The middle of a tile at a height, and the coefficients of its series.
    fn expansion(&self, tile: Tile, height: f64) -> ([f64; 3], [[f64; 3]; 5]) {
        let middle = tile.centre::<f64>();
        let shifted = self.map().shifted().map(Second::from_plain);
        let point: [Second; 2] = Dual::variables(Dual::variables([middle.x(), middle.y()]));
        let [x, y, z] = self.map().projection().vector(tile.face(), point);
        let normal = shifted.normal(Direction::within(x, y, z));
        let lifted = along(shifted.ellipsoid().foot(normal), Second::of(height), normal.to_array());

        let half = 1.0 / f64::from(1_u32 << tile.level());
        let square = half * half;
        let [x, y, z] = lifted.map(|component| {
            let [by_x, by_y] = component.slopes();
            let ([xx, xy], [_, yy]) = (by_x.slopes(), by_y.slopes());
            [
                half * by_x.value(),
                half * by_y.value(),
                0.5 * square * xx,
                square * xy,
                0.5 * square * yy,
            ]
        });
        let mut coefficients = [[0.0; 3]; 5];
        for (((vector, x), y), z) in coefficients.iter_mut().zip(x).zip(y).zip(z) {
            *vector = [x, y, z];
        }
        (lifted.map(Real::plain), coefficients)
    }
}
