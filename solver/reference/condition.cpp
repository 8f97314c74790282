#include "solver/reference/condition.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

namespace plumb::reference {
namespace {

using R = Real50;
using Responses = Eigen::Matrix<R, 4, 3>;

struct Size {
  R normal, points;
};

/// How far the normal and the points move for the chart steps in `x` (one column a unit disturbance).
Size size_of_response(const PlacedPair<R>& pair, const ChartPair<R>& at, const Responses& x) {
  const SurfacePoint<R> s1 = surface_point<R>(pair.body1.shape, at.at1);
  const SurfacePoint<R> s2 = surface_point<R>(pair.body2.shape, at.at2);
  const R normal = (s1.dnormal * x.topRows<2>()).norm();
  const R point1 = (s1.dpoint * x.topRows<2>()).norm();
  const R point2 = (s2.dpoint * x.bottomRows<2>()).norm();
  return {normal, point1 > point2 ? point1 : point2};
}

/// Of less than full rank, to 50 digits: flat on flat lets the points slide and keeps the normal, a continuum of common
/// normals (bodies of revolution) turns it too.
bool normal_is_free(const PlacedPair<R>& pair, const ChartResidual<R>& f, const ChartPair<R>& at) {
  const Eigen::FullPivLU<Eigen::Matrix<R, 6, 4>> lu(f.jacobian);
  const Eigen::Matrix<R, 4, Eigen::Dynamic, 0, 4, 4> slides = lu.kernel();
  const R small("1e-15");
  return (surface_point<R>(pair.body1.shape, at.at1).dnormal * slides.topRows<2>()).norm() > small * slides.norm();
}

}  // namespace

// Disturbances: a translation of body 2 by e_k adds l x e_k to the second equation; a rotation about the contact point by
// e_k adds e_k x n2 to the first.
Condition condition_of(const PlacedPair<R>& pair, const Goal<R>& goal, const ChartPair<R>& at) {
  const ChartResidual<R> f = chart_residual<R>(pair, goal, at);
  const Vec3<R> l = collinear_with<R>(pair, goal, f);
  Eigen::Matrix<R, 6, 3> translation = Eigen::Matrix<R, 6, 3>::Zero(), rotation = translation;
  for (int k = 0; k < 3; ++k) {
    const Vec3<R> e = Vec3<R>::Unit(k);
    translation.col(k).tail<3>() = l.cross(e);
    rotation.col(k).head<3>() = e.cross(f.normal1);
  }
  const Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<R, 6, 4>> solver(f.jacobian);
  const R size = pair.size();
  const Size by_translation = size_of_response(pair, at, solver.solve(translation));
  const Size by_rotation = size_of_response(pair, at, solver.solve(rotation));
  Condition out;
  out.normal = static_cast<double>(R(1) + size * by_translation.normal + by_rotation.normal);
  if (solver.rank() == 4)
    out.points = static_cast<double>(R(1) + by_translation.points + by_rotation.points / size);
  else if (normal_is_free(pair, f, at))
    out.normal = std::numeric_limits<double>::infinity();
  return out;
}

}  // namespace plumb::reference
