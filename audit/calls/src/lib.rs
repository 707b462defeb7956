//! Every public function of terrella with fixed arguments, in one list for all targets: hashed for the same bits, counted in
//! instructions and bytes of stack, linked to see that nothing panics.
//!
//! A program is a [`Visitor`]; [`every`] shows it the functions, first in `f64`, then in `f32`. Functions are written with their type's
//! name (`Karney::solve(&karney, …)`), so that `audit/complete` can tell from the documentation that none is missing.

#![no_std]

mod arguments;
mod batch;
mod batch_terrain;
mod bits;
mod catalogue;
mod cube;
mod distortion;
mod fences;
mod frame;
mod geodesic;
mod grid;
mod healpix;
mod intersections;
mod latitude;
mod legs;
mod math;
mod position;
mod rhumb;
mod scene;
mod terrain;
mod text;

use core::fmt;

pub use arguments::Arguments;
pub use bits::{Bits, Hash};
use terrella::Real;

/// A function's name, and how often it is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Function {
    name: &'static str,
    of: &'static str,
    calls: usize,
}

impl Function {
    /// A function, called 256 times.
    #[must_use]
    pub const fn new(name: &'static str) -> Self {
        Self::of(name, "")
    }

    /// A function of a projection, a method, a latitude.
    #[must_use]
    pub const fn of(name: &'static str, of: &'static str) -> Self {
        Self { name, of, calls: 256 }
    }

    /// The same, called less often: one that is long.
    #[must_use]
    pub const fn calls(self, calls: usize) -> Self {
        Self { calls, ..self }
    }

    /// How often it is called for its hash.
    #[must_use]
    pub const fn number_of_calls(self) -> usize {
        self.calls
    }

    /// The hash of what the function gives for its fixed arguments.
    pub fn hash<I: Copy, O: Bits>(self, draw: impl Fn(&mut Arguments) -> I, call: impl Fn(I) -> O) -> u64 {
        let mut arguments = Arguments::with_limits();
        let mut hash = Hash::default();
        for _ in 0..self.calls {
            call(draw(&mut arguments)).add_to(&mut hash);
        }
        hash.value()
    }
}

impl fmt::Display for Function {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)?;
        if !self.of.is_empty() {
            write!(f, ", {}", self.of)?;
        }
        Ok(())
    }
}

/// `f32` or `f64`.
pub trait Scalar: Real<Plain = Self> + Bits {
    /// Its name.
    const NAME: &str;
}

impl Scalar for f32 {
    const NAME: &str = "f32";
}

impl Scalar for f64 {
    const NAME: &str = "f64";
}

/// What is done with each function.
pub trait Visitor {
    /// Takes a function: its scalar and name, what draws its arguments, and the call.
    fn visit<T: Scalar, I: Copy, O: Bits>(
        &mut self,
        function: Function,
        draw: impl Fn(&mut Arguments) -> I,
        call: impl Fn(I) -> O,
    );

    /// [`Self::visit`] for what needs no more than a name.
    fn function<T: Scalar, I: Copy, O: Bits>(
        &mut self,
        name: &'static str,
        draw: impl Fn(&mut Arguments) -> I,
        call: impl Fn(I) -> O,
    ) {
        self.visit::<T, I, O>(Function::new(name), draw, call);
    }
}

/// The points of a batch: two whole blocks, and a part of one.
pub const POINTS: usize = 150;

struct Hashes<'a>(&'a mut dyn FnMut(Function, &'static str, u64));

impl Visitor for Hashes<'_> {
    fn visit<T: Scalar, I: Copy, O: Bits>(
        &mut self,
        function: Function,
        draw: impl Fn(&mut Arguments) -> I,
        call: impl Fn(I) -> O,
    ) {
        (self.0)(function, T::NAME, function.hash(draw, call));
    }
}

/// Hands on each function, its scalar and the hash of what it gives: compiled here, once for all who ask.
pub fn hashes(mut take: impl FnMut(Function, &'static str, u64)) {
    hashes_of_all(&mut take);
}

fn hashes_of_all(take: &mut dyn FnMut(Function, &'static str, u64)) {
    every(&mut Hashes(take));
}

/// Shows all functions, in both scalars.
pub fn every<V: Visitor>(visitor: &mut V) {
    every_in::<f64, V>(visitor);
    every_in::<f32, V>(visitor);
}

/// Shows all functions in one scalar.
pub fn every_in<T: Scalar, V: Visitor>(visitor: &mut V) {
    math::show::<T, V>(visitor);
    position::show::<T, V>(visitor);
    latitude::show::<T, V>(visitor);
    frame::show::<T, V>(visitor);
    cube::show::<T, V>(visitor);
    distortion::show::<T, V>(visitor);
    geodesic::show::<T, V>(visitor);
    catalogue::show::<T, V>(visitor);
    healpix::show::<T, V>(visitor);
    legs::show::<T, V>(visitor);
    fences::show::<T, V>(visitor);
    intersections::show::<T, V>(visitor);
    rhumb::show::<T, V>(visitor);
    grid::show::<T, V>(visitor);
    text::show::<T, V>(visitor);
    batch::show::<T, V>(visitor);
    scene::show::<T, V>(visitor);
    terrain::show::<T, V>(visitor);
    batch_terrain::show::<T, V>(visitor);
}
