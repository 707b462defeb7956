//! Grids of maps: UTM, UPS and MGRS, and the projections below and beside them.

use std::fmt;

use clap::Args;
use terrella::LatLon;
use terrella::grid::{
    AzimuthalEquidistant, Gnomonic, GridPosition, Hemisphere, LambertAzimuthal, Mgrs, PointScale, PolarStereographic,
    TransverseMercator, UtmUps, Zone,
};

use super::{Answer, Failure, Group, answer, group};
use crate::options::Planet;
use crate::read::{Count, Fields, Number, Read};
use crate::write::{Columns, Row};

pub const GROUP: Group = group! {
    "Grids: UTM, UPS (zone 0) and MGRS, and maps, with x to the east and y to the north in metres":
    "utm" "lat lon -> zone n/s easting northing, convergence and scale", utm(Zoned);
    "from-utm" "zone n/s easting northing -> lat lon", from_utm(Planet);
    "mgrs" "lat lon -> the square in which it is", mgrs(Square);
    "from-mgrs" "square -> lat lon of its centre", from_mgrs(Planet);
    "tm" "lon0 lat lon -> x y, convergence and scale of transverse Mercator about lon0", tm(Scaled);
    "from-tm" "lon0 x y -> lat lon", from_tm(Scaled);
    "polar" "n/s lat lon -> x y, convergence and scale of polar stereographic about that pole", polar(Scaled);
    "from-polar" "n/s x y -> lat lon", from_polar(Scaled);
    "laea" "lat0 lon0 lat lon -> x y: Lambert's azimuthal equal-area projection about lat0 lon0", laea(Planet);
    "from-laea" "lat0 lon0 x y -> lat lon", from_laea(Planet);
    "aeqd" "lat0 lon0 lat lon -> x y: azimuthal equidistant about lat0 lon0, by geodesics", aeqd(Planet);
    "from-aeqd" "lat0 lon0 x y -> lat lon", from_aeqd(Planet);
    "gnomonic"
        "lat0 lon0 lat lon -> x y: Karney's gnomonic projection about lat0 lon0 (2013, section 8)", gnomonic(Planet);
    "from-gnomonic" "lat0 lon0 x y -> lat lon", from_gnomonic(Planet);
};

/// Which zone of UTM.
#[derive(Args)]
pub struct Zoned {
    /// The zone, 1 to 60, or 0 for UPS; without it each place's own.
    #[arg(long, value_name = "ZONE")]
    zone: Option<u8>,

    #[command(flatten)]
    planet: Planet,
}

/// How many digits.
#[derive(Args)]
pub struct Square {
    /// Digits for each direction, 0 (100 km) to 11 (micrometres).
    #[arg(long, value_name = "DIGITS", default_value_t = 5)]
    precision: u8,

    #[command(flatten)]
    planet: Planet,
}

/// Which scale.
#[derive(Args)]
pub struct Scaled {
    /// The scale on the central meridian, or at the pole.
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    scale: f64,

    #[command(flatten)]
    planet: Planet,
}

impl Read for Hemisphere {
    const COLUMNS: Count = Count::exactly(1);

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        match fields.text()? {
            "n" | "N" => Ok(Self::North),
            "s" | "S" => Ok(Self::South),
            other => Err(format!("{other:?} is not n or s").into()),
        }
    }
}

impl<T: Number> Read for GridPosition<T> {
    const COLUMNS: Count = Count::exactly(4);

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        let (zone, hemisphere, [easting, northing]) = <(u8, Hemisphere, [T; 2])>::read(fields)?;
        Ok(Self::new(Zone::new(zone)?, hemisphere, easting, northing))
    }
}

impl Read for Mgrs {
    const COLUMNS: Count = Count::exactly(1);

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        Ok(fields.text()?.parse()?)
    }
}

impl Row for Mgrs {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        columns.put(self)
    }
}

impl Row for Hemisphere {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        columns.put(self)
    }
}

impl<T: Number> Row for GridPosition<T> {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        (self.zone.number(), self.hemisphere, [self.easting, self.northing]).write(columns)
    }
}

impl<T: Number> Row for PointScale<T> {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        [self.convergence, self.scale].write(columns)
    }
}

fn utm<T: Number>(Zoned { zone, planet }: Zoned) -> Result<Answer, Failure> {
    let grid = UtmUps::<T>::new(planet.ellipsoid()?)?;
    let asked = zone.map(Zone::new).transpose()?;
    answer(move |place: LatLon<T>| {
        let zone = asked.unwrap_or_else(|| Zone::of(place));
        Ok((grid.in_zone(zone, place)?, grid.point_scale(zone, place)?))
    })
}

fn from_utm<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let grid = UtmUps::<T>::new(planet.ellipsoid()?)?;
    answer(move |position: GridPosition<T>| Ok(grid.inverse(position)?))
}

fn mgrs<T: Number>(Square { precision, planet }: Square) -> Result<Answer, Failure> {
    let grid = UtmUps::<T>::new(planet.ellipsoid()?)?;
    if precision > Mgrs::MAX_PRECISION {
        return Err(format!("precision {precision} is above {}", Mgrs::MAX_PRECISION).into());
    }
    answer(move |place: LatLon<T>| Ok(Mgrs::of(&grid, place, precision)?))
}

fn from_mgrs<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let grid = UtmUps::<T>::new(planet.ellipsoid()?)?;
    answer(move |square: Mgrs| Ok(grid.inverse(square.centre())?))
}

fn tm<T: Number>(Scaled { scale, planet }: Scaled) -> Result<Answer, Failure> {
    let (ellipsoid, scale) = (planet.ellipsoid::<T>()?, T::of(scale));
    answer(move |(meridian, place): (T, LatLon<T>)| {
        let map = TransverseMercator::new(ellipsoid, scale, meridian)?;
        Ok((map.forward(place), map.point_scale(place)))
    })
}

fn from_tm<T: Number>(Scaled { scale, planet }: Scaled) -> Result<Answer, Failure> {
    let (ellipsoid, scale) = (planet.ellipsoid::<T>()?, T::of(scale));
    answer(move |(meridian, point): (T, [T; 2])| {
        Ok(TransverseMercator::new(ellipsoid, scale, meridian)?.inverse(point)?)
    })
}

fn polar<T: Number>(Scaled { scale, planet }: Scaled) -> Result<Answer, Failure> {
    let map = PolarStereographic::new(planet.ellipsoid::<T>()?, T::of(scale))?;
    answer(move |(about, place): (Hemisphere, LatLon<T>)| {
        Ok((map.forward(about, place), map.point_scale(about, place)))
    })
}

fn from_polar<T: Number>(Scaled { scale, planet }: Scaled) -> Result<Answer, Failure> {
    let map = PolarStereographic::new(planet.ellipsoid::<T>()?, T::of(scale))?;
    answer(move |(about, point): (Hemisphere, [T; 2])| Ok(map.inverse(about, point)?))
}

fn laea<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid()?;
    answer(move |[centre, place]: [LatLon<T>; 2]| Ok(LambertAzimuthal::new(ellipsoid, centre)?.forward(place)?))
}

fn from_laea<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid()?;
    answer(move |(centre, point): (LatLon<T>, [T; 2])| Ok(LambertAzimuthal::new(ellipsoid, centre)?.inverse(point)?))
}

fn aeqd<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid()?;
    answer(move |[centre, place]: [LatLon<T>; 2]| Ok(AzimuthalEquidistant::new(ellipsoid, centre)?.forward(place)))
}

fn from_aeqd<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid()?;
    answer(
        move |(centre, point): (LatLon<T>, [T; 2])| Ok(AzimuthalEquidistant::new(ellipsoid, centre)?.inverse(point)?),
    )
}

fn gnomonic<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid()?;
    answer(move |[centre, place]: [LatLon<T>; 2]| Ok(Gnomonic::new(ellipsoid, centre)?.forward(place)?))
}

fn from_gnomonic<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid()?;
    answer(move |(centre, point): (LatLon<T>, [T; 2])| Ok(Gnomonic::new(ellipsoid, centre)?.inverse(point)?))
}
