//! What can be written as the columns of a line.

use std::fmt::{self, Write};

use terrella::cube::FacePoint;
use terrella::geodesic::{Direct, Inverse, LinePoint};
use terrella::{Aer, Direction, Ecef, Enu, Geodetic, LatLon, Ned};

use crate::read::Number;

/// A line, to which columns are appended with tabs between them.
pub struct Columns<'a> {
    line: &'a mut String,
    tab: &'static str,
}

impl<'a> Columns<'a> {
    pub fn new(line: &'a mut String) -> Self {
        Self { line, tab: "" }
    }

    /// Appends one.
    pub fn put(&mut self, column: impl fmt::Display) -> fmt::Result {
        self.line.push_str(self.tab);
        self.tab = "\t";
        write!(self.line, "{column}")
    }
}

/// What can be written as columns.
pub trait Row {
    /// Appends them.
    fn write(&self, columns: &mut Columns) -> fmt::Result;
}

macro_rules! single {
    ($($type:ty => $format:literal;)*) => {
        $(
            impl Row for $type {
                fn write(&self, columns: &mut Columns) -> fmt::Result {
                    columns.put(format_args!($format, self))
                }
            }
        )*
    };
}

single! {
    f64 => "{:?}";
    f32 => "{:?}";
    u8 => "{}";
    u32 => "{}";
    u64 => "{}";
}

/// Text, of which each word is a column.
impl Row for String {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        self.split(' ').try_for_each(|word| columns.put(word))
    }
}

impl Row for bool {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        u8::from(*self).write(columns)
    }
}

impl<R: Row> Row for [R] {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        self.iter().try_for_each(|row| row.write(columns))
    }
}

impl<R: Row, const N: usize> Row for [R; N] {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        self.as_slice().write(columns)
    }
}

impl<R: Row> Row for Vec<R> {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        self.as_slice().write(columns)
    }
}

macro_rules! tuple {
    ($($name:ident $index:tt)*) => {
        impl<$($name: Row),*> Row for ($($name,)*) {
            fn write(&self, columns: &mut Columns) -> fmt::Result {
                $(self.$index.write(columns)?;)*
                Ok(())
            }
        }
    };
}

tuple!(A 0 B 1);
tuple!(A 0 B 1 C 2);
tuple!(A 0 B 1 C 2 D 3);

/// The columns of a type of the library.
macro_rules! rows {
    ($($type:ident |$value:ident| $columns:expr;)*) => {
        $(
            impl<T: Number> Row for $type<T> {
                fn write(&self, columns: &mut Columns) -> fmt::Result {
                    let $value = self;
                    $columns.write(columns)
                }
            }
        )*
    };
}

rows! {
    LatLon |place| [place.lat(), place.lon()];
    Geodetic |place| (place.lat_lon(), place.height());
    Direction |direction| direction.to_array();
    Ecef |point| point.to_array();
    Enu |enu| [enu.east, enu.north, enu.up];
    Ned |ned| [ned.north, ned.east, ned.down];
    Aer |aer| [aer.azimuth, aer.elevation, aer.range];
    FacePoint |point| (point.face().index(), [point.x(), point.y()]);
    Inverse |line| [line.distance, line.azimuth1, line.azimuth2];
    Direct |end| (end.position, end.azimuth);
    LinePoint |point| (point.position, [point.azimuth, point.arc, point.reduced_length, point.scale12, point.scale21]);
}
