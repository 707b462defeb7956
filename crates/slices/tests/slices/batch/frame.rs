//! Local frames: three kinds of axes, offsets, vectors.

use terrella::batch::{self, ellipsoid::InvalidGeodetic};
use terrella::frame::GeodeticOffset;
use terrella::{Aer, Ecef, Enu, Geodetic, InvalidEcef, LatLon, LocalFrame, Ned};

use super::{compare, entry, place};
use testkit::bytes::Bytes;
use testkit::scalar::Scalar;

/// Metres of any size of interest.
fn metres<T: Scalar>(bytes: &mut Bytes<'_>) -> [T; 3] {
    let size = bytes.choice(&[1e2, 1e5, 1e7, 1e9]);
    [entry(bytes, size), entry(bytes, size), entry(bytes, size)]
}

fn geodetic<T: Scalar>(bytes: &mut Bytes<'_>) -> [T; 3] {
    let [lat, lon] = place(bytes);
    [lat, lon, entry(bytes, 1e6)]
}

fn aer<T: Scalar>(bytes: &mut Bytes<'_>) -> [T; 3] {
    [entry(bytes, 400.0), entry(bytes, 90.0), entry(bytes, 1e7)]
}

fn checked<T: Scalar>([lat, lon, height]: [T; 3]) -> Result<Geodetic<T>, InvalidGeodetic<T>> {
    let place = LatLon::new(lat, lon).map_err(InvalidGeodetic::LatLon)?;
    Geodetic::new(place, height).map_err(InvalidGeodetic::Height)
}

fn ecef<T: Scalar>([x, y, z]: [T; 3]) -> Result<Ecef<T>, InvalidEcef<T>> {
    Ecef::new(x, y, z)
}

fn enu_of<T>([east, north, up]: [T; 3]) -> Enu<T> {
    Enu { east, north, up }
}

fn ned_of<T>([north, east, down]: [T; 3]) -> Ned<T> {
    Ned { north, east, down }
}

fn aer_of<T>([azimuth, elevation, range]: [T; 3]) -> Aer<T> {
    Aer {
        azimuth,
        elevation,
        range,
    }
}

fn of_enu<T>(Enu { east, north, up }: Enu<T>) -> [T; 3] {
    [east, north, up]
}

fn of_ned<T>(Ned { north, east, down }: Ned<T>) -> [T; 3] {
    [north, east, down]
}

fn of_aer<T>(
    Aer {
        azimuth,
        elevation,
        range,
    }: Aer<T>,
) -> [T; 3] {
    [azimuth, elevation, range]
}

fn of_place<T: Scalar>(place: Geodetic<T>) -> [T; 3] {
    [place.lat(), place.lon(), place.height()]
}

pub(super) fn frames<T: Scalar>(bytes: &mut Bytes<'_>) {
    let height = bytes.choice(&[0.0, 400.0, -4e6, 1e9]);
    let origin = Geodetic::new(bytes.place(), T::of(height)).unwrap();
    let frame = &LocalFrame::new(bytes.ellipsoid(-1.0 / 9.0, 0.1), origin);
    macro_rules! one_of {
        ($frame:ident $($name:ident $draw:ident |$row:ident| $one:expr;)*) => {
            let cases: &[fn(&mut Bytes<'_>, &LocalFrame<T>)] = &[$(|bytes, $frame| {
                compare(
                    bytes,
                    stringify!($name),
                    $draw,
                    |$row: [T; 3]| $one,
                    |from, to| batch::frame::$name($frame, from, to),
                );
            },)*];
            bytes.choice(cases)(bytes, $frame);
        };
    }
    one_of! { frame
        to_enu metres |row| Ok(of_enu(frame.to_enu(ecef(row)?)));
        to_ned metres |row| Ok(of_ned(frame.to_ned(ecef(row)?)));
        to_aer metres |row| Ok(of_aer(frame.to_aer(ecef(row)?)));
        from_enu metres |row| frame.from_enu(enu_of(row)).map(Ecef::to_array);
        from_ned metres |row| frame.from_ned(ned_of(row)).map(Ecef::to_array);
        from_aer aer |row| frame.from_aer(aer_of(row)).map(Ecef::to_array);
        geodetic_to_enu geodetic |row| Ok(of_enu(frame.geodetic_to_enu(checked(row)?)));
        geodetic_to_ned geodetic |row| Ok(of_ned(frame.geodetic_to_ned(checked(row)?)));
        geodetic_to_aer geodetic |row| Ok(of_aer(frame.geodetic_to_aer(checked(row)?)));
        enu_to_geodetic metres |row| frame.enu_to_geodetic(enu_of(row)).map(of_place);
        ned_to_geodetic metres |row| frame.ned_to_geodetic(ned_of(row)).map(of_place);
        aer_to_geodetic aer |row| frame.aer_to_geodetic(aer_of(row)).map(of_place);
        enu_to_offset metres |row| {
            let offset = frame.enu_to_offset(enu_of(row))?;
            Ok([offset.lat, offset.lon, offset.height])
        };
        offset_to_enu geodetic |row| {
            let [lat, lon, height] = row;
            Ok(of_enu(frame.offset_to_enu(GeodeticOffset { lat, lon, height })))
        };
        vector_to_enu metres |row| Ok(of_enu(frame.vector_to_enu(row)));
        vector_from_enu metres |row| Ok(frame.vector_from_enu(enu_of(row)));
    }
}
