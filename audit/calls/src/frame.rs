use terrella::frame::GeodeticOffset;
use terrella::{Aer, Ellipsoid, Enu, LocalFrame, Ned};

use crate::{Arguments, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    let earth = Ellipsoid::WGS84;
    let frame = LocalFrame::new(earth, Arguments::new().geodetic::<T>());
    let three = Arguments::units::<T, 3>;
    let enu = |[east, north, up]: [T; 3]| {
        let far = T::of(1e5);
        Enu {
            east: east * far,
            north: north * far,
            up: up * far,
        }
    };
    visitor.function::<T, _, _>("LocalFrame::new", Arguments::geodetic::<T>, |origin| {
        let frame = LocalFrame::new(earth, origin);
        let axes = [
            LocalFrame::east(&frame),
            LocalFrame::north(&frame),
            LocalFrame::up(&frame),
        ];
        let origin = (LocalFrame::origin(&frame), LocalFrame::origin_ecef(&frame));
        (axes, origin, LocalFrame::ellipsoid(&frame))
    });
    visitor.function::<T, _, _>("LocalFrame::to_enu", Arguments::ecef::<T>, |point| {
        LocalFrame::to_enu(&frame, point)
    });
    visitor.function::<T, _, _>("LocalFrame::to_ned", Arguments::ecef::<T>, |point| {
        LocalFrame::to_ned(&frame, point)
    });
    visitor.function::<T, _, _>("LocalFrame::to_aer", Arguments::ecef::<T>, |point| {
        LocalFrame::to_aer(&frame, point)
    });
    visitor.function::<T, _, _>("LocalFrame::from_enu", three, |parts| {
        LocalFrame::from_enu(&frame, enu(parts))
    });
    visitor.function::<T, _, _>("LocalFrame::from_ned", three, |parts| {
        LocalFrame::from_ned(&frame, Ned::from(enu(parts)))
    });
    visitor.function::<T, _, _>("LocalFrame::from_aer", three, |[azimuth, elevation, range]| {
        let (azimuth, elevation) = (azimuth * T::of(180.0), elevation * T::of(90.0));
        let range = T::ONE / range;
        let aer = Aer {
            azimuth,
            elevation,
            range,
        };
        LocalFrame::from_aer(&frame, aer)
    });
    visitor.function::<T, _, _>("LocalFrame::geodetic_to_enu", Arguments::geodetic::<T>, |place| {
        LocalFrame::geodetic_to_enu(&frame, place)
    });
    visitor.function::<T, _, _>("LocalFrame::geodetic_to_ned", Arguments::geodetic::<T>, |place| {
        LocalFrame::geodetic_to_ned(&frame, place)
    });
    visitor.function::<T, _, _>("LocalFrame::geodetic_to_aer", Arguments::geodetic::<T>, |place| {
        LocalFrame::geodetic_to_aer(&frame, place)
    });
    visitor.function::<T, _, _>("LocalFrame::enu_to_geodetic", three, |parts| {
        LocalFrame::enu_to_geodetic(&frame, enu(parts))
    });
    visitor.function::<T, _, _>("LocalFrame::ned_to_geodetic", three, |parts| {
        LocalFrame::ned_to_geodetic(&frame, Ned::from(enu(parts)))
    });
    visitor.function::<T, _, _>("LocalFrame::aer_to_geodetic", three, |[azimuth, elevation, range]| {
        let (azimuth, elevation) = (azimuth * T::of(180.0), elevation * T::of(90.0));
        let range = T::ONE / range;
        let aer = Aer {
            azimuth,
            elevation,
            range,
        };
        LocalFrame::aer_to_geodetic(&frame, aer)
    });
    visitor.function::<T, _, _>("LocalFrame::enu_to_offset", three, |parts| {
        // As far as the other side of the Earth, where the way is another.
        let Enu { east, north, up } = enu(parts);
        let far = Enu {
            east: east * T::of(64.0),
            north: north * T::of(64.0),
            up: up * T::of(64.0),
        };
        [enu(parts), far].map(|enu| LocalFrame::enu_to_offset(&frame, enu))
    });
    visitor.function::<T, _, _>("LocalFrame::offset_to_enu", three, |[lat, lon, height]| {
        let offset = GeodeticOffset { lat, lon, height };
        LocalFrame::offset_to_enu(&frame, offset)
    });
    visitor.function::<T, _, _>("LocalFrame::vector_to_enu", three, |vector| {
        LocalFrame::vector_to_enu(&frame, vector)
    });
    visitor.function::<T, _, _>("LocalFrame::vector_from_enu", three, |parts| {
        LocalFrame::vector_from_enu(&frame, enu(parts))
    });
    visitor.function::<T, _, _>("Enu, Ned and Aer, from each other", three, |parts| {
        let enu = enu(parts);
        let (ned, aer) = (Ned::from(enu), Aer::from(enu));
        (
            ned,
            aer,
            Aer::from(ned),
            Ned::from(aer),
            (Enu::from(ned), Enu::from(aer)),
        )
    });
}
