#include "solver/scene/world.hpp"

#include <Eigen/Geometry>

namespace plumb::scene {
namespace {

/// r x n of each body's arm, where anything turns.
double turn_part(const World& world, std::size_t contact) {
  const auto [i, j] = world.contacts.pairs[contact];
  const Column& spin = *world.state.angular_velocity;
  return spin.vector(j).dot(world.contacts.arm2->vector(contact)) -
         spin.vector(i).dot(world.contacts.arm1->vector(contact));
}

Vec3<double> point_velocity(const World& world, std::uint32_t body, const Vec3<double>& point) {
  const Vec3<double> v = world.state.velocity->vector(body);
  if (!world.has_turning()) return v;
  const Vec3<double> arm = point - world.state.position->vector(body);
  return v + Vec3<double>(world.state.angular_velocity->vector(body)).cross(arm);
}

}  // namespace

Vec3<double> World::relative_velocity(std::size_t contact) const {
  const auto [i, j] = contacts.pairs[contact];
  const Vec3<double> point = contacts.point->vector(contact);
  return point_velocity(*this, j, point) - point_velocity(*this, i, point);
}

double World::normal_velocity(std::size_t contact) const {
  const auto [i, j] = contacts.pairs[contact];
  const double shift = (state.velocity->vector(j) - state.velocity->vector(i)).dot(contacts.normal->vector(contact));
  return has_turning() ? shift + turn_part(*this, contact) : shift;
}

Vec3<double> World::relative_turn(std::size_t contact) const {
  const auto [i, j] = contacts.pairs[contact];
  return state.angular_velocity->vector(j) - state.angular_velocity->vector(i);
}

double World::contact_radius(std::size_t contact) const {
  const auto [i, j] = contacts.pairs[contact];
  const Vec3<double> point = contacts.point->vector(contact);
  const double inverse1 = 1 / (point - state.position->vector(i)).norm();
  return 1 / (bodies.is_wall(j) ? inverse1 : inverse1 + 1 / (point - state.position->vector(j)).norm());
}

void World::push(std::size_t contact, const Vec3<double>& force) {
  const auto [i, j] = contacts.pairs[contact];
  state.force->vector(i) -= force;
  state.force->vector(j) += force;
  if (!has_turning()) return;
  const Vec3<double> point = contacts.point->vector(contact);
  state.torque->vector(i) -= (point - state.position->vector(i)).cross(force);
  if (!bodies.is_wall(j)) state.torque->vector(j) += (point - state.position->vector(j)).cross(force);
}

void World::turn(std::size_t contact, const Vec3<double>& couple) {
  const auto [i, j] = contacts.pairs[contact];
  state.torque->vector(i) -= couple;
  state.torque->vector(j) += couple;
}

}  // namespace plumb::scene
