// The common normal's four equations at a pair of surface points: zero at a certified common normal, and their derivatives
// against differences in 50 digits.
#include "solver/method/auto/surface/surface_equations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "solver/reference/real.hpp"
#include "solver/reference/reference.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::surface_equations_tests {
namespace {

using Fine = Real50;

template <class S>
SuperellipsoidPair<S> surfaces(const Pair& pair) {
  const Superellipsoid<double>&one = pair.body1.shape, &two = pair.body2.shape;
  return superellipsoid_pair<S>(framed_pair<S>(pair, PairFrame<S>(pair)), per_body<S>(S(one.n1), S(two.n1)),
                                per_body<S>(S(one.n2), S(two.n2)));
}

/// Where the normals are n and -n.
template <class S>
Surfaces<S> at_normal(const SuperellipsoidPair<S>& pair, const Vector3<S>& n) {
  return surfaces_at<S>(pair, pair.inner, pair.outer, times(to_body_axes(pair, n), pair.semi_axes), Mask<S>(true));
}

template <class S>
SurfaceEquations<S> equations_at(const SuperellipsoidPair<S>& pair, const Surfaces<S>& at) {
  SurfaceEquations<S> out;
  set_equations<S>(pair, at, out);
  return out;
}

/// The surfaces after a step of one coordinate, d0 or d1, of one body. d0: c of the outer arc along its tangent; d1: of the
/// inner one, divided by the outer's a.
Surfaces<Fine> moved(const SuperellipsoidPair<Fine>& pair, const Surfaces<Fine>& at, int body, int coordinate,
                     const Fine& step) {
  const ArcPoint<Fine>&i = at.inner, &o = at.outer;
  const PerBody<Fine> by = body == 0 ? per_body<Fine>(step, Fine(0)) : per_body<Fine>(Fine(0), step);
  const Vector3<PerBody<Fine>> along = coordinate == 0 ? Vector3<PerBody<Fine>>{-o.gb * i.ca, -o.gb * i.cb, o.ga}
                                                       : Vector3<PerBody<Fine>>{-i.gb, i.ga, PerBody<Fine>(Fine(0))};
  const Vector3<PerBody<Fine>> w = chart_of<Fine>(at);
  return surfaces_of_chart<Fine>(pair, pair.inner, pair.outer,
                                 {w.x + along.x * by, w.y + along.y * by, w.z + along.z * by});
}

const Fine difference_step("1e-17");

/// Of any numbers that follow the surfaces, by a central difference.
template <class Values>
auto slope_of(const SuperellipsoidPair<Fine>& pair, const Surfaces<Fine>& at, int body, int coordinate, Values values) {
  auto ahead = values(moved(pair, at, body, coordinate, difference_step));
  const auto behind = values(moved(pair, at, body, coordinate, -difference_step));
  for (std::size_t k = 0; k < ahead.size(); ++k) ahead[k] = (ahead[k] - behind[k]) / (2 * difference_step);
  return ahead;
}

Pair draw_pair(Stream& stream) {
  static constexpr std::array exponents{1.2, 1.7, 2.0, 3.0, 8.0, 30.0};
  Pair pair;
  for (Body* body : {&pair.body1, &pair.body2}) {
    body->shape = random_ellipsoid(stream, 4);
    body->shape.n1 = stream.pick(exponents);
    body->shape.n2 = stream.pick(exponents);
    body->quaternion = random_rotation(stream);
  }
  pair.body2.position = random_direction(stream) * stream.uniform(0.2, 1.5);
  return pair;
}

/// Not beside a fold, where second derivatives have no bound.
bool is_inside_an_octant(const Surfaces<Fine>& at) {
  return all_of(min(at.inner.t, at.outer.t) > Fine(0.02)) && all_of(abs(at.outer.ca) > Fine(0.02));
}

/// Points and unit normals along the equations' own two directions, body by body: what Newton's system is made of.
TEST(SurfaceEquations, DerivativesOfPointsAndNormalsAreTheirDifferences) {
  int tried = 0;
  Stream stream("derivatives", 1, 0);
  for (int draw = 0; draw < 60; ++draw) {
    const SuperellipsoidPair<Fine> pair = surfaces<Fine>(draw_pair(stream));
    const Vec3<Fine> n = random_direction(stream).cast<Fine>().normalized();
    const Vec3<Fine> beside = (n + 0.2 * random_direction(stream).cast<Fine>()).normalized();  // no common normal
    Surfaces<Fine> at = at_normal<Fine>(pair, Vector3<Fine>::of(n));
    const Vector3<PerBody<Fine>> other = chart_of<Fine>(at_normal<Fine>(pair, Vector3<Fine>::of(beside)));
    const Vector3<PerBody<Fine>> own = chart_of<Fine>(at);
    const auto mixed = [](const PerBody<Fine>& a, const PerBody<Fine>& b) { return per_body<Fine>(a[0], b[1]); };
    at = surfaces_of_chart<Fine>(pair, pair.inner, pair.outer,
                                 {mixed(own.x, other.x), mixed(own.y, other.y), mixed(own.z, other.z)});
    if (!is_inside_an_octant(at)) continue;
    ++tried;
    const SurfaceEquations<Fine> f = equations_at<Fine>(pair, at);
    for (int body = 0; body < 2; ++body)
      for (int coordinate = 0; coordinate < 2; ++coordinate) {
        const auto values = [&](const Surfaces<Fine>& there) {
          const Vector3<PerBody<Fine>> normals = pair.rotation * there.normal * inverse_length<Fine>(there.normal);
          const Vector3<PerBody<Fine>> points = pair.rotation * there.point;
          const auto of = [&](const Vector3<PerBody<Fine>>& v) { return body == 0 ? first(v) : second(v); };
          return std::array<Fine, 4>{dot(f.across[0], of(normals)), dot(f.across[1], of(normals)),
                                     dot(f.across[0], of(points)), dot(f.across[1], of(points))};
        };
        const std::array<Fine, 4> slope = slope_of(pair, at, body, coordinate, values);
        for (std::size_t k = 0; k < 2; ++k) {
          const auto c = static_cast<std::size_t>(coordinate);
          const Fine dnormal = f.dnormal[k][c][body], dpoint = f.dpoint[k][c][body];
          EXPECT_LE(abs(Fine(dnormal - slope[k])), Fine("1e-20") * (1 + abs(dnormal))) << draw;
          EXPECT_LE(abs(Fine(dpoint - slope[2 + k])), Fine("1e-20") * (1 + abs(dpoint))) << draw;
        }
      }
  }
  EXPECT_GT(tried, 20);
}

/// Pairs whose common normal is certified to 1e-40, with the surfaces there.
struct Certified {
  Case from;
  Reference reference;
  SuperellipsoidPair<Fine> pair;
  Surfaces<Fine> at;

  Certified(std::string_view family, std::uint64_t index)
      : from(generate(family, 41, index)), reference(find_reference(from.pair)), pair(surfaces<Fine>(from.pair)),
        at(at_normal<Fine>(pair, Vector3<Fine>::of(reference.common_normal.normal))) {}

  [[nodiscard]] bool is_sharp() const {
    return reference.common_normal.proved && reference.common_normal.normal_radius < 1e-40 && is_inside_an_octant(at);
  }
};

std::vector<Certified> certified_pairs() {
  std::vector<Certified> out;
  for (const std::string_view family : {"ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 8; ++i)
      if (Certified found(family, i); found.is_sharp()) out.push_back(std::move(found));
  return out;
}

TEST(SurfaceEquations, VanishAtACertifiedCommonNormalAndNotBesideIt) {
  const std::vector<Certified> pairs = certified_pairs();
  ASSERT_GT(pairs.size(), 7U);
  for (const Certified& c : pairs) {
    const SurfaceEquations<Fine> f = equations_at<Fine>(c.pair, c.at);
    EXPECT_LE(f.twist, Fine("1e-45")) << c.from.name;
    EXPECT_LE(f.slope, Fine("1e-30")) << c.from.name;  // the points follow the normal by a power of it
    EXPECT_TRUE(f.opposite);
    const Fine overlap = PairFrame<Fine>(c.from.pair).to_world_length(f.overlap);
    EXPECT_LE(abs(Fine(overlap - c.reference.common_normal.overlap)), Fine("1e-30")) << c.from.name;
    EXPECT_TRUE(is_minimum<Fine>(c.pair, f)) << c.from.name;
    const Vec3<Fine> n = c.reference.common_normal.normal;
    const Vec3<Fine> off = (n + Fine(1e-3) * n.unitOrthogonal()).normalized();
    EXPECT_GE(equations_at<Fine>(c.pair, at_normal<Fine>(c.pair, Vector3<Fine>::of(off))).slope, Fine("1e-6"))
        << c.from.name;
  }
}

/// Newton's system at a common normal, where t turns with m, column by column.
TEST(SurfaceEquations, NewtonsSystemIsTheJacobianAtACommonNormal) {
  for (const Certified& c : certified_pairs()) {
    const SurfaceEquations<Fine> f = equations_at<Fine>(c.pair, c.at);
    const std::array<Equation4<Fine>, 4> system = newton_system<Fine>(f, f.overlap);
    for (int body = 0; body < 2; ++body)
      for (int coordinate = 0; coordinate < 2; ++coordinate) {
        const std::size_t column = 2 * static_cast<std::size_t>(body) + static_cast<std::size_t>(coordinate);
        const auto values = [&](const Surfaces<Fine>& at) { return equations_at<Fine>(c.pair, at).value; };
        const std::array<Fine, 4> slope = slope_of(c.pair, c.at, body, coordinate, values);
        for (std::size_t k = 0; k < 4; ++k)
          EXPECT_LE(abs(Fine(system[k].row[column] - slope[k])), Fine("1e-19") * (1 + abs(slope[k])))
              << c.from.name << ", equation " << k << ", column " << column;
      }
  }
}

/// In double the same numbers.
TEST(SurfaceEquations, InDoubleTheyAreThoseOfFiftyDigits) {
  Stream stream("double", 1, 0);
  for (int draw = 0; draw < 200; ++draw) {
    const Pair drawn = draw_pair(stream);
    const Vec3<double> n = random_direction(stream);
    const SuperellipsoidPair<Fine> fine = surfaces<Fine>(drawn);
    const Surfaces<Fine> fine_at = at_normal<Fine>(fine, Vector3<Fine>::of(n.cast<Fine>()));
    if (!is_inside_an_octant(fine_at)) continue;
    const SuperellipsoidPair<double> pair = surfaces<double>(drawn);
    const SurfaceEquations<double> f = equations_at<double>(pair, at_normal<double>(pair, Vector3<double>::of(n)));
    const SurfaceEquations<Fine> truth = equations_at<Fine>(fine, fine_at);
    EXPECT_NEAR(f.overlap, static_cast<double>(truth.overlap), 1e-12) << draw;
    EXPECT_LE(f.twist, 1e-13) << draw;
    EXPECT_NEAR(f.slope, static_cast<double>(truth.slope), 1e-11) << draw;
  }
}

/// E'(H1 + H2)E from the surfaces against the support functions' own second derivative.
TEST(SurfaceEquations, TheHessianIsThatOfTheSupportFunctions) {
  Stream stream("hessian", 1, 0);
  int tried = 0;
  for (int draw = 0; draw < 200; ++draw) {
    const Pair drawn = draw_pair(stream);
    const Vec3<double> n = random_direction(stream);
    const SuperellipsoidPair<double> pair = surfaces<double>(drawn);
    const SurfaceEquations<double> f = equations_at<double>(pair, at_normal<double>(pair, Vector3<double>::of(n)));
    const PlacedPair<double> placed = place<double>(drawn);
    Mat3<double> sum = Mat3<double>::Zero();
    for (const PlacedBody<double>* body : {&placed.body1, &placed.body2})
      sum += body->rotation * support_hessian<double>(body->shape, body->to_body_direction(n)).hessian *
             body->rotation.transpose();
    Tangent<double> basis;
    basis << f.across[0].eigen(), f.across[1].eigen();
    const Eigen::Matrix2d expected = basis.transpose() * sum * basis;
    if (!(expected.norm() < 1e3)) continue;  // near a flat, which counts as 1e8 sizes
    ++tried;
    const PlaneHessian<double> found = hessian_of<double>(pair, f);
    const double allowed = 1e-4 * expected.norm();  // 1e-8 of its square
    EXPECT_NEAR(found.xx, expected(0, 0), allowed) << draw;
    EXPECT_NEAR(found.xy, expected(0, 1), allowed) << draw;
    EXPECT_NEAR(found.yy, expected(1, 1), allowed) << draw;
    const double lower = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(expected).eigenvalues()[0];
    EXPECT_NEAR(found.lower_eigenvalue(), lower, allowed) << draw;
    EXPECT_NEAR(found.along(2, 1), Eigen::Vector2d(2, 1).dot(expected * Eigen::Vector2d(2, 1)) / 5, allowed) << draw;
  }
  EXPECT_GT(tried, 100);
}

/// Equal concentric ellipsoids: a minimum at the shortest axis, saddles at the middle one, maxima at the longest.
TEST(SurfaceEquations, AMinimumIsToldFromASaddleAndAMaximum) {
  Pair pair;
  pair.body1.shape.semi_axes = pair.body2.shape.semi_axes = {1.5, 0.4, 1};
  pair.body1.quaternion = pair.body2.quaternion = {0.3, 0.1, -0.5, 0.7};
  const Mat3<double> axes = rotation<double>(pair.body1.quaternion);
  const SuperellipsoidPair<double> own = surfaces<double>(pair);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      const Vec3<double> n = sign * axes.col(axis);
      const SurfaceEquations<double> f = equations_at<double>(own, at_normal<double>(own, Vector3<double>::of(n)));
      EXPECT_LE(f.slope, 1e-14);
      EXPECT_NEAR(f.overlap, 2 * pair.body1.shape.semi_axes[axis], 1e-14);
      EXPECT_EQ(is_minimum<double>(own, f), axis == 1);
    }
}

/// Against a rank-revealing elimination, with zeros where a pivot would be.
TEST(SurfaceEquations, FourEquationsAreSolved) {
  Stream stream("solve4", 1, 0);
  for (int draw = 0; draw < 500; ++draw) {
    Eigen::Matrix4d m;
    Eigen::Vector4d right;
    for (int i = 0; i < 4; ++i) {
      right[i] = stream.uniform(-1, 1);
      for (int j = 0; j < 4; ++j) m(i, j) = stream.chance(0.3) ? 0 : stream.signed_log_uniform(1e-3, 1);
    }
    const Eigen::FullPivLU<Eigen::Matrix4d> lu(m);
    if (!lu.isInvertible() || lu.rcond() < 1e-6) continue;
    std::array<Equation4<double>, 4> system;
    for (std::size_t i = 0; i < 4; ++i)
      system[i] = {{m(i, 0), m(i, 1), m(i, 2), m(i, 3)}, right[static_cast<Eigen::Index>(i)]};
    const std::array<double, 4> found = solve4<double>(system);
    const Eigen::Vector4d x(found[0], found[1], found[2], found[3]);
    EXPECT_LE((x - lu.solve(right)).norm(), 1e-8 * x.norm()) << draw;
  }
}

}  // namespace
}  // namespace plumb::surface_equations_tests
