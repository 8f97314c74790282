#include "solver/reference/touch/proved_answer.hpp"

#include "solver/reference/interval/digits.hpp"

namespace plumb::reference {
namespace {

using I = TouchScalar;

EnclosedAnswer in_world(const EnclosedAnswer& in_pair, const Pair& pair) {
  const EnclosedPair<I> frame = enclose<I>(pair);
  EnclosedAnswer out = in_pair;
  out.overlap = times_power_of_two<I>(out.overlap, frame.exponent);
  for (IVec3<I>* point : {&out.point1, &out.point2}) *point = frame.to_world_point(*point, pair);
  return out;
}

/// The middle of the proved answer: where the charts are nearly singular, many digits more than the local solve has.
void round_to(Solution& out, const EnclosedAnswer& truth) {
  out.overlap = middle<Real50>(truth.overlap);
  for (int i = 0; i < 3; ++i) {
    out.normal[i] = middle<Real50>(truth.normal[i]);
    out.point1[i] = middle<Real50>(truth.point1[i]);
    out.point2[i] = middle<Real50>(truth.point2[i]);
  }
}

}  // namespace

EnclosedAnswer not_enclosed(const char* reason) {
  EnclosedAnswer out;
  out.reason = reason;
  return out;
}

Solution unsolved(const char* reason) {
  Solution out;
  out.reason = reason;
  return out;
}

Solution proved_by(Solution found, const EnclosedAnswer& in_pair, const Pair& pair) {
  if (!found.solved) return found;
  found.reason = in_pair.reason;
  if (!found.reason.empty()) return found;
  const EnclosedAnswer truth = in_world(in_pair, pair);
  round_to(found, truth);
  found.bounds = ends_of(hull<I>(truth.overlap, enclosing<I>(found.overlap)));
  found.normal_radius = angle_of_chord(farthest(truth.normal, found.normal));
  found.points_radius = std::max(farthest(truth.point1, found.point1), farthest(truth.point2, found.point2));
  found.proved = found.bounds.upper - found.bounds.lower <= widest_gap * size_of(pair);
  if (!found.proved) found.reason = "the bounds are wider than 1e-12 of the size";
  return found;
}

}  // namespace plumb::reference
