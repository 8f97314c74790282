#include <cmath>
#include <limits>

#include "properties/families_hard.hpp"

namespace plumb::hard {
namespace {

/// An ordinary pair of size 1, whose numbers are then made extraordinary.
void draw_ordinary(Stream& stream, Draft& draft) {
  draft.pair.body1.shape = random_body(stream, 3);
  draft.pair.body2.shape = random_body(stream, 3);
  draft.pair.body1.quaternion = random_rotation(stream);
  draft.pair.body2.quaternion = random_rotation(stream);
  place_on_random_line(stream, draft, stream.signed_log_uniform(1e-3, 0.3));
}

/// 10^-low .. 10^-high or 10^low .. 10^high, on a logarithmic scale that does not overflow on the way.
double power_of_ten(Stream& stream, double low, double high) {
  return std::pow(10.0, stream.uniform(low, high));
}

void rescale(Draft& draft, double unit) {
  scale(draft.pair, unit);
  draft.facts["unit"] = unit;
}

}  // namespace

void length_unit(Stream& stream, Draft& draft) {
  draw_ordinary(stream, draft);
  rescale(draft, power_of_ten(stream, -12, 12));
}

void far_from_origin(Stream& stream, Draft& draft) {
  draw_ordinary(stream, draft);
  const double distance = stream.log_uniform(10, 1e9);
  const Vec3<double> shift = random_direction(stream) * distance;
  draft.pair.body1.position += shift;
  draft.pair.body2.position += shift;
  draft.facts["origin_distance"] = distance;
}

void huge_numbers(Stream& stream, Draft& draft) {
  draw_ordinary(stream, draft);
  rescale(draft, power_of_ten(stream, 100, 300));
}

void subnormal_numbers(Stream& stream, Draft& draft) {
  draw_ordinary(stream, draft);
  rescale(draft, power_of_ten(stream, -319, -100));
}

void subnormal_offset(Stream& stream, Draft& draft) {
  draw_ordinary(stream, draft);
  const auto component = static_cast<int>(stream.below(3));
  const double small = std::numeric_limits<double>::denorm_min() * std::floor(stream.log_uniform(1, 1e12));
  draft.pair.body2.position[component] = stream.sign() * small;
  draft.facts["component"] = component;
}

void quaternion_length(Stream& stream, Draft& draft) {
  draw_ordinary(stream, draft);
  for (Body* body : {&draft.pair.body1, &draft.pair.body2}) {
    // Whole components stay exact down to the last subnormal number; others must keep a few bits there.
    const bool whole = stream.chance(0.25);
    if (whole) body->quaternion = random_axis_rotation(stream);
    const double length =
        whole && stream.chance(0.5) ? std::numeric_limits<double>::denorm_min() : power_of_ten(stream, -318, 300);
    for (double& component : body->quaternion) component *= length;
  }
}

}  // namespace plumb::hard
