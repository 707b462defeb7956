//! Numbers, places and points from bytes, which a fuzzer mutates: anywhere, and often where something
//! could go wrong. Past the end all bytes are 0.
//!
//! A corpus is such bytes: it is of no use to another reader of them.

use terrella::cube::{Face, FacePoint, Projection};
use terrella::{Direction, Ellipsoid, LatLon};

use crate::scalar::{Scalar, steps};

pub struct Bytes<'a>(&'a [u8]);

/// Where sines, tangents, faces and formulas change: parts of a limit.
const LANDMARKS: [f64; 8] = [
    0.0,
    1.0,
    0.5,
    0.25,
    0.75,
    1.0 / 3.0,
    2.0 / 3.0,
    core::f64::consts::FRAC_1_SQRT_2,
];

impl<'a> Bytes<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    pub fn byte(&mut self) -> u8 {
        match self.0.split_first() {
            Some((&first, rest)) => {
                self.0 = rest;
                first
            }
            None => 0,
        }
    }

    pub fn word(&mut self) -> u64 {
        u64::from_le_bytes(core::array::from_fn(|_| self.byte()))
    }

    pub fn flag(&mut self) -> bool {
        self.byte() & 1 == 1
    }

    /// One of them.
    pub fn choice<V: Copy>(&mut self, of: &[V]) -> V {
        of[usize::from(self.byte()) % of.len()]
    }

    /// A whole number between minus and plus a limit.
    pub fn between(&mut self, limit: i32) -> i32 {
        i32::from(self.byte() as i8) % (limit + 1)
    }

    /// In [−1, 1), evenly.
    pub fn even(&mut self) -> f64 {
        self.word() as i64 as f64 / 9_223_372_036_854_775_808.0
    }

    /// Of any size up to 1, down to 2⁻²⁵⁶, evenly in its logarithm; of either sign.
    pub fn tiny(&mut self) -> f64 {
        let size = f64::from(self.byte());
        self.even() * (-size).exp2()
    }

    /// Between minus and plus a limit: anywhere, tiny, next to the limit, on or next to a landmark; or any bits.
    pub fn within<T: Scalar>(&mut self, limit: f64) -> T {
        let value = match self.byte() % 8 {
            0..=2 => T::of(limit * self.even()),
            3 => T::from_bits(self.word()),
            4 => T::of(limit * self.tiny()),
            5 => T::of(limit * (1.0 - self.tiny().abs()) * if self.flag() { -1.0 } else { 1.0 }),
            6 => {
                let landmark = limit * self.choice(&LANDMARKS);
                let number = steps(T::of(landmark), self.between(8));
                if self.flag() { -number } else { number }
            }
            _ => T::of(limit * (self.choice(&LANDMARKS) + self.tiny())),
        };
        let (size, limit) = (value.abs(), T::of(limit));
        if size <= limit {
            value
        } else if size.is_finite() {
            limit * (limit / value)
        } else {
            limit
        }
    }

    /// Any bits, what is special about floating point, and ordinary numbers.
    pub fn anything<T: Scalar>(&mut self) -> T {
        let number = match self.byte() % 8 {
            0..=2 => T::from_bits(self.word()),
            3 => {
                let special = [T::LARGEST, T::SMALLEST, T::SMALLEST_NORMAL, T::EPSILON];
                steps(self.choice(&special), self.between(2))
            }
            4 => self.choice(&[f64::INFINITY, f64::NAN, 0.0, 1.0].map(T::of)),
            5 => steps(
                T::of(self.choice(&[1.0, 45.0, 90.0, 180.0, 360.0, 540.0])),
                self.between(2),
            ),
            6 => T::of(self.even()),
            _ => T::of(1000.0 * self.even()),
        };
        if self.flag() { -number } else { number }
    }

    /// Any finite number.
    pub fn finite<T: Scalar>(&mut self) -> T {
        let number: T = self.anything();
        if number.is_finite() { number } else { T::LARGEST }
    }

    pub fn place<T: Scalar>(&mut self) -> LatLon<T> {
        let (lat, lon) = (self.within(90.0), self.within(180.0));
        LatLon::new(lat, lon).unwrap()
    }

    /// A place near another, or near its antipode: the latitude or the longitude may be the very same.
    pub fn place_about<T: Scalar>(&mut self, from: LatLon<T>, antipode: bool) -> LatLon<T> {
        let half_circle = T::of(180.0);
        let (lat, lon) = if antipode {
            (-from.lat(), from.lon() - half_circle.copysign(from.lon()))
        } else {
            (from.lat(), from.lon())
        };
        let mut beside = |about: T| {
            if self.flag() {
                about + T::of(4.0 * self.tiny())
            } else {
                about
            }
        };
        let (lat, lon) = (beside(lat), beside(lon));
        let right = T::of(90.0);
        LatLon::new(if lat.abs() > right { right.copysign(lat) } else { lat }, lon).unwrap()
    }

    /// Two places: anywhere, nearly coincident, nearly antipodal, on a meridian or on a parallel.
    pub fn pair<T: Scalar>(&mut self) -> (LatLon<T>, LatLon<T>) {
        let kind = self.byte();
        let from = self.place();
        let to = match kind % 8 {
            0..=2 => self.place(),
            3 | 4 => self.place_about(from, true),
            5 | 6 => self.place_about(from, false),
            _ => {
                let other = self.place::<T>();
                if self.flag() {
                    LatLon::new(from.lat(), other.lon()).unwrap()
                } else {
                    LatLon::new(other.lat(), from.lon()).unwrap()
                }
            }
        };
        (from, to)
    }

    pub fn face(&mut self) -> Face {
        self.choice(&Face::ALL)
    }

    pub fn projection(&mut self) -> Projection {
        self.choice(Projection::ALL)
    }

    /// A direction: by gnomonic coordinates, the second of which may be near the first, or by components of any size.
    pub fn direction<T: Scalar>(&mut self) -> Direction<T> {
        let kind = self.byte();
        let vector = if kind % 8 == 7 {
            [self.finite(), self.finite(), self.finite()]
        } else {
            let face = self.face();
            let u = self.within::<T>(1.0);
            let v = if kind % 8 == 6 {
                steps(u, self.between(8))
            } else {
                self.within(1.0)
            };
            face.to_earth([u, if self.flag() { -v } else { v }, T::ONE])
        };
        let [x, y, z] = vector;
        let front = Direction::new(T::ONE, T::ZERO, T::ZERO).unwrap();
        Direction::new(x, y, z).unwrap_or(front)
    }

    /// A point of a face, whose second coordinate may be near the first.
    pub fn point<T: Scalar>(&mut self) -> FacePoint<T> {
        let face = self.face();
        let x = self.within::<T>(1.0);
        let y = if self.byte() % 8 == 7 {
            steps(x, self.between(8))
        } else {
            self.within(1.0)
        };
        let y = if y.abs() > T::ONE { T::ONE } else { y };
        FacePoint::new(face, x, if self.flag() { -y } else { y }).unwrap()
    }

    /// An ellipsoid: the Earth's, or one of a flattening between two, a sphere among them.
    pub fn ellipsoid<T: Scalar>(&mut self, least: f64, most: f64) -> Ellipsoid<T> {
        let (low, high) = (T::of(least), T::of(most));
        let f = match self.byte() % 8 {
            0..=2 => return Ellipsoid::WGS84,
            3 => T::ZERO,
            4 => low,
            5 => high,
            6 => T::of(self.tiny()),
            _ => T::of(least + (most - least) * 0.5 * (1.0 + self.even())),
        };
        let f = if f < low {
            low
        } else if f > high {
            high
        } else {
            f
        };
        Ellipsoid::new(T::of(6.4e6), f).unwrap()
    }
}
