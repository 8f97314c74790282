// Axes in which a lens is about as wide as it is high.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <numbers>

#include "solver/patch/kernel.hpp"
#include "solver/patch/lens.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb::detail {

/// Columns e1, e2, e3: half axes of the lens, e1 x e2 along e3, which is along the contact's normal.
struct LensFrame {
  Vec3<double> origin;
  Mat3<double> axes;
  Mat3<double> inverse = Mat3<double>::Zero();  ///< of the axes, where they are final

  [[nodiscard]] double thickness() const { return axes.col(2).norm(); }
  [[nodiscard]] double width() const { return std::max(axes.col(0).norm(), axes.col(1).norm()); }
  [[nodiscard]] Vector3<Eight> across(const Circle& azimuths) const {
    Vector3<Eight> out;
    for (std::size_t k = 0; k < eight; ++k)
      set(out, k, azimuths.cosine[k] * axes.col(0) + azimuths.sine[k] * axes.col(1));
    return out;
  }
};

namespace detail_frame {

inline constexpr double ray_accuracy = 0.1;  // relative: a frame need not be exact

/// How far the first `count` rays go inside the lens.
[[nodiscard]] inline Eight reaches(const Lens& lens, const Vec3<double>& from, const Vector3<Eight>& along, int count) {
  std::array<Eight, 2> exits;
  lens_kernel().find_exits(lens.bodies, Vector3<double>::of(from), along, count, ray_accuracy, exits);
  Eight out{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) out[i] = std::min(exits[0][i], exits[1][i]);
  return out;
}

/// Origin to the middle of the lens along e3, and e3 to half its height there.
inline void centre_height(const Lens& lens, LensFrame& frame) {
  const Vec3<double> e3 = frame.axes.col(2);
  const Eight reach = reaches(lens, frame.origin, both_ways(e3), 2);
  const double up = reach[0], down = reach[1];
  frame.origin += (up - down) / 2 * e3;
  frame.axes.col(2) *= (up + down) / 2;
}

/// Origin to the centroid of the section across e3, e1 and e2 to the half axes of the ellipse with its second moments. Returns by how
/// much they changed: 1 for not at all.
[[nodiscard]] inline double centre_section(const Lens& lens, LensFrame& frame) {
  const Circle azimuths = circle(0, std::numbers::pi / 4);
  const Eight reach = reaches(lens, frame.origin, frame.across(azimuths), eight);
  double area = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (std::size_t k = 0; k < eight; ++k) {
    const double r = reach[k];
    const Eigen::Vector2d at(r * azimuths.cosine[k], r * azimuths.sine[k]);
    area += r * r / 2, first += r * r / 3 * at, second += r * r / 4 * at * at.transpose();
  }
  const Eigen::Vector2d middle = first / area;
  const Eigen::Matrix2d spread = second / area - middle * middle.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(spread);
  const Eigen::Vector2d half = 2 * solver.eigenvalues().cwiseMax(1e-6).cwiseSqrt();  // of an ellipse
  const Eigen::Matrix<double, 3, 2> across = frame.axes.leftCols<2>();
  const Vec3<double> moved = frame.origin + across * middle;
  if (lens.gauge(moved) < 1) frame.origin = moved;
  frame.axes.leftCols<2>() = across * solver.eigenvectors() * half.asDiagonal();
  if (frame.axes.col(0).cross(frame.axes.col(1)).dot(frame.axes.col(2)) < 0) frame.axes.col(0) *= -1;
  return std::max({half[1] / half[0], half[1], 1 / half[0], 1 + middle.norm()});
}

}  // namespace detail_frame

/// `inside` in the lens, `normal` unit. `size`: of the pair.
[[nodiscard]] inline LensFrame lens_frame(const Lens& lens, const Vec3<double>& inside, const Vec3<double>& normal,
                                          double size) {
  LensFrame frame{inside, {}, {}};
  frame.axes << size * tangent_basis<double>(normal), size * normal;
  const int limit = 8;
  const double round_enough =
      lens.is_of_ellipsoids() ? 1.05 : 1.5;  // their rays cost little, and the rounder the fewer azimuths
  for (int i = 0; i < limit; ++i) {
    detail_frame::centre_height(lens, frame);
    if (i == 0) frame.axes.leftCols<2>() *= std::sqrt(frame.thickness() / size);  // as of two spheres
    if (detail_frame::centre_section(lens, frame) < round_enough) break;
  }
  detail_frame::centre_height(lens, frame);
  frame.inverse = frame.axes.inverse();
  return frame;
}

}  // namespace plumb::detail
