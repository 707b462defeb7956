//! A pass of a library's function over a set of points, and the set itself.

use std::array::from_fn;
use std::ops::Range;

/// What a library computes in.
pub trait Scalar: Copy + Into<f64> {
    /// The word for a record's `scalar`.
    const NAME: &str;

    /// The nearest.
    fn of(value: f64) -> Self;
}

impl Scalar for f64 {
    const NAME: &str = "f64";

    fn of(value: f64) -> Self {
        value
    }
}

impl Scalar for f32 {
    const NAME: &str = "f32";

    fn of(value: f64) -> Self {
        value as f32
    }
}

/// Points: up to four coordinates, and a face where one is known or wanted.
#[derive(Clone, Default)]
pub struct Set<T = f64> {
    /// 0 to 5.
    pub face: Vec<u8>,
    /// The coordinates, each of the same length.
    pub columns: Vec<Vec<T>>,
}

impl<T: Scalar> Set<T> {
    /// Points without faces.
    pub fn new(columns: Vec<Vec<T>>) -> Self {
        Self {
            face: vec![0; columns[0].len()],
            columns,
        }
    }

    /// Points on faces.
    pub fn on(face: Vec<u8>, columns: Vec<Vec<T>>) -> Self {
        Self { face, columns }
    }

    /// Room for the results of `n` points.
    pub fn room(n: usize) -> Self {
        Self {
            face: vec![0; n],
            columns: vec![vec![T::of(f64::NAN); n]; 3],
        }
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.face.len()
    }

    /// The same in another scalar.
    pub fn rounded<U: Scalar>(&self) -> Set<U> {
        let rounded = |column: &Vec<T>| column.iter().map(|&value| U::of(value.into())).collect();
        Set {
            face: self.face.clone(),
            columns: self.columns.iter().map(rounded).collect(),
        }
    }
}

impl Set {
    /// A column changed: for other units.
    pub fn map(mut self, column: usize, change: impl Fn(f64) -> f64) -> Self {
        self.columns[column]
            .iter_mut()
            .for_each(|value| *value = change(*value));
        self
    }

    /// The same points, those of a face together.
    pub fn sorted_by_face(&self) -> Self {
        let mut order: Vec<usize> = (0..self.len()).collect();
        order.sort_by_key(|&i| self.face[i]);
        Self {
            face: order.iter().map(|&i| self.face[i]).collect(),
            columns: self
                .columns
                .iter()
                .map(|column| order.iter().map(|&i| column[i]).collect())
                .collect(),
        }
    }
}

/// Reads the points of the first set that the range tells, fills the second. A point that fails gives a first result that is not finite.
pub type Pass<T = f64> = Box<dyn Fn(&Set<T>, &mut Set<T>, Range<usize>)>;

/// The pass that calls `function` once per point: `I` coordinates in, `O` results out.
pub fn each<const I: usize, const O: usize>(function: impl Fn([f64; I]) -> [f64; O] + 'static) -> Pass {
    Box::new(move |set, room, range| {
        let n = range.len();
        let inputs: [&[f64]; I] = from_fn(|k| &set.columns[k][range.clone()]);
        let mut columns = room.columns.iter_mut();
        let outputs: [&mut [f64]; O] = from_fn(|_| &mut columns.next().expect("three columns of room")[range.clone()]);
        for i in 0..n {
            let results = function(from_fn(|k| inputs[k][i]));
            for k in 0..O {
                outputs[k][i] = results[k];
            }
        }
    })
}

/// The pass that hands a function all points of the range at once: `I` coordinates in, one result out.
pub fn batch<T: Scalar + 'static, const I: usize>(function: impl Fn([&[T]; I], &mut [T]) + 'static) -> Pass<T> {
    Box::new(move |set, room, range| {
        function(
            from_fn(|k| &set.columns[k][range.clone()]),
            &mut room.columns[0][range.clone()],
        )
    })
}
