//! The README's table for those who come from another library: our calls in it compile and run.

use core::error::Error;
use std::hint::black_box;

use terrella::cube::{CubeMap, Healpix, Quadrilateralized};
use terrella::geodesic::{Area, Geodesic, GreatCircle, Karney};
use terrella::latitude::Conversion;
use terrella::terrain::Key;
use terrella::{Ellipsoid, Geodetic, LatLon, Latitude, LocalFrame, Shift};
use testkit::generated;

/// Rows of a table: the calls of GeographicLib, pymap3d, PROJ, geo and S2 in words, and ours as code that is run.
macro_rules! rows {
    ($($their:literal => $ours:expr;)*) => {{
        let mut table = String::new();
        $(
            let _ = black_box($ours);
            table += &format!("| {} | `{}` |\n", $their, stringify!($ours));
        )*
        table
    }};
}

#[test]
fn our_calls_are_as_the_readme_shows() -> Result<(), Box<dyn Error>> {
    let wgs84 = Ellipsoid::<f64>::WGS84;
    let (lat, lon, height) = (59.9139, 10.7522, 23.0);
    let (from, to, end) = (
        LatLon::new(lat, lon)?,
        LatLon::new(-0.18, -78.47)?,
        LatLon::new(0.0, 9.0)?,
    );
    let (azimuth, distance) = (30.0, 1000.0);
    let karney = Karney::new(wgs84)?;
    let line = karney.line(from, azimuth)?;
    let area = Area::new(wgs84)?;
    let sphere = GreatCircle::new(wgs84.mean_radius())?;
    let position = Geodetic::new(from, height)?;
    let point = wgs84.to_ecef(position);
    let frame = LocalFrame::new(wgs84, position);
    let (enu, aer) = (frame.to_enu(point), frame.to_aer(point));
    let (direction, other) = (from.to_direction(), to.to_direction());
    let authalic = Conversion::new(wgs84, Latitude::Geodetic, Latitude::Authalic)?;
    let qsc = CubeMap::new(wgs84, Shift::Geocentric, Quadrilateralized)?;
    let rhealpix = CubeMap::new(wgs84, Shift::Authalic, Healpix)?;
    let (leaf, level) = (Key::s2_leaf(direction), 12);

    let rows = rows! {
        "`Geodesic.Inverse` | `vdist` | `geod_inverse` | `Geodesic.distance`, `.bearing` |" => karney.inverse(from, to);
        "`Geodesic.Direct` | `vreckon` | `geod_direct` | `Geodesic.destination` |" => karney.direct(from, azimuth, distance);
        "`Geodesic.Line` | | `geod_directline` | |" => karney.line(from, azimuth);
        "`GeodesicLine.Position` | | `geod_position` | |" => line.at(distance);
        "`m12`, `M12`, `M21`, `S12` | | `geod_geninverse` | |" => karney.solve(from, to);
        "`PolygonArea` | | `geod_polygon_init` | `geodesic_area_signed` |" => area.polygon();
        " | | | `Haversine.distance` |" => sphere.inverse(from, to);
        " | | | `CrossTrackDistance` |" => sphere.cross_track(from, to, end);
        " | `anglesep` | | | `S1Angle(a, b)`" => GreatCircle::angle_radians(direction, other);
        " | | | `Point::new(lon, lat)` | `S2LatLng::FromDegrees`" => LatLon::new(lat, lon);
        "`Geocentric.Forward` | `geodetic2ecef` | `+proj=cart` | |" => wgs84.to_ecef(position);
        "`Geocentric.Reverse` | `ecef2geodetic` | `+inv +proj=cart` | |" => wgs84.to_geodetic(point);
        " | `ecef2enu` | `+proj=topocentric` | |" => frame.to_enu(point);
        "`LocalCartesian.Forward` | `geodetic2enu` | | |" => frame.geodetic_to_enu(position);
        "`LocalCartesian.Reverse` | `enu2geodetic` | | |" => frame.enu_to_geodetic(enu);
        " | `geodetic2ned` | | |" => frame.geodetic_to_ned(position);
        " | `geodetic2aer` | | |" => frame.geodetic_to_aer(position);
        " | `aer2geodetic` | | |" => frame.aer_to_geodetic(aer);
        "`AuxLatitude.Convert` | `geodetic2authalic` | | |" => authalic.degrees(lat);
        " | | `+proj=qsc` | |" => qsc.project(from);
        " | | `+proj=rhealpix` | |" => rhealpix.project(from);
        " | | | | `S2LatLng.ToPoint`" => from.to_direction();
        " | | | | `S2CellId(point)`" => Key::s2_leaf(direction);
        " | | | | `S2CellId.parent`" => leaf.ancestor(level);
        " | | | | `S2CellId.ToToken`" => leaf.to_string();
        " | | | | `S2CellId.range_min`, `range_max`" => leaf.range();
        " | | | | `S2CellId.GetEdgeNeighbors`" => leaf.s2_edge_neighbours();
    };
    let head = "| GeographicLib | pymap3d | PROJ | geo | S2 | terrella |\n|---|---|---|---|---|---|\n";
    generated::section("README.md", "| GeographicLib |", &format!("{head}{rows}"));
    Ok(())
}
