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

using LensInterval = DoubleInterval;
using LensVector = Vec3<double>;

constexpr double endless = std::numeric_limits<double>::infinity();
LensBounds unknown_lens() {
  const LensVector least = LensVector::Constant(-endless), most = LensVector::Constant(endless);
  return {0, endless, least, most, LensVector::Zero(), most};
}

// ---- The search, in doubles ---------------------------------------------------------------------------------------------------

/// The larger gauge, and its gradient.
NormValue<double> worse_gauge(const PlacedPair<double>& pair, const LensVector& x) {
  const auto of = [&](const PlacedBody<double>& body) {
    const LensVector from = body.to_body(x);
    if (from.isZero(0)) return NormValue<double>{0, LensVector::Zero()};
    NormValue<double> out = gauge_gradient<double>(body.shape, from);
    out.gradient = body.to_pair_direction(out.gradient);
    return out;
  };
  const NormValue<double> one = of(pair.body1), two = of(pair.body2);
  return one.value > two.value ? one : two;
}

/// A point inside both bodies, if projections on tangent planes of rising level sets find one.
LensVector search_inside(const PlacedPair<double>& pair, LensVector x) {
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

/// Where a ray from inside leaves the lens, by Newton; `reach` is outside. The larger gauge is convex: no step goes too far in.
double search_exit(const PlacedPair<double>& pair, const LensVector& from, const LensVector& along, double reach) {
  double t = reach;
  while (worse_gauge(pair, from + t * along).value < 1) t *= 2;
  const int rounds = 60;
  for (int i = 0; i < rounds; ++i) {
    const NormValue<double> at = worse_gauge(pair, from + t * along);
    const double step = (at.value - 1) / at.gradient.dot(along);
    if (!(step > 0)) break;
    t -= step;
  }
  return t;
}

/// A point inside and axes in which the lens is about round.
struct Rounding {
  LensVector inside;
  Mat3<double> axes;
};

Rounding search_rounding(const PlacedPair<double>& pair, const LensVector& inside, const LensVector& normal) {
  Rounding out{inside, frame_about(normal)};
  const int passes = 12;
  for (int pass = 0; pass < passes; ++pass) {
    LensVector sum = LensVector::Zero();
    Mat3<double> squares = Mat3<double>::Zero();
    double count = 0;
    for (int code = 0; code < 27; ++code) {
      const int x = code % 3 - 1, y = code / 3 % 3 - 1, z = code / 9 - 1;
      const LensVector d(x, y, z);
      if (d.isZero(0)) continue;
      const LensVector along = out.axes * d.normalized(), at = search_exit(pair, out.inside, along, 4) * along;
      sum += at, squares += at * at.transpose(), count += 1;
    }
    const LensVector mean = sum / count;
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
  LensInterval inner = 0.0, outer = 0.0;
  IVec3<LensInterval> first = IVec3<LensInterval>::Constant(LensInterval(0.0));   ///< int y dV from the point inside
  IVec3<LensInterval> second = IVec3<LensInterval>::Constant(LensInterval(0.0));  ///< int (e.y)^2 dV along each axis e
};

class Lens {
 public:
  Lens(const Pair& pair, const Contact<double>& contact, const Mat3<double>& axes)
      : axes_(axes), rough_(place<double>(pair)), enclosed_(enclose<LensInterval>(pair)),
        found_(search_rounding(rough_, start(pair, contact), contact.normal)) {}

  [[nodiscard]] bool has_inside() const { return holds(found_.inside); }
  [[nodiscard]] const LensVector& inside() const { return found_.inside; }
  [[nodiscard]] int exponent() const { return enclosed_.exponent; }

  /// A corner of the inner polyhedron in a direction of the round axes, from the point inside.
  [[nodiscard]] LensVector corner(const LensVector& direction) const {
    const LensVector along = found_.axes * direction;
    double t = search_exit(rough_, found_.inside, along, 4);
    double back = 1e-12;  // of the way, until it is proved
    while (back < 1 && !holds(found_.inside + (1 - back) * t * along)) back *= 4;
    return back < 1 ? LensVector((1 - back) * t * along) : LensVector(1e-3 * t * along);
  }
  /// The cone over a triangle, whose corners are given from the point inside; false where nothing bounds it.
  [[nodiscard]] bool add(Sums& sums, const std::array<LensVector, 3>& corners) const {
    const std::array<IVec3<LensInterval>, 3> w{from_inside(corners[0]), from_inside(corners[1]),
                                               from_inside(corners[2])};
    const LensInterval inner = dot<LensInterval>(w[0], cross_product<LensInterval>(w[1], w[2])) / LensInterval(6.0);
    if (!is_positive<LensInterval>(inner)) return false;
    const LensVector plane = best_plane(corners);
    LensInterval outer = inner;
    std::array<IVec3<LensInterval>, 3> cut = w;
    for (std::size_t k = 0; k < 3; ++k) {
      const LensInterval reach =
          high_end<LensInterval>(least_support(plane)) / dot<LensInterval>(enclosed<LensInterval>(plane), w[k]);
      if (!is_positive<LensInterval>(reach)) return false;
      outer = outer * reach;
      for (int i = 0; i < 3; ++i) cut[k][i] = cut[k][i] * reach;
    }
    sums.inner += inner;
    sums.outer += outer;
    const LensInterval gap = hull<LensInterval>(0.0, high_end<LensInterval>(outer - inner));
    for (int i = 0; i < 3; ++i) {
      const LensInterval where =
          hull<LensInterval>(hull<LensInterval>(0.0, cut[0][i]), hull<LensInterval>(cut[1][i], cut[2][i]));
      sums.first[i] += inner * (w[0][i] + w[1][i] + w[2][i]) / LensInterval(4.0) + gap * where;
      sums.second[i] += inner * mean_square(w, i) + gap * farthest_square(w, cut, i);
    }
    return true;
  }

 private:
  [[nodiscard]] LensVector start(const Pair& pair, const Contact<double>& contact) const {
    return search_inside(rough_, rough_.to_pair_point((contact.point1 + contact.point2) / 2, pair));
  }
  /// The corner is the rounded sum of the point inside and a vector: from it to the corner, exactly enclosed.
  [[nodiscard]] IVec3<LensInterval> from_inside(const LensVector& corner) const {
    const LensVector x = found_.inside + corner;
    return enclosed<LensInterval>(x) - enclosed<LensInterval>(found_.inside);
  }
  [[nodiscard]] static IVec3<LensInterval> in_body(const EnclosedBody<LensInterval>& body,
                                                   const IVec3<LensInterval>& from_centre) {
    return body.rotation.transpose() * from_centre;
  }
  [[nodiscard]] bool holds(const LensVector& x) const {
    const IVec3<LensInterval> at = enclosed<LensInterval>(x);
    return is_inside<LensInterval>(enclosed_.body1, in_body(enclosed_.body1, at)) &&
           is_inside<LensInterval>(enclosed_.body2, in_body(enclosed_.body2, at - enclosed_.centre));
  }
  /// e.w of the three corners.
  [[nodiscard]] IVec3<LensInterval> along(const std::array<IVec3<LensInterval>, 3>& w, int axis) const {
    const IVec3<LensInterval> e = enclosed<LensInterval>(axes_.col(axis));
    return {dot<LensInterval>(e, w[0]), dot<LensInterval>(e, w[1]), dot<LensInterval>(e, w[2])};
  }
  /// Of e.y over the tetrahedron of the origin and three corners: (sum s_i^2 + sum s_i s_j) / 10, s = e.w.
  [[nodiscard]] LensInterval mean_square(const std::array<IVec3<LensInterval>, 3>& w, int axis) const {
    const IVec3<LensInterval> s = along(w, axis);
    return (square<LensInterval>(s[0]) + square<LensInterval>(s[1]) + square<LensInterval>(s[2]) + s[0] * s[1] +
            s[1] * s[2] + s[2] * s[0]) /
           LensInterval(10.0);
  }
  /// [0, the largest (e.y)^2 between inner and cut corners].
  [[nodiscard]] LensInterval farthest_square(const std::array<IVec3<LensInterval>, 3>& w,
                                             const std::array<IVec3<LensInterval>, 3>& cut, int axis) const {
    LensInterval out = 0.0;
    for (const IVec3<LensInterval>& s : {along(w, axis), along(cut, axis)})
      for (int k = 0; k < 3; ++k) out = hull<LensInterval>(out, square<LensInterval>(s[k]));
    return out;
  }
  /// The lower of both bodies' largest a.y from the point inside, each of which holds for the lens.
  [[nodiscard]] LensInterval least_support(const LensVector& a) const {
    const IVec3<LensInterval> direction = enclosed<LensInterval>(a), at = enclosed<LensInterval>(found_.inside);
    const auto of = [&](const EnclosedBody<LensInterval>& body,
                        const IVec3<LensInterval>& from_centre) -> LensInterval {
      const IVec3<LensInterval> u = in_body(body, direction);
      IVec3<LensInterval> q;
      for (int i = 0; i < 3; ++i) q[i] = u[i] * body.semi_axes[i];
      return support_value<LensInterval>(body, q) - dot<LensInterval>(direction, from_centre);
    };
    const LensInterval one = of(enclosed_.body1, at), two = of(enclosed_.body2, at - enclosed_.centre);
    return high(one) < high(two) ? one : two;
  }
  /// Of the tangent planes at the corners and above the triangle's middle, the one that cuts off the smallest cone.
  [[nodiscard]] LensVector best_plane(const std::array<LensVector, 3>& corners) const {
    const LensVector middle = (corners[0] + corners[1] + corners[2]) / 3;
    const LensVector above = middle * search_exit(rough_, found_.inside, middle, 1.5);
    LensVector best = LensVector::Zero();
    double least = endless;
    for (const LensVector& at : {above, corners[0], corners[1], corners[2]}) {
      const LensVector plane = worse_gauge(rough_, found_.inside + at).gradient;
      double volume = 1;
      for (const LensVector& corner : corners) volume *= plane.dot(at) / plane.dot(corner);
      if (volume > 0 && volume < least) least = volume, best = plane;
    }
    return best;
  }

  Mat3<double> axes_;
  PlacedPair<double> rough_;
  EnclosedPair<LensInterval> enclosed_;
  Rounding found_;
};

/// A direction of the round axes, and the inner polyhedron's corner there.
struct LensCorner {
  LensVector direction, at;

  [[nodiscard]] static LensCorner of(const Lens& lens, const LensVector& direction) {
    return {direction, lens.corner(direction)};
  }
};

/// The triangle's four parts, again and again.
bool add_triangles(const Lens& lens, Sums& sums, const std::array<LensCorner, 3>& corners, int level) {
  if (level == 0) return lens.add(sums, {corners[0].at, corners[1].at, corners[2].at});
  const auto between = [&](std::size_t i, std::size_t j) {
    return LensCorner::of(lens, (corners[i].direction + corners[j].direction).normalized());
  };
  const LensCorner ab = between(0, 1), bc = between(1, 2), ca = between(2, 0);
  return add_triangles(lens, sums, {corners[0], ab, ca}, level - 1) &&
         add_triangles(lens, sums, {ab, corners[1], bc}, level - 1) &&
         add_triangles(lens, sums, {ca, bc, corners[2]}, level - 1) &&
         add_triangles(lens, sums, {ab, bc, ca}, level - 1);
}

/// Over all cones, which fill space about the point inside because each triangle's determinant is proved positive.
bool add_octants(const Lens& lens, Sums& sums, int level) {
  for (int octant = 0; octant < 8; ++octant) {
    const auto sign = [&](int bit) { return (octant >> bit & 1) != 0 ? -1.0 : 1.0; };
    const auto on_axis = [&](int k) { return LensCorner::of(lens, sign(k) * LensVector::Unit(k)); };
    const LensCorner x = on_axis(0), y = on_axis(1), z = on_axis(2);
    const bool is_right_handed = sign(0) * sign(1) * sign(2) > 0;
    if (!add_triangles(lens, sums, {x, is_right_handed ? y : z, is_right_handed ? z : y}, level)) return false;
  }
  return true;
}

LensInterval cube_root(const LensInterval& x) {
  return positive_power<LensInterval>(x, LensInterval(1.0) / LensInterval(3.0));
}

}  // namespace

LensBounds bound_lens(const Pair& pair, const Contact<double>& contact, int level, const Mat3<double>& axes) {
  const StandardArithmetic mode;
  const Lens lens(pair, contact, axes);
  Sums sums;
  if (!lens.has_inside() || !add_octants(lens, sums, level)) return unknown_lens();
  const auto in_world = [&](const LensInterval& x) { return times_power_of_two<LensInterval>(x, lens.exponent()); };
  const LensInterval volume = hull<LensInterval>(low_end<LensInterval>(sums.inner), high_end<LensInterval>(sums.outer));
  const LensInterval in_unit = times_power_of_two<LensInterval>(volume, 3 * lens.exponent());
  LensBounds out{low(in_unit), high(in_unit), {}, {}, {}, {}};
  for (int i = 0; i < 3; ++i) {
    const LensInterval centre =
        in_world(LensInterval(lens.inside()[i]) + sums.first[i] / volume) + LensInterval(pair.body1.position[i]);
    out.centre_lower[i] = low(centre), out.centre_upper[i] = high(centre);
    const LensInterval middle = dot<LensInterval>(enclosed<LensInterval>(axes.col(i)), sums.first) / volume;
    const LensInterval moment =
        times_power_of_two<LensInterval>(sums.second[i] / volume - square<LensInterval>(middle), 2 * lens.exponent());
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
  const LensInterval at(pair.body2.position[axis]), here = root_of(pair);
  const LensInterval upper = (here - root_of(before)) / (at - LensInterval(before.body2.position[axis]));
  const LensInterval lower = (root_of(after) - here) / (LensInterval(after.body2.position[axis]) - at);
  const LensInterval area = -(LensInterval(3.0) * here * here *
                              hull<LensInterval>(low_end<LensInterval>(lower), high_end<LensInterval>(upper)));
  return {low(area), high(area)};
}

}  // namespace plumb::reference
