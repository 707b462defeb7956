use core::f64::consts::{FRAC_PI_2, PI};

use super::bound::at_least;
use super::{Closest, Legs, Reach, Segment, Track};
use crate::geodesic::{GreatCircle, Karney};
use crate::math::{atan2, max, min, sin_cos_degrees};
use crate::{LatLon, Real};

/// Steps of Newton's kind before the bracket is halved instead, and steps of both kinds: from a circuit to a
/// ten millionth of a radius in f64.
const FREE_STEPS: u32 = 8;
const MOST_STEPS: u32 = 40;

/// Parts of a line that are looked at one by one if it is far away, and halvings of a part in which a minimum
/// may be hidden.
const PARTS: u64 = 24;
const HALVINGS: u32 = 16;

/// What is seen of a place from a point of the line, or of that point from the place.
#[derive(Clone, Copy)]
struct Sight<T> {
    along: T,
    position: LatLon<T>,
    distance: T,
    /// Sine and cosine of the angle from the way on, away from the place, to the line: the cosine is the
    /// derivative of the distance along the line, the sine is positive if the place is to the right.
    sin: T,
    cos: T,
    /// The reduced length from the place to the point, and the scale of lines that are parallel there.
    reduced: T,
    scale: T,
}

/// The one whose point is nearer to the place.
fn nearer<T: Real>(one: Sight<T>, two: Sight<T>) -> Sight<T> {
    if two.distance < one.distance { two } else { one }
}

/// A part of a line.
#[derive(Clone, Copy)]
struct Stretch<T> {
    from: T,
    to: T,
}

/// A line and a place.
struct Search<'a, T> {
    karney: &'a Karney<T>,
    leg: &'a Segment<T>,
    place: LatLon<T>,
    /// A radius of the sphere that steps are computed on.
    radius: T,
    /// Nearer than this, distances are convex along every line.
    convex: T,
    /// Farther than this, they are concave.
    concave: T,
}

impl<'a, T: Real> Search<'a, T> {
    fn new(karney: &'a Karney<T>, leg: &'a Segment<T>, place: LatLon<T>) -> Self {
        let ellipsoid = karney.ellipsoid();
        let (a, b) = (ellipsoid.a(), ellipsoid.b());
        // 1/√K is b at the equator and a²/b at the poles. Within (π/2)/√K of a place, K the largest, its
        // circles are convex, for half of the shortest closed geodesic is longer; beyond (π/2)/√K, K the
        // smallest, and up to where the lines from the place cross again, the scale is negative (Sturm).
        let (one, two) = (b, a * (a / b));
        let quarter = T::of(FRAC_PI_2);
        Self {
            karney,
            leg,
            place,
            radius: ellipsoid.mean_radius(),
            convex: quarter * min(one, two),
            concave: quarter * max(one, two),
        }
    }

    /// At a distance along the line.
    fn sight(&self, along: T) -> Sight<T> {
        let ([start, end], way) = (self.leg.ends(), self.leg.way());
        let (position, azimuth) = if along == T::ZERO {
            (start, way.azimuth1)
        } else if along == way.distance {
            (end, way.azimuth2)
        } else {
            let point = self.leg.line().near(along);
            (point.position, point.azimuth)
        };
        let solution = self.karney.solve(self.place, position);
        let (sin, cos) = sin_cos_degrees(azimuth - solution.inverse.azimuth2);
        Sight {
            along,
            position,
            distance: solution.inverse.distance,
            sin,
            cos,
            reduced: solution.reduced_length,
            scale: solution.scale21,
        }
    }

    /// How far the closest point seems to be from here: the third side of a right triangle, on the sphere
    /// with the same reduced length and scale. Exact on a sphere of any radius, and in the plane next to the
    /// place.
    fn step(&self, here: &Sight<T>) -> T {
        -self.radius * atan2(here.reduced * here.cos, here.scale * self.radius)
    }

    /// The closest point of a stretch in which the derivative of the distance changes its sign from − to +
    /// once at most: by steps as on a sphere, inside a bracket.
    fn descend(&self, mut here: Sight<T>, stretch: Stretch<T>) -> Sight<T> {
        // Below this the next step is below rounding.
        let small = T::EPSILON.sqrt() * self.radius;
        let Stretch {
            from: mut low,
            to: mut high,
        } = stretch;
        let (mut low_seen, mut high_seen) = (false, false);
        for count in 0..MOST_STEPS {
            if here.cos < T::ZERO {
                (low, low_seen) = (here.along, true);
            } else {
                (high, high_seen) = (here.along, true);
            }
            let step = self.step(&here);
            let next = here.along + step;
            if step.abs() <= small || low >= high {
                let next = max(min(next, stretch.to), stretch.from);
                return if next == here.along { here } else { self.sight(next) };
            }
            let middle = low + (high - low) * T::of(0.5);
            let next = if next <= low && !low_seen {
                low
            } else if next >= high && !high_seen {
                high
            } else if next > low && next < high && count < FREE_STEPS {
                next
            } else {
                middle
            };
            if high - low <= small {
                return self.sight(next);
            }
            here = self.sight(next);
        }
        here
    }

    /// The closest point of all those of a stretch. `near` is its closest point on a sphere. Next to it the
    /// search may go on to what is `around` the stretch.
    fn closest(&self, near: T, stretch: Stretch<T>, around: Stretch<T>) -> Sight<T> {
        let here = self.sight(near);
        if here.distance < self.convex {
            // The points of a line that are nearer than this are a part of it without a gap, and along it the
            // distance has one minimum.
            return self.descend(here, around);
        }
        self.among_far(here, stretch)
    }

    /// Two points of a short part of a line, between which the distance has a minimum: it falls at the first
    /// and rises at the second.
    fn valley(&self, before: Sight<T>, here: Sight<T>) -> Option<[Sight<T>; 2]> {
        let falls = |sight: &Sight<T>| sight.cos < T::ZERO;
        if falls(&before) != falls(&here) {
            return falls(&before).then_some([before, here]);
        }
        // Is there a minimum and a maximum? The second derivative of the distance has the sign of the scale.
        // It changes between them, and is here where it must be for that: halve to where it is 0.
        let toward = if falls(&before) { T::ONE } else { -T::ONE };
        let (mut low, mut high) = (before, here);
        for _ in 0..HALVINGS {
            let bends = (low.scale * toward > T::ZERO) & (high.scale * toward < T::ZERO);
            if !bends {
                return None;
            }
            let middle = self.sight(T::of(0.5) * (low.along + high.along));
            if falls(&middle) != falls(&before) {
                return Some(if falls(&before) { [low, middle] } else { [middle, high] });
            }
            if middle.scale * toward > T::ZERO {
                low = middle;
            } else {
                high = middle;
            }
        }
        None
    }

    /// The closest point if all are about a quarter of the way round or farther: there may be several minima.
    #[cold]
    #[inline(never)]
    fn among_far(&self, near: Sight<T>, stretch: Stretch<T>) -> Sight<T> {
        let Stretch { from, to } = stretch;
        let mut before = self.sight(from);
        let mut best = nearer(before, near);
        // What a line on the sphere lacks of one on the ellipsoid.
        let error = T::of(4.0) * self.karney.ellipsoid().f().abs() * self.radius;
        let ends_only = near.distance > self.concave + error;
        for part in 1..=PARTS {
            if ends_only && part < PARTS {
                continue;
            }
            let fraction = T::whole(part) / T::whole(PARTS);
            let along = if part == PARTS {
                to
            } else {
                from + (to - from) * fraction
            };
            let here = self.sight(along);
            if here.distance < self.convex {
                return self.descend(here, stretch);
            }
            if let (false, Some([low, high])) = (ends_only, self.valley(before, here)) {
                let part = Stretch {
                    from: low.along,
                    to: high.along,
                };
                best = nearer(best, self.descend(nearer(low, high), part));
            }
            best = nearer(best, here);
            before = here;
        }
        best
    }
}

/// Legs of the ellipsoid are geodesics. The closest point is the global one, also at poles, across ±180° and
/// on the far side.
///
/// Worst error on the Earth, in metres:
///
/// | | `f64` | `f32` |
/// |---|---|---|
/// | distance, across | 1e-8 | 8 |
/// | along and the closest point, times cos σ | 1e-8 | 8 |
///
/// σ is the distance in radii: a quarter of the way round, the place is as far from a long part of the leg.
/// For f = 1/10 and −1/150 the distance is within 1e-8; the closest point of a leg of length L to a place at
/// a distance d within 1e-8 (1 + 0.01 d/L) below 8000 km.
///
/// The derivative of the distance along the line is the cosine of the angle between the two lines. A step
/// goes to where it is 0 in the right triangle of the sphere with the same reduced length and geodesic scale;
/// the error of the next step is proportional to the square of this one, and on a sphere it is 0. So three or
/// four inverse problems are usual after the first point, which is that of a sphere. It stays in a bracket,
/// which is halved after eight steps: there are at most 40.
///
/// Within (π/2)/√K of the place, K the largest curvature (9985 km on the Earth), circles about it are convex:
/// a line has one part inside, along which the distance has one minimum. Farther than (π/2)/√K, K the
/// smallest (10 052 km), there is none but the ends. If all points of a leg that were seen are beyond the
/// first limit, 24 parts of it are looked at one by one, and halved up to 16 times where the derivatives at
/// both ends leave room for a minimum between.
///
/// By [`track`](Legs::track) the line goes on to half of a circuit before and behind the start. Its point is
/// the one next to the closest on a sphere, or the lowest if all are about a quarter of the way round.
///
/// S. Baselga and J. C. Martínez-Llario, *Intersection and point-to-line solutions for geodesics on the
/// ellipsoid*, Stud. Geophys. Geod. 62 (2018); C. F. F. Karney, *Geodesic intersections* (2023), arXiv
/// 2308.00495, on their steps.
impl<T: Real> Legs<T> for Karney<T> {
    type Leg = Segment<T>;

    fn leg(&self, start: LatLon<T>, end: LatLon<T>) -> Segment<T> {
        Segment::new(self, start, end)
    }

    fn length(&self, leg: &Segment<T>) -> T {
        leg.length()
    }

    fn closest_on(&self, leg: &Segment<T>, place: LatLon<T>) -> Closest<T> {
        let ([start, end], length) = (leg.ends(), leg.length());
        let sphere = GreatCircle::mean(self.ellipsoid());
        let [along, _] = sphere.tracks_beside(place, start, leg.way().azimuth1);
        let near = max(min(along, length), T::ZERO);
        let stretch = Stretch {
            from: T::ZERO,
            to: length,
        };
        let found = Search::new(self, leg, place).closest(near, stretch, stretch);
        let on_leg = found.distance == T::ZERO;
        let reach = if found.along == T::ZERO && found.cos > T::ZERO && !on_leg {
            Reach::BeforeStart
        } else if found.along == length && found.cos < T::ZERO && !on_leg {
            Reach::PastEnd
        } else {
            Reach::Within
        };
        let position = match reach {
            Reach::PastEnd => end,
            _ => found.position,
        };
        Closest {
            distance: found.distance,
            position,
            along: found.along,
            reach,
        }
    }

    fn track_beside(&self, leg: &Segment<T>, place: LatLon<T>) -> Track<T> {
        let sphere = GreatCircle::mean(self.ellipsoid());
        let [start, _] = leg.ends();
        let [near, _] = sphere.tracks_beside(place, start, leg.way().azimuth1);
        let half = T::of(PI) * self.ellipsoid().mean_radius();
        let within = |half: T| Stretch { from: -half, to: half };
        let found = Search::new(self, leg, place).closest(near, within(half), within(half * T::of(1.25)));
        Track {
            across: found.distance.copysign(found.sin),
            along: found.along,
        }
    }

    fn at_least(&self, place: LatLon<T>, start: LatLon<T>, end: LatLon<T>) -> T {
        at_least(self.ellipsoid(), place, start, end)
    }
}
