// One block of doubles that JavaScript writes and reads; one thread, so one is enough.
//
//   in    each body: semi-axes 3, n1, n2, position 3, quaternion (w, x, y, z) 4; after both, body 2's motion 3
//   out   status, verdict, overlap, normal 3, point 1 3, point 2 3, contact point 3, iterations, evaluations;
//         then what the points say of themselves (diagnosis.hpp): R1..R5, the angles d_n1, d_n2, n1_n2, normals 3 + 3, what fails;
//         then the bounds of the lowest overlap (overlap_bounds.hpp)
//
// plumb_contact.mjs has the same order.
#pragma once

#include <array>
#include <cstddef>

#include "solver/contact.hpp"

namespace plumb::js {

inline constexpr std::size_t per_body = 12, inputs = 2 * per_body + 3, outputs = 34;
inline constexpr std::size_t normal = inputs + 3, point1 = inputs + 6, point2 = inputs + 9, bounds = inputs + 32;

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): the caller's side of the door; the solver has none
inline std::array<double, inputs + outputs> block;

inline Vec3<double> three(std::size_t from) {
  return {block[from], block[from + 1], block[from + 2]};
}

inline Body body_at(std::size_t from) {
  Body out;
  out.shape = {three(from), block[from + 3], block[from + 4]};
  out.position = three(from + 5);
  out.quaternion = {block[from + 8], block[from + 9], block[from + 10], block[from + 11]};
  return out;
}

inline Pair given() {
  return {body_at(0), body_at(per_body), three(2 * per_body)};
}

}  // namespace plumb::js
