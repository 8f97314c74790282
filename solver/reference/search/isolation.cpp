#include "solver/reference/search/isolation.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "solver/reference/frame.hpp"
#include "solver/reference/interval/digits.hpp"
#include "solver/reference/proof/verify.hpp"
#include "solver/reference/search/plane_map.hpp"

namespace plumb::reference {
namespace {

using Look = RoughInterval;
using Check = Interval18;
using Fine = Interval80;

constexpr int widest_level = 2, narrowest_level = 44;  // of the squares tried, half = 2^-level
constexpr int widest_level_by_signs = 20,
              narrowest_level_by_signs = 50;  // wider boxes say too little about the direction
constexpr double wide_region = 1.0 / 32;      // wide enough not to look for better
constexpr double ridge_width = 1.0 / 32;      // of a unit normal's component, for a ridge to be tried

/// Whether the columns are orthonormal to a sixteenth.
bool is_nearly_orthonormal(const Mat3<double>& frame) {
  const IMat3<Check> f = frame.cast<Check>();
  const IMat3<Check> gram = f.transpose() * f;
  for (int i = 0; i < 3; ++i) {
    Check sum(0.0);
    for (int j = 0; j < 3; ++j) sum += magnitude<Check>(Check(gram(i, j) - Check(i == j ? 1.0 : 0.0)));
    if (!(high(sum) < 1.0 / 16)) return false;
  }
  return true;
}

/// A frame about n whose first two axes are along the eigenvectors of the Hessian of o.
Mat3<double> principal_frame(const EnclosedPair<Look>& pair, const Vec3<double>& n) {
  Mat3<double> f = frame_about(n);
  const ChartedPair<Look> charted(pair, {f});
  const IMat2<Look> j = PlaneMap<Look>(charted, {f}).jacobian(charted, direction_box<Look>(charted, {0.0, 0.0, 1.0}));
  Eigen::Matrix2d m;
  m << j(0, 0).lower, (j(0, 1).lower + j(1, 0).lower) / 2, (j(0, 1).lower + j(1, 0).lower) / 2, j(1, 1).lower;
  if (!m.allFinite()) return f;
  Eigen::Matrix2d turn = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(m).eigenvectors();
  if (turn.determinant() < 0) turn.col(1) *= -1;
  const Eigen::Matrix<double, 3, 2> turned = f.leftCols<2>() * turn;
  f.leftCols<2>() = turned;
  return f;
}

/// A frame in a body's own axes for a direction near the plane across its axis k, where second derivatives along that axis may
/// be infinite: the first column is the axis, the others are in the plane.
DirectionFrame ridge_frame(int body, int k, const Vec3<double>& n, bool aligned) {
  Vec3<double> along = n;
  along[k] = 0;
  along.normalize();
  Mat3<double> f;
  f << Vec3<double>::Unit(k), along.cross(Vec3<double>::Unit(k)), along;
  return {f, body, aligned};
}

/// The chart point v with L v parallel to n, third component 1, to the digits of n.
IVec3<Fine> chart_point(const Mat3<double>& frame, const Vec3<Real50>& n) {
  const Vec3<Real50> v = in_frame<Real50>(frame, n);
  return enclosed<Fine>(Vec3<Real50>(v / v[2]));
}

/// The widest of the squares tried about the normal, above `beyond`, of which `is_proved` holds; 0: none.
template <class Proof>
double widest_square(double beyond, const Proof& is_proved) {
  for (int level = widest_level; level < narrowest_level && std::ldexp(1, -level) > beyond; ++level)
    if (is_proved(std::ldexp(1, -level))) return std::ldexp(1, -level);
  return 0;
}

/// The widest square with one stationary direction at most.
double widest_by_slopes(const ChartedPair<Look>& look, const ChartedPair<Check>& check, const DirectionFrame& frame) {
  return widest_square(0, [&](double half) {
    return has_one_zero_at_most<Look>(look, frame, half) && has_one_zero_at_most<Check>(check, frame, half);
  });
}

/// The same above `beyond`, of bodies of revolution by their axes.
double widest_by_axes(const ChartedPair<Look>& look, const ChartedPair<Check>& check, const DirectionFrame& frame,
                      double beyond) {
  return widest_square(beyond, [&](double half) {
    for (int body = 0; body < 2; ++body) {
      const auto own = check.body(static_cast<std::size_t>(body)).axis;
      const int axis = 3 * body + own.value_or(0);
      if (own && has_one_zero_at_most<Look>(look, frame, axis, half) &&
          has_one_zero_at_most<Check>(check, frame, axis, half))
        return true;
    }
    return false;
  });
}

/// A square of directions that is proved to hold a stationary one, by Krawczyk's operator.
std::optional<IVec3<Fine>> contract(const ChartedPair<Fine>& pair, const PlaneMap<Fine>& map, const IVec3<Fine>& v) {
  const DirectionBox<Fine> at = direction_box<Fine>(pair, v);
  const IMat2<Fine> slope = map.jacobian(pair, at);
  const auto number = [](const Fine& x) { return (low(x) + high(x)) / 2; };
  Eigen::Matrix2d m;
  m << number(slope(0, 0)), number(slope(0, 1)), number(slope(1, 0)), number(slope(1, 1));
  const Eigen::Matrix2d inverse = m.inverse();
  if (!inverse.allFinite()) return {};
  IMat2<Fine> y;
  for (int i = 0; i < 4; ++i) y(i / 2, i % 2) = Fine(inverse(i / 2, i % 2));
  const IVec2<Fine> newton = y * map.value(at);
  const auto first_half = [&](int k) {
    return 4 * high(magnitude<Fine>(newton[k])) + 1e-30 * high(magnitude<Fine>(v[k])) + 1e-60;
  };
  std::array<double, 2> half{first_half(0), first_half(1)};
  for (int i = 0; i < 6; ++i, half[0] *= 1024, half[1] *= 1024) {
    IVec3<Fine> box = v;
    const std::array<Fine, 2> reach{hull<Fine>(-half[0], half[0]), hull<Fine>(-half[1], half[1])};
    for (const int k : {0, 1}) box[k] += reach[static_cast<std::size_t>(k)];
    const IMat2<Fine> product = y * map.jacobian(pair, direction_box<Fine>(pair, box));
    bool inside = true;
    IVec3<Fine> next = v;
    for (const int k : {0, 1}) {
      Fine step = -newton[k];
      for (const int l : {0, 1})
        step += (Fine(k == l ? 1.0 : 0.0) - product(k, l)) * reach[static_cast<std::size_t>(l)];
      inside &= high(magnitude<Fine>(step)) < half[static_cast<std::size_t>(k)];
      next[k] += step;
    }
    if (inside) return next;
  }
  return {};
}

/// det J has the sign of the Hessian's determinant: the two bases of the plane that it is written in are turned alike.
std::optional<StationaryKind> kind_of(const ChartedPair<Fine>& pair, const PlaneMap<Fine>& map, const IVec3<Fine>& v,
                                      const DirectionFrame& frame) {
  const DirectionBox<Fine> box = direction_box<Fine>(pair, v);
  const IMat2<Fine> j = map.jacobian(pair, box);
  const Fine determinant = j(0, 0) * j(1, 1) - j(0, 1) * j(1, 0);
  if (is_positive(Fine(-determinant))) return StationaryKind::saddle;
  if (!is_positive(determinant)) return {};
  const Fine bending = bending_of<Fine>(pair, box, frame.columns.col(0));
  if (is_positive(bending)) return StationaryKind::minimum;
  if (is_positive(Fine(-bending))) return StationaryKind::maximum;
  return {};
}

// det J has the sign of J11 J22 where has_one_zero_at_most holds. For the sign of a definite Hessian M: J = b'M f with bases b
// and f of the plane across d that differ by little in a small box of a nearly orthonormal frame, and a definite M keeps its
// sign in M (1 + e) as long as |e| < 1.
StationaryKind kind_of_region(const ChartedPair<Check>& pair, const PlaneMap<Check>& map, const IVec3<Check>& box) {
  const IMat2<Check> j = map.jacobian(pair, direction_box<Check>(pair, box));
  if ((low(j(0, 0)) > 0) != (low(j(1, 1)) > 0)) return StationaryKind::saddle;
  return low(j(0, 0)) > 0 ? StationaryKind::minimum : StationaryKind::maximum;
}

// Miranda: phi1 has opposite signs on the sides x = -half and x = half, phi2 on y = -half and y = half.
bool has_zero_by_signs(const ChartedPair<Check>& pair, const PlaneMap<Check>& map, double half) {
  const Check reach = hull<Check>(-half, half);
  const auto sign_on_side = [&](int k, double end) {
    IVec3<Check> middle{Check(0.0), Check(0.0), Check(1.0)}, side = middle;
    middle[k] = side[k] = Check(end);
    side[1 - k] = reach;
    const Functional<Check>& phi = map.phi[static_cast<std::size_t>(k)];
    const Check value = value_of<Check>(direction_box<Check>(pair, middle), phi) +
                        slope_of<Check>(pair, direction_box<Check>(pair, side), phi, 1 - k) * reach;
    return low(value) > 0 ? 1 : (high(value) < 0 ? -1 : 0);
  };
  for (const int k : {0, 1})
    if (sign_on_side(k, -half) * sign_on_side(k, half) != -1) return false;
  return true;
}

/// The middle of x, and how far x reaches from it.
struct Ball {
  Vec3<Real50> centre;
  double radius;
};

Ball ball_about(const IVec3<Fine>& x) {
  Ball out;
  for (int i = 0; i < 3; ++i) out.centre[i] = middle<Real50>(x[i]);
  out.radius = farthest(x, out.centre);
  return out;
}

/// What is known of a pair whose direction lies in a box of chart points; `overlap` in the pair's lengths.
StationaryPair reported(const Pair& pair, const ChartedPair<Fine>& charted, const IVec3<Fine>& v, StationaryKind kind,
                        const std::optional<Fine>& overlap) {
  const DirectionBox<Fine> box = direction_box<Fine>(charted, v);
  const IVec3<Fine> d = charted.frame * v;
  const IVec3<Fine> normal = d / length_of(d);
  const IVec3<Fine> point1 = charted.pair.body1.rotation * box.bodies[0].point;
  const IVec3<Fine> point2 = charted.pair.body2.rotation * box.bodies[1].point + charted.pair.centre;
  const Fine along = dot<Fine>(normal, point1 - point2);
  const Fine world = times_power_of_two<Fine>(overlap.value_or(along), charted.pair.exponent);
  const Ball n = ball_about(normal), p1 = ball_about(charted.pair.to_world_point(point1, pair)),
             p2 = ball_about(charted.pair.to_world_point(point2, pair));
  return {kind,      low_as<Real50>(world),         high_as<Real50>(world), n.centre, n.radius, p1.centre,
          p2.centre, std::max(p1.radius, p2.radius)};
}

IVec3<Check> narrowed(const IVec3<Fine>& v) {
  return v.unaryExpr([](const Fine& x) {
    Check out;
    mpfi_set(out.data(), x.data());
    return out;
  });
}

/// The widest square above `beyond` on which o is proved convex, as it may be where second derivatives are infinite.
double widest_convex(const EnclosedPair<Check>& pair, const Mat3<double>& frame, const IVec3<Check>& v, double beyond) {
  const FramedPair<Check> framed(pair, frame);
  return widest_square(beyond,
                       [&](double half) { return verify_region<Check>(framed, Cell{2, 1, 0, 0, half}, v).located; });
}

template <class I>
bool is_in_region(const EnclosedPair<I>& pair, const IVec3<I>& direction, const Isolated& region) {
  const int base = region.frame.base;
  if (base < 0) return is_within<I>(region.frame.columns, direction, region.half);
  const IMat3<I>& turn = base == 0 ? pair.body1.rotation : pair.body2.rotation;
  return is_within<I>(region.frame.columns, IVec3<I>(turn.transpose() * direction), region.half);
}

}  // namespace

template <class I>
bool is_inside_region(const ChartedPair<I>& search, const Cell& cell, const Isolated& region) {
  for (const double du : {-1.0, 1.0})
    for (const double dv : {-1.0, 1.0}) {
      const IVec3<I> corner = search.frame * enclosed<I>(cell.at(du, dv));
      if (!is_in_region<I>(search.pair, corner, region)) return false;
    }
  return true;
}

bool lies_in_region(const EnclosedPair<Look>& pair, const Vec3<double>& direction, const Isolated& region) {
  return is_in_region<Look>(pair, enclosed<Look>(direction), region);
}

Isolator::Isolator(const Pair& pair)
    : pair_(pair), placed_(place<Real50>(pair)), fine_(enclose<Fine>(pair)), coarse_(enclose<Check>(pair)),
      rough_(rounded(coarse_)) {}

std::optional<Isolated> Isolator::isolate_in(const DirectionFrame& frame, const IVec3<Fine>& v) const {
  const ChartedPair<Check> check(coarse_, frame);
  const ChartedPair<Look> look(rough_, frame);
  const double half_by_slopes = widest_by_slopes(look, check, frame);
  const double half = std::max(half_by_slopes, widest_by_axes(look, check, frame, half_by_slopes));
  if (!(half > 0)) return {};
  const auto is_in_square = [&](const IVec3<Fine>& box) {
    return is_within<Fine>(frame.columns, IVec3<Fine>(frame.columns.cast<Fine>() * box), half);
  };
  const ChartedPair<Fine> charted(fine_, frame);
  const PlaneMap<Fine> map(charted, frame);
  if (const auto box = contract(charted, map, v); box && is_in_square(*box))
    if (const auto kind = kind_of(charted, map, *box, frame))
      return Isolated{reported(pair_, charted, *box, *kind, std::nullopt), frame, half};
  const PlaneMap<Check> rough_map(check, frame);
  if (!is_nearly_orthonormal(frame.columns)) return {};
  for (int level = narrowest_level_by_signs; level >= widest_level_by_signs; --level) {
    const double small = std::ldexp(1, -level);
    if (small > half_by_slopes) break;
    const bool holds_solution = is_within<Fine>(frame.columns, frame.columns.cast<Fine>() * v, small);
    if (!holds_solution || !has_zero_by_signs(check, rough_map, small)) continue;
    const StationaryKind kind = kind_of_region(check, rough_map, square_about_axis<Check>(small));
    const IVec3<Fine> box = square_about_axis<Fine>(small);
    return Isolated{reported(pair_, charted, box, kind, std::nullopt), frame, half};
  }
  return {};
}

// The widest square proved serves the cover, the narrowest the answer.
std::optional<Isolated> Isolator::isolate_convex(const Mat3<double>& frame, const IVec3<Fine>& v) const {
  const FramedPair<Check> check(coarse_, frame);
  const FramedPair<Fine> framed(fine_, frame);
  double widest = 0;
  RegionProof<Fine> best;
  for (int level = widest_level; level < narrowest_level; level += widest > 0 ? 8 : 1) {
    const Cell region{2, 1, 0, 0, std::ldexp(1, -level)};
    if (!is_positive(verify_region<Check>(check, region, narrowed(v)).curvature)) continue;
    const RegionProof<Fine> proof = verify_region<Fine>(framed, region, v);
    if (!proof.located) continue;
    best = proof;
    widest = std::max(widest, region.half);
  }
  if (!(widest > 0)) return {};
  IVec3<Fine> about = v;
  for (const int k : {0, 1}) about[k] += hull<Fine>(Fine(-best.radius), best.radius);
  const Fine overlap = hull<Fine>(Fine(best.value - best.deficit), best.value);
  return Isolated{reported(pair_, {fine_, {frame}}, about, StationaryKind::minimum, overlap), {frame}, widest};
}

std::optional<Isolated> Isolator::isolate(const ChartPair<Real50>& at) const {
  const Vec3<Real50> normal1 = surface_point<Real50>(placed_.body1.shape, at.at1).normal;
  const Vec3<Real50> normal2 = surface_point<Real50>(placed_.body2.shape, at.at2).normal;
  const Vec3<Real50> world = placed_.body1.to_pair_direction(normal1);
  const DirectionFrame frame{principal_frame(rough_, world.cast<double>())};
  const IVec3<Fine> v = chart_point(frame.columns, world);
  std::optional<Isolated> best = isolate_in(frame, v);
  const auto keep = [&](const std::optional<Isolated>& other) {
    if (other && (!best || other->half > best->half)) best = other;
  };
  if (best && best->half >= wide_region) return best;
  const bool aligned = pair_.body1.quaternion == pair_.body2.quaternion;
  for (int body = 0; body < 2; ++body) {
    const Vec3<Real50> own = body == 0 ? normal1 : Vec3<Real50>(-normal2);
    for (int k = 0; k < 3; ++k) {
      if (abs(own[k]) > ridge_width) continue;
      const DirectionFrame ridge = ridge_frame(body, k, own.cast<double>(), aligned);
      keep(isolate_in(ridge, chart_point(ridge.columns, own)));
    }
  }
  if (!best) return isolate_convex(frame.columns, v);
  if (best->pair.kind != StationaryKind::minimum || best->frame.base >= 0) return best;
  best->half = std::max(best->half, widest_convex(coarse_, frame.columns, narrowed(v), best->half));
  return best;
}

std::optional<ChartPair<Real50>> Isolator::zero_near(const Vec3<double>& n) const {
  if (!fine_.body1.axis || !fine_.body2.axis) return {};
  const DirectionFrame frame{frame_about(n)};
  const ChartedPair<Fine> charted(fine_, frame);
  const PlaneMap<Fine> map = map_about<Fine>(charted, frame, *fine_.body1.axis);
  Eigen::Matrix<Real50, 2, 1> at = Eigen::Matrix<Real50, 2, 1>::Zero();
  const Real50 farthest_zero = 0.05, last_step = 1e-30;
  for (int i = 0; i < 16; ++i) {
    const Vec3<Real50> v(at[0], at[1], Real50(1));
    const DirectionBox<Fine> box = direction_box<Fine>(charted, enclosed<Fine>(v));
    const auto number = [](const Fine& x) { return middle<Real50>(x); };
    const Eigen::Matrix<Real50, 2, 2> slope = map.jacobian(charted, box).unaryExpr(number);
    const Eigen::Matrix<Real50, 2, 1> step = slope.inverse() * map.value(box).unaryExpr(number);
    at -= step;
    if (!(at.norm() < farthest_zero)) return {};
    if (!(step.norm() < last_step)) continue;
    const Vec3<Real50> normal = frame.columns.cast<Real50>() * Vec3<Real50>(at[0], at[1], Real50(1));
    return charts_of_direction<Real50>(placed_, normal.normalized());
  }
  return {};
}

template bool is_inside_region(const ChartedPair<Look>&, const Cell&, const Isolated&);
template bool is_inside_region(const ChartedPair<Check>&, const Cell&, const Isolated&);

}  // namespace plumb::reference
