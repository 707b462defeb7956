use super::jacobian::is_regular;
use super::unfolded::{across, along, turned};
use super::{Ground, Jacobian, Statistic};
use crate::Real;
use crate::cube::{CubeProjection, Edge, Face, FacePoint};
use crate::math::atan2_degrees;

/// An accumulator of kinks: the angles, in degrees, by which straight lines of the map turn on the ground
/// where they cross an edge of the cube, a diagonal of a face, or a midline. Its size is fixed.
///
/// The line is the one that crosses the crease at right angles on the unfolded cube, where it is straight. On
/// the ground it arrives in one direction and leaves in another; the kink is the angle between the two, in
/// [0, 180]. A projection that is smooth within a face has kinks at the edges only. At a corner of the cube
/// three right angles fill 360°, so near the corners a map that is smooth within its faces turns by 60°.
///
/// Directions are derivatives of the projection's own code, taken 1e-12 (`f64`) or 1e-6 (`f32`) of a unit
/// beside a diagonal or midline: a kink within a face is off by about that times the curvature.
///
/// ```
/// use terrella::cube::{CubeMap, Face, Quadrilateralized};
/// use terrella::distortion::{Ground, Kinks};
/// use terrella::{Ellipsoid, Shift};
///
/// let sphere = Ellipsoid::sphere(1.0_f64)?;
/// let ground = Ground::new(CubeMap::new(sphere, Shift::Geodetic, Quadrilateralized)?);
/// let mut kinks = Kinks::new();
/// kinks.face(&ground, Face::Front, 100);
/// assert!(kinks.diagonals().min() > 38.0 && kinks.diagonals().max() < 48.0);
/// assert!(kinks.midlines().max() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "crease")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Kinks<T> {
    edges: Statistic<T>,
    diagonals: Statistic<T>,
    midlines: Statistic<T>,
    skipped: u64,
}

impl<T: Real> Default for Kinks<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Real> Kinks<T> {
    /// Creates an empty accumulator.
    #[must_use]
    pub fn new() -> Self {
        let none = Statistic::about(T::ZERO);
        Self {
            edges: none,
            diagonals: none,
            midlines: none,
            skipped: 0,
        }
    }

    /// Includes n places on each of the four edges, both diagonals and both midlines of a face, at −1 + (2i +
    /// 1)/n for i from 0 to n − 1. An even n leaves out the centre.
    pub fn face<P: CubeProjection>(&mut self, ground: &Ground<T, P>, face: Face, n: u32) {
        let (one, zero) = (T::ONE, T::ZERO);
        for index in 0..n {
            let s = T::whole(u64::from(index) * 2 + 1) / T::whole(u64::from(n)) - one;
            for edge in Edge::ALL {
                let kink = at_edge(ground, face, edge, s);
                self.skipped += include(&mut self.edges, face, along(edge, s, zero), kink);
            }
            for (point, step) in [([s, s], [one, -one]), ([s, -s], [one, one])] {
                let kink = inside(ground, face, point, step);
                self.skipped += include(&mut self.diagonals, face, point, kink);
            }
            for (point, step) in [([zero, s], [one, zero]), ([s, zero], [zero, one])] {
                let kink = inside(ground, face, point, step);
                self.skipped += include(&mut self.midlines, face, point, kink);
            }
        }
    }

    /// Includes n places on each crease of the six faces; edges are included from both sides.
    pub fn sphere<P: CubeProjection>(&mut self, ground: &Ground<T, P>, n: u32) {
        for face in Face::ALL {
            self.face(ground, face, n);
        }
    }

    /// Includes all places that another accumulator has.
    pub fn merge(&mut self, other: &Self) {
        self.edges.merge(&other.edges);
        self.diagonals.merge(&other.diagonals);
        self.midlines.merge(&other.midlines);
        self.skipped += other.skipped;
    }

    /// Returns the statistic of kinks at the edges of the cube.
    #[must_use]
    pub fn edges(&self) -> &Statistic<T> {
        &self.edges
    }

    /// Returns the statistic of kinks at the diagonals of the faces.
    #[must_use]
    pub fn diagonals(&self) -> &Statistic<T> {
        &self.diagonals
    }

    /// Returns the statistic of kinks at the midlines of the faces.
    #[must_use]
    pub fn midlines(&self) -> &Statistic<T> {
        &self.midlines
    }

    /// Returns the number of kinks that were left out because the map has no derivative there.
    #[must_use]
    pub fn skipped(&self) -> u64 {
        self.skipped
    }
}

/// Includes a kink, and returns the number of those left out.
fn include<T: Real>(statistic: &mut Statistic<T>, face: Face, [x, y]: [T; 2], kink: Option<T>) -> u64 {
    match kink {
        Some(kink) => {
            statistic.include(FacePoint::within(face, x, y), kink);
            0
        }
        None => 1,
    }
}

/// The kink of the line through a point of a face in the direction of a step.
fn inside<T, P>(ground: &Ground<T, P>, face: Face, [x, y]: [T; 2], [dx, dy]: [T; 2]) -> Option<T>
where
    T: Real,
    P: CubeProjection,
{
    let aside = T::pick(1e-12, 1e-6);
    let leads = |out: T| leads(ground, face, [x + out * dx, y + out * dy], [dx, dy]);
    Some(turn(leads(-aside)?, leads(aside)?))
}

/// The kink of the line that crosses an edge at right angles on the cube.
fn at_edge<T: Real, P: CubeProjection>(ground: &Ground<T, P>, face: Face, edge: Edge, s: T) -> Option<T> {
    let here = along(edge, s, T::ZERO);
    let (next, there) = across(face, edge, here);
    let outward = match edge {
        Edge::Right => [T::ONE, T::ZERO],
        Edge::Up => [T::ZERO, T::ONE],
        Edge::Left => [-T::ONE, T::ZERO],
        Edge::Down => [T::ZERO, -T::ONE],
    };
    let inward = turned(outward, face.neighbour(edge).turns);
    Some(turn(
        leads(ground, face, here, outward)?,
        leads(ground, next, there, inward)?,
    ))
}

/// Where a step from a point of a face leads to: a tangent of the ground, in Earth axes. Beside a pole, east
/// and north would turn between the two sides of a crease.
fn leads<T, P>(ground: &Ground<T, P>, face: Face, point: [T; 2], [dx, dy]: [T; 2]) -> Option<[T; 3]>
where
    T: Real,
    P: CubeProjection,
{
    let (normal, slopes) = ground.slopes(face, point);
    let [[a, b, c], [d, e, f]] = slopes;
    is_regular(Jacobian::in_tangent_plane(normal, slopes).area())
        .then(|| [dx * a + dy * d, dx * b + dy * e, dx * c + dy * f])
}

/// The angle between two vectors, in degrees.
fn turn<T: Real>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> T {
    let [u, v, w] = [b * z - c * y, c * x - a * z, a * y - b * x];
    atan2_degrees((u * u + v * v + w * w).sqrt(), a * x + b * y + c * z)
}
