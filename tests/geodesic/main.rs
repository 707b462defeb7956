//! Geodesics against the truth and against GeographicLib.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod along;
mod andoyer;
mod antipode;
mod azimuths;
mod equator;
mod evaluations;
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
