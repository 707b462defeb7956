//! What can be read from the columns of a line.

use std::fmt;
use std::str::{FromStr, SplitAsciiWhitespace};

use terrella::cube::{Face, FacePoint};
use terrella::{Aer, Direction, Ecef, Enu, Geodetic, LatLon, Ned, Real};

use crate::operation::Failure;
use crate::write::Row;

/// A precision in which numbers are read, computed and written.
pub trait Number: Real + FromStr + Into<f64> + Read + Row {}

impl Number for f64 {}
impl Number for f32 {}

/// How many columns something takes.
#[derive(Clone, Copy)]
pub struct Count {
    least: usize,
    /// Further ones, each of which is there or not.
    further: usize,
    /// Further ones that come together, any number of times; 0 if there are none.
    repeated: usize,
}

impl Count {
    pub const fn exactly(columns: usize) -> Self {
        Self {
            least: columns,
            further: 0,
            repeated: 0,
        }
    }

    const fn and(self, next: Self) -> Self {
        Self {
            least: self.least + next.least,
            further: self.further + next.further,
            repeated: self.repeated + next.repeated,
        }
    }

    /// Whether a line of so many columns is one.
    pub fn allows(self, columns: usize) -> bool {
        match columns.checked_sub(self.least) {
            None => false,
            Some(more) => more <= self.further || self.repeated > 0 && more.is_multiple_of(self.repeated),
        }
    }

    /// Whether a line without columns is one.
    pub fn allows_none(self) -> bool {
        self.least == 0
    }
}

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            least,
            further,
            repeated,
        } = self;
        write!(f, "{least}")?;
        if *repeated > 0 {
            write!(f, ", {}, {}, …", least + repeated, least + 2 * repeated)
        } else if *further > 0 {
            write!(f, " to {}", least + further)
        } else {
            Ok(())
        }
    }
}

/// The columns of a line, of which there are as many as [`Read::COLUMNS`] allows.
pub struct Fields<'a>(SplitAsciiWhitespace<'a>);

impl<'a> Fields<'a> {
    /// Reads a whole line.
    pub fn read<C: Read>(line: &'a str) -> Result<C, Failure> {
        let found = line.split_ascii_whitespace().count();
        if !C::COLUMNS.allows(found) {
            return Err(format!("fields: {} expected, {found} found", C::COLUMNS).into());
        }
        C::read(&mut Self(line.split_ascii_whitespace()))
    }

    /// The next column.
    pub fn text(&mut self) -> Result<&'a str, Failure> {
        Ok(self.0.next().ok_or("a field is missing")?)
    }

    fn is_empty(&self) -> bool {
        self.0.clone().next().is_none()
    }

    fn number<T: FromStr>(&mut self) -> Result<T, Failure> {
        let text = self.text()?;
        text.parse().map_err(|_| format!("{text:?} is not a number").into())
    }

    /// A whole number that the type has.
    fn whole<N: FromStr>(&mut self) -> Result<N, Failure> {
        let text = self.text()?;
        text.parse()
            .map_err(|_| format!("{text:?} is not a whole number, or too large").into())
    }
}

/// What can be read from columns.
pub trait Read: Sized {
    /// How many.
    const COLUMNS: Count;

    /// Reads them.
    ///
    /// # Errors
    /// What is wrong with them, in one line.
    fn read(fields: &mut Fields) -> Result<Self, Failure>;
}

macro_rules! single {
    ($($type:ty, $read:ident;)*) => {
        $(
            impl Read for $type {
                const COLUMNS: Count = Count::exactly(1);

                fn read(fields: &mut Fields) -> Result<Self, Failure> {
                    fields.$read()
                }
            }
        )*
    };
}

single! {
    f64, number;
    f32, number;
    u8, whole;
    u32, whole;
    u64, whole;
}

/// A column as it is.
impl Read for String {
    const COLUMNS: Count = Count::exactly(1);

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        Ok(fields.text()?.to_owned())
    }
}

/// All columns that are left, with spaces between them; at least one.
pub struct Rest(pub String);

impl Read for Rest {
    const COLUMNS: Count = Count {
        least: 1,
        further: 0,
        repeated: 1,
    };

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        let mut text = fields.text()?.to_owned();
        while !fields.is_empty() {
            text.push(' ');
            text.push_str(fields.text()?);
        }
        Ok(Self(text))
    }
}

impl<C: Read, const N: usize> Read for [C; N] {
    const COLUMNS: Count = Count::exactly(N * C::COLUMNS.least);

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        let all: Vec<_> = (0..N).map(|_| C::read(fields)).collect::<Result<_, _>>()?;
        all.try_into().map_err(|_| "a field is missing".into())
    }
}

macro_rules! tuple {
    ($($name:ident)*) => {
        impl<$($name: Read),*> Read for ($($name,)*) {
            const COLUMNS: Count = Count::exactly(0)$(.and($name::COLUMNS))*;

            fn read(fields: &mut Fields) -> Result<Self, Failure> {
                Ok(($($name::read(fields)?,)*))
            }
        }
    };
}

tuple!(A B);
tuple!(A B C);
tuple!(A B C D);

/// Read where columns are left.
impl<C: Read> Read for Option<C> {
    const COLUMNS: Count = Count {
        least: 0,
        further: C::COLUMNS.least,
        repeated: 0,
    };

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        (!fields.is_empty()).then(|| C::read(fields)).transpose()
    }
}

/// Read until no column is left.
impl<C: Read> Read for Vec<C> {
    const COLUMNS: Count = Count {
        least: 0,
        further: 0,
        repeated: C::COLUMNS.least,
    };

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        let mut all = Self::new();
        while !fields.is_empty() {
            all.push(C::read(fields)?);
        }
        Ok(all)
    }
}

/// A type that a constructor makes of other columns, or refuses.
macro_rules! constructed {
    ($($type:ident $columns:pat = $read:ty => $make:expr;)*) => {
        $(
            impl<T: Number> Read for $type<T> {
                const COLUMNS: Count = <$read>::COLUMNS;

                fn read(fields: &mut Fields) -> Result<Self, Failure> {
                    let $columns = <$read>::read(fields)?;
                    Ok($make)
                }
            }
        )*
    };
}

constructed! {
    LatLon [lat, lon] = [T; 2] => Self::new(lat, lon)?;
    Geodetic (place, height) = (LatLon<T>, T) => Self::new(place, height)?;
    Direction [x, y, z] = [T; 3] => Self::new(x, y, z)?;
    Ecef [x, y, z] = [T; 3] => Self::new(x, y, z)?;
    Enu [east, north, up] = [T; 3] => Self { east, north, up };
    Ned [north, east, down] = [T; 3] => Self { north, east, down };
    Aer [azimuth, elevation, range] = [T; 3] => Self { azimuth, elevation, range };
    FacePoint (face, [x, y]) = (Face, [T; 2]) => Self::new(face, x, y)?;
}

impl Read for Face {
    const COLUMNS: Count = Count::exactly(1);

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        let number = fields.number::<f64>()?;
        let known = Self::ALL.into_iter().find(|face| f64::from(face.index()) == number);
        known.ok_or_else(|| format!("face {number} is not an integer in 0 to 5").into())
    }
}
