// Neither a wrong solution nor a tampered proof is confirmed, and a wrong answer is called by its name.
#include <gtest/gtest.h>

#include <functional>

#include "properties/laws/laws.hpp"
#include "solver/pose.hpp"
#include "solver/reference/proof/verify.hpp"
#include "solver/reference/reference.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

using namespace reference;
using I = Interval80;

/// Two equal ellipsoids, centred to 1e-10 of each other: o has its least value 1 - 1e-10 at +z, a second minimum 1 + 1e-10 at
/// -z, saddles at the y axis and maxima at the x axis.
Pair nearly_tied() {
  Pair pair;
  pair.body1.shape.semi_axes = pair.body2.shape.semi_axes = Vec3<double>(1.5, 1.2, 0.5);
  pair.body2.position << 0, 0, 1e-10;
  return pair;
}

RegionProof<I> region_proof(const Pair& pair, const Cell& region, const Vec3<double>& chart) {
  const FramedPair<I> framed(enclose<I>(pair), Mat3<double>::Identity());
  return verify_region<I>(framed, region, {I(chart[0]), I(chart[1]), I(chart[2])});
}

const std::array widths{1.0 / 16, 1e-3, 1e-6, 1e-12};

TEST(Verifier, TakesAMinimumForWhatItIs) {
  for (const double sign : {1.0, -1.0}) {
    const RegionProof<I> proof = region_proof(nearly_tied(), {2, sign, 0, 0, 1e-3}, {0, 0, sign});
    EXPECT_TRUE(proof.convex && proof.located);
    EXPECT_LT(high(proof.radius), 1e-70);
    EXPECT_NEAR(low(proof.value), 1 - sign * 1e-10, 1e-15);
  }
}

TEST(Verifier, RefusesASaddle) {
  for (const double half : widths) EXPECT_FALSE(region_proof(nearly_tied(), {1, 1, 0, 0, half}, {0, 1, 0}).convex);
}

TEST(Verifier, RefusesAMaximum) {
  for (const double half : widths) EXPECT_FALSE(region_proof(nearly_tied(), {0, 1, 0, 0, half}, {1, 0, 0}).convex);
}

TEST(Verifier, RefusesAMovedPoint) {
  const double off = 1e-9;
  EXPECT_FALSE(region_proof(nearly_tied(), {2, 1, off, 0, off / 2}, {off, 0, 1}).located);
  // In a region that holds the true one it says how far that is, and never less.
  const RegionProof<I> wide = region_proof(nearly_tied(), {2, 1, 0, 0, 1e-3}, {off, 0, 1});
  EXPECT_TRUE(wide.convex && wide.located);
  EXPECT_GT(high(wide.radius), off);
}

TEST(Verifier, RefusesAFlippedNormal) {
  Pair pair = nearly_tied();
  pair.body2.position << 0.1, 0.2, 0.9;
  const Vec3<double> n = find_reference(pair, Effort::digits).common_normal.normal.cast<double>();
  ASSERT_GT(n[2], 0.9);
  const Vec3<double> chart = n / n[2];
  for (const double half : widths) {
    if (half > 1e-10) {
      EXPECT_TRUE(region_proof(pair, {2, 1, chart[0], chart[1], half}, chart).located) << half;
    }
    EXPECT_FALSE(region_proof(pair, {2, -1, -chart[0], -chart[1], half}, -chart).located) << half;
  }
}

/// One leaf of a cover with what belongs to it.
struct LeafOf {
  Cell cell;
  Leaf leaf;
  Witness witness;
  int region = -1;
};

/// A cover written again, each leaf as `change` leaves it.
class Rewritten {
 public:
  Rewritten(const Cover& cover, const std::function<void(LeafOf&)>& change) : old_(cover), change_(change) {
    out_.frame = cover.frame;
    out_.regions = cover.regions;
    for (int face = 0; face < 6; ++face) walk(face_of_cube(face));
  }
  [[nodiscard]] const Cover& cover() const { return out_; }

 private:
  void walk(const Cell& cell) {
    const Leaf kind = old_.tree[next_++];
    if (kind == Leaf::split) {
      out_.tree.push_back(kind);
      for (int k = 0; k < 4; ++k) walk(cell.quarter(k));
      return;
    }
    LeafOf leaf{cell, kind, {}, -1};
    if (kind != Leaf::convex) leaf.witness = old_.witnesses[witness_++];
    if (kind == Leaf::convex || kind == Leaf::bounded) leaf.region = old_.regions_of[region_++];
    change_(leaf);
    out_.tree.push_back(leaf.leaf);
    if (leaf.leaf != Leaf::convex) out_.witnesses.push_back(leaf.witness);
    if (leaf.leaf == Leaf::convex || leaf.leaf == Leaf::bounded) out_.regions_of.push_back(leaf.region);
  }

  const Cover& old_;
  const std::function<void(LeafOf&)>& change_;
  Cover out_;
  std::size_t next_ = 0, witness_ = 0, region_ = 0;
};

/// The support points at a cell's centre: the best reason there is for excluding it.
Witness witness_at(const Pair& pair, const Mat3<double>& frame, const Cell& cell) {
  const double inside = 1 - 1e-14;
  const PlacedPair<double> placed = place<double>(pair);
  const Vec3<double> n = (frame * cell.at(0, 0)).normalized();
  const auto point = [&](const PlacedBody<double>& body, const Vec3<double>& u) -> Vec3<double> {
    return support_point<double>(body.shape, body.to_body_direction(u)).gradient * inside;
  };
  return {point(placed.body1, n), point(placed.body2, -n)};
}

/// An honest cover, and what the verifier says of others in its place. The size lies in [1, 2): the pair's unit is the world's.
class CoverTest : public testing::Test {
 protected:
  CoverTest() : pair_(nearly_tied()), found_(find_reference(pair_, Effort::digits)) {
    level_ = std::nextafter(static_cast<double>(found_.overlap.upper), 2);
  }
  [[nodiscard]] CoverProof verified(const Cover& cover, double level) const {
    return verify_cover<Interval18>({enclose<Interval18>(pair_), cover.frame}, cover, level);
  }
  [[nodiscard]] bool stands(const Cover& cover, double level) const {
    const CoverProof proof = verified(cover, level);
    return proof.well_formed && proof.excluded && proof.least_open >= level;
  }
  [[nodiscard]] bool stands(const Cover& cover) const { return stands(cover, level_); }

  Pair pair_;
  Reference found_;
  double level_ = 0;
};

TEST_F(CoverTest, StandsAsItIs) {
  EXPECT_TRUE(stands(found_.cover));
  EXPECT_TRUE(stands(Rewritten(found_.cover, [](LeafOf&) {}).cover()));
  EXPECT_EQ(found_.unique, Claim::proved);
  EXPECT_GT(found_.common_normal.normal[2], 0.99);
}

/// The second minimum passed off as the lowest: at its level the directions of the first cannot be excluded.
TEST_F(CoverTest, DoesNotStandForASecondMinimum) {
  const auto forge = [&](LeafOf& leaf) {
    const Vec3<double> n = found_.cover.frame * leaf.cell.at(0, 0);
    if (leaf.region >= 0 && n[2] > 0)
      leaf = {leaf.cell, Leaf::excluded, witness_at(pair_, found_.cover.frame, leaf.cell), -1};
  };
  EXPECT_FALSE(stands(Rewritten(found_.cover, forge).cover(), 1 + 1e-10));
  EXPECT_FALSE(stands(Rewritten(found_.cover, forge).cover(), 1 - 1e-10));
}

TEST_F(CoverTest, ALeafThatCannotBeExcluded) {
  bool done = false;
  const auto forge = [&](LeafOf& leaf) {
    if (done || leaf.region < 0) return;
    leaf = {leaf.cell, Leaf::excluded, witness_at(pair_, found_.cover.frame, leaf.cell), -1};
    done = true;
  };
  const Rewritten forged(found_.cover, forge);
  ASSERT_TRUE(done);
  EXPECT_FALSE(verified(forged.cover(), level_).excluded);
}

TEST_F(CoverTest, AWitnessOutsideItsBody) {
  for (const std::size_t k : {std::size_t{0}, found_.cover.witnesses.size() - 1})
    for (const double factor : {1.001, 1 + 1e-12}) {
      Cover first = found_.cover, second = found_.cover;
      first.witnesses[k].point1 *= factor;
      second.witnesses[k].point2 *= factor;
      EXPECT_FALSE(verified(first, level_).well_formed);
      EXPECT_FALSE(verified(second, level_).well_formed);
    }
}

TEST_F(CoverTest, LeavesMissingOrTooMany) {
  Cover missing = found_.cover, more = found_.cover, none = found_.cover;
  missing.tree.pop_back();
  more.tree.push_back(Leaf::excluded);
  none.tree.clear();
  EXPECT_FALSE(verified(missing, level_).well_formed);
  EXPECT_FALSE(verified(more, level_).well_formed);
  EXPECT_FALSE(verified(none, level_).well_formed);
  Cover fewer = found_.cover;
  fewer.witnesses.pop_back();
  EXPECT_FALSE(verified(fewer, level_).well_formed);
}

TEST_F(CoverTest, AWrongLevel) {
  EXPECT_FALSE(stands(found_.cover, 1.05));
  EXPECT_FALSE(stands(found_.cover, 3));
}

TEST_F(CoverTest, ARegionElsewhere) {
  for (std::size_t k = 0; k < found_.cover.regions.size(); ++k) {
    Cover shifted = found_.cover, turned = found_.cover, narrow = found_.cover;
    shifted.regions[k].u += shifted.regions[k].half;
    turned.regions[k].axis = (turned.regions[k].axis + 1) % 3;
    narrow.regions[k].half *= 1e-6;
    EXPECT_FALSE(stands(shifted));
    EXPECT_FALSE(stands(turned));
    EXPECT_FALSE(stands(narrow));
  }
  Cover unknown = found_.cover;
  unknown.regions_of.front() = static_cast<int>(unknown.regions.size());
  EXPECT_FALSE(verified(unknown, level_).well_formed);
}

Contact<double> answer_of(const Vec3<double>& normal, const Vec3<double>& point1, const Vec3<double>& point2) {
  Contact<double> out;
  out.method = "somebody's";
  out.status = Status::converged;
  out.normal = normal;
  out.point1 = point1;
  out.point2 = point2;
  out.overlap = normal.dot(point1 - point2);
  out.verdict = out.overlap > 0 ? Verdict::overlapping : Verdict::separated;
  out.contact_point = (point1 + point2) / 2;
  return out;
}

FindingKind finding(const Pair& pair, const Contact<double>& answer) {
  return Judge(pair).judge(Problem::common_normal, answer).finding.kind;
}

TEST(WrongAnswers, AreNamed) {
  const Pair pair = nearly_tied();
  const double top = 0.5, shift = 1e-10;
  const Vec3<double> x = Vec3<double>::UnitX(), y = Vec3<double>::UnitY(), z = Vec3<double>::UnitZ();
  const Contact<double> right = answer_of(z, top * z, (shift - top) * z);
  EXPECT_EQ(finding(pair, right), FindingKind::none);
  EXPECT_EQ(finding(pair, answer_of(-z, -top * z, (shift + top) * z)), FindingKind::wrong_branch);
  Contact<double> flipped = right;
  flipped.normal = -z;
  EXPECT_EQ(finding(pair, flipped), FindingKind::misaligned);
  EXPECT_EQ(finding(pair, answer_of(z, top * z + 1e-9 * x, (shift - top) * z)), FindingKind::misaligned);
  EXPECT_EQ(finding(pair, answer_of(z, (top + 1e-9) * z, (shift - top) * z)), FindingKind::off_surface);
  Pair concentric = pair;
  concentric.body2.position.setZero();
  EXPECT_EQ(finding(concentric, answer_of(y, 1.2 * y, -1.2 * y)), FindingKind::wrong_branch) << "a saddle";
  EXPECT_EQ(finding(concentric, answer_of(x, 1.5 * x, -1.5 * x)), FindingKind::wrong_branch) << "a maximum";
}

}  // namespace
}  // namespace plumb
