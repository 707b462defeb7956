//! Geodesics against the truth and against GeographicLib.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod along;
mod andoyer;
mod antipode;
mod azimuths;
mod bowring;
mod equator;
mod evaluations;
mod flat;
mod great_circle;
mod haversine;
mod karney;
mod methods;
mod planar;
mod poles;
mod polygons;
mod sample;
mod stability;
mod track;
mod vincenty;
