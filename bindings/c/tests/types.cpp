// The types of terrella.hpp: they compute what terrella.h does, and keep units apart.

#include <cmath>
#include <cstdio>
#include <type_traits>

#include "terrella.hpp"

using namespace terrella;
using namespace terrella::literals;

static_assert(!std::is_convertible_v<double, Degrees> && !std::is_convertible_v<Degrees, Metres>);
static_assert(sizeof(Metres) == sizeof(double) && std::is_trivially_copyable_v<Karney>);

int main() {
  const auto wgs84 = Ellipsoid::named("wgs84");
  const auto earth = Karney::on(*wgs84);
  const Place kennedy{40.6_deg, Degrees(-73.8)}, heathrow{51.6_deg, Degrees(-0.5)};
  const auto line = earth->inverse(kennedy, heathrow);
  if (!wgs84 || !earth || !line || std::fabs(line->distance.value - 5551759.4003) > 1e-4) return 1;
  const auto end = earth->direct(kennedy, line->azimuth1, line->distance);
  if (!end || std::fabs(end->place.lat.value - 51.6) > 1e-12) return 2;
  if (std::fabs(earth->distance(kennedy, heathrow)->value - line->distance.value) > 1e-8) return 3;
  const auto frame = Frame::at(*wgs84, {47_deg, 8_deg, 500_m});
  const auto ned = frame->to_ned({47.001_deg, 8_deg, 500_m});
  const auto back = frame->from_ned(*ned);
  if (!back || std::fabs(back->lat.value - 47.001) > 1e-12) return 4;
  const auto point = wgs84->to_ecef({0_deg, 90_deg, 0_m});
  if (point->y.value != 6378137 || !wgs84->to_geodetic(*point) || !Ellipsoid::of(6371000_m, 0)) return 5;
  const auto none = earth->distance({91_deg, 0_deg}, heathrow);
  if (none || none.status != TERRELLA_LATITUDE) return 6;
  std::puts(none.why());
}
