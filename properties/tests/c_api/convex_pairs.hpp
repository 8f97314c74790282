// Pairs of convex bodies as plumb.h has them, of those of C++.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "properties/tests/c_api/owned_hull.hpp"
#include "properties/tests/reference/drawn_bodies.hpp"
#include "solver/plumb.h"
#include "solver/shape/overloaded.hpp"
#include "solver/shape/shape_fields.hpp"

namespace plumb {

[[nodiscard]] inline OwnedHull hull_of(const Shape& shape) {
  const auto* polyhedron = std::get_if<Polyhedron>(&shape);
  if (polyhedron == nullptr) return nullptr;
  const std::vector<Vec3<double>>& corners = polyhedron->hull->corners;
  return OwnedHull(plumb_hull_create(corners.front().data(), corners.size(), nullptr));
}

template <class S>
[[nodiscard]] std::vector<double> numbers_of_fields(const S& shape) {
  std::vector<double> out;
  each_field(shape, [&](auto, const auto&, const auto& numbers) {
    for (const double* number : numbers) out.push_back(*number);
  });
  return out;
}

/// Of the first shapes as plumb.h tells them, which nothing may change; of those that came later as their fields do.
[[nodiscard]] inline std::vector<double> parameters_of(const Shape& shape) {
  const auto list = [](const auto& numbers, std::initializer_list<double> more) {
    std::vector<double> out(numbers.begin(), numbers.end());
    out.insert(out.end(), more);
    return out;
  };
  using Numbers = std::vector<double>;
  return std::visit(detail::Overloaded{[&](const Superellipsoid<double>& s) { return list(s.semi_axes, {s.n1, s.n2}); },
                                       [](const Capsule& s) { return Numbers{s.half_length, s.radius}; },
                                       [](const Cylinder& s) { return Numbers{s.half_length, s.radius}; },
                                       [](const Cone& s) { return Numbers{s.radius, s.height}; },
                                       [&](const Frustum& s) { return list(s.radii, {s.height}); },
                                       [&](const Box& s) { return list(s.half_extents, {}); },
                                       [](const Polyhedron&) { return Numbers(); },
                                       [&](const PolySuperellipsoid& s) { return list(s.semi_axes, {s.n1, s.n2}); },
                                       [](const HalfSpace&) { return Numbers(); },
                                       [](const auto& later) { return numbers_of_fields(later); }},
                    shape);
}

/// What is not the kind's is NaN: nothing may read it.
[[nodiscard]] inline plumb_convex_body c_body(const ConvexBody& from, const plumb_hull* hull) {
  plumb_convex_body out{};
  out.shape.kind = static_cast<int>(from.shape.index());
  out.shape.hull = hull;
  std::fill_n(out.shape.parameters, std::size(out.shape.parameters), NAN);
  const std::vector<double> parameters = parameters_of(from.shape);
  std::copy(parameters.begin(), parameters.end(), out.shape.parameters);
  out.swept_radius = from.swept_radius;
  Vec3<double>::Map(out.position) = from.position;
  std::copy_n(from.quaternion.begin(), 4, out.quaternion_wxyz);
  return out;
}

/// A pair of each language, with the hulls of C's.
struct BothPairs {
  ConvexPair pair;
  OwnedHull hull1 = hull_of(pair.body1.shape), hull2 = hull_of(pair.body2.shape);
  plumb_convex_pair c_pair{{c_body(pair.body1, hull1.get()), c_body(pair.body2, hull2.get())}};
};

/// Of each two shapes so many pairs, the same at every call.
template <class F>
void for_c_pairs(int each, const F& use) {
  Stream stream("convex pairs in C", 1, 0);
  for (std::size_t kind1 = 0; kind1 < reference::bodies_tests::shape_count; ++kind1)
    for (std::size_t kind2 = 0; kind2 < reference::bodies_tests::shape_count; ++kind2)
      for (int i = 0; i < each; ++i) {
        SCOPED_TRACE(std::to_string(kind1) + " " + std::to_string(kind2) + " " + std::to_string(i));
        use(BothPairs{reference::bodies_tests::draw_pair(kind1, kind2, stream)});
      }
}

}  // namespace plumb
