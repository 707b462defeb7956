// terrella for C++17: the calls of terrella.h about geodesics, Earth axes, frames and cube maps, with types that tell degrees
// from metres. Nothing throws, nothing is allocated; a result is there if its status is 0.

#pragma once

#include "terrella.h"

namespace terrella {

/// A number with its unit: degrees are never taken for metres.
template <typename Unit>
struct Quantity {
  double value = 0;

  constexpr Quantity() = default;
  constexpr explicit Quantity(double number) : value(number) {}
};

using Degrees = Quantity<struct DegreesUnit>;
using Metres = Quantity<struct MetresUnit>;

namespace literals {
constexpr Degrees operator""_deg(long double number) { return Degrees(static_cast<double>(number)); }
constexpr Degrees operator""_deg(unsigned long long number) { return Degrees(static_cast<double>(number)); }
constexpr Metres operator""_m(long double number) { return Metres(static_cast<double>(number)); }
constexpr Metres operator""_m(unsigned long long number) { return Metres(static_cast<double>(number)); }
} // namespace literals

/// What a call gave, or why it gave nothing.
template <typename T>
struct [[nodiscard]] Result {
  terrella_status status;
  T value{};

  explicit operator bool() const { return status == TERRELLA_OK; }
  const T &operator*() const { return value; }
  const T *operator->() const { return &value; }
  const char *why() const { return terrella_status_text(static_cast<int32_t>(status)); }
};

struct Place {
  Degrees lat, lon;
};

struct Geodetic {
  Degrees lat, lon;
  Metres height;
};

struct Ecef {
  Metres x, y, z;
};

struct Ned {
  Metres north, east, down;
};

struct Inverse {
  Metres distance;
  Degrees azimuth1, azimuth2;
};

struct Direct {
  Place place;
  Degrees azimuth;
};

/// An ellipsoid of revolution.
class Ellipsoid {
public:
  static Result<Ellipsoid> named(const char *name) {
    Result<Ellipsoid> made{};
    made.status = terrella_ellipsoid_named_f64(&made.value.handle_, name);
    return made;
  }

  static Result<Ellipsoid> of(Metres a, double f) {
    Result<Ellipsoid> made{};
    made.status = terrella_ellipsoid_init_f64(&made.value.handle_, a.value, f);
    return made;
  }

  Result<Ecef> to_ecef(Geodetic place) const {
    Result<Ecef> point{};
    point.status = terrella_ellipsoid_to_ecef_f64(&handle_, place.lat.value, place.lon.value, place.height.value,
                                                  &point.value.x.value, &point.value.y.value, &point.value.z.value);
    return point;
  }

  Result<Geodetic> to_geodetic(Ecef point) const {
    Result<Geodetic> place{};
    place.status = terrella_ellipsoid_to_geodetic_f64(&handle_, point.x.value, point.y.value, point.z.value,
                                                      &place.value.lat.value, &place.value.lon.value,
                                                      &place.value.height.value);
    return place;
  }

  const terrella_ellipsoid_f64 *handle() const { return &handle_; }

private:
  terrella_ellipsoid_f64 handle_{};
};

/// Karney's geodesics.
class Karney {
public:
  static Result<Karney> on(const Ellipsoid &ellipsoid) {
    Result<Karney> made{};
    made.status = terrella_karney_init_f64(&made.value.handle_, ellipsoid.handle());
    return made;
  }

  Result<Metres> distance(Place from, Place to) const {
    Result<Metres> metres{};
    metres.status = terrella_karney_distance_f64(&handle_, from.lat.value, from.lon.value, to.lat.value, to.lon.value,
                                                 &metres.value.value);
    return metres;
  }

  Result<Inverse> inverse(Place from, Place to) const {
    Result<Inverse> line{};
    line.status = terrella_karney_inverse_f64(&handle_, from.lat.value, from.lon.value, to.lat.value, to.lon.value,
                                              &line.value.distance.value, &line.value.azimuth1.value,
                                              &line.value.azimuth2.value);
    return line;
  }

  Result<Direct> direct(Place from, Degrees azimuth, Metres distance) const {
    Result<Direct> end{};
    end.status = terrella_karney_direct_f64(&handle_, from.lat.value, from.lon.value, azimuth.value, distance.value,
                                            &end.value.place.lat.value, &end.value.place.lon.value,
                                            &end.value.azimuth.value);
    return end;
  }

private:
  terrella_karney_f64 handle_{};
};

/// North, east and down about an origin.
class Frame {
public:
  static Result<Frame> at(const Ellipsoid &ellipsoid, Geodetic origin) {
    Result<Frame> made{};
    made.status = terrella_frame_init_f64(&made.value.handle_, ellipsoid.handle(), origin.lat.value, origin.lon.value,
                                          origin.height.value);
    return made;
  }

  Result<Ned> to_ned(Geodetic place) const {
    Result<Ned> point{};
    point.status = terrella_frame_to_ned_f64(&handle_, place.lat.value, place.lon.value, place.height.value,
                                             &point.value.north.value, &point.value.east.value,
                                             &point.value.down.value);
    return point;
  }

  Result<Geodetic> from_ned(Ned point) const {
    Result<Geodetic> place{};
    place.status = terrella_frame_from_ned_f64(&handle_, point.north.value, point.east.value, point.down.value,
                                               &place.value.lat.value, &place.value.lon.value,
                                               &place.value.height.value);
    return place;
  }

private:
  terrella_frame_f64 handle_{};
};

} // namespace terrella
