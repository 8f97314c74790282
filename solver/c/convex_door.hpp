// C's convex pairs as those of C++.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <utility>

#include "solver/plumb.h"
#include "solver/shape/hull.hpp"
#include "solver/shape/shape_fields.hpp"

struct plumb_hull {
  plumb::Polyhedron polyhedron;
};

namespace plumb::door {

/// The caller's hull for the length of a call: without a count of its owners, at which threads would wait for each other.
[[nodiscard]] inline Polyhedron polyhedron_of(const plumb_hull& hull) {
  return {std::shared_ptr<const Hull>(std::shared_ptr<const Hull>(), hull.polyhedron.hull.get())};
}

/// Parameters are the fields' numbers, in the order of both.
template <class S>
Shape read_shape(const plumb_shape& from) {
  S out{};
  std::size_t next = 0;
  each_field(out, [&](auto place, const auto&, const auto& numbers) {
    for (std::size_t i = 0; i < number_count<S, place>; ++i) *numbers[i] = from.parameters[next++];
  });
  return out;
}
template <>
inline Shape read_shape<Polyhedron>(const plumb_shape& from) {
  return from.hull == nullptr ? Polyhedron() : polyhedron_of(*from.hull);
}
/// Functions beyond the caller's `size` are not there.
template <>
inline Shape read_shape<ForeignShape>(const plumb_shape& from) {
  plumb_foreign f{};
  if (from.foreign != nullptr) std::memcpy(&f, from.foreign, std::min(from.foreign->size, sizeof f));
  return ForeignShape{f.support, f.hessian, f.enclose, f.data, f.bounding_radius, f.inscribed_radius};
}

inline constexpr int kinds = std::variant_size_v<Shape>;

/// Of a kind that there is.
[[nodiscard]] inline Shape shape_of(const plumb_shape& from) {
  static constexpr auto readers = []<std::size_t... kind>(std::index_sequence<kind...>) {
    return std::array{&read_shape<std::variant_alternative_t<kind, Shape>>...};
  }(std::make_index_sequence<kinds>());
  return readers[static_cast<std::size_t>(from.kind)](from);
}

[[nodiscard]] inline ConvexBody body_of(const plumb_convex_body& from) {
  ConvexBody out;
  out.shape = shape_of(from.shape);
  out.swept_radius = from.swept_radius;
  out.position = Vec3<double>::Map(from.position);
  std::copy_n(from.quaternion_wxyz, 4, out.quaternion.begin());
  return out;
}

[[nodiscard]] inline ConvexPair pair_of(const plumb_convex_pair& from) {
  return {body_of(from.bodies[0]), body_of(from.bodies[1])};
}

/// What only C can get wrong: a kind that is none, a hull or functions that are not there.
[[nodiscard]] inline InputError error_in(const plumb_shape& shape, int body) {
  if (shape.kind < 0 || shape.kind >= kinds) return {"shape.kind", "no shape has this number", body};
  if (shape.kind == PLUMB_SHAPE_POLYHEDRON && shape.hull == nullptr) return {"shape.hull", "must not be null", body};
  if (shape.kind == PLUMB_SHAPE_FOREIGN && shape.foreign == nullptr) return {"shape.foreign", "must not be null", body};
  return {};
}

[[nodiscard]] inline InputError error_in_shapes(const plumb_convex_pair& pair) {
  const InputError first = error_in(pair.bodies[0].shape, 0);
  return first.reason.empty() ? error_in(pair.bodies[1].shape, 1) : first;
}

}  // namespace plumb::door
