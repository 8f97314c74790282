// Planes between bodies that do not touch: none stands between two that do, and one lasts.
#include <gtest/gtest.h>

#include <functional>

#include "properties/generators/draft.hpp"
#include "solver/method/methods.hpp"
#include "solver/scene/body/mass.hpp"
#include "solver/scene/contact/narrow_phase.hpp"
#include "solver/scene/contact/separation.hpp"
#include "solver/scene/part.hpp"

namespace plumb::scene {
namespace {

using Vec = Vec3<double>;

/// Two bodies that are put where they are, and what is between them.
class TwoBodies {
 public:
  TwoBodies(const Superellipsoid<double>& shape1, const Superellipsoid<double>& shape2) {
    std::array<SceneBody, 2> bodies;
    bodies[0].body.shape = shape1;
    bodies[1].body.shape = shape2;
    part_.renew(bodies, {{0, 1}});
  }

  /// A step of the narrow phase.
  void put(const std::array<Vec, 2>& places, const std::array<Quaternion, 2>& turns) {
    for (std::size_t i = 0; i < 2; ++i) part_.place(i, places[i], Vec::Zero(), turns[i], Vec::Zero());
    part_.press(0, 0);
  }

  [[nodiscard]] bool are_parted() { return scene::are_parted(part_.world(), 0); }
  [[nodiscard]] bool are_balls_about_them_in_touch() {
    const Pair at = pair();
    return (at.body2.position - at.body1.position).norm() <=
           bounding_radius(at.body1.shape) + bounding_radius(at.body2.shape);
  }
  [[nodiscard]] Vec plane() { return Vec::Map(part_.world().contacts.separation->entry(0).data()); }
  [[nodiscard]] Pair pair() { return solver_pair(part_.world(), 0); }

 private:
  static PartSettings settings() {
    PartSettings out;
    out.effects.linear = Linear{1};
    return out;
  }
  Part part_{settings()};
};

/// Two bodies that come from afar and pass through each other, turning as they do.
void pass_through(Stream& stream, double fastest_turn, const std::function<void(TwoBodies&)>& look) {
  constexpr int steps = 150;
  const auto shape1 = random_superellipsoid(stream, 4, 1.2, 20), shape2 = random_superellipsoid(stream, 4, 1.2, 20);
  TwoBodies two(shape1, shape2);
  const Vec way = 2.2 * (shape1.semi_axes.norm() + shape2.semi_axes.norm()) * random_direction(stream);
  const Vec beside = shape1.semi_axes.minCoeff() * random_direction(stream);
  const double angle = fastest_turn * stream.uniform();
  std::array turns{random_rotation(stream), random_rotation(stream)};
  for (int k = 0; k <= steps; ++k) {
    for (Quaternion& q : turns) q = product(turn(random_direction(stream), angle), q);
    two.put({Vec(Vec::Zero()), Vec((0.5 - 1.0 * k / steps) * way + beside)}, turns);
    look(two);
  }
}

TEST(Separation, NoPlaneStandsBetweenBodiesThatTouch) {
  int parted = 0, near = 0, touching = 0;
  for (std::uint64_t i = 0; i < 150; ++i) {
    Stream stream("separation", 1, i);
    pass_through(stream, i % 3 == 0 ? 0 : 0.1, [&](TwoBodies& two) {
      const bool is_apart = find_method("auto")->solve(two.pair(), {}, nullptr).verdict == Verdict::separated;
      const bool is_parted = two.are_parted();
      EXPECT_TRUE(is_apart || !is_parted) << "pair " << i;
      parted += is_parted ? 1 : 0;
      touching += is_apart ? 0 : 1;
      near += is_apart && two.are_balls_about_them_in_touch() ? 1 : 0;
    });
  }
  EXPECT_GT(touching, 2000);
  EXPECT_GT(parted, 0.99 * near) << "of those that are asked for";
}

/// Turning by 1e-4 a step, a quarter of a body apart: the gap is used up by turns of thousands of steps, and by no motion along the plane.
TEST(Separation, APlaneLastsWhileBodiesMoveAlongItAndTurnALittle) {
  Stream stream("separation lasts", 1, 0);
  TwoBodies two({{1, 0.8, 0.6}, 4, 3}, {{1, 0.8, 0.6}, 4, 3});
  std::array turns{Quaternion{1, 0, 0, 0}, Quaternion{1, 0, 0, 0}};
  int planes = 0;
  Vec last = Vec::Zero();
  for (int k = 0; k < 1000; ++k) {
    for (Quaternion& q : turns) q = product(turn(random_direction(stream), 1e-4), q);
    two.put({Vec(5e-4 * k, 0, 0), Vec(0, 0, 1.45)}, turns);
    EXPECT_TRUE(two.are_parted());
    if (two.plane() != last) ++planes;
    last = two.plane();
  }
  EXPECT_LE(planes, 10);
}

}  // namespace
}  // namespace plumb::scene
