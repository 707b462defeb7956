//! Points, and passes of a function over them.

use std::array::from_fn;
use std::ops::Range;

use terrella::Real;
use terrella::cube::{Face, FacePoint};

/// Points: up to four coordinates, each in a slice of its own, and a face where one is known or wanted.
pub struct Set<T> {
    /// Where there are none: all the front.
    pub face: Vec<Face>,
    /// The coordinates.
    pub columns: Vec<Vec<T>>,
}

impl<T: Real> Set<T> {
    /// Points without faces, rounded to the scalar.
    pub fn new(columns: Vec<Vec<f64>>) -> Self {
        Self::on(vec![Face::Front; columns[0].len()], columns)
    }

    /// Points on faces, rounded to the scalar.
    pub fn on(face: Vec<Face>, columns: Vec<Vec<f64>>) -> Self {
        let rounded = |column: Vec<f64>| column.into_iter().map(T::of).collect();
        Self {
            face,
            columns: columns.into_iter().map(rounded).collect(),
        }
    }

    /// Points row by row, without faces.
    pub fn rows(rows: Vec<Vec<f64>>) -> Self {
        let width = rows.first().map_or(0, Vec::len);
        Self::new((0..width).map(|k| rows.iter().map(|row| row[k]).collect()).collect())
    }

    /// Room for the results of `n` points.
    pub fn room(n: usize) -> Self {
        Self::new(vec![vec![f64::NAN; n]; 3])
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.face.len()
    }

    fn inputs<const I: usize>(&self, range: &Range<usize>) -> [&[T]; I] {
        from_fn(|k| &self.columns[k][range.clone()])
    }

    fn outputs<const O: usize>(&mut self, range: &Range<usize>) -> (&mut [Face], [&mut [T]; O]) {
        let mut columns = self.columns.iter_mut();
        let outputs = from_fn(|_| &mut columns.next().expect("three columns of room")[range.clone()]);
        (&mut self.face[range.clone()], outputs)
    }
}

/// Reads the points of the first set that the range tells, fills the second.
pub type Pass<'a, T> = &'a dyn Fn(&Set<T>, &mut Set<T>, Range<usize>);

/// The pass that calls a function once per point. What fails is NaN.
pub fn each<T: Real, const I: usize, const O: usize>(
    function: impl Fn([T; I]) -> Option<[T; O]>,
) -> impl Fn(&Set<T>, &mut Set<T>, Range<usize>) {
    move |set, room, range| {
        let inputs = set.inputs::<I>(&range);
        let (_, outputs) = room.outputs::<O>(&range);
        for i in 0..range.len() {
            let results = function(from_fn(|k| inputs[k][i])).unwrap_or([T::of(f64::NAN); O]);
            for k in 0..O {
                outputs[k][i] = results[k];
            }
        }
    }
}

/// The same to points of faces.
pub fn each_to_face<T: Real, const I: usize>(
    function: impl Fn([T; I]) -> Option<FacePoint<T>>,
) -> impl Fn(&Set<T>, &mut Set<T>, Range<usize>) {
    move |set, room, range| {
        let inputs = set.inputs::<I>(&range);
        let (faces, [x, y]) = room.outputs(&range);
        for i in 0..range.len() {
            if let Some(point) = function(from_fn(|k| inputs[k][i])) {
                (faces[i], x[i], y[i]) = (point.face(), point.x(), point.y());
            }
        }
    }
}

/// The same from points of faces.
pub fn each_from_face<T: Real, const O: usize>(
    function: impl Fn(FacePoint<T>) -> [T; O],
) -> impl Fn(&Set<T>, &mut Set<T>, Range<usize>) {
    move |set, room, range| {
        let faces = &set.face[range.clone()];
        let [x, y] = set.inputs(&range);
        let (_, outputs) = room.outputs::<O>(&range);
        for i in 0..range.len() {
            if let Ok(point) = FacePoint::new(faces[i], x[i], y[i]) {
                let results = function(point);
                for k in 0..O {
                    outputs[k][i] = results[k];
                }
            }
        }
    }
}

/// The pass that hands a function all points of the range at once.
pub fn batch<T: Real, const I: usize, const O: usize>(
    function: impl Fn([&[T]; I], [&mut [T]; O]),
) -> impl Fn(&Set<T>, &mut Set<T>, Range<usize>) {
    move |set, room, range| function(set.inputs(&range), room.outputs(&range).1)
}

/// The same to points of faces.
pub fn batch_to_face<T: Real, const I: usize>(
    function: impl Fn([&[T]; I], &mut [Face], [&mut [T]; 2]),
) -> impl Fn(&Set<T>, &mut Set<T>, Range<usize>) {
    move |set, room, range| {
        let (faces, points) = room.outputs(&range);
        function(set.inputs(&range), faces, points);
    }
}

/// The same from points of faces.
pub fn batch_from_face<T: Real, const O: usize>(
    function: impl Fn(&[Face], [&[T]; 2], [&mut [T]; O]),
) -> impl Fn(&Set<T>, &mut Set<T>, Range<usize>) {
    move |set, room, range| {
        function(&set.face[range.clone()], set.inputs(&range), room.outputs(&range).1);
    }
}
