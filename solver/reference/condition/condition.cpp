#include "solver/reference/condition/condition.hpp"

#include "solver/least_squares.hpp"
#include "solver/reference/condition/sensitivity.hpp"
#include "solver/reference/real.hpp"

namespace plumb::reference {
namespace {

/// lambda of the exponents (sensitivity.hpp) times p and n; zero where the coordinate is zero.
template <class S>
void set_by_exponents(SurfaceJet<S>& jet, const Superellipsoid<S>& shape) {
  using std::log;
  const Vec3<S> v = detail::divide<S>(jet.point, shape).cwiseAbs();
  const S rho = pair_norm<S>(v[0], v[1], Exponent<S>::primal(shape.n2));
  const auto log_or_zero = [](const S& x) { return x > S(0) ? S(log(x)) : S(0); };
  const S outer = log_or_zero(rho);
  const Vec3<S> by_n1{outer, outer, log_or_zero(v[2])};
  const Vec3<S> by_n2{v[0] > S(0) ? S(log(v[0] / rho)) : S(0), v[1] > S(0) ? S(log(v[1] / rho)) : S(0), S(0)};
  int column = 3;
  for (const Vec3<S>& lambda : {by_n1, by_n2}) {
    const Vec3<S> turn = lambda.cwiseProduct(jet.normal);
    jet.point_by_shape.col(column) = -lambda.cwiseProduct(jet.point);
    jet.normal_by_shape.col(column++) = turn - jet.normal * jet.normal.dot(turn);
  }
}

template <class S>
SurfaceJet<S> surface_jet(const PlacedBody<S>& body, const CubePoint<S>& at) {
  const SurfacePoint<S> s = surface_point<S>(body.shape, at);
  SurfaceJet<S> jet{s.point, s.normal, s.dpoint, s.dnormal, ByShape<S>::Zero(), ByShape<S>::Zero()};
  for (int i = 0; i < 3; ++i) {
    jet.point_by_shape(i, i) = s.point[i];
    jet.normal_by_shape.col(i) = s.normal * (s.normal[i] * s.normal[i]);
    jet.normal_by_shape(i, i) -= s.normal[i];
  }
  set_by_exponents<S>(jet, body.shape);
  return jet.turned(body.rotation);
}

/// From 1 / epsilon on a change that no double shows may move the answer anywhere: as good as infinite.
template <class S>
double factor(const S& x) {
  return x < S(1 / machine_epsilon) ? static_cast<double>(x) : std::numeric_limits<double>::infinity();
}

/// Of less than full rank: flat on flat lets the points slide and keeps the normal, a continuum of common normals (bodies
/// of revolution) turns it too.
template <class S>
bool normal_is_free(const ContactJet<S>& at, const Eigen::Matrix<S, 6, 4>& jacobian) {
  using std::pow;
  const DenseMatrix<S> slides = null_space<S>(jacobian);
  const S small = pow(epsilon<S>(), S(0.3));
  for (Eigen::Index k = 0; k < slides.cols(); ++k) {
    const Vec3<S> turn = at.body1.dnormal.col(0) * slides(0, k) + at.body1.dnormal.col(1) * slides(1, k);
    if (turn.norm() > small * slides.col(k).norm()) return true;
  }
  return false;
}

}  // namespace

template <class S>
Condition condition_of(const PlacedPair<S>& pair, const Goal<S>& goal, const ChartPair<S>& at) {
  const ContactJet<S> jet{surface_jet<S>(pair.body1, at.at1), surface_jet<S>(pair.body2, at.at2), pair.body2.centre,
                          pair.size()};
  const Linearised<S> by = linearised<S>(jet, goal);
  const LeastSquares<S> response = shortest_least_squares<S>(by.jacobian, by.change);
  const Magnitudes<S> found = magnitudes<S>(jet, by, ByDisturbance<S, 4>(response.x));
  Condition out;
  out.overlap = factor<S>(found.overlap);
  if (response.rank == 4) {
    out.normal = factor<S>(found.normal1);
    out.points = factor<S>(found.point1 > found.point2 ? found.point1 : found.point2);
  } else if (!normal_is_free<S>(jet, by.jacobian)) {
    // Where flats meet the normal lies between the two faces' own: it follows one or the other.
    out.normal = factor<S>(found.normal1 > found.normal2 ? found.normal1 : found.normal2);
  }
  return out;
}

#define PLUMB_INSTANTIATE_CONDITION(S) \
  template Condition condition_of(const PlacedPair<S>&, const Goal<S>&, const ChartPair<S>&);

PLUMB_INSTANTIATE_CONDITION(double)
PLUMB_INSTANTIATE_CONDITION(long double)
PLUMB_INSTANTIATE_CONDITION(Real50)

}  // namespace plumb::reference
