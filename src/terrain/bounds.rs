use super::vector::{along, cross, difference, dot, normalised};
use super::{Heights, OrientedBox, Tile};
use crate::Real;
use crate::cube::{CubeMap, CubeProjection};
use crate::math::{max, min, select};

/// Boxes and spheres that contain the tiles of a cube map with their terrain.
///
/// Every point of a tile at a height in its range along the ellipsoid's normal is inside, for any ellipsoid and shift and for every
/// projection of this crate. In the order of the computation:
///
/// 1. *The tile in gnomonic coordinates.* Let (u, v) be those of the face. In every projection of this crate u rises with x, so that it is
///    largest in a tile on the edge of larger x; and along an edge it exceeds its larger value at the ends by at most C·l²/8, where l is the
///    edge's length in units of y, and C = 1.25. (Most have C = 0: between the creases u is monotonic in y. Measured are 0.08 for the
///    COBE cubes, 0.5 for `square`, 1.03 for `vertex`; `tests/terrain/bounds.rs` searches.) Taken for both halves of every edge, with
///    eight points of the tile's boundary, this gives a rectangle of u and v: the directions of the tile are inside the spherical quadrangle Q
///    of its corners. A projection of a user's own has to keep to this, or is bounded only as far as it does.
/// 2. *Q from the middle.* C is the direction of the tile's middle, n the ellipsoid's normal there, F its foot. Q is inside the cap about C
///    through its farthest corner, for caps are convex; let its radius be θ. Its directions D project from the centre to a convex quadrangle of the
///    tangent plane of n, which lies in the rectangle p₀ ≤ p ≤ p₁, q₀ ≤ q ≤ q₁ of its corners along axes e₁, e₂; and e₁·D = p/√(1 + p² + q²)
///    rises with p.
/// 3. *Ground and normal as maps of the sphere.* G(D) is the foot and N(D) the normal where D leads. Their singular values are within
///    [λ₀, λ₁] and [κ₀, κ₁]: along the meridian κ = dφ/dξ, along the parallel κ = cos φ/cos ξ, for which the shift's formula has bounds; λ is κ
///    times a radius of curvature, between b²/a and a²/b. Where |φ − ξ| ≤ δ, the derivatives of G − ρD and N − κD, with ρ and κ the means
///    of the bounds, have norms of at most σ = √(((λ₁ − λ₀)/2)² + λ₁ρδ²) and likewise σ′.
/// 4. *Along e₁ and e₂*, at a height h: the point is within (σ + |h|σ′)θ of F + (ρ + hκ)(D − C).
/// 5. *Along n*: the ellipsoid lies below the plane through F, and above the sphere of its least radius of curvature r that
///    touches it there (Blaschke), so by no more than |G(D) − F|²/2r ≤ (λ₁θ)²/2r below; h adds h·cos γ with 1 − cos γ ≤ (κ₁θ)²/2.
///
/// What rounding may do, 16 ulps of the planet's radius, is added.
///
/// The box of a tile is wider than need be by 1 to 2 % on the Earth for the sake of 3 (not at all on a sphere), and by what the tile is
/// askew; the coarsest levels more.
///
/// ```
/// use terrella::cube::{CubeMap, Face, Quadrilateralized};
/// use terrella::terrain::{Enclosure, Heights, Tile};
/// use terrella::{Ellipsoid, Shift};
///
/// let map = CubeMap::new(Ellipsoid::<f64>::wgs84(), Shift::Authalic, Quadrilateralized)?;
/// let enclosure = Enclosure::new(map);
/// let tile = Tile::new(Face::Front, 10, 600, 700)?;
/// let bounds = enclosure.of(tile, Heights::new(100.0, 500.0)?);
/// let [x, y, z] = bounds.half();
/// assert!(x < 6_000.0 && y < 5_000.0 && z < 205.0);
/// assert!(bounds.sphere().radius < 7_500.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Enclosure<T, P> {
    map: CubeMap<T, P>,
    ground: Spread<T>,
    normal: Spread<T>,
    /// The least radius of curvature.
    radius: T,
}

/// The singular values of a map of the sphere: their mean, the largest, and how far the derivative is from the mean.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Spread<T> {
    mean: T,
    largest: T,
    apart: T,
}

impl<T: Real> Spread<T> {
    fn new([low, high]: [T; 2], angle: T) -> Self {
        let half = T::of(0.5);
        let (mean, width) = (half * (low + high), half * (high - low));
        Self {
            mean,
            largest: high,
            apart: (width * width + high * mean * (angle * angle)).sqrt(),
        }
    }
}

/// C/8 for edges of half a tile, in units of a tile's width squared, where a face's is 2.
const BULGE: f64 = 1.25 / 8.0 / 4.0;

impl<T: Real, P: CubeProjection> Enclosure<T, P> {
    /// Of the tiles of a cube map.
    #[must_use]
    pub fn new(map: CubeMap<T, P>) -> Self {
        let ellipsoid = map.shifted().ellipsoid();
        let (a, b) = (ellipsoid.a(), ellipsoid.b());
        let [_, correction] = map.shifted().corrections();
        let (angle, [low, high]) = correction.bounds();
        let (flat, steep) = (a * (a / b), b * (b / a));
        let radius = min(flat, steep);
        Self {
            map,
            ground: Spread::new([low * radius, high * max(flat, steep)], angle),
            normal: Spread::new([low, high], angle),
            radius,
        }
    }

    /// The cube map.
    #[must_use]
    pub fn map(&self) -> CubeMap<T, P> {
        self.map
    }

    /// The box of a tile with terrain of these heights: its third axis is the normal in the tile's middle, its first in the direction of x there.
    #[must_use]
    pub fn of(&self, tile: Tile, heights: Heights<T>) -> OrientedBox<T> {
        let face = tile.face();
        let (projection, shifted) = (self.map.projection(), self.map.shifted());
        let middle = projection.unproject(tile.centre());
        let normal = shifted.normal(middle);
        let foot = shifted.ellipsoid().foot(normal);
        let middle = face.to_local(middle.to_array());
        let n = face.to_local(normal.to_array());
        let first = normalised(along(
            [T::ONE, T::ZERO, T::ZERO],
            -dot([T::ONE, T::ZERO, T::ZERO], n),
            n,
        ));
        let axes = [first, cross(n, first), n];

        let [[left, right], [down, up]] = self.gnomonic(tile);
        let mut chord = T::ZERO;
        let none = T::pick(f64::MAX, f32::MAX);
        let mut reach = [[none, -none]; 2];
        for corner in [[left, down], [right, down], [left, up], [right, up]].map(|[u, v]| [u, v, T::ONE]) {
            let apart = difference(normalised(corner), middle);
            chord = max(chord, dot(apart, apart));
            let outward = dot(n, corner);
            for (range, axis) in reach.iter_mut().zip(axes) {
                let p = dot(axis, corner) / outward;
                *range = [min(range[0], p), max(range[1], p)];
            }
        }
        // 2 asin(c/2) ≤ c(1 + c²/18) up to a right angle.
        let angle = chord.sqrt() * (T::ONE + T::of(0.0556) * chord);

        let [p, q] = reach;
        let [first, second] = [(p, q, axes[0]), (q, p, axes[1])].map(|(p, q, axis)| {
            let from = dot(axis, middle);
            self.across(sines(p, q).map(|s| s - from), angle, heights)
        });
        let third = self.outward(angle, heights);
        let rest = T::of(16.0) * T::EPSILON * (self.ground.largest + max(heights.low().abs(), heights.high().abs()));
        let half = T::of(0.5);
        let mut centre = face.to_local(foot);
        let mut extent = [T::ZERO; 3];
        for ((extent, axis), [low, high]) in extent.iter_mut().zip(axes).zip([first, second, third]) {
            centre = along(centre, half * (low + high), axis);
            *extent = half * (high - low) + rest;
        }
        OrientedBox {
            centre: face.to_earth(centre),
            axes: axes.map(|axis| face.to_earth(axis)),
            half: extent,
        }
    }
    /// The ranges of u and of v in a tile (step 1).
    #[inline(always)]
    fn gnomonic(&self, tile: Tile) -> [[T; 2]; 2] {
        const BOUNDARY: [[u32; 2]; 8] = [[0, 0], [1, 0], [2, 0], [0, 1], [2, 1], [0, 2], [1, 2], [2, 2]];
        let projection = self.map.projection();
        let none = T::pick(f64::MAX, f32::MAX);
        let mut ranges = [[none, -none]; 2];
        for node in BOUNDARY {
            let point = tile.node::<T>(node, 2);
            let [right, up, outward] = projection.inverse(tile.face(), [point.x(), point.y()]);
            for (range, w) in ranges.iter_mut().zip([right / outward, up / outward]) {
                *range = [min(range[0], w), max(range[1], w)];
            }
        }
        let width = T::of(2.0) / T::whole(1 << tile.level());
        let rest = T::of(BULGE) * (width * width) + T::of(8.0) * T::EPSILON;
        ranges.map(|[low, high]| [low - rest, high + rest])
    }

    /// The range along an axis of the tangent plane, from the foot, for the sines by which directions of an angle go that way (step 4).
    #[inline(always)]
    fn across(&self, [low, high]: [T; 2], angle: T, heights: Heights<T>) -> [T; 2] {
        let none = T::pick(f64::MAX, f32::MAX);
        let mut range = [none, -none];
        for height in [heights.low(), heights.high()] {
            let scale = self.ground.mean + height * self.normal.mean;
            let rest = (self.ground.apart + height.abs() * self.normal.apart) * angle;
            let (a, b) = (scale * low, scale * high);
            range = [min(range[0], min(a, b) - rest), max(range[1], max(a, b) + rest)];
        }
        range
    }

    /// The range along the normal, from the foot (step 5).
    #[inline(always)]
    fn outward(&self, angle: T, heights: Heights<T>) -> [T; 2] {
        let half = T::of(0.5);
        let (chord, turn) = (self.ground.largest * angle, self.normal.largest * angle);
        let (sag, versine) = (half * (chord * (chord / self.radius)), half * (turn * turn));
        [
            heights.low() - max(heights.high(), T::ZERO) * versine - sag,
            heights.high() + max(-heights.low(), T::ZERO) * versine,
        ]
    }
}

/// The range of p/√(1 + p² + q²).
#[inline(always)]
fn sines<T: Real>([low, high]: [T; 2], [from, to]: [T; 2]) -> [T; 2] {
    let least = max(max(from, -to), T::ZERO);
    let most = max(to, -from);
    let sine = |p: T, q: T| p / (T::ONE + p * p + q * q).sqrt();
    [
        sine(low, select(low < T::ZERO, least, most)),
        sine(high, select(high < T::ZERO, most, least)),
    ]
}
