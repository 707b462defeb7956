use core::marker::PhantomData;
use core::mem::take;

use crate::Real;
use crate::cube::Face;
use crate::simd::{BLOCK, Sink, Source, block, push, store};

/// An element of a column of faces: a [`Face`], or its number as a byte.
///
/// The trait is sealed.
pub trait FaceNumber: Copy + sealed::Number {}

impl FaceNumber for Face {}

impl FaceNumber for u8 {}

mod sealed {
    use crate::Real;
    use crate::cube::Face;

    pub trait Number {
        /// The number; above 5 it is that of no face.
        fn number(self) -> u8;

        /// The face with a number in 0 to 5. The choice vectorises.
        fn of<T: Real>(number: T) -> Self;
    }

    impl Number for Face {
        #[inline(always)]
        fn number(self) -> u8 {
            self.index()
        }

        #[inline(always)]
        fn of<T: Real>(number: T) -> Self {
            Self::of_number(number)
        }
    }

    impl Number for u8 {
        #[inline(always)]
        fn number(self) -> u8 {
            self
        }

        #[inline(always)]
        fn of<T: Real>(number: T) -> Self {
            number.to_byte()
        }
    }
}

/// A column of faces that is read or written as one of numbers.
#[derive(Clone, Copy)]
pub(super) struct Faces<F, T>(F, PhantomData<T>);

impl<F, T> Faces<F, T> {
    pub(super) const fn new(faces: F) -> Self {
        Self(faces, PhantomData)
    }
}

impl<F, T> Faces<&[F], T> {
    /// Takes the first faces off.
    pub(super) fn head(&mut self, count: usize) -> Self {
        let (head, rest) = self.0.split_at_checked(count).unwrap_or_default();
        self.0 = rest;
        Self::new(head)
    }
}

impl<F, T> Faces<&mut [F], T> {
    /// Takes the first faces off.
    pub(super) fn front(&mut self, count: usize) -> Self {
        let (head, rest) = take(&mut self.0).split_at_mut_checked(count).unwrap_or_default();
        self.0 = rest;
        Self::new(head)
    }
}

impl<F: FaceNumber, T: Real> Source for Faces<&[F], T> {
    type Row = T;
    type Spare = [T; BLOCK];
    type Block<'a>
        = &'a [T; BLOCK]
    where
        Self: 'a;

    #[inline(always)]
    fn spare() -> Self::Spare {
        [T::ZERO; BLOCK]
    }

    #[inline(always)]
    fn len(&self) -> usize {
        self.0.len()
    }

    fn other_length(&self, length: usize) -> Option<usize> {
        (self.0.len() != length).then_some(self.0.len())
    }

    #[inline(always)]
    fn at(&self, index: usize) -> T {
        T::from_byte(self.0.get(index).map_or(0, |face| face.number()))
    }

    #[inline(always)]
    fn next<'a>(&mut self, numbers: &'a mut Self::Spare) -> Self::Block<'a>
    where
        Self: 'a,
    {
        let Some(&any) = self.0.first() else { return numbers };
        let mut spare = [any; BLOCK];
        let here = block(&mut self.0, &mut spare);
        for (slot, &face) in numbers.iter_mut().zip(here) {
            *slot = T::from_byte(face.number());
        }
        numbers
    }

    #[inline(always)]
    fn block<'a>(spare: &'a Self::Spare) -> Self::Block<'a>
    where
        Self: 'a,
    {
        spare
    }

    #[inline(always)]
    fn row<'a>(block: Self::Block<'a>, i: usize) -> T
    where
        Self: 'a,
    {
        block.get(i).copied().unwrap_or_default()
    }

    #[inline(always)]
    fn put(spare: &mut Self::Spare, i: usize, number: T) {
        if let Some(slot) = spare.get_mut(i) {
            *slot = number;
        }
    }
}

impl<F: FaceNumber, T: Real> Sink for Faces<&mut [F], T> {
    type Row = T;
    type Block = [T; BLOCK];

    #[inline(always)]
    fn block() -> Self::Block {
        [T::ZERO; BLOCK]
    }

    /// The number of the front face.
    #[inline(always)]
    fn nothing() -> T {
        T::ZERO
    }

    fn other_length(&self, length: usize) -> Option<usize> {
        (self.0.len() != length).then_some(self.0.len())
    }

    #[inline(always)]
    fn put(block: &mut Self::Block, i: usize, number: T) {
        if let Some(slot) = block.get_mut(i) {
            *slot = number;
        }
    }

    fn get(block: &Self::Block, i: usize) -> T {
        block.get(i).copied().unwrap_or_default()
    }

    #[inline(always)]
    fn store(&mut self, block: &Self::Block) {
        store(&mut self.0, &block.map(F::of));
    }

    #[inline(always)]
    fn push(&mut self, number: T) {
        push(&mut self.0, F::of(number));
    }
}
