use terrella::batch::{self, grid::InvalidMapped};
use terrella::grid::{
    AzimuthalEquidistant, Gnomonic, GridPosition, Hemisphere, InvalidMap, InvalidZone, LambertAzimuthal, Mgrs,
    MgrsText, NotOnMap, OutsideGrid, OutsideMap, OutsideMgrs, ParseMgrsError, PointScale, PolarStereographic,
    TransverseMercator, Ups, Utm, UtmUps, Zone,
};
use terrella::{Ellipsoid, LatLon};

use crate::batch::{columns, function, into, lent, places};
use crate::{Arguments, Bits, Hash, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    conformal::<T, V>(visitor);
    azimuthal::<T, V>(visitor);
    utm_and_ups::<T, V>(visitor);
    squares::<T, V>(visitor);
    batches::<T, V>(visitor);
    if T::NAME == f64::NAME {
        text(visitor);
    }
}

/// A point some thousand kilometres from an origin.
fn point<T: Scalar>(arguments: &mut Arguments) -> [T; 2] {
    arguments.units::<T, 2>().map(|x| x * T::of(1e7))
}

fn about(arguments: &mut Arguments) -> Hemisphere {
    if arguments.below(2) == 0 {
        Hemisphere::North
    } else {
        Hemisphere::South
    }
}

fn conformal<T: Scalar, V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| (arguments.ellipsoid::<T>(), arguments.units::<T, 2>());
    visitor.function::<T, _, _>("TransverseMercator::new", draw, |(ellipsoid, [scale, lon])| {
        let map = TransverseMercator::new(ellipsoid, T::abs(scale), lon * T::of(400.0))?;
        let f = TransverseMercator::ellipsoid(&map).f();
        Ok::<_, InvalidMap<T>>([f, TransverseMercator::scale(&map), TransverseMercator::meridian(&map)])
    });
    if let Ok(map) = TransverseMercator::new(Ellipsoid::<T>::WGS84, T::of(0.9996), T::of(9.0)) {
        visitor.function::<T, _, _>("TransverseMercator::forward", Arguments::place::<T>, |place| {
            TransverseMercator::forward(&map, place)
        });
        visitor.function::<T, _, _>("TransverseMercator::inverse", point::<T>, |point| {
            TransverseMercator::inverse(&map, point)
        });
        visitor.function::<T, _, _>("TransverseMercator::point_scale", Arguments::place::<T>, |place| {
            TransverseMercator::point_scale(&map, place)
        });
    }
    let draw = |arguments: &mut Arguments| (arguments.ellipsoid::<T>(), arguments.unit::<T>());
    visitor.function::<T, _, _>("PolarStereographic::new", draw, |(ellipsoid, scale)| {
        let map = PolarStereographic::new(ellipsoid, scale)?;
        let f = PolarStereographic::ellipsoid(&map).f();
        Ok::<_, InvalidMap<T>>([f, PolarStereographic::scale(&map)])
    });
    if let Ok(map) = PolarStereographic::new(Ellipsoid::<T>::WGS84, T::of(0.994)) {
        let draw = |arguments: &mut Arguments| (about(arguments), arguments.place::<T>());
        visitor.function::<T, _, _>("PolarStereographic::forward", draw, |(about, place)| {
            PolarStereographic::forward(&map, about, place)
        });
        visitor.function::<T, _, _>("PolarStereographic::point_scale", draw, |(about, place)| {
            PolarStereographic::point_scale(&map, about, place)
        });
        let draw = |arguments: &mut Arguments| (about(arguments), point::<T>(arguments));
        visitor.function::<T, _, _>("PolarStereographic::inverse", draw, |(about, point)| {
            PolarStereographic::inverse(&map, about, point)
        });
    }
}

fn azimuthal<T: Scalar, V: Visitor>(visitor: &mut V) {
    let earth = Ellipsoid::<T>::WGS84;
    let draw = |arguments: &mut Arguments| (arguments.ellipsoid::<T>(), arguments.place::<T>());
    visitor.function::<T, _, _>("LambertAzimuthal::new", draw, |(ellipsoid, centre)| {
        LambertAzimuthal::new(ellipsoid, centre)
            .map(|map| (LambertAzimuthal::ellipsoid(&map).f(), LambertAzimuthal::centre(&map)))
    });
    visitor.function::<T, _, _>("AzimuthalEquidistant::new", draw, |(ellipsoid, centre)| {
        AzimuthalEquidistant::new(ellipsoid, centre).map(|map| AzimuthalEquidistant::centre(&map))
    });
    visitor.function::<T, _, _>("Gnomonic::new", draw, |(ellipsoid, centre)| {
        Gnomonic::new(ellipsoid, centre).map(|map| Gnomonic::centre(&map))
    });
    let Ok(centre) = LatLon::new(T::of(52.0), T::of(10.0)) else {
        return;
    };
    if let Ok(map) = LambertAzimuthal::new(earth, centre) {
        visitor.function::<T, _, _>("LambertAzimuthal::forward", Arguments::place::<T>, |place| {
            LambertAzimuthal::forward(&map, place)
        });
        visitor.function::<T, _, _>("LambertAzimuthal::inverse", point::<T>, |point| {
            LambertAzimuthal::inverse(&map, point)
        });
    }
    if let Ok(map) = AzimuthalEquidistant::new(earth, centre) {
        visitor.function::<T, _, _>("AzimuthalEquidistant::forward", Arguments::place::<T>, |place| {
            AzimuthalEquidistant::forward(&map, place)
        });
        visitor.function::<T, _, _>("AzimuthalEquidistant::inverse", point::<T>, |point| {
            AzimuthalEquidistant::inverse(&map, point)
        });
    }
    if let Ok(map) = Gnomonic::new(earth, centre) {
        visitor.function::<T, _, _>("Gnomonic::forward", Arguments::place::<T>, |place| {
            Gnomonic::forward(&map, place)
        });
        visitor.function::<T, _, _>("Gnomonic::inverse", point::<T>, |point| Gnomonic::inverse(&map, point));
    }
}

fn zone(arguments: &mut Arguments) -> u8 {
    arguments.below(62) as u8
}

fn position<T: Scalar>(arguments: &mut Arguments) -> (u8, Hemisphere, [T; 2]) {
    let [east, north] = arguments.units::<T, 2>();
    (
        zone(arguments),
        about(arguments),
        [east * T::of(3e6), T::abs(north) * T::of(1e7)],
    )
}

fn utm_and_ups<T: Scalar, V: Visitor>(visitor: &mut V) {
    visitor.function::<T, _, _>("Zone::of", Arguments::place::<T>, |place| {
        let zone = Zone::of(place);
        (
            Zone::number(zone),
            Zone::meridian::<T>(zone),
            Hemisphere::of(place.lat()),
        )
    });
    visitor.function::<T, _, _>("Utm::new", Arguments::ellipsoid::<T>, |ellipsoid| {
        let utm = Utm::new(ellipsoid)?;
        let zone = Zone::new(31).ok().and_then(|zone| Utm::zone(&utm, zone));
        let meridian = zone.map(|map| TransverseMercator::meridian(&map));
        Ok::<_, terrella::latitude::UnsupportedFlattening<T>>((Utm::ellipsoid(&utm).f(), meridian))
    });
    visitor.function::<T, _, _>("Ups::new", Arguments::ellipsoid::<T>, |ellipsoid| {
        Ups::new(ellipsoid).map(|ups| Ups::ellipsoid(&ups).f())
    });
    visitor.function::<T, _, _>("UtmUps::new", Arguments::ellipsoid::<T>, |ellipsoid| {
        UtmUps::new(ellipsoid).map(|grid| UtmUps::ellipsoid(&grid).f())
    });
    let earth = Ellipsoid::<T>::WGS84;
    let in_zone = |arguments: &mut Arguments| (zone(arguments), arguments.place::<T>());
    if let (Ok(utm), Ok(ups), Ok(grid)) = (Utm::new(earth), Ups::new(earth), UtmUps::new(earth)) {
        visitor.function::<T, _, _>("Utm::forward", Arguments::place::<T>, |place| Utm::forward(&utm, place));
        visitor.function::<T, _, _>("Utm::in_zone", in_zone, |(zone, place)| {
            Ok::<_, InvalidZone>(Utm::in_zone(&utm, Zone::new(zone)?, place))
        });
        visitor.function::<T, _, _>("Utm::inverse", position::<T>, |(zone, about, [east, north])| {
            let zone = Zone::new(zone)?;
            Ok::<_, InvalidZone>(Utm::inverse(&utm, GridPosition::new(zone, about, east, north)))
        });
        visitor.function::<T, _, _>("Utm::point_scale", in_zone, |(zone, place)| {
            Ok::<_, InvalidZone>(Utm::point_scale(&utm, Zone::new(zone)?, place))
        });
        visitor.function::<T, _, _>("Ups::forward", Arguments::place::<T>, |place| Ups::forward(&ups, place));
        visitor.function::<T, _, _>("Ups::inverse", position::<T>, |(_, about, [east, north])| {
            Ups::inverse(&ups, GridPosition::new(Zone::POLAR, about, east, north))
        });
        visitor.function::<T, _, _>("Ups::point_scale", Arguments::place::<T>, |place| {
            Ups::point_scale(&ups, place)
        });
        visitor.function::<T, _, _>("UtmUps::forward", Arguments::place::<T>, |place| {
            UtmUps::forward(&grid, place)
        });
        visitor.function::<T, _, _>("UtmUps::in_zone", in_zone, |(zone, place)| {
            Ok::<_, InvalidZone>(UtmUps::in_zone(&grid, Zone::new(zone)?, place))
        });
        visitor.function::<T, _, _>("UtmUps::inverse", position::<T>, |(zone, about, [east, north])| {
            let zone = Zone::new(zone)?;
            Ok::<_, InvalidZone>(UtmUps::inverse(&grid, GridPosition::new(zone, about, east, north)))
        });
        visitor.function::<T, _, _>("UtmUps::point_scale", in_zone, |(zone, place)| {
            Ok::<_, InvalidZone>(UtmUps::point_scale(&grid, Zone::new(zone)?, place))
        });
    }
}

fn squares<T: Scalar, V: Visitor>(visitor: &mut V) {
    let Ok(grid) = UtmUps::new(Ellipsoid::<T>::WGS84) else {
        return;
    };
    let draw = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.below(13) as u8);
    visitor.function::<T, _, _>("Mgrs::of", draw, |(place, precision)| {
        let square = Mgrs::of(&grid, place, precision)?;
        let positions = [Mgrs::centre::<T>(square), Mgrs::south_west(square)];
        let parts = (
            Mgrs::zone(square),
            Mgrs::hemisphere(square),
            Mgrs::precision(square),
            Mgrs::width::<T>(square),
        );
        Ok::<_, OutsideMgrs<T>>((square, positions, parts))
    });
    let draw = |arguments: &mut Arguments| {
        let (zone, about, [east, north]) = position::<T>(arguments);
        (zone, about, [T::abs(east), north], arguments.unit::<T>())
    };
    visitor.function::<T, _, _>("Mgrs::new", draw, |(zone, about, [east, north], lat)| {
        let position = GridPosition::new(Zone::new(zone)?, about, east, north);
        Ok::<_, InvalidZone>(Mgrs::new(position, lat * T::of(90.0), 5))
    });
}

/// Of whole numbers: the same for all scalars.
fn text<V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| {
        let mut text = [(); 9].map(|()| b'A' + arguments.below(26) as u8);
        for (place, byte) in text.iter_mut().enumerate() {
            if !(2..=4).contains(&place) {
                *byte = b'0' + arguments.below(10) as u8;
            }
        }
        text
    };
    visitor.function::<f64, _, _>("Mgrs::coarser", draw, |text| {
        let square: Mgrs = core::str::from_utf8(&text).unwrap_or_default().parse()?;
        Ok::<_, ParseMgrsError>((square, Mgrs::coarser(square, 1)))
    });
}

fn batches<T: Scalar, V: Visitor>(visitor: &mut V) {
    let earth = Ellipsoid::<T>::WGS84;
    let points = |arguments: &mut Arguments| columns::<T, 2>(arguments, [T::of(8e6); 2]);
    if let Ok(map) = TransverseMercator::new(earth, T::of(0.9996), T::of(9.0)) {
        visitor.visit::<T, _, _>(
            function("batch::grid::transverse_mercator", ""),
            places::<T>,
            |places| into(|points| batch::grid::transverse_mercator(&map, lent(&places), points)),
        );
        visitor.visit::<T, _, _>(
            function("batch::grid::transverse_mercator_inverse", ""),
            points,
            |points| into(|places| batch::grid::transverse_mercator_inverse(&map, lent(&points), places)),
        );
        visitor.visit::<T, _, _>(function("batch::grid::utm", ""), places::<T>, |places| {
            into(|points| batch::grid::utm(&map, Hemisphere::South, lent(&places), points))
        });
        visitor.visit::<T, _, _>(function("batch::grid::utm_inverse", ""), points, |points| {
            into(|places| batch::grid::utm_inverse(&map, Hemisphere::South, lent(&points), places))
        });
    }
    if let Ok(map) = PolarStereographic::new(earth, T::of(0.994)) {
        visitor.visit::<T, _, _>(
            function("batch::grid::polar_stereographic", ""),
            places::<T>,
            |places| into(|points| batch::grid::polar_stereographic(&map, Hemisphere::North, lent(&places), points)),
        );
        visitor.visit::<T, _, _>(
            function("batch::grid::polar_stereographic_inverse", ""),
            points,
            |points| {
                into(|places| batch::grid::polar_stereographic_inverse(&map, Hemisphere::North, lent(&points), places))
            },
        );
    }
    let Ok(centre) = LatLon::new(T::of(52.0), T::of(10.0)) else {
        return;
    };
    if let Ok(map) = LambertAzimuthal::new(earth, centre) {
        visitor.visit::<T, _, _>(function("batch::grid::lambert_azimuthal", ""), places::<T>, |places| {
            into(|points| batch::grid::lambert_azimuthal(&map, lent(&places), points))
        });
        visitor.visit::<T, _, _>(
            function("batch::grid::lambert_azimuthal_inverse", ""),
            points,
            |points| into(|places| batch::grid::lambert_azimuthal_inverse(&map, lent(&points), places)),
        );
    }
}

impl Bits for Zone {
    fn add_to(&self, hash: &mut Hash) {
        Zone::number(*self).add_to(hash);
    }
}

impl Bits for Hemisphere {
    fn add_to(&self, hash: &mut Hash) {
        (*self as u8).add_to(hash);
    }
}

impl<T: Scalar> Bits for GridPosition<T> {
    fn add_to(&self, hash: &mut Hash) {
        (self.zone, self.hemisphere, [self.easting, self.northing]).add_to(hash);
    }
}

impl<T: Scalar> Bits for PointScale<T> {
    fn add_to(&self, hash: &mut Hash) {
        [self.convergence, self.scale].add_to(hash);
    }
}

impl Bits for Mgrs {
    fn add_to(&self, hash: &mut Hash) {
        let text: MgrsText = Mgrs::text(*self);
        MgrsText::as_str(&text).add_to(hash);
    }
}

impl<T: Scalar> Bits for OutsideMap<T> {
    fn add_to(&self, hash: &mut Hash) {
        [self.x, self.y].add_to(hash);
    }
}

impl<T: Scalar> Bits for NotOnMap<T> {
    fn add_to(&self, hash: &mut Hash) {
        self.0.add_to(hash);
    }
}

impl Bits for InvalidZone {
    fn add_to(&self, hash: &mut Hash) {
        self.0.add_to(hash);
    }
}

impl<T: Scalar> Bits for InvalidMap<T> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Flattening(why) => (0_u8, why.0),
            Self::Scale(scale) => (1, *scale),
            Self::Meridian(lon) => (2, *lon),
        }
        .add_to(hash);
    }
}

impl<T: Scalar> Bits for OutsideGrid<T> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Latitude(lat) => (0_u8, *lat),
            Self::Longitude(lon) => (1, *lon),
            Self::Easting(easting) => (2, *easting),
            Self::Northing(northing) => (3, *northing),
            Self::Zone(zone) => return zone.add_to(hash),
        }
        .add_to(hash);
    }
}

impl<T: Scalar> Bits for OutsideMgrs<T> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Grid(why) => return why.add_to(hash),
            Self::Precision(precision) => return precision.add_to(hash),
            Self::Easting(easting) => (0_u8, *easting),
            Self::Northing(northing) => (1, *northing),
            Self::Latitude(lat) => (2, *lat),
        }
        .add_to(hash);
    }
}

impl Bits for ParseMgrsError {
    fn add_to(&self, hash: &mut Hash) {
        let number = match self {
            Self::Zone(zone) => u32::from(*zone),
            Self::Band(letter) | Self::Column(letter) | Self::Row(letter) | Self::Character(letter) => *letter as u32,
            Self::Unfinished => 1,
            Self::Inconsistent(band, row) => *band as u32 * 256 + *row as u32,
            Self::Odd(count) | Self::TooLong(count) => *count as u32,
        };
        number.add_to(hash);
    }
}

impl<T: Scalar> Bits for InvalidMapped<T> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Place(why) => why.add_to(hash),
            Self::Map(why) => why.add_to(hash),
        }
    }
}
