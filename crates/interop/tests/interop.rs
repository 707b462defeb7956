//! The optional conversions: serde, glam, mint, nalgebra, geo-types, num-traits, defmt; each test needs its feature.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // a test may fail loudly

#[cfg(feature = "serde")]
mod serde {
    use std::fmt::Debug;

    use ::serde::Serialize;
    use ::serde::de::DeserializeOwned;
    use serde_json::{from_str, from_value, to_string, to_value};
    use terrella::cube::{CubeProjection, Face, FacePoint, Projection};
    use terrella::frame::GeodeticOffset;
    use terrella::healpix::Pixel;
    use terrella::terrain::{Heights, Hilbert, Key, Morton, Tile};
    use terrella::{Aer, Direction, Ecef, Ellipsoid, Geodetic, LatLon, Latitude, NAMED, Real, Shift};

    /// Out and in again, as a tree of values: decimals would test the reader's rounding, not ours.
    fn comes_back<V: Serialize + DeserializeOwned + PartialEq + Debug>(value: V) {
        let tree = to_value(&value).unwrap();
        assert_eq!(from_value::<V>(tree.clone()).unwrap(), value, "{tree}");
    }

    fn reads<V: DeserializeOwned + PartialEq + Debug>(text: &str, value: V) {
        assert_eq!(from_str::<V>(text).unwrap(), value, "{text}");
    }

    /// Refused, with the words of the constructor.
    fn refuses<V: DeserializeOwned + Debug>(text: &str, because: &str) {
        let why = from_str::<V>(text).unwrap_err().to_string();
        assert!(why.contains(because), "{text}: {why}");
    }

    fn numbers_come_back<T: Real + Serialize + DeserializeOwned>(epsilon: f64) {
        let mut rng = fastrand::Rng::with_seed(50);
        for _ in 0..2000 {
            let mut signed = |scale: f64| T::of(scale * (2.0 * rng.f64() - 1.0));
            comes_back(LatLon::new(signed(90.0), signed(180.0)).unwrap());
            comes_back(Direction::new(signed(1.0), signed(1.0), signed(1.0)).unwrap());
            comes_back(Ellipsoid::new(signed(1.0).abs() + T::of(epsilon), signed(1.0)).unwrap());
            for face in Face::ALL {
                let point = FacePoint::new(face, signed(1.0), signed(1.0)).unwrap();
                comes_back(point);
                comes_back(Projection::Quadrilateralized.unproject(point));
            }
        }
        for &name in NAMED {
            comes_back(Ellipsoid::<T>::named(name).unwrap());
        }
    }

    #[test]
    fn values_come_back() {
        numbers_come_back::<f64>(1e-15);
        numbers_come_back::<f32>(1e-6);
    }

    #[test]
    fn the_text_is_plain() {
        let place = LatLon::new(59.5, -10.75).unwrap();
        assert_eq!(to_string(&place).unwrap(), r#"{"lat":59.5,"lon":-10.75}"#);
        let east = Direction::new(0.0, 2.0, 0.0).unwrap();
        assert_eq!(to_string(&east).unwrap(), r#"{"x":0.0,"y":1.0,"z":0.0}"#);
        let point = FacePoint::new(Face::Top, 0.25_f32, -1.0).unwrap();
        assert_eq!(to_string(&point).unwrap(), r#"{"face":"top","x":0.25,"y":-1.0}"#);
        let moon = Ellipsoid::<f64>::MOON;
        assert_eq!(to_string(&moon).unwrap(), r#"{"a":1737400.0,"f":0.0}"#);
        reads(r#"{"lon": -10.75, "lat": 59.5}"#, place);
        reads(r#"{"x":0,"y":1,"z":0}"#, east);
        reads(r#"{"face":"top","x":0.25,"y":-1}"#, point);
        reads(r#"{"a":1737400,"f":0}"#, moon);
        let heights = Heights::new(-11.0, 8848.0).unwrap();
        assert_eq!(to_string(&heights).unwrap(), r#"{"low":-11.0,"high":8848.0}"#);
        reads(r#"{"low":-11,"high":8848}"#, heights);
        let pixel = Pixel::new(9, 954_011).unwrap();
        assert_eq!(to_string(&pixel).unwrap(), r#"{"depth":9,"number":954011}"#);
        reads(r#"{"depth":9,"number":954011}"#, pixel);
        let key = Key::<Hilbert>::from(Tile::new(Face::Right, 2, 1, 3).unwrap());
        assert_eq!(to_string(&key).unwrap(), r#""39""#);
        reads(r#""39""#, key);
        reads(
            r#"{"lat":0.5,"lon":-1,"height":2}"#,
            GeodeticOffset {
                lat: 0.5,
                lon: -1.0,
                height: 2.0,
            },
        );
        let tile = Tile::new(Face::Back, 30, 7, 1_073_741_823).unwrap();
        let text = r#"{"face":"back","level":30,"i":7,"j":1073741823}"#;
        assert_eq!(to_string(&tile).unwrap(), text);
        reads(text, tile);
    }

    #[test]
    fn reading_does_what_new_does() {
        reads(r#"{"lat":0,"lon":361}"#, LatLon::new(0.0, 1.0).unwrap());
        reads(r#"{"lat":0,"lon":-180}"#, LatLon::new(0.0, -180.0).unwrap());
        reads(r#"{"x":0,"y":-3,"z":4}"#, Direction::new(0.0, -0.6, 0.8).unwrap());
    }

    #[test]
    fn local_coordinates_and_points_in_space_come_back() {
        let place = Geodetic::new(LatLon::new(1.0, 2.0).unwrap(), 3.0).unwrap();
        let text = to_string(&place).unwrap();
        assert_eq!(text, r#"{"lat_lon":{"lat":1.0,"lon":2.0},"height":3.0}"#);
        assert_eq!(from_str::<Geodetic<f64>>(&text).unwrap(), place);
        assert!(from_str::<Geodetic<f64>>(r#"{"lat_lon":{"lat":91.0,"lon":2.0},"height":3.0}"#).is_err());
        let point = Ecef::new(1.0, 2.0, 3.0).unwrap();
        assert_eq!(from_str::<Ecef<f64>>(&to_string(&point).unwrap()).unwrap(), point);
        let seen = Aer {
            azimuth: 1.0,
            elevation: 2.0,
            range: 3.0,
        };
        assert_eq!(from_str::<Aer<f64>>(&to_string(&seen).unwrap()).unwrap(), seen);
    }

    #[test]
    fn what_new_refuses_is_refused() {
        refuses::<LatLon<f64>>(r#"{"lat":90.5,"lon":0}"#, "latitude 90.5");
        // Too large for single precision: the number reads as infinite.
        refuses::<LatLon<f32>>(r#"{"lat":0,"lon":1e300}"#, "longitude inf");
        refuses::<Direction<f64>>(r#"{"x":0,"y":0,"z":0}"#, "no direction");
        refuses::<Ellipsoid<f64>>(r#"{"a":-1,"f":0}"#, "axis -1");
        refuses::<Ellipsoid<f64>>(r#"{"a":1,"f":1}"#, "flattening 1");
        refuses::<FacePoint<f64>>(r#"{"face":"top","x":0,"y":1.5}"#, "1.5");
        refuses::<FacePoint<f64>>(r#"{"face":"roof","x":0,"y":0}"#, "unknown variant");
        refuses::<Tile>(r#"{"face":"top","level":31,"i":0,"j":0}"#, "level 31");
        refuses::<Tile>(r#"{"face":"top","level":2,"i":0,"j":4}"#, "row 4");
        refuses::<Heights<f64>>(r#"{"low":2,"high":1}"#, "low ≤ high, got 2.0 and 1.0");
        refuses::<Pixel>(r#"{"depth":1,"number":48}"#, "pixel 48");
        refuses::<Key<Morton>>(r#""f""#, "0xf000000000000000 is not the key of a tile");
        refuses::<Key<Morton>>("57", "expected the token of a tile");
        refuses::<LatLon<f64>>(r#"{"lat":0}"#, "missing field `lon`");
        refuses::<LatLon<f64>>(r#"{"lat":null,"lon":0}"#, "invalid type");
    }

    /// The names in a file are the names of the program.
    fn named<V: Serialize + DeserializeOwned + PartialEq + Debug + Copy>(all: &[V], name: impl Fn(V) -> &'static str) {
        for &value in all {
            assert_eq!(to_value(value).unwrap(), name(value));
            comes_back(value);
        }
        refuses::<V>(r#""nonsense""#, "unknown variant");
    }

    #[test]
    fn names_are_the_names() {
        named(Projection::ALL, Projection::name);
        named(Shift::ALL, Shift::name);
        named(Latitude::ALL, Latitude::name);
        named(&Face::ALL, |face| {
            ["front", "right", "back", "left", "top", "bottom"][face as usize]
        });
    }
}

#[cfg(feature = "num-traits")]
#[path = "interop/num_traits.rs"]
mod num_traits;

#[cfg(feature = "glam")]
mod glam {
    use ::glam::{DMat3, DVec3, Mat3, Mat3A, Vec3, Vec3A};
    use terrella::{Direction, Ecef, Enu, InvalidDirection, LocalFrame, Ned};

    use super::{ENU, frame};

    #[test]
    fn positions_and_axes() {
        let frame: LocalFrame = frame();
        let point = frame.from_enu(ENU).unwrap();
        let vector = DVec3::from(point);
        assert_eq!(vector.to_array(), point.to_array());
        assert_eq!(Ecef::try_from(vector), Ok(point));
        assert!(Ecef::try_from(DVec3::NAN).is_err() && Ecef::try_from(Vec3::INFINITY).is_err());
        assert_eq!(DVec3::from(ENU), DVec3::new(1.0, 2.0, 3.0));
        assert_eq!(Enu::from(DVec3::new(1.0, 2.0, 3.0)), ENU);
        assert_eq!(DVec3::from(Ned::from(ENU)), DVec3::new(2.0, 1.0, -3.0));
        assert_eq!(Ned::from(Vec3A::new(2.0, 1.0, -3.0)), Ned::from(ENU.to_f32()));
        let turned = DMat3::from(&frame) * DVec3::from(ENU);
        let [x, y, z] = frame.vector_from_enu(ENU);
        assert!(turned.distance(DVec3::new(x, y, z)) < 1e-15);

        let frame: LocalFrame<f32> = super::frame();
        let [x, y, z] = frame.vector_from_enu(ENU.to_f32());
        let turned = Mat3::from(&frame) * Vec3::from(ENU.to_f32());
        assert!(turned.distance(Vec3::new(x, y, z)) < 1e-6);
        let turned = Mat3A::from(&frame) * Vec3A::from(ENU.to_f32());
        assert!(turned.distance(Vec3A::new(x, y, z)) < 1e-6);
    }

    #[test]
    fn to_a_vector_and_back() {
        let mut rng = fastrand::Rng::with_seed(51);
        for _ in 0..10_000 {
            let [x, y, z] = [(); 3].map(|()| 2.0 * rng.f64() - 1.0);
            let double = Direction::new(x, y, z).unwrap();
            let vector = DVec3::from(double);
            assert_eq!(vector.to_array(), double.to_array());
            assert_eq!(Direction::try_from(vector), Ok(double));

            let single = Direction::new(x as f32, y as f32, z as f32).unwrap();
            let vector: Vec3 = single.into();
            let aligned: Vec3A = single.into();
            assert_eq!(vector.to_array(), single.to_array());
            assert_eq!(aligned.to_array(), single.to_array());
            assert_eq!(Direction::try_from(vector), Ok(single));
            assert_eq!(Direction::try_from(aligned), Ok(single));
        }
    }

    #[test]
    fn a_vector_of_any_length_has_a_direction() {
        let direction = Direction::try_from(DVec3::new(0.0, -3.0, 4.0) * 2f64.powi(700)).unwrap();
        assert_eq!(direction.to_array(), [0.0, -0.6, 0.8]);
        assert_eq!(Direction::try_from(Vec3::Y * 7.0).unwrap().to_array(), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn what_has_no_direction_is_refused() {
        let zero = InvalidDirection { x: 0.0, y: 0.0, z: 0.0 };
        assert_eq!(Direction::try_from(Vec3::ZERO), Err(zero));
        assert_eq!(Direction::try_from(Vec3A::ZERO), Err(zero));
        let infinite = InvalidDirection {
            x: 1.0,
            y: f64::INFINITY,
            z: 2.0,
        };
        assert_eq!(Direction::try_from(DVec3::new(1.0, f64::INFINITY, 2.0)), Err(infinite));
        let refused = Direction::try_from(DVec3::NAN).unwrap_err();
        assert!(refused.x.is_nan() && refused.y.is_nan() && refused.z.is_nan());
    }
}

/// A vector in the axes of [`frame`].
#[cfg(any(feature = "glam", feature = "mint", feature = "nalgebra"))]
const ENU: terrella::Enu = terrella::Enu {
    east: 1.0,
    north: 2.0,
    up: 3.0,
};

#[cfg(any(feature = "glam", feature = "mint", feature = "nalgebra"))]
fn frame<T: terrella::Real>() -> terrella::LocalFrame<T> {
    let origin = terrella::LatLon::new(T::of(52.0), T::of(-8.0)).unwrap();
    terrella::LocalFrame::new(terrella::Ellipsoid::WGS84, origin.into())
}

#[cfg(feature = "mint")]
mod mint {
    use ::mint::{ColumnMatrix3, Point3, Vector3};
    use terrella::{Direction, Ecef, Enu, LocalFrame, Ned};

    use super::{ENU, frame};

    #[test]
    fn there_and_back() {
        let frame: LocalFrame = frame();
        let up = frame.up();
        let vector = Vector3::from(up);
        assert_eq!([vector.x, vector.y, vector.z], up.to_array());
        assert_eq!(Direction::try_from(vector), Ok(up));
        assert!(Direction::try_from(Vector3::from([0.0, 0.0, 0.0])).is_err());

        let point = frame.origin_ecef();
        assert_eq!(<[f64; 3]>::from(Point3::from(point)), point.to_array());
        assert_eq!(Ecef::try_from(Point3::from(point)), Ok(point));
        assert_eq!(Ecef::try_from(Vector3::from(point)), Ok(point));
        assert!(Ecef::try_from(Point3::from([0.0, f32::NAN, 0.0])).is_err());

        assert_eq!(Vector3::from(ENU), [1.0, 2.0, 3.0].into());
        assert_eq!(Enu::from(Vector3::from(ENU)), ENU);
        assert_eq!(Enu::from(Point3::from(ENU)), ENU);
        let ned = Ned::from(ENU);
        assert_eq!(Point3::from(ned), [2.0, 1.0, -3.0].into());
        assert_eq!(Ned::from(Point3::from(ned)), ned);
        assert_eq!(Ned::from(Vector3::from(ned)), ned);

        let columns: [[f64; 3]; 3] = ColumnMatrix3::from(&frame).into();
        assert_eq!(columns, [frame.east(), frame.north(), up].map(Direction::to_array));
    }
}

#[cfg(feature = "nalgebra")]
mod nalgebra {
    use ::nalgebra::{Matrix3, Point3, Rotation3, UnitVector3, Vector3};
    use terrella::{Direction, Ecef, Enu, LocalFrame, Ned};

    use super::{ENU, frame};

    #[test]
    fn there_and_back() {
        let frame: LocalFrame = frame();
        let up = frame.up();
        assert_eq!(Direction::try_from(Vector3::from(up)), Ok(up));
        assert_eq!(UnitVector3::from(up).into_inner(), Vector3::from(up));
        assert!(Direction::try_from(Vector3::new(0.0, 0.0, 0.0)).is_err());

        let point = frame.origin_ecef();
        assert_eq!(Point3::from(point), Point3::new(point.x(), point.y(), point.z()));
        assert_eq!(Ecef::try_from(Point3::from(point)), Ok(point));
        assert_eq!(Ecef::try_from(Vector3::from(point)), Ok(point));
        assert!(Ecef::try_from(Point3::new(0.0, f32::NAN, 0.0)).is_err());

        assert_eq!(Vector3::from(ENU), Vector3::new(1.0, 2.0, 3.0));
        assert_eq!(Enu::from(Vector3::from(ENU)), ENU);
        assert_eq!(Enu::from(Point3::from(ENU)), ENU);
        let ned = Ned::from(ENU);
        assert_eq!(Point3::from(ned), Point3::new(2.0, 1.0, -3.0));
        assert_eq!(Ned::from(Point3::from(ned)), ned);
        assert_eq!(Ned::from(Vector3::from(ned)), ned);
    }

    #[test]
    fn the_axes_are_a_rotation() {
        let frame: LocalFrame = frame();
        let matrix = Matrix3::from(&frame);
        assert_eq!(matrix.column(2), Vector3::from(frame.up()));
        let rotation = Rotation3::from(&frame);
        assert_eq!(rotation.matrix(), &matrix);
        let turned = rotation * Vector3::from(ENU);
        assert!((turned - Vector3::from(frame.vector_from_enu(ENU))).norm() < 1e-15);
        assert!((rotation.inverse() * turned - Vector3::from(ENU)).norm() < 1e-15);
        assert!((matrix.determinant() - 1.0).abs() < 1e-15);
    }
}

#[cfg(feature = "geo-types")]
mod geo_types {
    use ::geo_types::{Coord, Point, coord, point};
    use terrella::{InvalidLatLon, LatLon};

    #[test]
    fn x_is_the_longitude() {
        let oslo = LatLon::new(59.91, 10.75).unwrap();
        assert_eq!(Coord::from(oslo), coord! { x: 10.75, y: 59.91 });
        assert_eq!(Point::from(oslo), point! { x: 10.75, y: 59.91 });
        assert_eq!(
            LatLon::try_from(coord! { x: 370.75, y: 59.91 }),
            LatLon::new(59.91, 370.75)
        );
        assert_eq!(LatLon::try_from(Point::from(oslo.to_f32())), Ok(oslo.to_f32()));
        assert_eq!(
            LatLon::try_from(point! { x: 10.75, y: 100.0 }),
            Err(InvalidLatLon::Latitude(100.0))
        );
    }
}

/// Every public type and error has `defmt::Format`. Compiled, never run: formatting needs a logger for the whole program.
#[cfg(feature = "defmt")]
const _: () = {
    use ::defmt::Format;
    use terrella::cube::*;
    use terrella::frame::{Aer, Enu, GeodeticOffset, InvalidEnu, LocalFrame, Ned};
    use terrella::geodesic::*;
    use terrella::healpix::{InvalidPixel, InvalidPixelPlace, OutsidePlane, Pixel};
    use terrella::latitude::*;
    use terrella::math::Polynomial;
    use terrella::terrain::*;
    use terrella::{
        Direction, Dms, DmsLatLon, Ecef, Ellipsoid, Geodetic, InvalidDirection, InvalidEcef, InvalidEllipsoid,
        InvalidHeight, InvalidLatLon, LatLon, Latitude, ParseLatLonError, Shift, Shifted,
    };

    const fn formats<T: Format>() {}

    const fn generic<T: Format>() {
        formats::<LatLon<T>>();
        formats::<InvalidLatLon<T>>();
        formats::<ParseLatLonError<T>>();
        formats::<Direction<T>>();
        formats::<InvalidDirection<T>>();
        formats::<Ellipsoid<T>>();
        formats::<InvalidEllipsoid<T>>();
        formats::<Shifted<T>>();
        formats::<Conversion<T>>();
        formats::<InvalidLatitude<T>>();
        formats::<UnsupportedFlattening<T>>();
        formats::<FacePoint<T>>();
        formats::<InvalidFacePoint<T>>();
        formats::<InvalidNumbered<T>>();
        formats::<CubeMap<T, Projection>>();
        formats::<Geodetic<T>>();
        formats::<InvalidHeight<T>>();
        formats::<Ecef<T>>();
        formats::<InvalidEcef<T>>();
        formats::<LocalFrame<T>>();
        formats::<Enu<T>>();
        formats::<Ned<T>>();
        formats::<Aer<T>>();
        formats::<GeodeticOffset<T>>();
        formats::<InvalidEnu<T>>();
        formats::<OutsidePlane<T>>();
        formats::<InvalidPixelPlace<T>>();
        formats::<AnyMethod<T>>();
        formats::<GeodesicError<T>>();
        formats::<Inverse<T>>();
        formats::<Direct<T>>();
        formats::<Solution<T>>();
        formats::<Line<T>>();
        formats::<LinePoint<T>>();
        formats::<Area<T>>();
        formats::<PolygonArea<T>>();
        formats::<PlanarArea<T>>();
        formats::<PlanarPolygon<T>>();
        formats::<InvalidPlace<T>>();
        formats::<Heights<T>>();
        formats::<InvalidHeights<T>>();
        formats::<Enclosure<T, Projection>>();
        formats::<OrientedBox<T>>();
        formats::<BoundingSphere<T>>();
        formats::<Horizon<T>>();
        formats::<Camera<T>>();
        formats::<InvalidCamera<T>>();
        formats::<Detail<T>>();
        formats::<InvalidDetail<T>>();
    }

    generic::<f64>();
    generic::<f32>();
    formats::<Method>();
    formats::<UnknownMethod>();
    formats::<Latitude>();
    formats::<UnknownLatitude>();
    formats::<Shift>();
    formats::<UnknownShift>();
    formats::<Face>();
    formats::<InvalidFace>();
    formats::<UnknownFace>();
    formats::<Dms>();
    formats::<DmsLatLon>();
    formats::<Edge>();
    formats::<Neighbour>();
    formats::<Corner>();
    formats::<Numbering>();
    formats::<Projection>();
    formats::<UnknownProjection>();
    formats::<Polynomial<3, 2>>();
    formats::<Tile>();
    formats::<InvalidTile>();
    formats::<Adjacent>();
    formats::<Diagonal>();
    formats::<Around>();
    formats::<Along>();
    formats::<Morton>();
    formats::<Hilbert>();
    formats::<Key<Morton>>();
    formats::<InvalidKey>();
    formats::<InvalidNumberedTile>();
    formats::<Pixel>();
    formats::<InvalidPixel>();
    formats::<InvalidToken>();
    formats::<QuadCube>();
    formats::<Tangential>();
    formats::<Adjusted>();
    formats::<Outerra>();
    formats::<Cobe>();
    formats::<CobeExact>();
    formats::<Quadrilateralized>();
    formats::<Cartesian>();
    formats::<Healpix>();
    formats::<S2Quadratic>();
    formats::<EquiEdge>();
    formats::<Algebraic>();
    formats::<Vertex>();
    formats::<Conformal>();
    formats::<Balanced>();
    formats::<Square>();
    formats::<Separable>();
};
