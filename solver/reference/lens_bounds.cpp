#include "solver/reference/lens_bounds.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <vector>

#include "solver/pose.hpp"
#include "solver/reference/frame.hpp"
#include "solver/reference/interval/enclosure.hpp"
#include "solver/reference/interval/interval_double.hpp"
#include "solver/shape/superellipsoid.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb::reference {
namespace {

using I = DoubleInterval;
using Vector = Vec3<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
LensBounds unknown_lens() {
  const Vector least = Vector::Constant(-infinity), most = Vector::Constant(infinity);
  return {0, infinity, least, most, Vector::Zero(), most};
}

// ---- The search, in doubles ---------------------------------------------------------------------------------------------------

/// The larger gauge, and its gradient.
NormValue<double> worse_gauge(const PlacedPair<double>& pair, const Vector& x) {
  const auto of = [&](const PlacedBody<double>& body) {
    const Vector from = body.to_body(x);
    if (from.isZero(0)) return NormValue<double>{0, Vector::Zero()};
    NormValue<double> out = gauge_gradient<double>(body.shape, from);
    out.gradient = body.to_pair_direction(out.gradient);
    return out;
  };
  const NormValue<double> one = of(pair.body1), two = of(pair.body2);
  return one.value > two.value ? one : two;
}

/// A point inside both bodies, if projections on tangent planes of rising level sets find one.
Vector search_inside(const PlacedPair<double>& pair, Vector x) {
  const int rounds = 400, rounds_a_level = 20;
  double depth = 0.5;
  for (int i = 1; i <= rounds; ++i) {
    const NormValue<double> at = worse_gauge(pair, x);
    if (at.value < 1 - depth / 2 || (i == 1 && at.value < 1)) break;
    x -= (at.value - 1 + depth) / at.gradient.squaredNorm() * at.gradient;
    if (i % rounds_a_level == 0) depth /= 2;
  }
  return x;
}

/// Where a ray from inside leaves the lens, by halving; `reach` is outside.
double search_exit(const PlacedPair<double>& pair, const Vector& from, const Vector& along, double reach) {
  double inside = 0, outside = reach;
  while (worse_gauge(pair, from + outside * along).value < 1) outside *= 2;
  const int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (inside + outside) / 2;
    (worse_gauge(pair, from + middle * along).value < 1 ? inside : outside) = middle;
  }
  return inside;
}

/// A point inside and axes in which the lens is about round.
struct Rounding {
  Vector inside;
  Mat3<double> axes;
};

Rounding search_rounding(const PlacedPair<double>& pair, const Vector& inside, const Vector& normal) {
  Rounding out{inside, frame_about(normal)};
  const int passes = 12;
  for (int pass = 0; pass < passes; ++pass) {
    Vector sum = Vector::Zero();
    Mat3<double> squares = Mat3<double>::Zero();
    double count = 0;
    for (int code = 0; code < 27; ++code) {
      const Vector d(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
      if (d.isZero(0)) continue;
      const Vector along = out.axes * d.normalized(), y = search_exit(pair, out.inside, along, 4) * along;
      sum += y, squares += y * y.transpose(), count += 1;
    }
    const Vector mean = sum / count;
    const Eigen::SelfAdjointEigenSolver<Mat3<double>> spread(squares / count - mean * mean.transpose());
    out.inside += mean;
    out.axes = spread.eigenvectors() * (3 * spread.eigenvalues()).cwiseMax(1e-40).cwiseSqrt().asDiagonal();
  }
  if (out.axes.determinant() < 0) out.axes.col(0) *= -1;
  return out;
}

// ---- The proof, in intervals --------------------------------------------------------------------------------------------------

/// Inner and outer sums over the cones seen so far.
struct Sums {
  I inner = 0.0, outer = 0.0;
  IVec3<I> first = IVec3<I>::Constant(I(0.0));   ///< int y dV from the point inside
  IVec3<I> second = IVec3<I>::Constant(I(0.0));  ///< int (e.y)^2 dV along each axis e
};

class Lens {
 public:
  Lens(const Pair& pair, const Contact<double>& contact, const Mat3<double>& axes)
      : axes_(axes), rough_(place<double>(pair)), enclosed_(enclose<I>(pair)),
        found_(search_rounding(rough_, start(pair, contact), contact.normal)) {}

  [[nodiscard]] bool has_inside() const { return holds(found_.inside); }
  [[nodiscard]] const Vector& inside() const { return found_.inside; }
  [[nodiscard]] int exponent() const { return enclosed_.exponent; }

  /// A corner of the inner polyhedron in a direction of the round axes, from the point inside.
  [[nodiscard]] Vector corner(const Vector& direction) const {
    const Vector along = found_.axes * direction;
    double t = search_exit(rough_, found_.inside, along, 4);
    double back = 1e-12;  // of the way, until it is proved
    while (back < 1 && !holds(found_.inside + (1 - back) * t * along)) back *= 4;
    return back < 1 ? Vector((1 - back) * t * along) : Vector(1e-3 * t * along);
  }
  /// The cone over a triangle, whose corners are given from the point inside; false where nothing bounds it.
  [[nodiscard]] bool add(Sums& sums, const std::array<Vector, 3>& corners) const {
    const std::array<IVec3<I>, 3> w{from_inside(corners[0]), from_inside(corners[1]), from_inside(corners[2])};
    const I inner = dot<I>(w[0], cross_product<I>(w[1], w[2])) / I(6.0);
    if (!is_positive<I>(inner)) return false;
    const Vector plane = best_plane(corners);
    I outer = inner;
    std::array<IVec3<I>, 3> cut = w;
    for (std::size_t k = 0; k < 3; ++k) {
      const I reach = high_end<I>(least_support(plane)) / dot<I>(enclosed<I>(plane), w[k]);
      if (!is_positive<I>(reach)) return false;
      outer = outer * reach;
      for (int i = 0; i < 3; ++i) cut[k][i] = cut[k][i] * reach;
    }
    sums.inner += inner;
    sums.outer += outer;
    const I gap = hull<I>(0.0, high_end<I>(outer - inner));
    for (int i = 0; i < 3; ++i) {
      const I where = hull<I>(hull<I>(0.0, cut[0][i]), hull<I>(cut[1][i], cut[2][i]));
      sums.first[i] += inner * (w[0][i] + w[1][i] + w[2][i]) / I(4.0) + gap * where;
      sums.second[i] += inner * mean_square(w, i) + gap * farthest_square(w, cut, i);
    }
    return true;
  }

 private:
  [[nodiscard]] Vector start(const Pair& pair, const Contact<double>& contact) const {
    return search_inside(rough_, rough_.to_pair_point((contact.point1 + contact.point2) / 2, pair));
  }
  /// The corner is the rounded sum of the point inside and a vector: from it to the corner, exactly enclosed.
  [[nodiscard]] IVec3<I> from_inside(const Vector& corner) const {
    const Vector x = found_.inside + corner;
    return enclosed<I>(x) - enclosed<I>(found_.inside);
  }
  [[nodiscard]] static IVec3<I> in_body(const EnclosedBody<I>& body, const IVec3<I>& from_centre) {
    return body.rotation.transpose() * from_centre;
  }
  [[nodiscard]] bool holds(const Vector& x) const {
    const IVec3<I> at = enclosed<I>(x);
    return is_inside<I>(enclosed_.body1, in_body(enclosed_.body1, at)) &&
           is_inside<I>(enclosed_.body2, in_body(enclosed_.body2, at - enclosed_.centre));
  }
  /// e.w of the three corners.
  [[nodiscard]] IVec3<I> along(const std::array<IVec3<I>, 3>& w, int axis) const {
    const IVec3<I> e = enclosed<I>(axes_.col(axis));
    return {dot<I>(e, w[0]), dot<I>(e, w[1]), dot<I>(e, w[2])};
  }
  /// Of e.y over the tetrahedron of the origin and three corners: (sum s_i^2 + sum s_i s_j) / 10, s = e.w.
  [[nodiscard]] I mean_square(const std::array<IVec3<I>, 3>& w, int axis) const {
    const IVec3<I> s = along(w, axis);
    return (square<I>(s[0]) + square<I>(s[1]) + square<I>(s[2]) + s[0] * s[1] + s[1] * s[2] + s[2] * s[0]) / I(10.0);
  }
  /// [0, the largest (e.y)^2 between inner and cut corners].
  [[nodiscard]] I farthest_square(const std::array<IVec3<I>, 3>& w, const std::array<IVec3<I>, 3>& cut,
                                  int axis) const {
    I out = 0.0;
    for (const IVec3<I>& s : {along(w, axis), along(cut, axis)})
      for (int k = 0; k < 3; ++k) out = hull<I>(out, square<I>(s[k]));
    return out;
  }
  /// The lower of both bodies' largest a.y from the point inside, each of which holds for the lens.
  [[nodiscard]] I least_support(const Vector& a) const {
    const IVec3<I> direction = enclosed<I>(a), at = enclosed<I>(found_.inside);
    const auto of = [&](const EnclosedBody<I>& body, const IVec3<I>& from_centre) -> I {
      const IVec3<I> u = in_body(body, direction);
      IVec3<I> q;
      for (int i = 0; i < 3; ++i) q[i] = u[i] * body.semi_axes[i];
      return support_value<I>(body, q) - dot<I>(direction, from_centre);
    };
    const I one = of(enclosed_.body1, at), two = of(enclosed_.body2, at - enclosed_.centre);
    return high(one) < high(two) ? one : two;
  }
  /// Of the tangent planes at the corners and above the triangle's middle, the one that cuts off the smallest cone.
  [[nodiscard]] Vector best_plane(const std::array<Vector, 3>& corners) const {
    const Vector middle = (corners[0] + corners[1] + corners[2]) / 3;
    const Vector above = middle * search_exit(rough_, found_.inside, middle, 1.5);
    Vector best = Vector::Zero();
    double least = infinity;
    for (const Vector& at : {above, corners[0], corners[1], corners[2]}) {
      const Vector plane = worse_gauge(rough_, found_.inside + at).gradient;
      double volume = 1;
      for (const Vector& corner : corners) volume *= plane.dot(at) / plane.dot(corner);
      if (volume > 0 && volume < least) least = volume, best = plane;
    }
    return best;
  }

  Mat3<double> axes_;
  PlacedPair<double> rough_;
  EnclosedPair<I> enclosed_;
  Rounding found_;
};

/// The triangle's four parts, again and again.
bool add_triangles(const Lens& lens, Sums& sums, const std::array<Vector, 3>& directions, int level) {
  if (level == 0)
    return lens.add(sums, {lens.corner(directions[0]), lens.corner(directions[1]), lens.corner(directions[2])});
  const auto between = [&](std::size_t i, std::size_t j) -> Vector {
    return (directions[i] + directions[j]).normalized();
  };
  const Vector ab = between(0, 1), bc = between(1, 2), ca = between(2, 0);
  return add_triangles(lens, sums, {directions[0], ab, ca}, level - 1) &&
         add_triangles(lens, sums, {ab, directions[1], bc}, level - 1) &&
         add_triangles(lens, sums, {ca, bc, directions[2]}, level - 1) &&
         add_triangles(lens, sums, {ab, bc, ca}, level - 1);
}

/// Over all cones, which fill space about the point inside because each triangle's determinant is proved positive.
bool add_octants(const Lens& lens, Sums& sums, int level) {
  for (int octant = 0; octant < 8; ++octant) {
    const auto sign = [&](int bit) { return (octant >> bit & 1) != 0 ? -1.0 : 1.0; };
    const Vector x = sign(0) * Vector::UnitX(), y = sign(1) * Vector::UnitY(), z = sign(2) * Vector::UnitZ();
    const bool is_right_handed = sign(0) * sign(1) * sign(2) > 0;
    if (!add_triangles(lens, sums, {x, is_right_handed ? y : z, is_right_handed ? z : y}, level)) return false;
  }
  return true;
}

I cube_root(const I& x) {
  return positive_power<I>(x, I(1.0) / I(3.0));
}

}  // namespace

LensBounds bound_lens(const Pair& pair, const Contact<double>& contact, int level, const Mat3<double>& axes) {
  const StandardArithmetic mode;
  const Lens lens(pair, contact, axes);
  Sums sums;
  if (!lens.has_inside() || !add_octants(lens, sums, level)) return unknown_lens();
  const auto in_world = [&](const I& x) { return times_power_of_two<I>(x, lens.exponent()); };
  const I volume = hull<I>(low_end<I>(sums.inner), high_end<I>(sums.outer));
  const I in_unit = times_power_of_two<I>(volume, 3 * lens.exponent());
  LensBounds out{low(in_unit), high(in_unit), {}, {}, {}, {}};
  for (int i = 0; i < 3; ++i) {
    const I centre = in_world(I(lens.inside()[i]) + sums.first[i] / volume) + I(pair.body1.position[i]);
    out.centre_lower[i] = low(centre), out.centre_upper[i] = high(centre);
    const I middle = dot<I>(enclosed<I>(axes.col(i)), sums.first) / volume;
    const I moment = times_power_of_two<I>(sums.second[i] / volume - square<I>(middle), 2 * lens.exponent());
    out.moments_lower[i] = std::max(low(moment), 0.0), out.moments_upper[i] = high(moment);
  }
  return out;
}

AreaBounds bound_area(const Pair& pair, const Contact<double>& contact, int axis, double shift, int level) {
  const StandardArithmetic mode;
  Pair before = pair, after = pair;
  before.body2.position[axis] -= shift;
  after.body2.position[axis] += shift;
  const auto root_of = [&](const Pair& of) {
    const LensBounds bounds = bound_lens(of, contact, level);
    return cube_root({bounds.volume_lower, bounds.volume_upper});
  };
  const I at(pair.body2.position[axis]), here = root_of(pair);
  const I upper = (here - root_of(before)) / (at - I(before.body2.position[axis]));
  const I lower = (root_of(after) - here) / (I(after.body2.position[axis]) - at);
  const I area = -(I(3.0) * here * here * hull<I>(low_end<I>(lower), high_end<I>(upper)));
  return {low(area), high(area)};
}

}  // namespace plumb::reference
