// Walls of triangles: what a body feels of the edges between them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <ctime>

#include "properties/tests/draws.hpp"
#include "properties/tests/walls/made.hpp"
#include "solver/method/convex.hpp"
#include "solver/scene/wall/touches.hpp"

namespace plumb::scene {
namespace {

using namespace made;  // NOLINT: bodies and walls

const Superellipsoid<double> small_egg{{0.1, 0.08, 0.06}, 2, 2}, brick{{0.1, 0.07, 0.05}, 4, 3};

Mat3<double> tilted() {
  return Eigen::AngleAxisd(0.3, Vec(1, 2, 0.5).normalized()).toRotationMatrix();
}

/// One body that slides, with gravity across the wall and friction.
Scene slide(const Superellipsoid<double>& shape, const Wall& wall, const Mat3<double>& axes, double friction) {
  Scene scene;
  scene.bodies = {body(shape, axes * Vec(0.3, 0.5, 0.101), axes * Vec(2, 0.05, 0))};
  scene.bodies[0].body.quaternion = {0.9, 0.1, 0.2, 0.3};
  scene.walls = {wall};
  scene.effects.gravity = Gravity{axes * Vec(0, 0, -10)};
  scene.effects.linear = Linear{2000};
  scene.effects.damping = Damping{0.5};
  if (friction > 0) scene.effects.friction = Friction{.coefficient = friction, .damping = 0.2};
  scene.run.duration = 3;
  scene.run.time_step = 1e-3;
  return scene;
}

struct Difference {
  double velocity = 0, normal = 0;
  std::size_t most_contacts = 0;
  std::int64_t contacts = 0, parted = 0;
};

/// Two runs side by side.
Difference difference(Simulation& first, Simulation& second, const Vec& into) {
  Difference out;
  bool touched = false;
  while (!first.is_done()) {
    first.step();
    second.step();
    out.velocity = std::max(out.velocity, (velocity(first, 0) - velocity(second, 0)).norm());
    const auto& contacts = touching(second);
    out.most_contacts = std::max(out.most_contacts, contacts.size());
    out.contacts += std::ssize(contacts);
    if (touched && contacts.empty()) ++out.parted;
    touched = !contacts.empty();
    for (const std::uint32_t c : contacts) out.normal = std::max(out.normal, (normal(second, c) - into).norm());
  }
  return out;
}

/// n x n squares, 10 long and 2 wide.
Wall slope(int n, const Mat3<double>& axes) {
  return wall_of(mesh_of(sheet(n, Vec::Zero(), axes * Vec(10, 0, 0), axes * Vec(0, 2, 0))));
}

Wall plane_of(const Mat3<double>& axes) {
  Wall out;
  out.normal = axes * Vec::UnitZ();
  return out;
}

TEST(MeshWalls, OneOfAPlaneIsAPlaneToTheBit) {
  const int n = is_nightly() ? 224 : 60;
  for (const auto& shape : {Superellipsoid<double>{Vec::Constant(0.1)}, small_egg, brick})
    for (const double friction : {0.0, 0.4}) {
      const Mat3<double> axes = Mat3<double>::Identity();
      const auto plane = started(slide(shape, plane_of(axes), axes, friction));
      const auto mesh = started(slide(shape, slope(n, axes), axes, friction));
      const Difference found = difference(*plane, *mesh, -Vec::UnitZ());
      EXPECT_EQ(found.velocity, 0);
      EXPECT_EQ(found.normal, 0);
      EXPECT_EQ(found.most_contacts, 1U);
      EXPECT_GT(found.contacts, 1000);
      EXPECT_EQ(plane->totals().failed + mesh->totals().failed, 0);
    }
}

// Whose corners are rounded: one normal for all, and no energy for edges.
TEST(MeshWalls, ATiltedPlaneIsOnePlane) {
  const Mat3<double> axes = tilted();
  Scene scene = slide({Vec::Constant(0.1)}, slope(80, axes), axes, 0), other = scene;
  other.walls = {plane_of(axes)};
  const auto plane = started(other), mesh = started(scene);
  const Difference found = difference(*plane, *mesh, axes * -Vec::UnitZ());
  EXPECT_LT(found.normal, 1e-12);
  EXPECT_LT(found.velocity, 1e-12);
  EXPECT_EQ(found.most_contacts, 1U);
  EXPECT_GT((axes.transpose() * position(*mesh, 0)).x(), 6);  // over most of it
}

Scene room(const Superellipsoid<double>& shape, std::vector<Wall> walls) {
  Scene scene;
  scene.bodies = {body(shape, {0.1, 0.05, 0.02}, {3, 2.1, 1.3})};
  scene.bodies[0].body.quaternion = {0.9, 0.1, 0.2, 0.3};
  scene.bodies[0].angular_velocity = {1, 2, 3};
  scene.walls = std::move(walls);
  scene.effects.linear = Linear{2000};
  scene.run.duration = is_nightly() ? 150 : 40;
  scene.run.time_step = 5e-4;
  return scene;
}

const Vec room_half(0.5, 0.4, 0.3);

std::vector<Wall> planes_of_room() {
  std::vector<Wall> out;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      Wall& wall = out.emplace_back();
      wall.normal = -sign * Vec::Unit(axis);
      wall.point = sign * Vec::Unit(axis).cwiseProduct(room_half);
    }
  return out;
}

/// Contacts that begin.
std::int64_t bounces(const Simulation& run, std::int64_t before, std::int64_t& sum) {
  const std::int64_t now = std::ssize(touching(run));
  sum += std::max<std::int64_t>(0, now - before);
  return now;
}

TEST(MeshWalls, ARoomOfTrianglesAndABoxAreSixPlanes) {
  const std::vector<Wall> box{wall_of(BoxWall{room_half, Side::inside})},
      mesh{wall_of(mesh_of(box_sheets(room_half, 5)))};
  for (const auto& shape : {Superellipsoid<double>{Vec::Constant(0.1)}, brick}) {
    const auto planes = started(room(shape, planes_of_room())), one = started(room(shape, box)),
               other = started(room(shape, mesh));
    double difference = 0;
    std::int64_t before = 0, sum = 0;
    while (!planes->is_done()) {
      for (auto* run : {planes.get(), one.get(), other.get()}) run->step();
      before = bounces(*planes, before, sum);
      difference = std::max({difference, (velocity(*planes, 0) - velocity(*one, 0)).norm(),
                             (velocity(*planes, 0) - velocity(*other, 0)).norm()});
      ASSERT_EQ(touching(*planes).size(), touching(*other).size()) << "at step " << planes->steps();
    }
    EXPECT_LT(difference, 1e-12);
    EXPECT_GT(sum, is_nightly() ? 1000 : 250);
  }
}

/// Over a ridge, or through a valley: pieces of a circle of radius 1 about (0, 0, 0).
std::vector<Vec> arc(int pieces, double from, double to, double radius = 1) {
  std::vector<Vec> out;
  for (int k = 0; k <= pieces; ++k) {
    const double t = from + (to - from) * k / pieces;
    out.push_back(radius * Vec(std::sin(t), 0, std::cos(t)));
  }
  return out;
}

/// Contacts at once at most, by how much the overlap changed in a step beyond what the body moved, and the energy that was gained.
struct Way {
  std::size_t most = 0;
  double gained = 0, jump = -1;
};

double spin_of(const Simulation& run) {
  return run.world().has_turning() ? spin(run, 0).norm() : 0;
}

Way follow(const Scene& scene) {
  const auto run = started(scene);
  Way out;
  const double first = total_energy(*run);
  double overlap = -1;
  while (!run->is_done()) {
    run->step();
    const auto& contacts = touching(*run);
    out.most = std::max(out.most, contacts.size());
    const double now = contacts.empty() ? 0 : (*run->world().contacts.overlap)[contacts[0]];
    const double moved = velocity(*run, 0).norm() + spin_of(*run) * run->world().bodies.radius[0];
    if (overlap > 0) out.jump = std::max(out.jump, std::abs(now - overlap) - 1.01 * moved * run->plan().time_step);
    overlap = now;
  }
  out.gained = total_energy(*run) / first - 1;
  EXPECT_EQ(run->totals().failed, 0);
  return out;
}

// From face to edge to face there is one contact, whose overlap does not jump.
TEST(MeshWalls, ABodyGoesOverARidgeOnOneContact) {
  for (const auto& shape : {Superellipsoid<double>{Vec::Constant(0.1)}, small_egg, brick}) {
    Scene scene;
    const double high = shape.semi_axes.z();
    scene.bodies = {body(shape, {-0.3, 0.01, 1.03}, {0.6, 0, 0})};
    scene.bodies[0].body.position.z() = std::sqrt(1 - 0.09) + high * 1.02;
    scene.walls = {wall_of(mesh_of(strip(arc(12, -0.8, 0.8))))};
    scene.effects.gravity = Gravity{{0, 0, -10}};
    scene.effects.linear = Linear{5000};
    scene.run.duration = 0.45;
    scene.run.time_step = 1e-5;  // what a bounce gains by a leapfrog goes to 0 with it: 2e-3 at ten times as much
    const Way way = follow(scene);
    EXPECT_EQ(way.most, 1U);
    EXPECT_LT(std::abs(way.gained), 1.5e-4);
    EXPECT_LE(way.jump, 0);
  }
}

TEST(MeshWalls, AValleyOfSmoothlyJoinedTrianglesIsOneContact) {
  for (const auto& shape : {Superellipsoid<double>{Vec::Constant(0.1)}, small_egg}) {
    Scene scene;
    scene.bodies = {body(shape, {-0.3, 0.01, -0.8})};
    scene.walls = {wall_of(mesh_of(strip(arc(40, 2.2, 4.1))))};
    scene.effects.gravity = Gravity{{0, 0, -10}};
    scene.effects.linear = Linear{5000};
    scene.run.duration = 1;
    scene.run.time_step = 4e-5;
    const Way way = follow(scene);
    EXPECT_EQ(way.most, 1U);
    EXPECT_LT(std::abs(way.gained), 1e-3);
  }
}

BodyAtWall placed(const Superellipsoid<double>& shape, const Vec& at, const Eigen::Quaterniond& q) {
  return {shape, at, q, bounding_radius(shape), 0};
}

std::vector<Touch> touches_of(const WallShape& wall, const BodyAtWall& at) {
  std::vector<std::uint32_t> scratch;
  Touches found;
  find_touches(wall, at, scratch, found);
  EXPECT_TRUE(found.is_complete());
  return {found.all().begin(), found.all().end()};
}

// In a corner of a room a ball touches three faces, and none of the edges and corners that are hollow.
TEST(MeshWalls, AHollowCornerHasItsFacesAlone) {
  const MeshWall mesh = mesh_of(box_sheets(room_half, 3));
  const Vec near = room_half - Vec(0.099, 0.098, 0.097);
  const auto found = touches_of(mesh, placed({Vec::Constant(0.1)}, near, Eigen::Quaterniond::Identity()));
  ASSERT_EQ(found.size(), 3U);
  for (const Touch& touch : found) EXPECT_NEAR(touch.into.cwiseAbs().maxCoeff(), 1, 1e-15);
}

// Outside a box is convex: one contact, on a face, an edge or a corner, the same as that of two convex bodies.
TEST(MeshWalls, ABoxFromOutsideIsTheConvexBody) {
  const MeshWall mesh = mesh_of(box_sheets(room_half, 4));
  Stream draws("box from outside", 1, 0);
  int count = 0, faces = 0;
  for (int k = 0; k < 4000; ++k) {
    const Superellipsoid<double> shape{{draws.uniform(0.05, 0.1), draws.uniform(0.05, 0.1), draws.uniform(0.05, 0.1)},
                                       draws.uniform(2, 5),
                                       draws.uniform(2, 5)};
    const Vec about(draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1));
    const Vec at = about.cwiseMax(-1).cwiseProduct(room_half + Vec::Constant(draws.uniform(0.05, 0.1)));
    const Eigen::Quaterniond q =
        Eigen::Quaterniond(draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1))
            .normalized();
    ConvexPair pair;
    pair.body1.shape = shape;
    pair.body1.position = at;
    pair.body1.quaternion = {q.w(), q.x(), q.y(), q.z()};
    pair.body2.shape = Box{room_half};
    const Contact<double> exact = solve_convex(pair, Want{}, nullptr);
    if (exact.status != Status::converged || exact.overlap > 0.02 || exact.overlap < -0.05) continue;
    const auto found = touches_of(mesh, placed(shape, at, q));
    ASSERT_EQ(found.size(), exact.overlap > 0 ? 1U : 0U) << k << ": " << exact.overlap;
    if (found.empty()) continue;
    ++count;
    faces += exact.normal.cwiseAbs().maxCoeff() > 1 - 1e-12 ? 1 : 0;
    EXPECT_NEAR(found[0].overlap, exact.overlap, 1e-12);
    EXPECT_LT((found[0].into - exact.normal).norm(), 1e-6) << k;
  }
  EXPECT_GT(faces, 20);
  EXPECT_GT(count - faces, 20);
}

// Its end hangs beneath the table, which it touches with its side, at the edge.
TEST(MeshWalls, WhatIsBeneathATableDoesNotTouchIt) {
  const MeshWall table = mesh_of(sheet(4, {-1, -1, 0}, {1, 0, 0}, {0, 2, 0}));
  const Eigen::Quaterniond leaning(Eigen::AngleAxisd(0.6, Vec::UnitY()));
  const Vec along = leaning * Vec::UnitZ(), across = leaning * Vec::UnitX();
  const Vec at = 0.3 * along + 0.0199 * across;
  const auto found = touches_of(table, placed({{0.02, 0.02, 0.5}}, at, leaning));
  for (const Touch& touch : found) EXPECT_LT(touch.overlap, 0.01);
}

// Bodies over hills, asked for twice, as in a run: the second time what they are near is known to the processor.
TEST(MeshWalls, AQueryOfManyTriangles) {
  const int n = is_nightly() ? 708 : 100;
  std::vector<Triangle> hills = sheet(n, Vec::Zero(), Vec::UnitX(), Vec::UnitY());
  const auto height = [](const Vec& x) { return 0.02 * std::sin(9 * x.x()) * std::cos(7 * x.y()); };
  for (Triangle& t : hills)
    for (Vec& corner : t) corner.z() = height(corner);
  const MeshWall mesh = mesh_of(std::move(hills));
  Stream draws("hills", 1, 0);
  const double radius = 4.0 / n;
  std::vector<BodyAtWall> bodies;
  for (int k = 0; k < 2000; ++k) {
    const Vec at(draws.uniform(0.1, 0.9), draws.uniform(0.1, 0.9), 0);
    const Superellipsoid<double> shape{radius * Vec(1, draws.uniform(0.6, 1), draws.uniform(0.6, 1)), 2, 2};
    bodies.push_back(
        placed(shape, at + (height(at) + 0.98 * shape.semi_axes.z()) * Vec::UnitZ(), Eigen::Quaterniond::Identity()));
  }
  std::vector<std::uint32_t> scratch;
  for (const char* const when : {"at first", "again"}) {
    std::int64_t touched = 0;
    const std::clock_t start = std::clock();
    for (const BodyAtWall& body : bodies) {
      Touches found;
      find_touches(mesh, body, scratch, found);
      touched += found.all().size() == 1 && found.is_complete() ? 1 : 0;
    }
    const double spent = 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_GT(touched, 1990);
    std::printf("%zu triangles, %s: %.1f us a query\n", mesh.mesh->triangles().size(), when, spent / 2000);
  }
}

TEST(MeshWalls, WhatIsNoMeshIsRefused) {
  const auto refusal = [](const std::vector<Triangle>& triangles) -> std::string {
    try {
      const Mesh mesh(triangles);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const Triangle good{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0)};
  EXPECT_EQ(refusal({}), "triangles: there is none");
  EXPECT_EQ(refusal({good}), "");
  EXPECT_EQ(refusal({good, {Vec(0, 0, 0), Vec(1, 1, 0), Vec(2, 2, 0)}}), "triangles[1]: has no area");
  EXPECT_EQ(refusal({{Vec(0, 0, NAN), Vec(1, 0, 0), Vec(0, 1, 0)}}), "triangles[0]: must be finite numbers");
}

}  // namespace
}  // namespace plumb::scene
