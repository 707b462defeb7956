//! Added to the library: a NaN in place of what a function gives, for a few of its results.
#![allow(missing_docs)]

use core::marker::PhantomData;
use core::sync::atomic::Ordering::Relaxed;

use crate::chosen::{CHOSEN, REACH, reach};

/// Of a place's numbers each is a scalar, `f64` or `f32`, and a part of the results: one in so many.
pub const PARTS: [u64; 3] = [128, 8, 1];
pub const NUMBERS: usize = 2 * PARTS.len();

/// A number in a result.
pub enum Number<'a> {
    Double(&'a mut f64),
    Single(&'a mut f32),
}

/// What may have numbers in it.
pub trait Plant {
    fn numbers(&mut self, each: &mut dyn FnMut(Number<'_>));
}

/// Any type: as [`Plant`] has it, or without numbers. By which of two traits a method is found that both have, one with a reference more.
pub struct Any<'a, V: ?Sized>(pub &'a mut V);

pub trait Known {
    fn numbers(&mut self, each: &mut dyn FnMut(Number<'_>));
}

impl<V: Plant + ?Sized> Known for Any<'_, V> {
    fn numbers(&mut self, each: &mut dyn FnMut(Number<'_>)) {
        self.0.numbers(each);
    }
}

pub trait Unknown {
    fn numbers(&mut self, _: &mut dyn FnMut(Number<'_>)) {}
}

impl<V: ?Sized> Unknown for &mut Any<'_, V> {}

/// Whether the results of a place are asked for.
#[inline(always)]
pub fn wanted(place: usize) -> bool {
    let chosen = CHOSEN.load(Relaxed);
    chosen == REACH || chosen.wrapping_sub(place) < NUMBERS
}

/// Notes that a place is reached; or plants a NaN in every number of a result, if the chosen part is to have one: by the result's bits, so
/// that the same result has it wherever it is computed.
#[cold]
pub fn plant(place: usize, result: &mut dyn FnMut(&mut dyn FnMut(Number<'_>))) {
    let mut seen = [None; 2];
    result(&mut |number| {
        let (scalar, bits) = match number {
            Number::Double(v) if v.is_finite() => (0, v.to_bits()),
            Number::Single(v) if v.is_finite() => (1, u64::from(v.to_bits())),
            _ => return,
        };
        let mixed = (seen[scalar].unwrap_or(0) ^ bits).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        seen[scalar] = Some(mixed ^ (mixed >> 32));
    });
    let chosen = CHOSEN.load(Relaxed);
    if chosen == REACH {
        for number in (0..NUMBERS).filter(|number| seen[number % 2].is_some()) {
            reach(place + number);
        }
        return;
    }
    let (scalar, part) = ((chosen - place) % 2, PARTS[(chosen - place) / 2]);
    if seen[scalar].is_some_and(|mixed| mixed.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32 & (part - 1) == 0) {
        result(&mut |number| match number {
            Number::Double(v) if scalar == 0 => *v = f64::NAN,
            Number::Single(v) if scalar == 1 => *v = f32::NAN,
            _ => {}
        });
    }
}

impl Plant for f64 {
    fn numbers(&mut self, each: &mut dyn FnMut(Number<'_>)) {
        each(Number::Double(self));
    }
}

impl Plant for f32 {
    fn numbers(&mut self, each: &mut dyn FnMut(Number<'_>)) {
        each(Number::Single(self));
    }
}

impl<V: Plant, const N: usize> Plant for [V; N] {
    fn numbers(&mut self, each: &mut dyn FnMut(Number<'_>)) {
        self.iter_mut().for_each(|v| v.numbers(each));
    }
}

impl<V: Plant> Plant for Option<V> {
    fn numbers(&mut self, each: &mut dyn FnMut(Number<'_>)) {
        self.iter_mut().for_each(|v| v.numbers(each));
    }
}

/// An error has the value that was wrong.
impl<V: Plant, E> Plant for Result<V, E> {
    fn numbers(&mut self, each: &mut dyn FnMut(Number<'_>)) {
        self.iter_mut().for_each(|v| v.numbers(each));
    }
}

impl<V: ?Sized> Plant for PhantomData<V> {
    fn numbers(&mut self, _: &mut dyn FnMut(Number<'_>)) {}
}

macro_rules! none {
    ($($kind:ty)*) => {$(
        impl Plant for $kind {
            fn numbers(&mut self, _: &mut dyn FnMut(Number<'_>)) {}
        }
    )*};
}
none! { () bool char i8 i32 i64 isize u8 u16 u32 u64 u128 usize &str }

macro_rules! tuples {
    ($(($($v:ident $index:tt)+))*) => {$(
        impl<$($v: Plant),+> Plant for ($($v,)+) {
            fn numbers(&mut self, each: &mut dyn FnMut(Number<'_>)) {
                $(self.$index.numbers(each);)+
            }
        }
    )*};
}
tuples! { (A 0 B 1) (A 0 B 1 C 2) (A 0 B 1 C 2 D 3) (A 0 B 1 C 2 D 3 E 4) (A 0 B 1 C 2 D 3 E 4 F 5) }
