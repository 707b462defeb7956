//! Routes and fields: legs, closest points, intersections, rhumb lines, rings and fences.
//!
//! Latitudes, longitudes and azimuths are in degrees, lengths in metres.
