use super::coverage::BOUNDARY;
use super::vector::{along, cross, difference, dot, normalised};
use super::{Heights, OrientedBox, Tile};
use crate::cube::{CubeMap, CubeProjection};
use crate::math::{max, min, select};
use crate::{Direction, Real};

/// Oriented bounding boxes and bounding spheres that contain the tiles of a cube map with their terrain.
///
/// The box of a tile contains every point above or below the tile whose height, along the ellipsoid's normal,
/// is in the given range. This holds for any ellipsoid and shift, and for every projection of this crate. The
/// computation has five steps:
///
/// 1. *The tile's edges.* Let C be the direction of the tile's middle, and project centrally to the plane
///    that touches the unit sphere at C. There each half of an edge stays within ½μ + lw/128 of the straight
///    line between its ends. Here l is the distance between the ends of the edge, μ is the distance of the
///    edge's middle from their line, and w = 2^(1−L) is the edge's length in x or y. This is the only
///    property of a projection that is used, and it was found by a search, not by formulas: over every tile
///    to level 8 and 200 000 deeper ones of each projection, most of them where it is singular, the largest
///    value in place of 1/128 was 0.0043 (`vertex`; nothing at all in nine of them). If a projection of your
///    own bends its edges more, its boxes may be too small. In a cube
///    [stretched](crate::cube::Stretched) by c, w counts c or 1/c times, the larger; there the largest value
///    was 0.0054. A tile of such a cube that reaches more than 66° from its middle is in a box around the
///    whole planet.
/// 2. *The tile's directions.* The map is one to one, so the tile lies within its edges, and hence in the
///    rectangle around eight points of them, widened by the bound of step 1. The corners of that rectangle
///    span the convex spherical quadrangle Q. Q lies inside the cap about C through its farthest corner; let
///    θ be the radius of that cap. Let F be the point on the ellipsoid that C leads to, and n the ellipsoid's
///    normal there. On the plane that touches the unit sphere at n, Q is again a convex quadrangle; it lies
///    in the rectangle p₀ ≤ p ≤ p₁, q₀ ≤ q ≤ q₁ of its corners along axes e₁, e₂. For D in Q, e₁·D = p/√(1 +
///    p² + q²), which increases with p.
/// 3. *Ground and normal as maps of the sphere.* A direction D leads to the point G(D) on the ellipsoid,
///    where the normal is N(D). The singular values of the derivatives of G and N are within [λ₀, λ₁] and
///    [κ₀, κ₁]. Along the meridian κ = dφ/dξ and along the parallel κ = cos φ/cos ξ, for which the shift's
///    formula gives bounds; λ is κ times a radius of curvature, which is between b²/a and a²/b. Let |φ − ξ| ≤
///    δ, and let ρ and κ be the means of the bounds. Then the derivatives of G − ρD and N − κD have norms of
///    at most σ = √(((λ₁ − λ₀)/2)² + λ₁ρδ²) and σ′ (the same with κ).
/// 4. *Along e₁ and e₂*: a point at height h is within (σ + |h|σ′)θ of F + (ρ + hκ)(D − C).
/// 5. *Along n*: the ellipsoid lies below the plane through F, and above the sphere of its least radius of
///    curvature r that touches it there (Blaschke). It is therefore at most |G(D) − F|²/2r ≤ (λ₁θ)²/2r below
///    the plane. The height adds h·cos γ with 1 − cos γ ≤ (κ₁θ)²/2.
///
/// A margin of 16 ulps of the planet's radius is added for rounding.
///
/// On the Earth a tile's box is wider than the tile by at most 3 % where edges are nearly straight, by 7 % in
/// the quadrilateralized, vertex and conformal cubes, and by 16 % in HEALPix's, where edges bend; at levels 0
/// to 2 by 10 %, at HEALPix's level 0 by 26 %.
///
/// ```
/// use terrella::cube::{CubeMap, Face, Quadrilateralized};
/// use terrella::terrain::{Enclosure, Heights, Tile};
/// use terrella::{Ellipsoid, Shift};
///
/// let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Quadrilateralized)?;
/// let enclosure = Enclosure::new(map);
/// let tile = Tile::new(Face::Front, 10, 600, 700)?;
/// let bounds = enclosure.of(tile, Heights::new(100.0, 500.0)?);
/// let [x, y, z] = bounds.half();
/// assert!(x < 6_000.0 && y < 5_000.0 && z < 205.0);
/// assert!(bounds.sphere().radius < 7_500.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "bounding volume")]
#[doc(alias = "OBB")]
#[doc(alias = "bounding box")]
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Enclosure<T, P> {
    map: CubeMap<T, P>,
    ground: Spread<T>,
    normal: Spread<T>,
    /// The ellipsoid's least radius of curvature.
    radius: T,
}

/// Bounds on the singular values of a map of the sphere: their mean, the largest, and the norm of the
/// derivative's difference from the mean (σ of step 3).
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

impl<T: Real, P: CubeProjection> Enclosure<T, P> {
    /// Creates the bounding volumes of a cube map's tiles.
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

    /// Returns the cube map.
    #[must_use]
    pub const fn map(&self) -> CubeMap<T, P> {
        self.map
    }

    /// Returns the oriented bounding box of a tile whose terrain has heights in this range. Its third axis is
    /// the ellipsoid's normal in the tile's middle; its first axis is horizontal, in the direction of x
    /// there.
    #[must_use]
    pub fn of(&self, tile: Tile, heights: Heights<T>) -> OrientedBox<T> {
        let face = tile.face();
        let shifted = self.map.shifted();
        let middle = self.map.projection().unproject(tile.centre());
        let normal = shifted.normal(middle);
        let foot = shifted.ellipsoid().foot(normal);
        let middle = face.to_local(middle.to_array());
        let n = face.to_local(normal.to_array());

        if self.is_wide(tile) {
            return self.whole(normal, heights);
        }
        let (corners, direction) = self.corners(tile, middle);
        let axes = frame(direction, n);
        let mut chord = T::ZERO;
        let mut reach = [nothing::<T>(); 2];
        for corner in corners {
            let apart = difference(normalised(corner), middle);
            chord = max(chord, dot(apart, apart));
            let outward = dot(n, corner);
            for (range, axis) in reach.iter_mut().zip(axes) {
                include(range, dot(axis, corner) / outward);
            }
        }
        // 2 asin(c/2) ≤ c(1 + c²/18) for angles up to a right angle.
        let angle = chord.sqrt() * (T::ONE + T::of(0.0556) * chord);

        let [p, q] = reach;
        let [first, second] = [(p, q, axes[0]), (q, p, axes[1])].map(|(p, q, axis)| {
            let from = dot(axis, middle);
            self.across(sines(p, q).map(|s| s - from), angle, heights)
        });
        let third = self.outward(angle, heights);
        let height = max(heights.low().abs(), heights.high().abs());
        let rest = T::of(16.0) * T::EPSILON * (self.ground.largest + height);
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

    /// Whether a tile is too wide for step 1, which only happens if the cube is stretched.
    pub(super) fn is_wide(&self, tile: Tile) -> bool {
        let toward = |node| self.map.projection().unproject(tile.node::<T>(node, 2)).to_array();
        !P::SYMMETRIC && {
            let middle = toward([1, 1]);
            BOUNDARY.iter().any(|&node| dot(middle, toward(node)) < T::of(0.4))
        }
    }

    /// A box around the whole planet, whose third axis is a normal.
    fn whole(&self, normal: Direction<T>, heights: Heights<T>) -> OrientedBox<T> {
        let (ellipsoid, normal) = (self.map.shifted().ellipsoid(), normal.to_array());
        let height = max(heights.low().abs(), heights.high().abs());
        OrientedBox {
            centre: [T::ZERO; 3],
            axes: frame(aside(normal), normal),
            half: [(max(ellipsoid.a(), ellipsoid.b()) + height) * (T::ONE + T::of(16.0) * T::EPSILON); 3],
        }
    }

    /// Vectors toward the corners of Q (steps 1 and 2), and the direction of x, in the frame of the face.
    #[inline(always)]
    fn corners(&self, tile: Tile, middle: [T; 3]) -> ([[T; 3]; 4], [T; 3]) {
        let half = T::of(0.5);
        let [right, up, _] = frame(aside(middle), middle);
        let nodes = BOUNDARY.map(|node| {
            let point = tile.node::<T>(node, 2);
            let vector = self.map.projection().unproject(point).to_array();
            let vector = tile.face().to_local(vector);
            let outward = dot(middle, vector);
            [dot(right, vector) / outward, dot(up, vector) / outward]
        });
        let [_, _, _, [east_p, east_q], _, _, _, [west_p, west_q]] = nodes;
        let (p, q) = (east_p - west_p, east_q - west_q);
        let length = (p * p + q * q).sqrt();
        // If rounding leaves no direction of x, any direction will do.
        let (cos, sin) = select(length > T::ZERO, (p / length, q / length), (T::ONE, T::ZERO));
        let axis = along(right.map(|v| v * cos), sin, up);
        let other = along(up.map(|v| v * cos), -sin, right);

        let width = T::of(1.0 / 64.0) * self.map.projection().bend() / T::whole(1 << tile.level());
        let mut widening = T::ZERO;
        let [a, ab, b, bc, c, cd, d, da] = nodes;
        for [from, between, to] in [[a, ab, b], [b, bc, c], [c, cd, d], [d, da, a]] {
            let (p, q) = (to[0] - from[0], to[1] - from[1]);
            let length = (p * p + q * q).sqrt();
            let cross = ((between[0] - from[0]) * q - (between[1] - from[1]) * p).abs();
            let bend = select(length > T::ZERO, cross / length, T::ZERO);
            widening = max(widening, half * bend + length * width);
        }
        widening += T::of(8.0) * T::EPSILON;
        let mut ranges = [nothing::<T>(); 2];
        for [p, q] in nodes {
            let turned = [p * cos + q * sin, q * cos - p * sin];
            for (range, w) in ranges.iter_mut().zip(turned) {
                include(range, w);
            }
        }
        let [[left, right], [down, up]] = ranges.map(|[low, high]| [low - widening, high + widening]);
        let corners = [[left, down], [right, down], [right, up], [left, up]];
        (corners.map(|[p, q]| along(along(middle, p, axis), q, other)), axis)
    }

    /// The range along an axis of the tangent plane, measured from F (step 4). `low` and `high` bound the
    /// component of D − C along that axis.
    #[inline(always)]
    fn across(&self, [low, high]: [T; 2], angle: T, heights: Heights<T>) -> [T; 2] {
        let mut range = nothing::<T>();
        for height in [heights.low(), heights.high()] {
            let scale = self.ground.mean + height * self.normal.mean;
            let rest = (self.ground.apart + height.abs() * self.normal.apart) * angle;
            for end in [scale * low, scale * high] {
                include(&mut range, end - rest);
                include(&mut range, end + rest);
            }
        }
        range
    }

    /// The range along the normal, measured from F (step 5).
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

/// An empty range.
#[inline(always)]
fn nothing<T: Real>() -> [T; 2] {
    [T::of(f64::INFINITY), T::of(f64::NEG_INFINITY)]
}

/// Widens a range to contain a number.
#[inline(always)]
fn include<T: Real>([low, high]: &mut [T; 2], number: T) {
    *low = min(number, *low);
    *high = max(number, *high);
}

/// A right-handed frame whose third axis is `outward`; its first axis is the part of `vector` that is
/// perpendicular to it.
#[inline(always)]
fn frame<T: Real>(vector: [T; 3], outward: [T; 3]) -> [[T; 3]; 3] {
    let first = normalised(along(vector, -dot(vector, outward), outward));
    [first, cross(outward, first), outward]
}

/// An axis that is not that of a unit vector: the first, or the second if the vector is near to the first.
#[inline(always)]
fn aside<T: Real>([x, _, _]: [T; 3]) -> [T; 3] {
    let first = x.abs() < T::of(0.9);
    select(first, [T::ONE, T::ZERO, T::ZERO], [T::ZERO, T::ONE, T::ZERO])
}

/// The range of p/√(1 + p² + q²) for p and q in these ranges.
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
