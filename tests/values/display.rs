//! How values and errors are written.

use terrella::cube::{Face, FacePoint, UnknownFace};
use terrella::geodesic::GeodesicError;
use terrella::terrain::Tile;
use terrella::{Aer, Direction, Ecef, Enu, Geodetic, LatLon, Ned};

#[test]
fn values_take_the_formatters_options() {
    let oslo = LatLon::new(59.91, 10.75).unwrap();
    assert_eq!(format!("{oslo}"), "59.91, 10.75");
    assert_eq!(format!("{oslo:.4}"), "59.9100, 10.7500");
    assert_eq!(format!("{oslo:+.1}"), "+59.9, +10.8");
    assert_eq!(
        format!("{:.2}", Geodetic::new(oslo, 12.0).unwrap()),
        "59.91, 10.75, 12.00 m"
    );
    assert_eq!(format!("{}", Ecef::new(1.0, -2.5, 0.0).unwrap()), "(1, -2.5, 0) m");
    assert_eq!(
        format!("{:.1}", Direction::new(3.0, 0.0, 4.0).unwrap()),
        "(0.6, 0.0, 0.8)"
    );
    let enu = Enu {
        east: 30.0,
        north: 0.0,
        up: 40.0,
    };
    assert_eq!(format!("{enu}"), "east 30, north 0, up 40 m");
    assert_eq!(format!("{}", Ned::from(enu)), "north 0, east 30, down -40 m");
    assert_eq!(
        format!("{:.1}", Aer::from(enu)),
        "azimuth 90.0°, elevation 53.1°, range 50.0 m"
    );
}

#[test]
fn faces_points_and_tiles() {
    for face in Face::ALL {
        assert_eq!(face.to_string().parse(), Ok(face));
    }
    let refused: UnknownFace = "roof".parse::<Face>().unwrap_err();
    assert_eq!(
        refused.to_string(),
        "unknown face \"roof\"; expected one of: front, right, back, left, top, bottom"
    );
    assert_eq!(format!("{:>6}", Face::Top), "   top");
    assert_eq!(
        FacePoint::new(Face::Front, 0.25, -1.0).unwrap().to_string(),
        "front (0.25, -1)"
    );
    assert_eq!(Tile::new(Face::Top, 3, 5, 2).unwrap().to_string(), "top/3/5/2");
}

#[test]
fn errors_write_places_in_decimal_degrees() {
    let place = |lat, lon| LatLon::new(lat, lon).unwrap();
    let error = GeodesicError::NotConverged(place(0.5, 0.0), place(-0.5, 179.75));
    assert_eq!(error.to_string(), "no convergence from 0.5, 0 to -0.5, 179.75");
}
