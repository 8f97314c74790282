// One pair in interval arithmetic: the case's doubles are exact, all that follows from them is enclosed. Pair frame as in
// pose.hpp (origin at body 1, lengths over 2^exponent).
#pragma once

#include <optional>

#include "solver/reference/interval/vector_interval.hpp"

namespace plumb::reference {

/// The body axis of revolution: z of a superellipsoid, the unequal one of a spheroid.
[[nodiscard]] inline std::optional<int> axis_of_revolution(const Superellipsoid<double>& shape) {
  if (shape.n2 != 2) return {};
  const Vec3<double>& a = shape.semi_axes;
  if (a[0] == a[1]) return 2;
  if (shape.n1 != 2) return {};
  if (a[1] == a[2]) return 0;
  return a[0] == a[2] ? std::optional(1) : std::nullopt;
}

/// An exponent of a support function, m = n/(n-1), with m - 1 and m - 2 free of cancellation.
template <class I>
struct DualExponent {
  I m, minus_one, minus_two;

  explicit DualExponent(double n)
      : m(I(n) / (I(n) - I(1.0))), minus_one(I(1.0) / (I(n) - I(1.0))), minus_two((I(2.0) - I(n)) / (I(n) - I(1.0))) {}
};

template <class I>
struct EnclosedBody {
  IVec3<I> semi_axes;
  double n1, n2;
  DualExponent<I> m1, m2;
  IMat3<I> rotation;
  std::optional<int> axis;  ///< of revolution, exactly

  [[nodiscard]] bool is_ellipsoid() const { return n1 == 2 && n2 == 2; }
};

template <class I>
struct EnclosedPair {
  EnclosedBody<I> body1, body2;
  IVec3<I> centre;  ///< of body 2
  int exponent;     ///< world length = 2^exponent times the pair's

  /// The longest semi-axis.
  [[nodiscard]] I size() const {
    I out = body1.semi_axes[0];
    for (const auto* body : {&body1, &body2})
      for (int i = 0; i < 3; ++i)
        if (high(body->semi_axes[i]) > high(out)) out = body->semi_axes[i];
    return out;
  }
  [[nodiscard]] IVec3<I> to_world_point(const IVec3<I>& x, const Pair& pair) const {
    IVec3<I> out;
    for (int i = 0; i < 3; ++i) out[i] = times_power_of_two<I>(x[i], exponent) + I(pair.body1.position[i]);
    return out;
  }
};

template <class I>
[[nodiscard]] EnclosedPair<I> enclose(const Pair& pair);

/// Whether a point in body axes is proved to lie in the body, its surface included.
template <class I>
[[nodiscard]] bool is_inside(const EnclosedBody<I>& body, const Vec3<double>& x);
/// The same of every point of a box.
template <class I>
[[nodiscard]] bool is_inside(const EnclosedBody<I>& body, const IVec3<I>& x);

/// Support function and its gradient at a direction of any length in body axes, multiplied by the semi-axes:
/// q = (a ux, b uy, c uz). The gradient is by u (the support point, body axes).
template <class I>
struct SupportEnclosure {
  I value;
  IVec3<I> point;
};
template <class I>
[[nodiscard]] I support_value(const EnclosedBody<I>& body, const IVec3<I>& q);
template <class I>
[[nodiscard]] SupportEnclosure<I> support(const EnclosedBody<I>& body, const IVec3<I>& q);

/// kappa a a': one of the rank-one terms that a body's support Hessian is at least the sum of, in two coordinates.
template <class I>
struct RankOne {
  I weight;  ///< a lower bound, finite
  IVec2<I> vector;
};
template <class I>
using HessianTerms = std::array<RankOne<I>, 3>;
template <class I>
using ChartMap = Eigen::Matrix<I, 3, 2>;  ///< dq / d(chart coordinates)

/// The Hessian itself for q in the box, with lower bounds of the two weights: sharp where the box is small and no
/// coordinate near zero makes the vectors jump.
template <class I>
[[nodiscard]] HessianTerms<I> hessian_terms(const EnclosedBody<I>& body, const IVec3<I>& q, const ChartMap<I>& map);

/// lambda times the identity of the two smaller coordinates of q: rougher, and right also where second derivatives are
/// infinite (flat faces).
template <class I>
[[nodiscard]] HessianTerms<I> hessian_floor(const EnclosedBody<I>& body, const IVec3<I>& q, const ChartMap<I>& map);

}  // namespace plumb::reference
