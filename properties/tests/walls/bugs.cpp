// Seeded bugs of walls (fuzz/bugs/walls) change what some body touches, and without a bug all touches are as they should be.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "corpus/json/json_text.hpp"
#include "properties/tests/walls/made.hpp"
#include "solver/method/convex.hpp"
#include "solver/scene/wall/body_at_wall.hpp"

namespace plumb::scene {
namespace {

using namespace made;  // NOLINT: bodies and walls

/// The library that holds them.
struct SeededWalls {
  using Find = std::size_t(int, const std::vector<Triangle>*, const WallShape*, const BodyAtWall*, Touch*, std::size_t);
  Find* find;
  int (*count)();
  const char* (*name)(int);
  const char* (*table)();

  [[nodiscard]] static SeededWalls load() {
    void* library = dlopen(PLUMB_SEEDED_WALLS, RTLD_NOW | RTLD_LOCAL);
    EXPECT_NE(library, nullptr) << dlerror();
    return {reinterpret_cast<Find*>(dlsym(library, "seeded_touches")),
            reinterpret_cast<int (*)()>(dlsym(library, "seeded_count")),
            reinterpret_cast<const char* (*)(int)>(dlsym(library, "seeded_name")),
            reinterpret_cast<const char* (*)()>(dlsym(library, "seeded_table"))};
  }
};

/// A body, a wall, and how deep and along what it touches: known by a closed form, or by the contact of convex bodies.
struct Known {
  const char* name;
  std::vector<Triangle> triangles;
  WallShape shape;
  BodyAtWall body;
  std::vector<double> overlaps;  ///< the deepest first
  Vec into = Vec::Zero();        ///< of the first; 0: not asked
};

BodyAtWall at(const Superellipsoid<double>& shape, const Vec& place,
              const Eigen::Quaterniond& q = Eigen::Quaterniond::Identity()) {
  return {shape, place, q, bounding_radius(shape), 0};
}

const Superellipsoid<double> ball1{Vec::Constant(0.1)};

/// Balls about a box of triangles: over faces, edges and corners.
void add_about_a_box(std::vector<Known>& out) {
  const Vec half(0.5, 0.4, 0.3);
  Stream draws("about a box", 1, 0);
  for (int k = 0; k < 60; ++k) {
    Vec nearest, away;
    for (int axis = 0; axis < 3; ++axis) {
      const double x = draws.uniform(-1.6, 1.6);
      nearest[axis] = std::clamp(x, -1.0, 1.0) * half[axis];
      away[axis] = std::abs(x) > 1 ? std::copysign(draws.uniform(0.1, 1), x) : 0;
    }
    if (away.isZero(0)) continue;
    const Vec n = away.normalized();
    out.push_back({"about a box", box_sheets(half, 3), PlaneWall{}, at(ball1, nearest + 0.09 * n), {0.01}, -n});
  }
}

void add_sheets(std::vector<Known>& out) {
  const auto flat = sheet(4, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  out.push_back({"on a sheet", flat, PlaneWall{}, at(ball1, {0.2, 0.3, 0.09}), {0.01}, -Vec::UnitZ()});
  out.push_back({"under it", flat, PlaneWall{}, at(ball1, {0.2, 0.3, -0.09}), {0.01}, Vec::UnitZ()});
  out.push_back({"beside it", flat, PlaneWall{}, at(ball1, {1.2, 0.3, 0.05}), {}});
  // It leans on the border from beside, its upper end over the sheet, its lower one beneath.
  const auto half = sheet(4, {-1, -1, 0}, {1, 0, 0}, {0, 2, 0});
  const Eigen::Quaterniond leaning(Eigen::AngleAxisd(-0.6, Vec::UnitY()));
  out.push_back({"past its border", half, PlaneWall{}, at({{0.02, 0.02, 0.5}}, Vec(0.05, 0, 0.05), leaning), {}});
  // Flat bodies in a valley: on both sides at the same time, which count as one.
  const double slope = 0.05;
  const auto valley = strip({Vec(-1, 0, slope), Vec(0, 0, 0), Vec(1, 0, slope)});
  const double along = std::atan(slope);
  out.push_back({"in a valley", valley, PlaneWall{}, at(ball1, {0, 0, 0.09 / std::cos(along)}), {0.01}});
  const Vec bent_normal = Vec(-0.01, 0, 1).normalized();
  const auto bent = strip({Vec(-1, 0, 0), Vec(0, 0, 0), Vec(1, 0, 0.01)});
  out.push_back({"on a sheet that is bent",
                 bent,
                 PlaneWall{},
                 at(ball1, Vec(0.5, 0, 0.005) + 0.09 * bent_normal),
                 {0.01},
                 -bent_normal});
  out.push_back({"flat in a valley", valley, PlaneWall{}, at({{0.4, 0.4, 0.1}}, {0.001, 0, 0.1}), {-1}});
}

void add_round(std::vector<Known>& out) {
  const std::vector<Triangle> none;
  const CylinderWall tube{1, 2};
  out.push_back({"in a tube", none, tube, at(ball1, {0, 0.91, 1}), {0.01}, Vec::UnitY()});
  out.push_back({"above a tube", none, tube, at(ball1, {0, 0.91, 2.2}), {}});
  out.push_back({"on its rim", none, tube, at(ball1, Vec(0, 0.94, 2.075)), {0.1 - std::hypot(0.06, 0.075)}});
  out.push_back(
      {"on a cone", none, ConeWall{{0.5, 0}, 1, Side::outside}, at(ball1, {0, 0, 1.09}), {0.01}, -Vec::UnitZ()});
}

std::vector<Known> all_known() {
  std::vector<Known> out;
  add_about_a_box(out);
  add_sheets(out);
  add_round(out);
  return out;
}

/// The first that is not as it is known to be; "" for none. An overlap of -1 is not known, but there is one contact.
std::string killer_of(const SeededWalls& library, int bug, const std::vector<Known>& all) {
  for (const Known& known : all) {
    std::array<Touch, 16> found;
    const std::size_t count =
        library.find(bug, &known.triangles, &known.shape, &known.body, found.data(), found.size());
    if (count != known.overlaps.size()) return std::string(known.name) + ": " + std::to_string(count) + " contacts";
    for (std::size_t k = 0; k < count; ++k) {
      if (known.overlaps[k] < 0 && found[k].overlap < 0.05) continue;
      if (!(std::abs(found[k].overlap - known.overlaps[k]) < 1e-9))
        return std::string(known.name) + ": overlap " + std::to_string(found[k].overlap);
      if (!known.into.isZero(0) && !((found[k].into - known.into).norm() < 1e-7))
        return std::string(known.name) + ": normal";
    }
  }
  return "";
}

TEST(SeededWallBugs, AreKilledButThoseThatSayWhyNot) {
  const SeededWalls library = SeededWalls::load();
  ASSERT_TRUE(library.find && library.count && library.name && library.table);
  const std::vector<Known> all = all_known();
  const Json rows = read_json(library.table());
  EXPECT_EQ(killer_of(library, -1, all), "");
  for (int bug = 0; bug < library.count(); ++bug) {
    const bool is_killed = !killer_of(library, bug, all).empty();
    EXPECT_NE(is_killed, rows.at(static_cast<std::size_t>(bug)).contains("survives")) << library.name(bug);
  }
  EXPECT_GE(library.count(), 12);
}

}  // namespace
}  // namespace plumb::scene
