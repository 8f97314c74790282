// Pairs of convex bodies, drawn, and the definitions of shapes written once more for the tests of their judge.
#pragma once

#include <algorithm>

#include "properties/generators/shapes.hpp"
#include "solver/pose.hpp"
#include "solver/reference/real.hpp"
#include "solver/shape/hull.hpp"
#include "solver/shape/shape_fields.hpp"

namespace plumb::reference::bodies_tests {

using plumb::draw_shape;
using plumb::shape_count;

/// Body 2 from deep inside body 1 to well apart.
[[nodiscard]] inline ConvexPair draw_pair(std::size_t kind1, std::size_t kind2, Stream& stream) {
  ConvexPair out{draw_convex_body(kind1, stream), draw_convex_body(kind2, stream)};
  out.body2.position += random_direction(stream) * stream.uniform(0, 2.5);
  return out;
}

/// max(|x|^n + |y|^n)^(1/n) for the dual exponent n.
template <class S>
[[nodiscard]] S dual_norm(const S& x, const S& y, double n) {
  using std::abs;
  using std::pow;
  const S m = S(n) / (S(n) - 1), larger = std::max<S>(abs(x), abs(y)), smaller = std::min<S>(abs(x), abs(y));
  return larger == 0 ? larger : S(larger * pow(S(1 + pow(S(smaller / larger), m)), S(1 / m)));
}

/// The centroid's height above a frustum's bottom.
template <class S>
[[nodiscard]] S centroid(const Frustum& s) {
  const S from(s.radii[0]), to(s.radii[1]);
  return S(s.height) * (from * from + 2 * from * to + 3 * to * to) / (4 * (from * from + from * to + to * to));
}

/// max u.x over a shape, body axes; of any but the half-space.
template <class S>
struct SupportOf {
  Vec3<S> u;

  [[nodiscard]] S across() const {
    using std::sqrt;
    return sqrt(S(u[0] * u[0] + u[1] * u[1]));
  }
  [[nodiscard]] S length() const {
    using std::sqrt;
    return sqrt(S(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]));
  }
  [[nodiscard]] static S size(const S& x) { return x < 0 ? S(-x) : x; }

  S operator()(const Superellipsoid<double>& s) const {
    const Vec3<double>& a = s.semi_axes;
    return (*this)(PolySuperellipsoid{{a[0], a[0], a[1], a[1], a[2], a[2]}, s.n1, s.n2});
  }
  S operator()(const Capsule& s) const { return S(s.half_length) * size(u[2]) + S(s.radius) * length(); }
  S operator()(const Cylinder& s) const { return S(s.half_length) * size(u[2]) + S(s.radius) * across(); }
  S operator()(const Cone& s) const { return (*this)(Frustum{{s.radius, 0}, s.height}); }
  S operator()(const Frustum& s) const {
    const S depth = centroid<S>(s);
    return std::max<S>(S(s.radii[0]) * across() - depth * u[2],
                       S(s.radii[1]) * across() + (S(s.height) - depth) * u[2]);
  }
  S operator()(const Tablet& s) const {
    const S r(s.radius), e(s.cap_height), ball = (r * r + e * e) / (2 * e), centre = S(s.half_length) + e - ball;
    const bool is_on_cap = length() > 0 && centre + ball * size(u[2]) / length() >= S(s.half_length);
    return is_on_cap ? S(centre * size(u[2]) + ball * length()) : S(S(s.half_length) * size(u[2]) + r * across());
  }
  S operator()(const Box& s) const {
    return S(s.half_extents[0]) * size(u[0]) + S(s.half_extents[1]) * size(u[1]) + S(s.half_extents[2]) * size(u[2]);
  }
  S operator()(const Polyhedron& s) const {
    S out = Vec3<S>(s.hull->corners[0].template cast<S>()).dot(u);
    for (const Vec3<double>& x : s.hull->corners) out = std::max<S>(out, Vec3<S>(x.template cast<S>()).dot(u));
    return out;
  }
  S operator()(const PolySuperellipsoid& s) const {
    std::array<S, 3> q;
    for (std::size_t i = 0; i < 3; ++i) {
      const S& along = u[static_cast<Eigen::Index>(i)];
      q[i] = S(s.semi_axes[along > 0 ? 2 * i : 2 * i + 1]) * along;
    }
    return dual_norm<S>(dual_norm<S>(q[0], q[1], s.n2), q[2], s.n1);
  }
  S operator()(const HalfSpace&) const { return S(0); }
  S operator()(const ForeignShape&) const { return S(0); }
};

/// max n.x over a body, world axes, seen from its position.
template <class S>
[[nodiscard]] S support(const ConvexBody& body, const Vec3<S>& n) {
  const SupportOf<S> of{rotation<S>(body.quaternion).transpose() * n};
  return std::visit(of, body.shape) + S(body.swept_radius) * of.length();
}

/// o(n) for a unit n.
template <class S>
[[nodiscard]] S overlap_along(const ConvexPair& pair, const Vec3<S>& n) {
  const Vec3<S> apart = pair.body2.position.cast<S>() - pair.body1.position.cast<S>();
  return support<S>(pair.body1, n) + support<S>(pair.body2, Vec3<S>(-n)) - apart.dot(n);
}

/// Above 0 where a point lies outside the shape, body axes; of shapes with an equation.
template <class S>
struct OutsideOf {
  Vec3<S> x;

  [[nodiscard]] S square_across() const { return x[0] * x[0] + x[1] * x[1]; }

  S operator()(const Superellipsoid<double>& s) const {
    const Vec3<double>& a = s.semi_axes;
    return (*this)(PolySuperellipsoid{{a[0], a[0], a[1], a[1], a[2], a[2]}, s.n1, s.n2});
  }
  S operator()(const Cylinder& s) const {
    using std::abs;
    return std::max<S>(abs(x[2]) - S(s.half_length), square_across() - S(s.radius) * S(s.radius));
  }
  S operator()(const Cone& s) const { return (*this)(Frustum{{s.radius, 0}, s.height}); }
  S operator()(const Frustum& s) const {
    const S above = x[2] + centroid<S>(s), share = above / S(s.height);
    const S radius = S(s.radii[0]) * (1 - share) + S(s.radii[1]) * share;
    return std::max<S>(std::max<S>(-above, above - S(s.height)), square_across() - radius * radius);
  }
  S operator()(const Tablet& s) const {
    using std::abs;
    const S r(s.radius), e(s.cap_height), ball = (r * r + e * e) / (2 * e), above = abs(x[2]) - S(s.half_length);
    if (above <= 0) return square_across() - r * r;
    return square_across() + (above - e + ball) * (above - e + ball) - ball * ball;
  }
  S operator()(const Box& s) const {
    using std::abs;
    S out(-1);
    for (int i = 0; i < 3; ++i) out = std::max<S>(out, abs(x[i]) - S(s.half_extents[i]));
    return out;
  }
  S operator()(const PolySuperellipsoid& s) const {
    using std::abs;
    using std::pow;
    std::array<S, 3> q;
    for (std::size_t i = 0; i < 3; ++i) {
      const S& along = x[static_cast<Eigen::Index>(i)];
      q[i] = abs(along) / S(s.semi_axes[along > 0 ? 2 * i : 2 * i + 1]);
    }
    return pow(S(pow(q[0], S(s.n2)) + pow(q[1], S(s.n2))), S(S(s.n1) / S(s.n2))) + pow(q[2], S(s.n1)) - 1;
  }
  /// Capsules are judged by their segments, polyhedra by their corners, and half-spaces by nothing.
  template <class Other>
  S operator()(const Other&) const {
    return S(0);
  }
};

}  // namespace plumb::reference::bodies_tests
