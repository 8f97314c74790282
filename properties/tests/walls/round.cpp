// Cylinders, cones and boxes as walls, and walls that turn.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/tests/walls/made.hpp"
#include "solver/scene/wall/touches.hpp"

namespace plumb::scene {
namespace {

using namespace made;  // NOLINT: bodies and walls

std::vector<Touch> touches_in(const WallShape& wall, const Superellipsoid<double>& shape, const Vec& at,
                              const Eigen::Quaterniond& q = Eigen::Quaterniond::Identity()) {
  std::vector<std::uint32_t> scratch;
  Touches found;
  find_touches(wall, {shape, at, q, bounding_radius(shape), 0}, scratch, found);
  EXPECT_TRUE(found.is_complete());
  return {found.all().begin(), found.all().end()};
}

const Superellipsoid<double> small_ball{Vec::Constant(0.1)};

TEST(RoundWalls, ABallInACylinder) {
  const CylinderWall tube{1, 2};
  for (const double phi : {0.0, 0.3, 2.0, 3.141592653589793, 5.0}) {
    const Vec out(std::cos(phi), std::sin(phi), 0);
    const auto found = touches_in(tube, small_ball, 0.93 * out + Vec(0, 0, 1.5));
    ASSERT_EQ(found.size(), 1U) << phi;
    EXPECT_NEAR(found[0].overlap, 0.03, 1e-15);
    EXPECT_LT((found[0].into - out).norm(), 1e-14);
    EXPECT_TRUE(touches_in(tube, small_ball, 0.89 * out).empty());
  }
  EXPECT_TRUE(touches_in(tube, {Vec::Constant(1.1)}, Vec::Zero()).empty());  // all round: no direction is its own
}

// A rod across a tube touches at both ends: at each the circle about the axis through the end's point is the wall's, pushed in.
TEST(RoundWalls, ARodAcrossACylinderTouchesAtBothEnds) {
  const CylinderWall tube{1, 2};
  const Eigen::Quaterniond across(Eigen::AngleAxisd(1.5707963267948966, Vec::UnitY()));
  const auto found = touches_in(tube, {{0.1, 0.1, 1.01}}, {0.002, 0, 0}, across);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].overlap, 0.012, 1e-12);
  EXPECT_NEAR(found[1].overlap, 0.008, 1e-12);
  EXPECT_NEAR(found[0].into.x(), 1, 1e-14);
  EXPECT_NEAR(found[1].into.x(), -1, 1e-14);
}

// What a search over many points says: each local maximum of the radial distance is a contact, and no other.
TEST(RoundWalls, LocalMaximaOfTheDistanceAreTheContacts) {
  Stream draws("local maxima", 1, 0);
  int several = 0;
  for (int k = 0; k < 300; ++k) {
    const Superellipsoid<double> shape{{draws.uniform(0.3, 1), draws.uniform(0.3, 1), draws.uniform(0.3, 1)},
                                       draws.uniform(2, 6),
                                       draws.uniform(2, 6)};
    const Eigen::Quaterniond q =
        Eigen::Quaterniond(draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1))
            .normalized();
    const Vec at(draws.uniform(-0.3, 0.3), draws.uniform(-0.3, 0.3), 0);
    constexpr int directions = 4000;
    std::vector<double> heights;
    for (int n = 0; n < directions; ++n) {
      const double phi = 2 * std::numbers::pi * n / directions;
      const Vec u(std::cos(phi), std::sin(phi), 0);
      heights.push_back(support<double>(shape, Vec(q.conjugate() * u)) + u.dot(at));
    }
    const double radius = *std::ranges::max_element(heights) - 0.02;
    std::vector<double> peaks;
    for (std::size_t n = 0; n < heights.size(); ++n) {
      const double before = heights[(n + heights.size() - 1) % heights.size()],
                   after = heights[(n + 1) % heights.size()];
      if (heights[n] > before && heights[n] >= after && heights[n] > radius) peaks.push_back(heights[n] - radius);
    }
    std::ranges::sort(peaks, std::greater{});
    const auto found = touches_in(CylinderWall{radius, 5}, shape, at, q);
    ASSERT_EQ(found.size(), peaks.size()) << k;
    several += peaks.size() > 1 ? 1 : 0;
    for (std::size_t n = 0; n < peaks.size(); ++n) EXPECT_NEAR(found[n].overlap, peaks[n], 1e-5);
  }
  EXPECT_GT(several, 10);
}

// A hopper: the side's normal, the rim about the hole, a closed floor.
TEST(RoundWalls, ABallInACone) {
  const ConeWall hopper{{0.2, 1}, 1};
  const Vec slope = Vec(0.8, 0, 1).normalized(), into = Vec(1, 0, -0.8).normalized();
  const Vec on_side = Vec(0.2, 0, 0) + 0.6 * slope;
  const auto side = touches_in(hopper, small_ball, on_side - 0.09 * into);
  ASSERT_EQ(side.size(), 1U);
  EXPECT_NEAR(side[0].overlap, 0.01, 1e-15);
  EXPECT_LT((side[0].into - into).norm(), 1e-14);
  // Beneath the hole, near the rim: along the line to it.
  const Vec below = Vec(0.2, 0, 0) + 0.095 * Vec(-0.6, 0, -0.8);
  const auto rim = touches_in(hopper, small_ball, below);
  ASSERT_EQ(rim.size(), 1U);
  EXPECT_NEAR(rim[0].overlap, 0.005, 1e-12);
  EXPECT_LT((rim[0].into - Vec(0.6, 0, 0.8)).norm(), 1e-8);
  EXPECT_TRUE(touches_in(ConeWall{{0.2, 1}, 1, Side::inside, {End::bare, End::bare}}, small_ball, below).empty());
  const auto floor =
      touches_in(ConeWall{{0.3, 1}, 1, Side::inside, {End::closed, End::closed}}, small_ball, {0, 0, 0.095});
  ASSERT_EQ(floor.size(), 1U);
  EXPECT_NEAR(floor[0].overlap, 0.005, 1e-15);
}

// Over the rim of a tube a ball's contact goes on from the side to the edge, and what it stores does not jump.
TEST(RoundWalls, ABallLeavesATubeOverItsRim) {
  double last = 0;
  int count = 0;
  for (int k = 0; k < 220; ++k) {
    const double z = 1.9 + 1e-3 * k;
    const auto found = touches_in(CylinderWall{1, 2}, small_ball, {0.93, 0.01, z});
    ASSERT_LE(found.size(), 1U);
    const double overlap = found.empty() ? 0 : found[0].overlap;
    if (count++ > 0) {
      EXPECT_LT(std::abs(overlap - last), 1.1e-3) << z;
    }
    last = overlap;
  }
  EXPECT_EQ(last, 0);
}

TEST(RoundWalls, SolidsFromOutside) {
  const Vec up = Vec::UnitZ();
  const auto on_cylinder = touches_in(CylinderWall{0.5, 1, Side::outside}, small_ball, {0.59, 0, 0});
  ASSERT_EQ(on_cylinder.size(), 1U);
  EXPECT_NEAR(on_cylinder[0].overlap, 0.01, 1e-14);
  const auto on_cone = touches_in(ConeWall{{0.5, 0}, 1, Side::outside}, small_ball, {0, 0, 1.09});
  ASSERT_EQ(on_cone.size(), 1U);
  EXPECT_NEAR(on_cone[0].overlap, 0.01, 1e-14);
  EXPECT_LT((on_cone[0].into + up).norm(), 1e-12);
  const auto on_box = touches_in(BoxWall{{1, 1, 1}, Side::outside}, small_ball, {0.3, 0.4, 1.09});
  ASSERT_EQ(on_box.size(), 1U);
  EXPECT_NEAR(on_box[0].overlap, 0.01, 1e-14);
}

Scene held_by(const Wall& wall, const Vec& at, double friction = 0.5) {
  Scene scene;
  scene.bodies = {ball(0.1, at)};
  scene.walls = {wall};
  scene.effects.gravity = Gravity{{0, 0, -10}};
  scene.effects.linear = Linear{2000};
  scene.effects.damping = Damping{0.3};
  if (friction > 0) scene.effects.friction = Friction{.coefficient = friction, .damping = 0.3};
  scene.run.duration = 2;
  scene.run.time_step = 5e-4;
  return scene;
}

Wall lying(WallShape shape) {
  Wall out = wall_of(std::move(shape));
  out.quaternion = {std::sqrt(0.5), std::sqrt(0.5), 0, 0};  // its axis along y
  return out;
}

/// Of the wall against the body where they touch.
double slip(const Simulation& run) {
  const World& world = run.world();
  const std::uint32_t contact = touching(run).at(0);
  const Vec slips = world.relative_velocity(contact, world.levers(contact));
  return (slips - slips.dot(normal(run, contact)) * normal(run, contact)).norm();
}

// In a drum that turns a ball swings about at the lowest place and spins as fast as the wall beneath it, where nothing resists its rolling.
TEST(TurningWalls, ABallInADrumSpinsWithIt) {
  Scene scene = held_by(lying(CylinderWall{1, 1, Side::inside, {End::closed, End::closed}}), {0, 0, -0.9});
  MovingWalls moving;
  moving.motions.emplace_back().angular_velocity = {0, 0.5, 0};
  scene.effects.moving_walls = moving;
  const auto run = ended(scene);
  EXPECT_EQ(run->totals().failed, 0);
  EXPECT_LT(slip(*run), 1e-3);
  EXPECT_GT(spin(*run, 0).y(), 3);
}

// The same drum of triangles: about its axis as through a point beside it.
TEST(TurningWalls, ADrumOfTrianglesCarriesWhatLiesInIt) {
  std::vector<Vec> round;
  for (int k = 0; k <= 36; ++k)
    round.emplace_back(std::sin(k * std::numbers::pi / 18), 0, std::cos(k * std::numbers::pi / 18));
  round.back() = round.front();
  Scene scene = held_by(wall_of(mesh_of(strip(round))), {0, 0, -0.88});
  MovingWalls moving;
  moving.motions.emplace_back().angular_velocity = {0, 0.5, 0};
  scene.effects.moving_walls = moving;
  const auto run = started(scene);
  while (!run->is_done()) {
    run->step();
    ASSERT_LE(touching(*run).size(), 1U) << run->steps();
  }
  EXPECT_LT(slip(*run), 2e-2);
  EXPECT_GT(spin(*run, 0).y(), 3);
}

// A plane that turns about an axis in it pushes as a paddle: velocity of its material where it touches.
TEST(TurningWalls, APlaneThatTurnsPushes) {
  Scene scene = held_by(Wall{{0, 0, 0}, {-1, 0, 0}, {}}, {-0.1, 0, 0.5}, 0);
  scene.bodies[0].body.position = {-0.1, 0, -1};
  scene.effects.gravity.reset();
  scene.effects.damping.reset();
  MovingWalls moving;
  moving.motions.emplace_back().angular_velocity = {0, 0.2, 0};  // at z = -1 it comes towards -x with 0.2
  scene.effects.moving_walls = moving;
  scene.run.duration = 0.1;
  const auto run = ended(scene);
  EXPECT_NEAR(velocity(*run, 0).x(), -0.4, 0.01);  // an elastic ball leaves at twice the wall's velocity
}

TEST(TurningWalls, APivotIsThePointThatStays) {
  Scene scene = held_by(lying(CylinderWall{1, 1, Side::inside, {End::closed, End::closed}}), {0, 0, -0.9});
  MovingWalls moving;
  moving.motions.push_back({.wall = 0, .angular_velocity = {0, 1, 0}, .pivot = {0.3, 0, 0}});
  scene.effects.moving_walls = moving;
  const auto run = started(scene);
  for (int k = 0; k < 100; ++k) run->step();
  const Vec centre = run->world().state.position->vector(1), velocity = run->world().state.velocity->vector(1);
  const double t = run->time(), middle = t - run->plan().time_step / 2;
  EXPECT_LT((centre - Vec(0.3 - 0.3 * std::cos(t), 0, 0.3 * std::sin(t))).norm(), 1e-14);
  EXPECT_LT((velocity - Vec(0.3 * std::sin(middle), 0, 0.3 * std::cos(middle))).norm(), 1e-14);
}

// Snapshots, threads and a list of contacts that is made anew change no bit.
TEST(RoundWalls, ARunGoesOnToTheSameBits) {
  Scene scene = held_by(lying(CylinderWall{1, 1, Side::inside, {End::closed, End::closed}}), {0, 0, -0.9});
  for (int k = 0; k < 6; ++k)
    scene.bodies.push_back(body({{0.1, 0.08, 0.06}, 4, 3}, {0.1 * k - 0.3, 0.2, -0.5 + 0.2 * k}));
  scene.walls.push_back(wall_of(mesh_of(sheet(6, {-1, -1, -0.95}, {2, 0, 0}, {0, 2, 0}))));
  MovingWalls moving;
  moving.motions.emplace_back().angular_velocity = {0, 1, 0};
  scene.effects.moving_walls = moving;
  scene.run.duration = 0.5;
  const auto once = ended(scene), twice = ended(scene, 2);
  EXPECT_EQ(once->hash(), twice->hash());
  const auto half = started(scene), rest = started(scene);
  for (int k = 0; k < 400; ++k) half->step();
  ASSERT_TRUE(rest->restore(half->snapshot()));
  while (!rest->is_done()) rest->step();
  EXPECT_EQ(once->hash(), rest->hash());
  EXPECT_GT(once->totals().lists, 1);
}

}  // namespace
}  // namespace plumb::scene
