//! The options of operations.

use std::error::Error;
use std::str::FromStr;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use terrella::cube::{CubeMap, Face, Numbering, Projection, Rotation, Stretched, Turned};
use terrella::geodesic::{AnyMethod, Method};
use terrella::healpix::OnEllipsoid;
use terrella::{Ellipsoid, Geodetic, LatLon, Latitude, LocalFrame, NAMED, Shift};

use crate::cube::Cube;
use crate::operation::Failure;
use crate::read::Number;

/// None at all.
#[derive(Args)]
pub struct Nothing {}

/// An ellipsoid.
#[derive(Args)]
pub struct Planet {
    #[arg(long, value_name = "NAME|A,F", default_value = "wgs84", value_parser = draw::ellipsoid::parse, help = planets())]
    ellipsoid: Ellipsoid<f64>,
}

impl Planet {
    /// The ellipsoid, its axis and flattening rounded to the scalar.
    pub fn ellipsoid<T: Number>(&self) -> Result<Ellipsoid<T>, Failure> {
        rounded(self.ellipsoid)
    }
}

/// An ellipsoid, its axis and flattening rounded to the scalar.
pub fn rounded<T: Number>(ellipsoid: Ellipsoid<f64>) -> Result<Ellipsoid<T>, Failure> {
    Ok(Ellipsoid::new(T::of(ellipsoid.a()), T::of(ellipsoid.f()))?)
}

fn planets() -> String {
    let names = NAMED.join(", ");
    format!("The ellipsoid: {names}, or semi-major axis in metres and flattening, as in 6378137,1/298.257223563")
}

/// A method on an ellipsoid.
#[derive(Args)]
pub struct Line {
    /// How geodesics are computed; methods of the sphere take that of mean radius.
    #[arg(long, value_name = "NAME", default_value = "karney", value_parser = one_of::<Method>(Method::ALL.iter().map(|m| m.name())))]
    method: Method,

    /// The place about which `plane` holds, in degrees.
    #[arg(long, value_name = "LAT,LON", allow_hyphen_values = true, value_parser = numbers::<2>)]
    about: Option<[f64; 2]>,

    #[command(flatten)]
    planet: Planet,
}

impl Line {
    pub fn method<T: Number>(&self) -> Result<AnyMethod<T>, Failure> {
        let ellipsoid = self.planet.ellipsoid()?;
        let Some(about) = self.about else {
            return Ok(self.method.on(ellipsoid)?);
        };
        let [lat, lon] = about.map(T::of);
        Ok(self.method.about(ellipsoid, LatLon::new(lat, lon)?)?)
    }
}

/// A local frame.
#[derive(Args)]
pub struct Local {
    /// The origin in degrees and metres.
    #[arg(long, value_name = "LAT,LON,H", allow_hyphen_values = true, value_parser = numbers::<3>)]
    origin: [f64; 3],

    #[command(flatten)]
    planet: Planet,
}

impl Local {
    pub fn frame<T: Number>(&self) -> Result<LocalFrame<T>, Failure> {
        let [lat, lon, height] = self.origin.map(T::of);
        let origin = Geodetic::new(LatLon::new(lat, lon)?, height)?;
        Ok(LocalFrame::new(self.planet.ellipsoid()?, origin))
    }
}

fn numbers<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    let numbers = numbers.ok().and_then(|numbers| numbers.try_into().ok());
    numbers.ok_or_else(|| format!("expected {N} numbers with commas between them"))
}

/// A projection of the sphere.
#[derive(Args)]
pub struct Sphere {
    /// The projection between sphere and cube.
    #[arg(long, value_name = "NAME", value_parser = projection())]
    projection: Projection,

    /// Where on the sphere the front face's centre is, and the azimuth of that face's y, in degrees.
    #[arg(long, value_name = "LAT,LON,AZIMUTH", allow_hyphen_values = true, value_parser = numbers::<3>, conflicts_with = "top")]
    front: Option<[f64; 3]>,

    /// The same of the top face.
    #[arg(long, value_name = "LAT,LON,AZIMUTH", allow_hyphen_values = true, value_parser = numbers::<3>)]
    top: Option<[f64; 3]>,

    /// How many times as fine the cube is at the top face's centre, and as coarse opposite (Schmidt).
    #[arg(long, value_name = "FACTOR")]
    stretch: Option<f64>,
}

impl Sphere {
    pub fn cube(&self) -> Result<Cube, Failure> {
        let place = (self.front.map(|place| (Face::Front, place))).or(self.top.map(|place| (Face::Top, place)));
        if place.is_none() && self.stretch.is_none() {
            return Ok(Cube::Plain(self.projection));
        }
        let (face, [lat, lon, azimuth]) = place.unwrap_or((Face::Front, [0.0; 3]));
        let rotation = Rotation::facing(face, LatLon::new(lat, lon)?.to_direction(), azimuth)?;
        let stretched = Stretched::new(self.projection, self.stretch.unwrap_or(1.0))?;
        Ok(Cube::Oblique(Turned::new(stretched, rotation)))
    }
}

/// A projection of the sphere, and other names of its faces.
#[derive(Args)]
pub struct Numbered {
    /// Whose numbers and axes the faces have.
    #[arg(long, value_name = "NAME", value_parser = numbering())]
    pub numbering: Numbering,

    #[command(flatten)]
    pub sphere: Sphere,
}

/// The projection of cells.
#[derive(Args)]
pub struct Cells {
    /// The projection between sphere and cube.
    #[arg(long, value_name = "NAME", default_value = "s2-quadratic", value_parser = projection())]
    pub projection: Projection,
}

/// Tiles on an ellipsoid. Latitudes are taken as those of the sphere, as for cells, unless a shift is asked for.
#[derive(Args)]
pub struct Tiles {
    #[command(flatten)]
    pub cells: Cells,

    /// The latitude that is taken for that of the sphere; authalic for equal areas.
    #[arg(long, value_name = "NAME", default_value = "geodetic", value_parser = one_of::<Shift>(Shift::ALL.iter().map(|s| s.name())))]
    shift: Shift,

    #[command(flatten)]
    pub planet: Planet,
}

impl Tiles {
    pub fn map<T: Number>(&self) -> Result<CubeMap<T, Projection>, Failure> {
        Ok(CubeMap::new(
            self.planet.ellipsoid()?,
            self.shift,
            self.cells.projection,
        )?)
    }
}

/// A covering by tiles.
#[derive(Args)]
pub struct Cover {
    /// The level of the tiles, 0 to 30.
    #[arg(long, value_name = "LEVEL")]
    pub level: u8,

    /// Only tiles that are inside.
    #[arg(long)]
    pub inner: bool,

    /// Tiles of coarser levels too, where they are inside.
    #[arg(long)]
    pub mixed: bool,

    /// The finest level up to LEVEL with at most so many tiles.
    #[arg(long, value_name = "COUNT")]
    pub most: Option<u32>,

    #[command(flatten)]
    pub tiles: Tiles,
}

/// The sphere, or an ellipsoid that is asked for.
#[derive(Args)]
pub struct SphereOrPlanet {
    /// The ellipsoid, as for other operations; without it latitudes are those of the sphere.
    #[arg(long, value_name = "NAME|A,F", value_parser = draw::ellipsoid::parse)]
    ellipsoid: Option<Ellipsoid<f64>>,
}

impl SphereOrPlanet {
    pub fn healpix<T: Number>(&self) -> Result<OnEllipsoid<T>, Failure> {
        let ellipsoid = match self.ellipsoid {
            Some(ellipsoid) => rounded(ellipsoid)?,
            None => Ellipsoid::sphere(T::ONE)?,
        };
        Ok(OnEllipsoid::new(ellipsoid)?)
    }
}

/// How pixels of HEALPix are numbered.
#[derive(Args)]
pub struct Scheme {
    /// Numbers of the ring scheme instead of the nested one.
    #[arg(long)]
    pub ring: bool,
}

/// Pixels of HEALPix, and what they lie on.
#[derive(Args)]
pub struct Pixels {
    #[command(flatten)]
    pub scheme: Scheme,

    #[command(flatten)]
    pub surface: SphereOrPlanet,
}

/// A projection of the ellipsoid.
#[derive(Args)]
pub struct Map {
    #[command(flatten)]
    sphere: Sphere,

    /// The latitude that is taken for that of the sphere.
    #[arg(long, value_name = "NAME", default_value_t, value_parser = one_of::<Shift>(Shift::ALL.iter().map(|s| s.name())))]
    shift: Shift,

    #[command(flatten)]
    planet: Planet,
}

impl Map {
    pub fn map<T: Number>(&self) -> Result<CubeMap<T, Cube>, Failure> {
        Ok(CubeMap::new(self.planet.ellipsoid()?, self.shift, self.sphere.cube()?)?)
    }
}

/// From which latitude to which, on what.
#[derive(Args)]
pub struct Latitudes {
    /// The latitude that is read.
    #[arg(long, value_name = "NAME", value_parser = latitude())]
    pub from: Latitude,

    /// The latitude that is written.
    #[arg(long, value_name = "NAME", value_parser = latitude())]
    pub to: Latitude,

    /// Radians in and out, instead of degrees.
    #[arg(long)]
    pub radians: bool,

    #[command(flatten)]
    pub planet: Planet,
}

fn latitude() -> impl TypedValueParser<Value = Latitude> {
    one_of(Latitude::ALL.iter().map(|l| l.name()))
}

fn projection() -> impl TypedValueParser<Value = Projection> {
    one_of(Projection::ALL.iter().map(|p| p.name()))
}

fn numbering() -> impl TypedValueParser<Value = Numbering> {
    PossibleValuesParser::new(["s2", "opengl", "fits", "eac"]).map(|name| match name.as_str() {
        "s2" => Numbering::S2,
        "opengl" => Numbering::OpenGl,
        "fits" => Numbering::Fits,
        _ => Numbering::Eac,
    })
}

/// Reads one of the names, which help and errors list.
fn one_of<K>(names: impl Iterator<Item = &'static str>) -> impl TypedValueParser<Value = K>
where
    K: FromStr<Err: Error + Send + Sync> + Clone + Send + Sync + 'static,
{
    PossibleValuesParser::new(names).try_map(|name| name.parse())
}
