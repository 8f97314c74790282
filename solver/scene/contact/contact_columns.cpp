#include "solver/scene/contact/contact_columns.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "solver/patch/patch.hpp"
#include "solver/pose.hpp"
#include "solver/scene/contact/narrow_phase.hpp"
#include "solver/scene/contact/relative_curvature.hpp"
#include "solver/shape/curvature.hpp"

namespace plumb::scene {
namespace {

using Index = std::uint32_t;

/// arm = (point - centre) x normal, which is 0 for a sphere whatever rounding says.
Vec3<double> arm_of(bool is_sphere, const Vec3<double>& from_centre, const Vec3<double>& normal) {
  if (is_sphere) return Vec3<double>::Zero();
  return from_centre.cross(normal);
}

/// The arms of the normal, and the mass that it feels: 1 / mass and what turning adds to it, of both bodies.
void keep_arms(World& world, std::size_t c, const Contact<double>& answer) {
  Contacts& contacts = world.contacts;
  const auto [i, j] = contacts.pairs[c];
  const bool is_wall = world.bodies.is_wall(j);
  double inverse_mass = world.bodies.inverse_mass[i] + world.bodies.inverse_mass[j];
  if (contacts.arm1 != nullptr) {
    const Vec3<double> arm1 =
        arm_of(world.bodies.is_sphere[i] != 0, answer.contact_point - world.state.position->vector(i), answer.normal);
    const Vec3<double> arm2 = arm_of(is_wall || world.bodies.is_sphere[j] != 0,
                                     answer.contact_point - world.second_position(c), answer.normal);
    contacts.arm1->vector(c) = arm1;
    contacts.arm2->vector(c) = arm2;
    if (contacts.yield1 != nullptr) {
      const Vec3<double> yield1 = world.yield(i, arm1), yield2 = world.yield(j, arm2);
      contacts.yield1->vector(c) = yield1;
      contacts.yield2->vector(c) = yield2;
      inverse_mass += arm1.dot(yield1) + arm2.dot(yield2);
    }
  }
  if (contacts.inverse_mass != nullptr) (*contacts.inverse_mass)[c] = inverse_mass;
}

double radius_at(const World& world, std::size_t c, const Vec3<double>& point) {
  const auto [i, j] = world.contacts.pairs[c];
  const double inverse = 1 / (point - world.state.position->vector(i)).norm();
  return 1 / (world.bodies.is_wall(j) ? inverse : inverse + 1 / (point - world.second_position(c)).norm());
}

/// All but the curvature.
void keep_first_order(World& world, std::size_t c, const Contact<double>& answer) {
  Contacts& contacts = world.contacts;
  if (contacts.overlap != nullptr) (*contacts.overlap)[c] = answer.overlap;
  if (contacts.normal != nullptr) contacts.normal->vector(c) = answer.normal;
  if (contacts.point != nullptr) contacts.point->vector(c) = answer.contact_point;
  if (contacts.radius != nullptr) (*contacts.radius)[c] = radius_at(world, c, answer.contact_point);
  keep_arms(world, c, answer);
}

/// Of a body's surface on the ray from its centre through a point, world axes.
Curvatures curvatures_at(const World& world, Index i, const Vec3<double>& from_centre) {
  const Superellipsoid<double>& shape = world.bodies.shape[i];
  if (world.bodies.is_sphere[i] != 0) return Curvatures::of_ball(shape.semi_axes[0]);
  const Eigen::Quaterniond q = world.solver_orientation(i);
  PrincipalCurvature<double> at = principal_curvature<double>(shape, Vec3<double>(q.conjugate() * from_centre));
  at.direction1 = q * at.direction1;
  return Curvatures::of(at, shape.semi_axes.maxCoeff());
}

/// Of a contact that lasts most effects go by the one that it began with.
bool is_curvature_wanted(const Contacts& contacts, std::size_t c) {
  if (contacts.curvature == nullptr) return false;
  const bool is_known = (*contacts.is_pressing)[c] != 0 && !std::isnan(contacts.curvature->entry(c)[0]);
  return contacts.follows_curvature || !is_known;
}

void keep_curvature(World& world, std::size_t c, const Curvatures& first, const Curvatures& second) {
  std::ranges::copy(relative_curvature(first, second), world.contacts.curvature->entry(c).begin());
}

/// The point on the normal through a ball's centre, and two balls' normal through both: there they are up to the tolerance of the solver or
/// the patch, but a ball's arm is zero by its shape, and what is left of it would be angular momentum made from nothing.
void straighten(const World& world, std::size_t c, Contact<double>& answer) {
  const auto [i, j] = world.contacts.pairs[c];
  const bool is_ball1 = world.bodies.is_sphere[i] != 0, is_ball2 = world.bodies.is_sphere[j] != 0;
  if (!is_ball1 && !is_ball2) return;
  const Vec3<double> x1 = world.state.position->vector(i), x2 = world.second_position(c);
  if (is_ball1 && is_ball2 && x1 != x2) answer.normal = (x2 - x1).normalized();
  const Vec3<double>& centre = is_ball1 ? x1 : x2;
  answer.contact_point = centre + answer.normal.dot(answer.contact_point - centre) * answer.normal;
}

/// With a turn's w the normal velocities at both ends of an axis are +-w.arm; all ends have the patch's mean square of them.
Eigen::Matrix3d arms_of(const Patch& patch) {
  Eigen::Matrix3d arms;
  for (int k = 0; k < 3; ++k)
    arms.col(k) = std::sqrt(patch.second_moments[k]) * Vec3<double>(patch.axes.col(k)).cross(patch.normal);
  return arms;
}

/// The patch's columns; normal and point become its own, which no face makes jump. A body within another has no area, and so no force.
/// False, and nothing changed, where bodies overlap by more than rounding and `find` finds none.
template <class Find>
bool keep_patch(World& world, std::size_t c, Contact<double>& answer, const Find& find) {
  constexpr double rounding = 1e-12;
  Contacts& contacts = world.contacts;
  const auto [i, j] = contacts.pairs[c];
  const bool overlaps = answer.overlap > rounding * world.bodies.radius[i];
  const Patch patch = overlaps ? find() : Patch{.volume = 0, .area = 0, .error = 0};
  if (std::isinf(patch.error)) return false;
  const bool has_ball = world.bodies.is_sphere[i] != 0 || world.bodies.is_sphere[j] != 0;
  const bool has_area = patch.area > 0 && patch.normal.allFinite();
  (*contacts.volume)[c] = patch.volume > 0 ? patch.volume : 0;
  (*contacts.area)[c] = has_area ? patch.area : 0;
  Eigen::Map<Eigen::Matrix3d>(contacts.patch_arms->entry(c).data()) =
      has_area ? arms_of(patch) : Eigen::Matrix3d(Eigen::Matrix3d::Zero());
  contacts.area_moment->vector(c) = has_area && !has_ball ? patch.area_moment : Vec3<double>(Vec3<double>::Zero());
  if (!has_area) return true;
  answer.normal = patch.normal;
  answer.contact_point = patch.centre;
  return true;
}

/// `of_body`: where a contact's entry begins, for this body.
void keep_chart(double* of_body, const Vec3<double>& now) {
  Eigen::Map<Vec3<double>> last(of_body + ChartEntry::last), before_last(of_body + ChartEntry::before_last),
      bend(of_body + ChartEntry::bend);
  bend = chart_bend<double>(now, last, before_last).cast<double>();
  before_last = last;
  last = now;
}

}  // namespace

void keep_charts(Contacts& contacts, std::size_t c, const Contact<double>& answer) {
  double* const kept = contacts.chart->entry(c).data();
  keep_chart(kept, answer.chart1);
  keep_chart(kept + 3, answer.chart2);
}

bool keep_contact(World& world, std::size_t c, Contact<double> answer) {
  const auto [i, j] = world.contacts.pairs[c];
  bool is_complete = true;
  if (world.contacts.volume != nullptr) {
    const Pair pair = solver_pair(world, c);
    const PlacedPair<double> placed = place<double>(pair);
    is_complete = keep_patch(world, c, answer, [&] {
      return patch_at(pair, answer.normal, placed.to_pair_point(answer.point1, pair),
                      placed.to_pair_point(answer.point2, pair), world.contacts.patch_tolerance);
    });
  }
  straighten(world, c, answer);
  keep_first_order(world, c, answer);
  if (is_curvature_wanted(world.contacts, c))
    keep_curvature(world, c, curvatures_at(world, i, answer.point1 - world.state.position->vector(i)),
                   curvatures_at(world, j, answer.point2 - world.second_position(c)));
  return is_complete;
}

bool keep_wall_contact(World& world, std::size_t c, Contact<double> answer) {
  const auto [i, j] = world.contacts.pairs[c];
  bool is_complete = true;
  if (world.contacts.volume != nullptr) {
    is_complete = keep_patch(world, c, answer, [&] {
      const bool is_plane = std::holds_alternative<PlaneWall>(world.bodies.wall_shape[j - world.bodies.count]);
      const Vec3<double> on_wall = is_plane ? Vec3<double>(world.state.position->vector(j)) : answer.point2;
      return patch_at_wall(solver_body(world, i), answer.normal, on_wall, world.contacts.patch_tolerance);
    });
    straighten(world, c, answer);
  }
  keep_first_order(world, c, answer);
  if (is_curvature_wanted(world.contacts, c))
    keep_curvature(world, c, curvatures_at(world, i, answer.point1 - world.state.position->vector(i)), {});
  return is_complete;
}

}  // namespace plumb::scene
