#include "solver/c/details.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>

#include "solver/patch/patch.hpp"

namespace plumb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class Matrix, std::size_t N>
void write_rows(const Matrix& from, double (&to)[N][3]) {
  for (std::size_t row = 0; row < N; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      to[row][column] = from(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
}

void write_curvature(const PrincipalCurvature<double>& from, double (&radii)[2], double (&directions)[2][3]) {
  radii[0] = from.radius1;
  radii[1] = from.radius2;
  Vec3<double>::Map(directions[0]) = from.direction1;
  Vec3<double>::Map(directions[1]) = from.direction2;
}

PoseDerivative<double> no_derivative() {
  return {not_valid<double>(), not_valid<double>(), Mat3<double>::Constant(nan), Mat3<double>::Constant(nan)};
}

plumb_patch patch_of(const Patch& found) {
  plumb_patch out{};
  out.volume = found.volume;
  out.area = found.area;
  Vec3<double>::Map(out.normal) = found.normal;
  Vec3<double>::Map(out.centre) = found.centre;
  Vec3<double>::Map(out.area_moment) = found.area_moment;
  Vec3<double>::Map(out.second_moments) = found.second_moments;
  write_rows(Mat3<double>(found.axes.transpose()), out.axes);
  const auto points_of_patch = points_of(found);
  for (std::size_t i = 0; i < points_of_patch.size(); ++i) Vec3<double>::Map(out.points[i]) = points_of_patch[i];
  out.error = found.error;
  return out;
}

plumb_details details_of(const Contact<double>& found, std::size_t size) {
  plumb_details out{};
  out.size = size;
  out.method = found.method.empty() ? "" : found.method.data();  // of a literal, which ends with a zero
  const auto derivatives = found.derivatives.value_or(std::array{no_derivative(), no_derivative()});
  for (std::size_t body = 0; body < 2; ++body) {
    write_curvature(found.curvature[body], out.radii[body], out.directions[body]);
    Vec3<double>::Map(out.overlap_by_shift[body]) = derivatives[body].overlap_by_shift;
    Vec3<double>::Map(out.overlap_by_turn[body]) = derivatives[body].overlap_by_turn;
    write_rows(derivatives[body].normal_by_shift, out.normal_by_shift[body]);
    write_rows(derivatives[body].normal_by_turn, out.normal_by_turn[body]);
  }
  out.patch = patch_of(found.patch.value_or(Patch{}));
  return out;
}

}  // namespace

void write_details(const Contact<double>& found, plumb_details& details) {
  const plumb_details all = details_of(found, details.size);
  std::memcpy(&details, &all, std::min(details.size, sizeof all));
}

}  // namespace plumb
