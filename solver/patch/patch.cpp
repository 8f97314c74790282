#include "solver/patch/patch.hpp"

#include "solver/instruction_set.hpp"
#include "solver/patch/ball_caps.hpp"
#include "solver/patch/kernel_impl.hpp"
#include "solver/patch/patch_quadrature.hpp"
#include "solver/patch/principal_axes.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace detail {

#if defined(__GLIBCXX__)
constinit const LensKernel lens_kernel_baseline = kernel_of<Pack<2>>();
#else
constinit const LensKernel lens_kernel_baseline = kernel_of<double>();
#endif

std::span<const LensKernel* const> lens_kernels() {
#if defined(PLUMB_WIDE_REGISTERS) && defined(__GLIBCXX__)
  static constexpr std::array all{&lens_kernel_baseline, &lens_kernel_avx2, &lens_kernel_avx512};
  const std::span<const LensKernel* const> kernels(all);
  return kernels.first(runs_avx512() ? 3 : runs_avx2() ? 2 : 1);
#else
  static constexpr std::array all{&lens_kernel_baseline};
  return all;
#endif
}

}  // namespace detail

namespace {

using detail::Lens;
using detail::LensFrame;
using detail::Quadrature;

/// What rounding leaves of a lens's thickness: of coordinates as large as the pair, in two gauges and the middle of two points.
double rounding_error(const PlacedPair<double>& placed, const LensFrame& frame) {
  const double roundings = 8;
  const double reach = std::max(placed.size(), placed.body2.centre.norm());
  return roundings * epsilon<double>() * reach / frame.thickness();
}

/// Newton's last step, relative, and what it leaves: about its square, times what the surfaces curve.
struct NewtonsEnd {
  double step, error;

  [[nodiscard]] static NewtonsEnd of(double tolerance, double rounding) {
    const double share = 0.01, curving = 10;
    const double step = std::max(share * std::sqrt(tolerance), rounding);
    return {step, curving * step * step};
  }
};

Quadrature moments(const Lens& lens, const LensFrame& frame, double tolerance, double step) {
  // Two squares turned by 45 degrees look the same to 4 azimuths and to 8; ellipses have no more than two axes each.
  const detail::AzimuthPlan of_ellipsoids{8, detail::Convergence::geometric}, of_all{16, detail::Convergence::power};
  const detail::FramedLens framed(lens, frame);
  const detail::LensTask task{framed, frame, step, tolerance};
  if (lens.has_smooth_normals()) {
    const double slack = tolerance / 10 * (1 - lens.gauge(frame.origin));
    const auto& azimuths = lens.is_of_ellipsoids() ? of_ellipsoids : of_all;
    if (const auto found = detail::CapQuadrature(task, slack, azimuths).moments()) return *found;
  }
  return detail::moments_by_meridians(task);
}

/// Columns right-handed, the third on the side of `normal`, and the first's largest component positive.
Mat3<double> oriented(Mat3<double> axes, const Vec3<double>& normal) {
  Eigen::Index largest = 0;
  axes.col(0).cwiseAbs().maxCoeff(&largest);
  if (axes(largest, 0) < 0) axes.col(0) *= -1;
  if (axes.col(2).dot(normal) < 0) axes.col(2) *= -1;
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

/// Both bodies' parts give the area vector, of opposite signs.
Vec3<double> mean_of_sides(const std::array<Vec3<double>, 2>& sides) {
  return (sides[0] - sides[1]) / 2;
}

Patch patch_of(const Quadrature& found, const LensFrame& frame, const PlacedPair<double>& placed, const Pair& pair) {
  Patch out;
  const auto length = [&](double x) { return placed.to_world_length(x); };
  const auto area = [&](double x) { return length(length(x)); };
  const auto volume = [&](double x) { return area(length(x)); };
  const detail::LensMoments& sum = found.moments;
  const Vec3<double> middle = frame.axes * sum.centre(), vector = mean_of_sides(sum.area);
  const Eigen::LLT<Mat3<double>> root(sum.spread());
  const detail::PrincipalAxes principal = detail::principal_axes(frame.axes * Mat3<double>(root.matrixL()));
  const double size = vector.norm();
  out.volume = volume(sum.volume);
  out.area = area(size);
  if (size > found.error * sum.area_scale(frame)) out.normal = vector / size;
  out.centre = placed.to_world_point(frame.origin + middle, pair);
  out.area_moment = (mean_of_sides(sum.moment) - middle.cross(vector)).unaryExpr(volume);
  out.second_moments = principal.lengths.cwiseAbs2().unaryExpr(area);
  out.axes = oriented(principal.axes, out.normal);
  return out;
}

/// Not the cube of a length beyond 1e102, nor below 1e-102; and no error that is larger than what is found.
bool is_answer(const Patch& patch) {
  constexpr double nothing_known = 1;
  return patch.error <= nothing_known && patch.volume >= std::numeric_limits<double>::min() &&
         std::isfinite(patch.volume) && std::isfinite(patch.area) && patch.centre.allFinite() &&
         patch.area_moment.allFinite() && patch.second_moments.allFinite();
}

/// The lens of a placed pair, or of its first body and something else.
Patch patch_of_lens(const Lens& lens, const PlacedPair<double>& placed, const Pair& pair, const Vec3<double>& normal,
                    const Vec3<double>& middle, double tolerance) {
  const Vec3<double> inside = detail::point_inside(lens, middle);
  if (!(lens.gauge(inside) < 1)) return {};
  const LensFrame frame = detail::lens_frame(lens, inside, normal, placed.size());
  const double rounding = rounding_error(placed, frame);
  const NewtonsEnd newton = NewtonsEnd::of(tolerance, rounding);
  const Quadrature found = moments(lens, frame, tolerance - newton.error, newton.step);
  Patch out = patch_of(found, frame, placed, pair);
  out.error = found.error + newton.error + rounding;
  return is_answer(out) ? out : Patch{};
}

bool is_ellipsoid(const Superellipsoid<double>& shape) {
  return shape.n1 == 2 && shape.n2 == 2;
}

bool is_ball(const Superellipsoid<double>& shape) {
  return is_ellipsoid(shape) && shape.semi_axes.minCoeff() == shape.semi_axes.maxCoeff();
}

Patch patch_of_caps(const detail::FramedMoments& lens, const PlacedPair<double>& placed, const Pair& pair) {
  Patch out = patch_of({lens.moments, 0}, lens.frame, placed, pair);
  out.error = rounding_error(placed, lens.frame);
  return is_answer(out) ? out : Patch{};
}

/// Of balls whose surfaces cross, in closed form.
std::optional<Patch> patch_of_balls(const PlacedPair<double>& placed, const Pair& pair) {
  const auto &body1 = placed.body1, &body2 = placed.body2;
  if (!is_ball(body1.shape) || !is_ball(body2.shape)) return {};
  const double r1 = body1.shape.semi_axes[0], r2 = body2.shape.semi_axes[0];
  const Vec3<double> between = body2.centre - body1.centre;
  const double distance = between.norm();
  if (!(distance > std::abs(r1 - r2) && distance < r1 + r2)) return {};
  const auto caps = detail::BallCaps::of_balls(between / distance, r1, r2, distance);
  const Vec3<double> middle_of_rim = body1.centre + (r1 - caps.height[0]) * caps.axis;
  return patch_of_caps(lens_of_caps(caps, Mat3<double>::Identity(), middle_of_rim), placed, pair);
}

/// Of an ellipsoid of which `overlap` is beyond a wall: a ball's cap, stretched.
std::optional<Patch> patch_of_ellipsoid_at_wall(const PlacedPair<double>& placed, const Pair& pair,
                                                const Vec3<double>& into_wall, double reach, double overlap) {
  const PlacedBody<double>& body = placed.body1;
  if (!is_ellipsoid(body.shape) || !(overlap < 2 * reach)) return {};
  const Mat3<double> stretch = body.rotation * body.shape.semi_axes.asDiagonal();
  const detail::BallCaps caps{stretch.transpose() * into_wall / reach, {1, 0}, {overlap / reach, 0}};
  const Vec3<double> middle_of_rim = body.centre + stretch * ((1 - caps.height[0]) * caps.axis);
  return patch_of_caps(lens_of_caps(caps, stretch, middle_of_rim), placed, pair);
}

}  // namespace

Patch patch_at(const Pair& pair, const Vec3<double>& normal, const Vec3<double>& point1, const Vec3<double>& point2,
               double tolerance) {
  const PlacedPair<double> placed = place<double>(pair);
  if (const auto closed = patch_of_balls(placed, pair)) return *closed;
  return patch_of_lens(Lens(placed), placed, pair, normal, (point1 + point2) / 2, tolerance);
}

Patch patch_at_wall(const Body& body, const Vec3<double>& into_wall, const Vec3<double>& wall_point, double tolerance) {
  const Pair pair{body, body};
  const PlacedPair<double> placed = place<double>(pair);
  const PlacedBody<double>& own = placed.body1;
  const NormValue<double> deepest = support_point<double>(own.shape, own.to_body_direction(into_wall));
  const double distance = into_wall.dot(placed.to_pair_point(wall_point, pair));
  // The body spans twice its support. From there on nothing changes, and no depth need be larger than twice that.
  const double overlap = std::min(deepest.value - distance, 4 * deepest.value), half = 4 * placed.size();
  if (!(overlap > 0)) return {.volume = 0, .area = 0, .error = 0};
  if (const auto closed = patch_of_ellipsoid_at_wall(placed, pair, into_wall, deepest.value, overlap)) return *closed;
  const Vec3<double> middle_of_wall = (deepest.value - overlap + half) * into_wall;
  const Lens lens(detail::PlacedGauge(own), detail::PlacedGauge::slab(middle_of_wall, -into_wall, half));
  const Vec3<double> middle =
      own.to_pair_direction(deepest.gradient) - std::min(overlap / 2, deepest.value) * into_wall;
  return patch_of_lens(lens, placed, pair, into_wall, middle, tolerance);
}

std::array<Vec3<double>, 4> points_of(const Patch& patch) {
  // The symmetric root of the moments: it follows them where their axes turn at once, as those of a square do.
  const Mat3<double> offsets = patch.axes * patch.second_moments.cwiseSqrt().asDiagonal() * patch.axes.transpose();
  const auto corner = [&](double x, double y, double z) -> Vec3<double> {
    return patch.centre + offsets * Vec3<double>(x, y, z);
  };
  return {corner(1, 1, 1), corner(1, -1, -1), corner(-1, 1, -1), corner(-1, -1, 1)};
}

}  // namespace plumb
