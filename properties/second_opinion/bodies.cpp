#include "bodies.hpp"

#include <limits>
#include <random>

namespace second_opinion {
namespace {

std::array<Vec<Quad>, 3> frame_of(const std::array<Quad, 4>& q) {
  const Quad most = std::max(std::max(fabsq(q[0]), fabsq(q[1])), std::max(fabsq(q[2]), fabsq(q[3])));
  const Quad w = q[0] / most, x = q[1] / most, y = q[2] / most, z = q[3] / most;
  const Quad s = 2 / (w * w + x * x + y * y + z * z);
  return {{{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
           {s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
           {s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)}}};
}

/// `nudge(x)` is a factor near 1.
template <class Nudge>
Body<Quad> placed(const GivenBody& b, double size, const Nudge& nudge) {
  const auto given = [&](double x) { return Quad(x) * nudge(); };
  const Quad shortest_of_exponents = 1 + Quad(std::numeric_limits<double>::epsilon()) / 2;
  Body<Quad> out;
  out.axes = {given(b.axes.x) / size, given(b.axes.y) / size, given(b.axes.z) / size};
  out.n1 = std::max(given(b.n1), shortest_of_exponents);
  out.n2 = std::max(given(b.n2), shortest_of_exponents);
  out.frame =
      frame_of({given(b.quaternion[0]), given(b.quaternion[1]), given(b.quaternion[2]), given(b.quaternion[3])});
  return out;
}

Vec<Quad> between(const GivenPair& pair, double size) {
  const Vec<double>&p = pair[0].position, &q = pair[1].position;
  return {(Quad(q.x) - p.x) / size, (Quad(q.y) - p.y) / size, (Quad(q.z) - p.z) / size};
}

}  // namespace

double size_of(const GivenPair& pair) {
  return std::max(largest(pair[0].axes), largest(pair[1].axes));
}

Pair<Quad> placed(const GivenPair& pair) {
  const double size = size_of(pair);
  const auto exact = [] { return Quad(1); };
  return {placed(pair[0], size, exact), placed(pair[1], size, exact), between(pair, size)};
}

Pair<Quad> nudged(const GivenPair& pair, unsigned draw) {
  std::minstd_rand numbers(draw + 1);
  // Up or down by a whole rounding: the corners of the box of inputs turn an answer most.
  const auto signed_rounding = [&] {
    return (numbers() >> 8U) % 2 == 0 ? Quad(std::numeric_limits<double>::epsilon())
                                      : -Quad(std::numeric_limits<double>::epsilon());
  };
  const auto nudge = [&] { return 1 + signed_rounding(); };
  const double size = size_of(pair);
  Pair<Quad> out{placed(pair[0], size, nudge), placed(pair[1], size, nudge), between(pair, size)};
  const Quad scale = std::max(Quad(1), largest(out.apart));
  out.apart = out.apart + Vec<Quad>{scale * signed_rounding(), scale * signed_rounding(), scale * signed_rounding()};
  // A quaternion's zeros are roundings of a turn as much as its other numbers.
  Body<Quad>& turned = out.second;
  const Vec<Quad> turn{signed_rounding(), signed_rounding(), signed_rounding()};
  for (Vec<Quad>& axis : turned.frame) axis = unit(axis + cross(turn, axis));
  return out;
}

Vec<Quad> from_first(const GivenPair& pair, const Vec<double>& point) {
  const double size = size_of(pair);
  const Vec<double>& p = pair[0].position;
  return {(Quad(point.x) - p.x) / size, (Quad(point.y) - p.y) / size, (Quad(point.z) - p.z) / size};
}

}  // namespace second_opinion
