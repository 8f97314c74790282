// What the reader takes from a dump, and what it refuses.
#include <gtest/gtest.h>

#include "corpus/case/case.hpp"
#include "properties/tests/dump/dumps.hpp"

namespace plumb {
namespace {

using Axes = Vec3<double>;
using Quaternion = std::array<double, 4>;

Body body_of(const DumpText& dump, const DumpOptions& options = {}) {
  const std::vector<DumpFrame> frames = frames_of(dump.text(), options);
  return frames.at(0).particles.at(0).body;
}

std::string refusal_of(const std::string& text, const DumpOptions& options = {}) {
  try {
    (void)frames_of(text, options);
  } catch (const InputFailure& error) {
    return error.what();
  }
  return "read";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

const DumpText two{.rows = {"7 1 1 2 3 0.5 0.5 0.5 0.5 2 4 6 3 5", "2 1 4 5 6 1 0 0 0 1 1 1 2 2"}};

TEST(ReadingDumps, LammpsShapesAreDiametersAndBlocksN1AndN2) {
  const DumpFrame frame = frames_of(two.text()).at(0);
  EXPECT_EQ(frame.step, 100);
  EXPECT_EQ(frame.format, DumpFormat::lammps);
  ASSERT_EQ(frame.particles.size(), 2U);
  EXPECT_EQ(frame.particles[0].id, 2) << "by rising id";
  const Body& body = frame.particles[1].body;
  EXPECT_EQ(body.shape.semi_axes, Axes(1, 2, 3));
  EXPECT_EQ(body.shape.n1, 3);
  EXPECT_EQ(body.shape.n2, 5);
  EXPECT_EQ(body.position, Axes(1, 2, 3));
  EXPECT_EQ(body.quaternion, (Quaternion{0.5, 0.5, 0.5, 0.5}));
}

TEST(ReadingDumps, LiggghtsShapesAreSemiAxes) {
  const DumpText dump{.columns = "blockiness2 blockiness1 id shapex shapey shapez quat1 quat2 quat3 quat4 radius x y z",
                      .rows = {"5 3 7 2 4 6 0 1 0 0 7 1 2 3"},
                      .before = "ITEM: LABEL\nsome words\n"};
  const DumpFrame frame = frames_of(dump.text()).at(0);
  EXPECT_EQ(frame.format, DumpFormat::liggghts);
  const Body& body = frame.particles.at(0).body;
  EXPECT_EQ(body.shape.semi_axes, Axes(2, 4, 6)) << "the radius is a bounding one";
  EXPECT_EQ(body.shape.n1, 3);
  EXPECT_EQ(body.shape.n2, 5);
  EXPECT_EQ(body.quaternion, (Quaternion{0, 1, 0, 0}));
}

TEST(ReadingDumps, TheFormatMayBeSaid) {
  EXPECT_EQ(body_of(two, {DumpFormat::liggghts, {}}).shape.semi_axes, Axes(1, 1, 1));
  const DumpText bare{.columns = "id x y z shapex shapey shapez", .rows = {"1 0 0 0 2 2 2"}};
  EXPECT_EQ(body_of(bare, {DumpFormat::lammps, {}}).shape.semi_axes, Axes(1, 1, 1));
  EXPECT_EQ(refusal_of(bare.text()),
            "d.dump:9: shapex: a diameter in LAMMPS's dumps and a semi-axis in LIGGGHTS's: --format says which");
}

TEST(ReadingDumps, ComputesAreKnownByCustomaryNamesOrByTheirColumn) {
  const DumpText known{.columns =
                           "id x y z c_q[1] c_q[2] c_q[3] c_q[4] c_shape[1] c_shape[2] c_shape[3] d_block1 d_block2",
                       .rows = {"1 0 0 0 1 2 3 4 2 4 6 3 5"}};
  EXPECT_EQ(body_of(known).quaternion, (Quaternion{1, 2, 3, 4}));
  EXPECT_EQ(body_of(known).shape.semi_axes, Axes(1, 2, 3));
  EXPECT_EQ(body_of(known).shape.n2, 5);
  const DumpText named{.columns = "id x y z c_1[1] c_1[2] c_1[3] c_1[4] shapex shapey shapez",
                       .rows = {"1 0 0 0 2 3 4 1 2 4 6"}};
  const DumpOptions options{DumpFormat::lammps,
                            {{"quati", "c_1[1]"}, {"quatj", "c_1[2]"}, {"quatk", "c_1[3]"}, {"quatw", "c_1[4]"}}};
  EXPECT_EQ(body_of(named, options).quaternion, (Quaternion{1, 2, 3, 4}));
}

TEST(ReadingDumps, WhatWasTakenForWhatIsToldOnce) {
  const DumpText dump{.columns = "id x y z c_q[1] c_q[2] c_q[3] c_q[4] shapex shapey shapez",
                      .rows = {"1 0 0 0 1 0 0 0 2 2 2"}};
  std::istringstream in(dump.text() + dump.text());
  DumpReader reader(in, "d.dump", {});
  while (reader.next([](std::int64_t) { return true; })) continue;
  EXPECT_EQ(reader.notes(), (std::vector<std::string>{"c_q[1] is taken for quatw", "c_q[2] is taken for quati",
                                                      "c_q[3] is taken for quatj", "c_q[4] is taken for quatk",
                                                      "no columns block1 block2: every shape is an ellipsoid"}));
}

TEST(ReadingDumps, SpheresByRadiusOrDiameterAndPointsAreCounted) {
  const DumpText radius{.columns = "id type xu yu zu radius", .rows = {"1 1 1 2 3 0.5", "2 1 0 0 0 0"}};
  const DumpFrame frame = frames_of(radius.text()).at(0);
  EXPECT_EQ(frame.points, 1U);
  ASSERT_EQ(frame.particles.size(), 1U);
  EXPECT_EQ(frame.particles[0].body.shape.semi_axes, Axes(0.5, 0.5, 0.5));
  const DumpText mixed{.columns = "id x y z shapex shapey shapez quatw quati quatj quatk block1 block2 diameter",
                       .rows = {"1 0 0 0 0 0 0 0 0 0 0 0 0 3"}};
  EXPECT_EQ(body_of(mixed).shape.semi_axes, Axes(1.5, 1.5, 1.5));
  EXPECT_EQ(body_of(mixed).shape.n1, 2);
  EXPECT_EQ(body_of(mixed).quaternion, (Quaternion{1, 0, 0, 0}));
}

TEST(ReadingDumps, ScaledCoordinatesAreInTheBox) {
  DumpText dump{
      .columns = "id xs ys zs radius", .rows = {"1 0.5 0.25 1"}, .box = "ITEM: BOX BOUNDS pp ff mm\n0 4\n-2 2\n1 3\n"};
  dump.rows = {"1 0.5 0.25 1 1"};
  EXPECT_EQ(body_of(dump).position, Axes(2, -1, 3));
  // Edges (4, 0, 0), (1, 4, 0), (-1, 0.5, 2) from (0, -2, 1): LAMMPS writes the box around them.
  dump.box = "ITEM: BOX BOUNDS xy xz yz pp pp pp\n-1 5 1\n-2 2.5 -1\n1 3 0.5\n";
  EXPECT_EQ(body_of(dump).position, Axes(2 + 0.25 - 1, -2 + 1 + 0.5, 3));
  dump.box = "ITEM: BOX BOUNDS abc origin pp pp pp\n4 0 0 0\n1 4 0 -2\n-1 0.5 2 1\n";
  EXPECT_EQ(body_of(dump).position, Axes(2 + 0.25 - 1, -2 + 1 + 0.5, 3));
}

TEST(ReadingDumps, FramesFollowEachOtherAndUnitsHoldForAll) {
  DumpText first = two, second = two;
  first.before = "ITEM: UNITS\nsi\nITEM: TIME\n0.125\n";
  second.step = "200";
  const std::vector<DumpFrame> frames = frames_of(first.text() + "\n" + second.text());
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].time, 0.125);
  EXPECT_FALSE(frames[1].time);
  EXPECT_EQ(frames[1].step, 200);
  EXPECT_EQ(frames[1].units, "si");
}

TEST(ReadingDumps, RowsOfOtherStepsAreNotRead) {
  DumpText broken = two, whole = two;
  broken.rows = {"nothing of a particle"};
  whole.step = "200";
  std::istringstream in(broken.text() + whole.text());
  DumpReader reader(in, "d.dump", {});
  const auto frame = reader.next([](std::int64_t step) { return step == 200; });
  if (!frame) FAIL();
  EXPECT_EQ(frame->step, 200);
}

TEST(ReadingDumps, LinesOfOtherSystemsAreRead) {
  std::string text = two.text();
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
  EXPECT_EQ(frames_of(text).at(0).particles.size(), 2U);
}

struct Refused {
  std::string text, words;
};

TEST(ReadingDumps, RefusalsNameLineFieldAndReason) {
  const std::string text = two.text();
  const std::vector<Refused> all{
      {"x", "1: 'x' where 'ITEM: ..' should stand"},
      {"\x1f\x8b\x08", "1: is compressed: zcat FILE | plumb import -"},
      {replaced(text, "ITEM: TIMESTEP", "ITEM: WEATHER"), "1: 'ITEM: WEATHER' is no item of a dump of atoms"},
      {replaced(text, "\n100\n", "\n1e2\n"), "2: TIMESTEP: '1e2' is no whole number"},
      {replaced(text, "ITEM: TIMESTEP\n100\n", ""), "7: TIMESTEP: stands nowhere before the atoms"},
      {replaced(text, "ITEM: NUMBER OF ATOMS\n2\n", ""), "7: NUMBER OF ATOMS: stands nowhere before the atoms"},
      {replaced(text, open_box, ""), "5: BOX BOUNDS: stands nowhere before the atoms"},
      {replaced(text, "\n2\n", "\n-2\n"), "4: NUMBER OF ATOMS: must not be negative"},
      {replaced(text, "\n2\n", "\n3\n"), "11: ATOMS: the file ends in the middle of a frame"},
      {replaced(text, "\n2\n", "\n1\n"), "11: '2 1 4 5 6 1 0 0 0 1 1 1 2 2 ' where 'ITEM: ..' should stand"},
      {"ITEM: TIMESTEP\n100\n", "2: the file ends in the middle of a frame"},
      {"ITEM: TIMESTEP\n", "1: TIMESTEP: the file ends in the middle of a frame"},
      {replaced(text, "-10 10", "-10"), "6: BOX BOUNDS: needs 2 numbers a line"},
      {replaced(text, "-10 10", "10 -10"), "8: BOX BOUNDS: the low bound is above the high one"},
      {replaced(text, "-10 10", "-10 1e101"), "6: BOX BOUNDS: '1e101' is beyond 1e100"},
      {replaced(text, "ff ff ff\n-10 10", "ff ff pp\n0 0"), "8: BOX BOUNDS: a periodic box without volume"},
      {replaced(text, "ff ff ff", "ff ff"), "5: BOX BOUNDS: needs three boundary flags (pp, ff, ..)"},
      {replaced(text, "id type", "no type"), "9: id: no such column: cases are named by it"},
      {replaced(text, "x y z", "a b c"), "9: x: no columns of a position: x y z, xu yu zu, xs ys zs or xsu ysu zsu"},
      {replaced(text, "x y z", "x y c"), "9: z: no such column, but one for x"},
      {replaced(text, "shapex shapey shapez", "a b c"),
       "9: shapex: no columns of a size: shapex shapey shapez, radius or diameter"},
      {replaced(text, "block2", "a"), "9: block2: no such column, but one for block1"},
      {replaced(text, "quatk", "a"), "9: quatk: no such column, but one for quatw"},
      {replaced(text, "type x", "x x"), "9: x: two columns for it: x"},
      {replaced(text, "quatw quati quatj quatk", "a b c d"),
       "10: quatw: no columns quatw quati quatj quatk, and the particle is no sphere"},
      {replaced(text, "7 1 1", "7.5 1 1"), "10: id: '7.5' is no whole number"},
      {replaced(text, "7 1 1", "2 1 1"), "11: id: 2 stands twice in the frame that ends here"},
      {replaced(text, "7 1 1", "7 1 nan"), "10: x: 'nan' is no finite number"},
      {replaced(text, "7 1 1", "7 1 1e999"), "10: x: '1e999' is no finite number"},
      {replaced(text, "7 1 1", "7 1 1x"), "10: x: '1x' is no finite number"},
      {replaced(text, "7 1 1", "7 1 1 1"), "10: ATOMS: 15 values in a row of 14 columns"},
      {replaced(text, " 2 4 6 ", " 2 0 6 "), "10: shapey: must be positive, or all three 0"},
      {replaced(text, " 2 4 6 ", " 2 4 -6 "), "10: shapez: must be positive, or all three 0"},
      {replaced(text, " 3 5 ", " 1 5 "), "10: block1: must be above 1"},
      {replaced(text, " 3 5 ", " 3 0 "), "10: block2: must be above 1"},
      {replaced(text, "0.5 0.5 0.5 0.5", "0 0 0 0"), "10: quatw: must not be 0, nor the other three"},
      {replaced(text, " 2 4 6 ", " 5e-324 4 6 "), "10: shape.superellipsoid.semi_axes[0]: must be finite and above 0"}};
  for (const auto& [input, words] : all) EXPECT_EQ(refusal_of(input), "d.dump:" + words);
  const DumpText negative{.columns = "id x y z radius", .rows = {"1 0 0 0 -1"}};
  EXPECT_EQ(refusal_of(negative.text()), "d.dump:10: radius: must not be negative");
  EXPECT_EQ(refusal_of(text, {DumpFormat::lammps, {{"quatw", "c_9[1]"}}}), "d.dump:9: quatw: no column c_9[1]");
}

}  // namespace
}  // namespace plumb
