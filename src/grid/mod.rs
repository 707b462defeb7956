//! Grids and their text: transverse Mercator, UTM, UPS and MGRS, azimuthal maps, Web Mercator's tiles, geohashes
//! and plus codes.
//!
//! Latitudes, longitudes and convergences are in degrees, eastings and northings in metres.
