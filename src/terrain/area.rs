use super::Tile;
use super::selection::after;
use crate::cube::{CubeMap, CubeProjection, FacePoint, ProjectionTask};
use crate::distortion::Ground;
use crate::math::Polynomial;
use crate::{Real, Shift};

impl Tile {
    /// Returns the area of the tile on the ellipsoid of a cube map, in square metres: what lies between its
    /// curved edges, not between geodesics through its corners.
    ///
    /// With an equal-area projection and the authalic shift it is the area of the ellipsoid divided by the
    /// number of tiles, for every tile of a level. Otherwise it is an integral of the map's scale by Gauss's
    /// formula, over quarters of the tile as small as it takes. No large numbers are subtracted, so small
    /// tiles are as exact as large ones.
    ///
    /// The worst relative error is 1e-13 (`f64`) or 2e-6 (`f32`), against areas of 25 digits. The tiles at the
    /// corners of the conformal cube are an exception: the scale vanishes there, and no figure is claimed.
    ///
    /// ```
    /// use terrella::cube::{CubeMap, Face, Quadrilateralized, S2Quadratic};
    /// use terrella::terrain::Tile;
    /// use terrella::{Ellipsoid, Shift};
    ///
    /// let earth = Ellipsoid::<f64>::WGS84;
    /// let equal = CubeMap::new(earth, Shift::Authalic, Quadrilateralized)?;
    /// let (tile, other) = (Tile::new(Face::Front, 10, 0, 0)?, Tile::new(Face::Top, 10, 500, 300)?);
    /// assert_eq!(tile.area(&equal), other.area(&equal));
    ///
    /// let unequal = CubeMap::new(earth, Shift::Geodetic, S2Quadratic)?;
    /// assert!(tile.area(&unequal) < 0.7 * other.area(&unequal));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "cell area")]
    #[must_use]
    pub fn area<T: Real, P: CubeProjection>(self, map: &CubeMap<T, P>) -> T {
        map.projection().with(Area { map, tile: self })
    }
}

struct Area<'a, T, P> {
    map: &'a CubeMap<T, P>,
    tile: Tile,
}

impl<T: Real, Q: CubeProjection> ProjectionTask for Area<'_, T, Q> {
    type Output = T;

    fn run<P: CubeProjection>(self, projection: P) -> T {
        let Self { map, tile } = self;
        let shifted = map.shifted();
        let ellipsoid = shifted.ellipsoid();
        if P::KEEPS_AREAS && (shifted.shift() == Shift::Authalic || ellipsoid.f() == T::ZERO) {
            let across = T::whole(1 << tile.level());
            let sixth = T::pick(4.0 * core::f64::consts::PI / 6.0, 2.094_395_2);
            return sixth * ellipsoid.authalic_radius_squared() / across / across;
        }
        integral(&Ground::new(map.with_projection(projection)), tile)
    }
}

/// How many levels below a tile its quarters go.
const DEEPEST: u8 = 10;

/// The area by quarters, each divided until its own quarters tell the same.
fn integral<T: Real, P: CubeProjection>(ground: &Ground<T, P>, tile: Tile) -> T {
    let estimate = sum(ground, tile);
    let allowed = T::pick(1e-14, 1e-6) * estimate;
    let deepest = if tile.level() + DEEPEST < Tile::MAX_LEVEL {
        tile.level() + DEEPEST
    } else {
        Tile::MAX_LEVEL
    };
    let mut total = T::ZERO;
    let mut next = Some(tile);
    while let Some(this) = next.filter(|this| tile.contains(*this)) {
        let whole = sum(ground, this);
        next = after(this);
        let Some(quarters) = this.children().filter(|_| this.level() < deepest) else {
            total += whole;
            continue;
        };
        let parts = quarters.map(|quarter| sum(ground, quarter));
        let [a, b, c, d] = parts;
        let all = (a + b) + (c + d);
        if (all - whole).abs() > allowed {
            let [first, ..] = quarters;
            next = Some(first);
        } else {
            total += all;
        }
    }
    total
}

/// Nodes of Gauss and Legendre on [−1, 1] from the middle to one side, each before its weight: eight, four and two
/// nodes in all.
const EIGHT: Polynomial<8, 8> = Polynomial::rounded([
    0.183_434_642_495_649_8, 0.362_683_783_378_361_98, 0.525_532_409_916_329, 0.313_706_645_877_887_29,
    0.796_666_477_413_626_74, 0.222_381_034_453_374_47, 0.960_289_856_497_536_23, 0.101_228_536_290_376_26,
]);
const FOUR: Polynomial<4, 4> = Polynomial::rounded([
    0.339_981_043_584_856_26, 0.652_145_154_862_546_1, 0.861_136_311_594_052_6, 0.347_854_845_137_453_9,
]);
const TWO: Polynomial<2, 2> = Polynomial::rounded([0.577_350_269_189_625_8, 1.0]);

/// Gauss's sum over a tile. A tile with a diagonal of the face, where projections may have creases, is the sum
/// of two triangles.
fn sum<T: Real, P: CubeProjection>(ground: &Ground<T, P>, tile: Tile) -> T {
    match tile.level() {
        0..=5 => by_rule(ground, tile, &T::all(&EIGHT)),
        6..=14 => by_rule(ground, tile, &T::all(&FOUR)),
        _ => by_rule(ground, tile, &T::all(&TWO)),
    }
}

fn by_rule<T: Real, P: CubeProjection>(ground: &Ground<T, P>, tile: Tile, rule: &[T]) -> T {
    let last = (1 << tile.level()) - 1;
    let (rising, falling) = (tile.i() == tile.j(), tile.i() + tile.j() == last);
    let half = T::of(0.5);
    let nodes = || {
        let halves = rule.chunks_exact(2).filter_map(|pair| match *pair {
            [node, weight] => Some([half * node, half * weight]),
            _ => None,
        });
        halves.flat_map(|[node, weight]| [[-node, weight], [node, weight]])
    };
    let mut sum = T::ZERO;
    for [s, p] in nodes() {
        for [t, q] in nodes() {
            let (s, t) = (half + s, half + t);
            if rising | falling {
                // Two triangles with an end of the diagonal in common: s goes away from it, t across.
                let far = T::ONE - s * t;
                let pairs = if rising {
                    [[s, s * t], [s * t, s]]
                } else {
                    [[s, far], [s * t, T::ONE - s]]
                };
                for pair in pairs {
                    sum += p * q * s * scale(ground, tile, pair);
                }
            } else {
                sum += p * q * scale(ground, tile, [s, t]);
            }
        }
    }
    let width = T::of(2.0) / T::whole(1 << tile.level());
    sum * width * width
}

/// The area on the ground for one of x and y; none where the map is singular.
fn scale<T: Real, P: CubeProjection>(ground: &Ground<T, P>, tile: Tile, place: [T; 2]) -> T {
    let point: FacePoint<T> = tile.point(place).unwrap_or(tile.centre());
    ground.jacobian(point).map_or(T::ZERO, |jacobian| jacobian.area())
}
