// For adapters in C++17: what stands between plumb_solver.h and somebody's library. The standard library alone.
//
//     #include <plumb/plumb_adapter.hpp>            (in plumb's sources: "solver/plumb_adapter.hpp")
//     static void claim(plumb_abilities& abilities) { abilities.name = "mine"; abilities.shapes = PLUMB_ELLIPSOIDS; }
//     static void solve(const plumb::adapter::Frame& frame, plumb_contact& contact) { .. frame.write(answer, contact); }
//     PLUMB_ADAPTER(claim, solve)
//
// solve() sees the pair in a frame of safe units and answers in it: world axes, origin at body 1, lengths divided by a power
// of two so that the longest semi-axis lies in [1, 2). Tolerances that are lengths mean the same in every unit there.
// A pair that is not legal or not claimed is refused before, an exception ends as `stalled`. fuzz/example/ has one of a page.
#ifndef PLUMB_ADAPTER_HPP
#define PLUMB_ADAPTER_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <vector>

#include "solver/plumb_solver.h"

namespace plumb {
namespace adapter {

/// x, y, z.
using Vector = std::array<double, 3>;
/// Its rows.
using Matrix = std::array<Vector, 3>;

/// v + w.
inline Vector operator+(const Vector& v, const Vector& w) {
  return {v[0] + w[0], v[1] + w[1], v[2] + w[2]};
}
/// v - w.
inline Vector operator-(const Vector& v, const Vector& w) {
  return {v[0] - w[0], v[1] - w[1], v[2] - w[2]};
}
/// -v.
inline Vector operator-(const Vector& v) {
  return {-v[0], -v[1], -v[2]};
}
/// factor v.
inline Vector operator*(double factor, const Vector& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}
/// v . w.
[[nodiscard]] inline double dot(const Vector& v, const Vector& w) {
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}
/// v x w.
[[nodiscard]] inline Vector cross(const Vector& v, const Vector& w) {
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}
/// m v.
inline Vector operator*(const Matrix& m, const Vector& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}
/// m' v.
[[nodiscard]] inline Vector transposed(const Matrix& m, const Vector& v) {
  return v[0] * m[0] + v[1] * m[1] + v[2] * m[2];
}
/// No component is NaN or infinite.
[[nodiscard]] inline bool is_finite(const Vector& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

namespace detail {

/// x 2^exponent.
template <std::size_t N>
std::array<double, N> scaled(std::array<double, N> x, int exponent) {
  for (double& component : x) component = std::ldexp(component, exponent);
  return x;
}

/// e for which the largest component divided by 2^e lies in [1, 2); of zeros, or what is not finite, anything.
template <std::size_t N>
int exponent_of(const std::array<double, N>& x) {
  double largest = 0;
  for (const double component : x) largest = std::max(largest, std::abs(component));
  int exponent = 0;
  (void)std::frexp(largest, &exponent);
  return exponent - 1;
}

/// To a largest component in [1, 2): squares neither overflow nor vanish.
template <std::size_t N>
std::array<double, N> unit_scaled(const std::array<double, N>& x) {
  return scaled(x, -exponent_of(x));
}

/// N = (x^p + y^p)^(1/p) of x, y >= 0 and its derivatives, (x/N)^(p-1) and (y/N)^(p-1), from less = p - 1 and root = (p-1)/p:
/// near p = 1 and of a large p neither is to be had from p.
struct Norm {
  double value, dx, dy;
};
/// `less`: p - 1; `root`: 1 - 1/p.
inline Norm norm(double x, double y, double less, double root) {
  const double large = std::max(x, y), small = std::min(x, y);
  if (!(large > 0)) return {0, 0, 0};
  const double t = small / large;
  const double power = less == 1 ? t : std::pow(t, less);
  const double sum = 1 + power * t;  // (N/large)^p
  const double d = 1 / (less == 1 ? std::sqrt(sum) : std::pow(sum, root));
  const Norm out{large * sum * d, d, d * power};
  return x < y ? Norm{out.value, out.dy, out.dx} : out;
}

/// N(N(x, y; n2), z; n1), or with `dual` of the exponents n/(n-1), and its gradient.
struct Nested {
  double value;
  Vector gradient;
};
/// With the exponent n, or its dual n/(n-1).
inline Norm norm_of(double x, double y, double n, bool dual) {
  return dual ? norm(x, y, 1 / (n - 1), 1 / n) : norm(x, y, n - 1, (n - 1) / n);
}
/// Of the components' magnitudes, the gradient with the signs of v.
inline Nested nested(const Vector& v, double n1, double n2, bool dual) {
  const Norm inner = norm_of(std::abs(v[0]), std::abs(v[1]), n2, dual);
  const Norm outer = norm_of(inner.value, std::abs(v[2]), n1, dual);
  return {outer.value,
          {std::copysign(outer.dx * inner.dx, v[0]), std::copysign(outer.dx * inner.dy, v[1]),
           std::copysign(outer.dy, v[2])}};
}

/// Component by component.
inline Vector times(const Vector& v, const Vector& w) {
  return {v[0] * w[0], v[1] * w[1], v[2] * w[2]};
}
/// Component by component.
inline Vector over(const Vector& v, const Vector& w) {
  return {v[0] / w[0], v[1] / w[1], v[2] / w[2]};
}

}  // namespace detail

/// v / |v|, of any length but 0 (NaN).
[[nodiscard]] inline Vector normalised(const Vector& v) {
  const Vector scaled = detail::unit_scaled(v);
  return (1 / std::sqrt(dot(scaled, scaled))) * scaled;
}

/// Of a quaternion (w, x, y, z) of any length but 0, and from body axes to the world's.
[[nodiscard]] inline Matrix rotation(const std::array<double, 4>& quaternion) {
  const std::array<double, 4> q = detail::unit_scaled(quaternion);
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double s = 2 / (w * w + x * x + y * y + z * z);
  return {{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
           {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
           {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}}};
}

/// h, the largest x.u over a body for the unit vector along u, and the point x where it is; of u = 0 the centre.
struct Support {
  double height;
  Vector point;
};
/// g(x), 1 on the surface and of degree 1, with its gradient.
struct Gauge {
  double value;
  Vector gradient;
};
/// Sides along the axes.
struct Box {
  Vector low, high;
};

/// One body in the pair's frame.
struct Body {
  Vector semi_axes;
  double n1, n2;
  Vector centre;
  Matrix axes;                       ///< from body axes to the frame's
  std::array<double, 4> quaternion;  ///< unit

  /// From body axes, and back.
  [[nodiscard]] Vector to_frame(const Vector& x) const { return axes * x + centre; }
  /// The way back.
  [[nodiscard]] Vector to_body(const Vector& x) const { return transposed(axes, x - centre); }

  /// Both exponents are 2.
  [[nodiscard]] bool is_ellipsoid() const { return n1 == 2 && n2 == 2; }

  /// Body axes, u of any length.
  [[nodiscard]] Support support_in_body(const Vector& u) const {
    const Vector along = detail::unit_scaled(u);
    const double length = std::sqrt(dot(along, along));
    if (!(length > 0)) return {0, {0, 0, 0}};
    const detail::Nested found = detail::nested(detail::times(semi_axes, along), n1, n2, true);
    return {found.value / length, detail::times(semi_axes, found.gradient)};
  }
  /// Frame axes; the height is above the frame's origin.
  [[nodiscard]] Support support(const Vector& u) const {
    const Support found = support_in_body(transposed(axes, u));
    const Vector point = to_frame(found.point);
    return {found.height + dot(normalised(u), centre), point};
  }
  /// Body axes, as x is.
  [[nodiscard]] Gauge gauge_in_body(const Vector& x) const {
    const detail::Nested found = detail::nested(detail::over(x, semi_axes), n1, n2, false);
    return {found.value, detail::over(found.gradient, semi_axes)};
  }
  /// Frame axes.
  [[nodiscard]] Gauge gauge(const Vector& x) const {
    const Gauge found = gauge_in_body(to_body(x));
    return {found.value, axes * found.gradient};
  }
  /// The least box along the frame's axes.
  [[nodiscard]] Box box() const {
    const Vector half{support_in_body(axes[0]).height, support_in_body(axes[1]).height,
                      support_in_body(axes[2]).height};
    return {centre - half, centre + half};
  }
  /// `count` points of the surface in body axes, for solvers that take hulls: on rays that are spread evenly over the sphere
  /// (a spiral that turns by the golden angle), stretched by the semi-axes.
  [[nodiscard]] std::vector<Vector> points(int count) const {
    const double golden_angle = std::acos(-1.0) * (3 - std::sqrt(5.0));
    std::vector<Vector> out;
    for (int i = 0; i < count; ++i) {
      const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z);
      const Vector ray = detail::times(semi_axes, {r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z});
      out.push_back((1 / gauge_in_body(ray).value) * ray);
    }
    return out;
  }
};

/// An answer in the frame. The normal, from body 1 to body 2, may have any length but 0.
struct Answer {
  double overlap;  ///< > 0: the depth, < 0: minus the distance
  Vector normal, point1, point2;
};

/// The pair in its frame, and the way back.
struct Frame {
  int exponent;
  Vector origin;
  std::array<Body, 2> bodies;

  /// Of a legal pair: body 1 at the origin, lengths divided by 2^exponent.
  explicit Frame(const plumb_pair& pair)
      : exponent(pair_exponent(pair)), origin(vector(pair.bodies[0].position)),
        bodies{placed(pair.bodies[0], {0, 0, 0}), placed(pair.bodies[1], to_centre(pair))} {}

  /// The longest semi-axis, in [1, 2).
  [[nodiscard]] double size() const { return std::max(longest(bodies[0].semi_axes), longest(bodies[1].semi_axes)); }
  /// A point of the frame.
  [[nodiscard]] Vector to_world(const Vector& x) const { return detail::scaled(x, exponent) + origin; }

  /// Two points, and the one midway.
  void write(const Answer& answer, plumb_contact& contact) const {
    write_midway(answer.overlap, answer.normal, 0.5 * (answer.point1 + answer.point2), contact);
    copy(to_world(answer.point1), contact.points[0]);
    copy(to_world(answer.point2), contact.points[1]);
    if (!is_finite(answer.point1) || !is_finite(answer.point2)) contact.status = PLUMB_NOT_FINITE;
  }
  /// Where the library has one point, between the bodies.
  void write_midway(double overlap, const Vector& normal, const Vector& point, plumb_contact& contact) const {
    const Vector unit = normalised(normal);
    const bool finite = std::isfinite(overlap) && is_finite(unit) && is_finite(point);
    contact.status = finite ? PLUMB_CONVERGED : PLUMB_NOT_FINITE;
    contact.verdict = overlap > 0 ? PLUMB_OVERLAPPING : overlap < 0 ? PLUMB_SEPARATED : PLUMB_UNDECIDED;
    contact.overlap = std::ldexp(overlap, exponent);
    copy(unit, contact.normal);
    copy(to_world(point), contact.contact_point);
  }
  /// Where all that the library says is that the bodies are apart: an answer of one that claims PLUMB_APART_VERDICT.
  static void write_separated(plumb_contact& contact) {
    contact.status = PLUMB_STALLED;
    contact.verdict = PLUMB_SEPARATED;
  }

 private:
  static Vector vector(const double* x) { return {x[0], x[1], x[2]}; }
  static double longest(const Vector& v) { return std::max({v[0], v[1], v[2]}); }
  static void copy(const Vector& from, double* to) { std::copy(from.begin(), from.end(), to); }
  static int pair_exponent(const plumb_pair& pair) {
    const double *a = pair.bodies[0].semi_axes, *b = pair.bodies[1].semi_axes;
    return detail::exponent_of(std::array<double, 6>{a[0], a[1], a[2], b[0], b[1], b[2]});
  }
  // A large unit is divided out before the subtraction, a small one after it: huge positions of opposite signs have no
  // difference before, and small ones lose no bit.
  [[nodiscard]] Vector to_centre(const plumb_pair& pair) const {
    const int before = std::max(exponent, 0);
    const Vector from = detail::scaled(vector(pair.bodies[0].position), -before);
    const Vector to = detail::scaled(vector(pair.bodies[1].position), -before);
    return detail::scaled(to - from, before - exponent);
  }
  [[nodiscard]] Body placed(const plumb_body& body, const Vector& centre) const {
    const double* q = body.quaternion_wxyz;
    std::array<double, 4> unit = detail::unit_scaled(std::array<double, 4>{q[0], q[1], q[2], q[3]});
    const double length = std::sqrt(unit[0] * unit[0] + unit[1] * unit[1] + unit[2] * unit[2] + unit[3] * unit[3]);
    const Matrix axes = rotation(unit);
    for (double& component : unit) component /= length;
    return {
        detail::scaled(vector(body.semi_axes), -exponent), body.exponents[0], body.exponents[1], centre, axes, unit};
  }
};

/// Whether the numbers are those of a body.
[[nodiscard]] inline bool is_legal(const plumb_body& body) {
  double sum = 0, quaternion = 0;
  for (const double x : body.semi_axes) sum += x > 0 ? 0 * x : std::numeric_limits<double>::quiet_NaN();
  for (const double x : body.exponents) sum += x > 1 ? 0 * x : std::numeric_limits<double>::quiet_NaN();
  for (const double x : body.position) sum += 0 * x;
  for (const double x : body.quaternion_wxyz) sum += 0 * x, quaternion = std::max(quaternion, std::abs(x));
  return sum == 0 && quaternion > 0;
}

/// Whether a body's shape is among those claimed.
[[nodiscard]] inline bool is_claimed(const plumb_body& body, const plumb_abilities& abilities) {
  const double *a = body.semi_axes, *n = body.exponents;
  if (abilities.shapes == PLUMB_SUPERELLIPSOIDS)
    return std::min(n[0], n[1]) >= abilities.exponents[0] && std::max(n[0], n[1]) <= abilities.exponents[1];
  return n[0] == 2 && n[1] == 2 && (abilities.shapes == PLUMB_ELLIPSOIDS || (a[0] == a[1] && a[1] == a[2]));
}

/// What plumb_solver_solve returns: the pair is refused, or put to solve(frame, contact).
template <class Claim, class Solve>
[[nodiscard]] int run(Claim claim, Solve solve, const plumb_pair& pair, plumb_contact& contact) {
  plumb_abilities abilities{};
  abilities.exponents[0] = 1;
  abilities.exponents[1] = std::numeric_limits<double>::infinity();
  claim(abilities);
  for (const plumb_body& body : pair.bodies)
    if (!is_legal(body) || !is_claimed(body, abilities)) return 1;
  const Frame frame(pair);
  if (!is_finite(frame.bodies[1].centre)) return 1;
  try {
    solve(frame, contact);
  } catch (const std::exception&) {
    contact.status = PLUMB_STALLED;
  }
  return 0;
}

}  // namespace adapter
}  // namespace plumb

/// The library's exported functions from claim(plumb_abilities&) and solve(const plumb::adapter::Frame&, plumb_contact&).
#define PLUMB_ADAPTER(claim, solve)                                        \
  int plumb_solver_version(void) {                                         \
    return PLUMB_SOLVER_VERSION;                                           \
  }                                                                        \
  void plumb_solver_abilities(plumb_abilities* abilities) {                \
    (claim)(*abilities);                                                   \
  }                                                                        \
  int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) { \
    return plumb::adapter::run((claim), (solve), *pair, *contact);         \
  }

#endif
