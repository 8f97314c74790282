// Which pairs of a frame touch: against every pair of every image, and over boundaries of every kind.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "properties/tests/dump/dumps.hpp"
#include "solver/method/automatic.hpp"

namespace plumb {
namespace {

using Image = std::array<int, 3>;
/// Ids and image.
using Found = std::set<std::tuple<std::int64_t, std::int64_t, Image>>;

Found found_in(const DumpFrame& frame, double gap = 0) {
  Found out;
  for (const DumpPair& pair : pairs_of(frame, gap))
    out.insert({frame.particles[pair.first].id, frame.particles[pair.second].id, pair.image});
  return out;
}

DumpFrame balls(const std::string& box, const std::vector<std::string>& rows) {
  return frames_of(DumpText{.columns = "id x y z radius", .rows = rows, .box = box}.text()).at(0);
}

const std::string periodic_x = "ITEM: BOX BOUNDS pp ff ff\n0 10\n0 10\n0 10\n";

TEST(DumpPairs, AcrossABoundaryBody2IsShifted) {
  const DumpFrame frame = balls(periodic_x, {"3 0.5 5 5 1", "8 9.5 5 5 1"});
  const std::vector<DumpPair> pairs = pairs_of(frame);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].image, (Image{-1, 0, 0}));
  EXPECT_EQ(pairs[0].pair.body1.position, Vec3<double>(0.5, 5, 5));
  EXPECT_EQ(pairs[0].pair.body2.position, Vec3<double>(-0.5, 5, 5));
  EXPECT_TRUE(pairs_of(balls("ITEM: BOX BOUNDS ff pp pp\n0 10\n0 10\n0 10\n", {"3 0.5 5 5 1", "8 9.5 5 5 1"})).empty());
}

TEST(DumpPairs, UnwrappedCoordinatesMeetInAnyImage) {
  const Found expected{{3, 8, {-6, 0, 0}}};
  EXPECT_EQ(found_in(balls(periodic_x, {"3 -29.5 5 5 1", "8 29.5 5 5 1"})), expected);
}

TEST(DumpPairs, InASmallBoxThereAreSeveralImages) {
  const std::string box = "ITEM: BOX BOUNDS pp ff ff\n0 3\n0 10\n0 10\n";
  const Found both{{1, 2, {0, 0, 0}}, {1, 2, {-1, 0, 0}}};
  EXPECT_EQ(found_in(balls(box, {"1 0.5 5 5 1", "2 2 5 5 1"})), both);
  const std::string smaller = "ITEM: BOX BOUNDS pp pp ff\n0 1.5\n0 1.8\n0 10\n";
  const Found own{{1, 1, {1, 0, 0}}, {1, 1, {0, 1, 0}}};
  EXPECT_EQ(found_in(balls(smaller, {"1 0.5 1 5 1"})), own);
}

TEST(DumpPairs, TiltedBoxesRepeatAlongTheirEdges) {
  // Edges (10, 0, 0), (5, 10, 0), (0, 0, 10).
  const std::string box = "ITEM: BOX BOUNDS xy xz yz pp pp ff\n0 15 5\n0 10 0\n0 10 0\n";
  const Found over{{1, 2, {0, -1, 0}}};
  EXPECT_EQ(found_in(balls(box, {"1 2 0.5 5 1", "2 7 9.5 5 1"})), over);
  EXPECT_TRUE(found_in(balls(box, {"1 2 0.5 5 1", "2 2 9.5 5 1"})).empty());
}

TEST(DumpPairs, GapTakesPairsApart) {
  const DumpFrame frame = balls(open_box, {"1 0 0 0 1", "2 3.25 0 0 2"});
  EXPECT_EQ(pairs_of(frame).size(), 0U);
  EXPECT_EQ(pairs_of(frame, 0.1).size(), 0U);
  EXPECT_EQ(pairs_of(frame, 0.13).size(), 1U) << "0.25 is 0.125 of the larger body";
}

TEST(DumpPairs, BodiesLargerThanTheBoxAreRefused) {
  const std::string box = "ITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n";
  EXPECT_THROW((void)pairs_of(balls(box, {"1 0 0 0 1e9"})), std::invalid_argument);
  EXPECT_THROW((void)pairs_of(balls(box, {"1 1e9 0 0 0.1"})), std::invalid_argument);
}

double drawn(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1 << 20) / (1 << 20);
}

DumpFrame drawn_frame() {
  DumpFrame frame;
  frame.box.origin = Vec3<double>(drawn(-9, 9), drawn(-9, 9), drawn(-9, 9));
  frame.box.edges << drawn(2, 4), drawn(-2, 2), drawn(-2, 2), 0, drawn(2, 4), drawn(-2, 2), 0, 0, drawn(2, 4);
  for (bool& flag : frame.box.is_periodic) flag = *rc::gen::arbitrary<bool>();
  const int count = *rc::gen::inRange(1, 6);
  for (int id = 1; id <= count; ++id) {
    Body body;
    body.shape = {{drawn(0.5, 1.2), drawn(0.5, 1.2), drawn(0.5, 1.2)}, drawn(2, 5), drawn(2, 5)};
    body.position = frame.box.origin + frame.box.edges * Vec3<double>(drawn(-1, 2), drawn(-1, 2), drawn(-1, 2));
    body.quaternion = {drawn(0.1, 2), drawn(-1, 1), drawn(-1, 1), drawn(-1, 1)};
    frame.particles.push_back({id, body});
  }
  return frame;
}

bool overlap(Pair pair, const DumpBox& box, const Image& image) {
  if (image != Image{}) pair.body2.position += box.edges * Vec3<double>(image[0], image[1], image[2]);
  return automatic<double>(pair, {}, nullptr).verdict == Verdict::overlapping;
}

/// Every pair, and of body 2 every image that can come near: centres are up to three edges apart, and bodies 1.2 large.
Found every_pair(const DumpFrame& frame) {
  constexpr int far = 9;
  std::array<int, 3> reach{};
  for (std::size_t k = 0; k < 3; ++k) reach[k] = frame.box.is_periodic[k] ? far : 0;
  Found out;
  for (std::size_t i = 0; i < frame.particles.size(); ++i)
    for (std::size_t j = i; j < frame.particles.size(); ++j)
      for (int a = -reach[0]; a <= reach[0]; ++a)
        for (int b = -reach[1]; b <= reach[1]; ++b)
          for (int c = -reach[2]; c <= reach[2]; ++c) {
            const Image image{a, b, c};
            if (i == j && !(image > Image{})) continue;
            const auto& [first, second] = std::tie(frame.particles[i], frame.particles[j]);
            const Vec3<double> apart =
                second.body.position + frame.box.edges * Vec3<double>(a, b, c) - first.body.position;
            if (apart.norm() < 5 && overlap({first.body, second.body}, frame.box, image))
              out.insert({first.id, second.id, image});
          }
  return out;
}

RC_GTEST_PROP(DumpPairs, AreThoseOfAllPairsOfAllImages, ()) {
  const DumpFrame frame = drawn_frame();
  const Found found = found_in(frame);
  RC_CLASSIFY(found.empty(), "nothing touches");
  RC_ASSERT(found == every_pair(frame));
}

}  // namespace
}  // namespace plumb
