#include "solver/scene/wall/touches.hpp"

#include <cmath>
#include <numbers>

#include "solver/shape/overloaded.hpp"

namespace plumb::scene {
namespace {

/// Two points of the body are one contact where they are no farther apart than this many of its radii times the angle between their
/// normals: a ball's are one radius apart, and those of the two ends of a rod far more.
constexpr double near_radii = 4;

bool are_one(const Touch& a, const Touch& b, double smooth, double radius) {
  if (!(a.into.dot(b.into) >= std::cos(smooth))) return false;
  constexpr double same = 1e-9;
  const double angle = 2 * std::asin(std::min(1.0, (a.into - b.into).norm() / 2));
  return (a.reach - b.reach).norm() <= (near_radii * angle + same) * radius;
}

template <class Wall>
void touch_round(const Wall& wall, const BodyAtWall& body, Touches& out) {
  if (wall.side == Side::inside)
    touch_inside(wall, body, out);
  else
    touch_outside(wall, body, out);
}

}  // namespace

void Touches::keep_deepest(const BodyAtWall& body, double smooth, std::size_t places) {
  std::stable_sort(touches_.begin(), touches_.begin() + static_cast<std::ptrdiff_t>(count_),
                   [](const Touch& a, const Touch& b) { return a.overlap > b.overlap; });
  std::size_t kept = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const Touch touch = touches_[k];
    const bool is_known = std::any_of(touches_.begin(), touches_.begin() + static_cast<std::ptrdiff_t>(kept),
                                      [&](const Touch& one) { return are_one(one, touch, smooth, body.radius); });
    if (!is_known) touches_[kept++] = touch;
  }
  if (kept > places) is_complete_ = false;
  count_ = std::min(kept, places);
}

void find_touches(const WallShape& wall, const BodyAtWall& body, std::vector<std::uint32_t>& scratch, Touches& out) {
  std::visit(plumb::detail::Overloaded{[](const PlaneWall&) {},
                                       [&](const MeshWall& mesh) {
                                         touch_mesh(mesh, body, scratch, out);
                                         out.keep_deepest(body, mesh.smooth_deg * std::numbers::pi / 180,
                                                          places_of(wall));
                                       },
                                       [&](const CylinderWall& round) {
                                         touch_round(round, body, out);
                                         out.keep_deepest(body, 0, places_of(wall));
                                       },
                                       [&](const ConeWall& round) {
                                         touch_round(round, body, out);
                                         out.keep_deepest(body, 0, places_of(wall));
                                       },
                                       [&](const BoxWall& box) {
                                         if (box.side == Side::outside) touch_outside(box, body, out);
                                       }},
             wall);
}

}  // namespace plumb::scene
