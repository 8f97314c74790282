#include "reports/bench/bench_shapes.hpp"

#include <algorithm>

#include "properties/generators/shapes.hpp"
#include "reports/bench/quantile.hpp"
#include "solver/method/convex.hpp"
#include "solver/reference/convex_bounds.hpp"
#include "solver/shape/hull.hpp"

namespace plumb::reports {
namespace {

double draw_length(Stream& stream) {
  return stream.log_uniform(0.1, 1);
}

Shape draw_box(Stream& stream) {
  const double a = draw_length(stream), b = draw_length(stream), c = draw_length(stream);
  return Box{{a, b, c}};
}

Shape draw_capsule(Stream& stream) {
  const double half_length = draw_length(stream), radius = draw_length(stream);
  return Capsule{half_length, radius};
}

Shape draw_hull(Stream& stream) {
  std::vector<Vec3<double>> corners(20);
  for (Vec3<double>& corner : corners) corner = random_direction(stream);
  return make_polyhedron(corners);
}

/// Two of them on a random line.
Case draw_two(Shape (*draw_one)(Stream&), std::string name, std::uint64_t seed, std::uint64_t index) {
  Stream stream(name, seed, index);
  ConvexPair pair;
  for (ConvexBody* body : {&pair.body1, &pair.body2}) {
    body->shape = draw_one(stream);
    body->quaternion = random_rotation(stream);
  }
  const double ratio = stream.log_uniform(1e-3, 5e-2);
  place_at_contact(pair, random_direction(stream), ratio * size_of(pair));
  Case out{std::move(name), {}, {}, {{"overlap_ratio", ratio}}, {}};
  out.convex = pair;
  return out;
}

Case draw_boxes(std::uint64_t seed, std::uint64_t index) {
  return draw_two(draw_box, "boxes", seed, index);
}
Case draw_capsules(std::uint64_t seed, std::uint64_t index) {
  return draw_two(draw_capsule, "capsules", seed, index);
}
Case draw_hulls(std::uint64_t seed, std::uint64_t index) {
  return draw_two(draw_hull, "hulls", seed, index);
}

constexpr std::array<PairSet, 3> kShapeSets{{
    {"boxes", "boxes, aspect to 10", "", 0, 0, true, draw_boxes},
    {"capsules", "capsules, half-length over radius 1/10..10", "", 0, 0, true, draw_capsules},
    {"hulls", "hulls of 20 points on a sphere", "", 0, 0, true, draw_hulls},
}};

/// In the pair's size.
double overlap_error(const ConvexPair& pair, double overlap) {
  constexpr int cells = 100'000;
  const Vec3<double> normal =
      solve_convex(pair, {}, nullptr).normal;  // where bounds look first; they hold whatever it is
  const reference::ConvexBounds bounds = reference::bound_overlap(pair, normal, cells);
  return std::max({0.0, bounds.lower - overlap, overlap - bounds.upper}) / size_of(pair);
}

}  // namespace

std::span<const PairSet> shape_sets() {
  return kShapeSets;
}

OverlapErrors overlap_errors_of(const Job& job) {
  std::vector<double> errors;
  for (const Task& task : job.tasks) {
    if (!task.convex) continue;
    if (const Contact<double> contact = answer(job.solver, task); contact.status == Status::converged)
      errors.push_back(overlap_error(*task.convex, contact.overlap));
  }
  if (errors.empty()) return {};
  return {quantile(errors, 0.5), quantile(errors, 1)};
}

}  // namespace plumb::reports
