//! The steps to an intersection.

use super::{Intersections, Overlap, Spot, moved};
use crate::Real;
use crate::geodesic::Line;
use crate::math::{atan2, sin_cos, sin_cos_degrees};

/// One step.
struct Step<T> {
    by: [T; 2],
    overlap: Option<Overlap>,
    angle: (T, T),
    last: bool,
}

impl<T: Real> Intersections<T> {
    /// An intersection near a point.
    pub(super) fn near(&self, one: &Line<T>, other: &Line<T>, start: [T; 2]) -> Spot<T> {
        let mut spot = Spot {
            at: start,
            overlap: None,
            angle: (T::ZERO, T::ONE),
        };
        // 36 µm (f32: 130 m): the next error is of the order of its square by the radius.
        let enough = self.margin * T::pick(1.8e-9, 6.4e-3);
        for _ in 0..Self::STEPS {
            let step = self.step(one, other, spot.at);
            spot = Spot {
                at: moved(spot.at, step.by),
                overlap: step.overlap,
                angle: step.angle,
            };
            let [x, y] = step.by;
            // Also for NaN.
            let goes_on = x.abs() + y.abs() > enough;
            if step.last || !goes_on {
                break;
            }
        }
        spot
    }

    /// One step on the sphere, from the triangle of the two points and the intersection (appendix A).
    fn step(&self, one: &Line<T>, other: &Line<T>, [x, y]: [T; 2]) -> Step<T> {
        let (a, b) = (one.near(x), other.near(y));
        let way = self.karney.way(a.position, b.position);
        let z = way.distance / self.radius;
        let (sin_z, cos_z) = sin_cos(z);
        // From each line to the way between the points.
        let (angle1, angle2) = (way.azimuth1 - a.azimuth, way.azimuth2 - b.azimuth);
        let turn = (angle2 - angle1).remainder(T::of(360.0));
        let (sin_turn, cos_turn) = sin_cos_degrees(turn);
        // Of both intersections on the sphere, the one on the nearer side.
        let half = T::of(180.0);
        let side = if turn.abs() > half { -turn } else { turn };
        let side = T::ONE.copysign(side);
        let ((sin1, cos1), (sin2, cos2)) = (sin_cos_degrees(angle1), sin_cos_degrees(angle2));
        let beyond = cos_z < T::ZERO;
        let slack = T::of(16.0) * T::EPSILON;
        let astray = if beyond { sin1 * cos2 + cos1 * sin2 } else { sin_turn };
        if astray.abs() <= slack && (sin1 * sin_z).abs() <= slack && (sin2 * sin_z).abs() <= slack {
            let straight = if beyond { cos1 * cos2 - sin1 * sin2 } else { cos_turn };
            let overlap = if straight > T::ZERO {
                Overlap::Parallel
            } else {
                Overlap::Antiparallel
            };
            // Each point goes half of the way to the other. Between antipodes there is a way in any
            // direction.
            let half = (way.distance * T::of(0.5)).copysign(cos1);
            return Step {
                by: [half, -overlap.sign::<T>() * half],
                overlap: Some(overlap),
                angle: (T::ZERO, overlap.sign()),
                last: true,
            };
        }
        let met = z <= T::of(3.0) * T::EPSILON;
        let by = if met {
            [T::ZERO; 2]
        } else {
            // sin a cos b cos z − cos a sin b, for z near 0 and near π without a loss.
            let half = sin_cos(z * T::of(0.5));
            let (versine, base) = if beyond {
                (-(half.1 + half.1) * half.1, -(sin2 * cos1 + cos2 * sin1))
            } else {
                ((half.0 + half.0) * half.0, sin_turn)
            };
            let along1 = base - sin2 * cos1 * versine;
            let along2 = if beyond {
                (sin2 * cos1 + cos2 * sin1) + sin1 * cos2 * versine
            } else {
                sin_turn + sin1 * cos2 * versine
            };
            [
                self.radius * atan2(side * sin2 * sin_z, side * along1),
                self.radius * atan2(side * sin1 * sin_z, side * along2),
            ]
        };
        Step {
            by,
            overlap: None,
            angle: (sin_turn.abs(), cos_turn),
            last: met,
        }
    }
}
