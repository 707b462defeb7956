//! Rows of numbers: read from a line, written to one.

use std::error::Error;
use std::fmt::{self, Write};
use std::str::FromStr;

use terrella::cube::FacePoint;
use terrella::frame::Enu;
use terrella::geodesic::{Direct, Inverse};
use terrella::{Direction, Ecef, Geodetic, LatLon, Real};

/// The numbers of a line that must have `N` of them.
pub fn parse<T: Real + FromStr, const N: usize>(line: &[u8]) -> Result<[T; N], Box<dyn Error>> {
    let line = std::str::from_utf8(line).map_err(|_| "not UTF-8")?;
    let mut fields = [""; N];
    let mut found = 0;
    for field in line.split_ascii_whitespace() {
        if let Some(place) = fields.get_mut(found) {
            *place = field;
        }
        found += 1;
    }
    if found != N {
        return Err(format!("fields: {N} expected, {found} found").into());
    }
    let mut numbers = [T::ZERO; N];
    for (number, field) in numbers.iter_mut().zip(fields) {
        *number = field.parse().map_err(|_| format!("{field:?} is not a number"))?;
    }
    Ok(numbers)
}

/// What can be written as columns.
pub trait Row {
    /// Appends the columns with tabs between them.
    fn write(&self, out: &mut String) -> fmt::Result;
}

impl<T: Real, const N: usize> Row for [T; N] {
    fn write(&self, out: &mut String) -> fmt::Result {
        let mut tab = "";
        for number in self {
            out.push_str(tab);
            write!(out, "{number:?}")?;
            tab = "\t";
        }
        Ok(())
    }
}

impl<T: Real> Row for Direction<T> {
    fn write(&self, out: &mut String) -> fmt::Result {
        self.to_array().write(out)
    }
}

impl<T: Real> Row for LatLon<T> {
    fn write(&self, out: &mut String) -> fmt::Result {
        [self.lat(), self.lon()].write(out)
    }
}

impl<T: Real> Row for Inverse<T> {
    fn write(&self, out: &mut String) -> fmt::Result {
        [self.distance, self.azimuth1, self.azimuth2].write(out)
    }
}

impl<T: Real> Row for Direct<T> {
    fn write(&self, out: &mut String) -> fmt::Result {
        [self.position.lat(), self.position.lon(), self.azimuth].write(out)
    }
}

impl<T: Real> Row for Ecef<T> {
    fn write(&self, out: &mut String) -> fmt::Result {
        self.to_array().write(out)
    }
}

impl<T: Real> Row for Geodetic<T> {
    fn write(&self, out: &mut String) -> fmt::Result {
        [self.lat(), self.lon(), self.height()].write(out)
    }
}

impl<T: Real> Row for Enu<T> {
    fn write(&self, out: &mut String) -> fmt::Result {
        [self.east, self.north, self.up].write(out)
    }
}

impl<T: Real> Row for FacePoint<T> {
    fn write(&self, out: &mut String) -> fmt::Result {
        write!(out, "{}\t", self.face().index())?;
        [self.x(), self.y()].write(out)
    }
}
