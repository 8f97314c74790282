// Stored proofs: one that is made verifies, its bounds are true, and whatever is changed in it is refused or proves what is
// true all the same.
#include "solver/reference/proof/proof.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "solver/reference/search/make_proof.hpp"

namespace plumb::reference::proof_tests {
namespace {

using Fine = Real50;

/// A pair, the proof made of its reference, and its lowest overlap to all digits.
struct Made {
  std::string name;
  Pair pair;
  Proof proof;
  Bounds truth;
};

Made made(const std::string& name, const Pair& pair) {
  const std::optional<Proof> proof = make_proof(pair, find_reference(pair, Effort::bounds));
  EXPECT_TRUE(proof) << name;
  return {name, pair, proof.value_or(Proof{}), find_reference(pair).overlap};
}

Pair spheroids_in_line(double apart) {
  Pair pair;
  pair.body1.shape.semi_axes << 1, 1, 2;
  pair.body2.shape.semi_axes << 0.7, 0.7, 1.5;
  pair.body2.position << 0, 0, apart;
  return pair;
}

Pair separated(Pair pair) {
  pair.body2.position = pair.body1.position + 2.5 * (pair.body2.position - pair.body1.position);
  return pair;
}

/// Of each kind of proof some.
const std::vector<Made>& all_made() {
  static const std::vector<Made> out = [] {
    std::vector<Made> list;
    for (const char* family : {"spheroid", "ellipsoid", "superquadric"})
      for (std::uint64_t i = 0; i < 2; ++i) {
        const Case c = generate(family, 51, i);
        list.push_back(made(c.name, c.pair));
        list.push_back(made(c.name + ", apart", separated(c.pair)));
      }
    list.push_back(made("in line", spheroids_in_line(1)));
    Pair spheres;
    spheres.body2.position << 0.3, 0.9, 1.1;
    list.push_back(made("spheres", spheres));
    spheres.body2.position.setZero();
    spheres.body2.shape.semi_axes *= 0.75;
    list.push_back(made("concentric spheres", spheres));
    return list;
  }();
  return out;
}

/// Refused, or true: it says nothing that is not so.
bool is_refused(const Pair& pair, const Proof& proof, const Bounds& truth, const std::string& what) {
  const ProofCheck check = verify_proof(pair, proof);
  if (!check.failure.empty()) return true;
  EXPECT_LE(check.overlap.lower, truth.upper) << what;
  EXPECT_GE(check.overlap.upper, truth.lower) << what;
  return false;
}

TEST(Proof, OneThatIsMadeVerifiesAndItsBoundsAreTrue) {
  std::array<int, 4> of_kind{};
  for (const Made& m : all_made()) {
    const ProofCheck check = verify_proof(m.pair, m.proof);
    EXPECT_EQ(check.failure, "") << m.name;
    EXPECT_LE(check.overlap.lower, m.truth.upper) << m.name;
    EXPECT_GE(check.overlap.upper, m.truth.lower) << m.name;
    EXPECT_LE(check.overlap.upper - check.overlap.lower, Fine(1e-11) * size_of(m.pair)) << m.name;
    ++of_kind.at(static_cast<std::size_t>(m.proof.kind));
  }
  for (const int count : of_kind) EXPECT_GT(count, 0);
}

TEST(Proof, OfAnotherKindItIsNone) {
  for (const Made& m : all_made())
    for (const ProofKind kind : {ProofKind::cover, ProofKind::meridian, ProofKind::spheres, ProofKind::apart}) {
      if (kind == m.proof.kind) continue;
      // That of spheres asks for no more than a direction.
      if (kind == ProofKind::spheres && m.name == "spheres") continue;
      Proof other = m.proof;
      other.kind = kind;
      EXPECT_TRUE(is_refused(m.pair, other, m.truth, m.name)) << m.name << ", kind " << static_cast<int>(kind);
    }
}

using Change = std::function<void(Proof&)>;

/// Each change to each proof of a kind.
void expect_refused(ProofKind kind, const std::vector<std::pair<const char*, Change>>& changes) {
  int tried = 0;
  for (const Made& m : all_made()) {
    if (m.proof.kind != kind) continue;
    for (const auto& [what, change] : changes) {
      Proof changed = m.proof;
      change(changed);
      EXPECT_TRUE(is_refused(m.pair, changed, m.truth, m.name)) << m.name << ": " << what;
      ++tried;
    }
  }
  EXPECT_GT(tried, 0);
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

/// Changes that every kind must refuse.
const std::vector<std::pair<const char*, Change>> of_any_kind{
    {"a stretched frame", [](Proof& p) { p.cover.frame.col(0) *= 3; }},
    {"a frame of rank two", [](Proof& p) { p.cover.frame.col(0) = p.cover.frame.col(1); }},
    {"a frame that is no number", [](Proof& p) { p.cover.frame(1, 1) = nan; }},
    {"no direction", [](Proof& p) { p.direction.high.setZero(), p.direction.low.setZero(); }},
    {"a direction that is no number", [](Proof& p) { p.direction.high[1] = nan; }},
    {"an infinite direction", [](Proof& p) { p.direction.low[1] = infinite; }},
    {"a solution too many", [](Proof& p) { p.solutions.push_back({}); }},
    {"a region without a solution", [](Proof& p) { p.cover.regions.push_back({0, 1, 0, 0, 0.1}); }},
};

TEST(Proof, ACoverChangedAnywhereIsRefused) {
  expect_refused(ProofKind::cover, of_any_kind);
  expect_refused(
      ProofKind::cover,
      {{"a level raised to 3", [](Proof& p) { p.level = 3; }},
       {"a level below zero", [](Proof& p) { p.level = -1e-9; }},
       {"a level that is no number", [](Proof& p) { p.level = nan; }},
       {"a leaf missing", [](Proof& p) { p.cover.tree.pop_back(); }},
       {"a leaf too many", [](Proof& p) { p.cover.tree.push_back(Leaf::excluded); }},
       {"no leaves", [](Proof& p) { p.cover.tree.clear(); }},
       {"a region twice as narrow", [](Proof& p) { p.cover.regions.front().half /= 1e6; }},
       {"a region as wide as a face", [](Proof& p) { p.cover.regions.front().half = 1; }},
       {"a region on another face",
        [](Proof& p) { p.cover.regions.front().axis = (p.cover.regions.front().axis + 1) % 3; }},
       {"a region on the other side", [](Proof& p) { p.cover.regions.front().sign *= -1; }},
       {"a region on no face", [](Proof& p) { p.cover.regions.front().axis = 3; }},
       {"a region of half a sign", [](Proof& p) { p.cover.regions.front().sign = 0.5; }},
       {"a solution outside its region",
        [](Proof& p) { p.solutions.front().high[p.cover.regions.front().axis == 0 ? 1 : 0] += 1.5; }},
       {"a solution off its face", [](Proof& p) { p.solutions.front().low[p.cover.regions.front().axis] = 1e-30; }},
       {"a leaf of a region that is not there", [](Proof& p) { p.cover.regions_of.front() = 99; }},
       {"a leaf of region -1", [](Proof& p) { p.cover.regions_of.back() = -1; }},
       {"a witness missing", [](Proof& p) { p.cover.witnesses.pop_back(); }},
       {"a witness too many", [](Proof& p) { p.cover.witnesses.push_back(p.cover.witnesses.front()); }},
       {"a witness that is no number", [](Proof& p) { p.cover.witnesses.front().point2[1] = nan; }}});
}

/// The places of the leaves of a kind in a tree.
std::vector<std::size_t> leaves_of(const Proof& proof, Leaf kind) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < proof.cover.tree.size(); ++k)
    if (proof.cover.tree[k] == kind) out.push_back(k);
  return out;
}

/// So many of the places 0 .. count - 1, the first and the last of them.
std::vector<std::size_t> some_of(std::size_t count, std::size_t most) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < std::min(count, most); ++k)
    out.push_back(k * (count - 1) / std::max<std::size_t>(1, std::min(count, most) - 1));
  return out;
}

TEST(Proof, NoWitnessMayBeMovedOutOfItsBody) {
  for (const Made& m : all_made()) {
    if (m.proof.kind != ProofKind::cover) continue;
    for (const std::size_t k : some_of(m.proof.cover.witnesses.size(), 6)) {
      Proof one = m.proof, two = m.proof;
      one.cover.witnesses[k].point1 *= 1 + 1e-9;
      two.cover.witnesses[k].point2 = two.cover.witnesses[k].point2 * 1.5 + Vec3<double>(0, 0, 1e-3);
      EXPECT_TRUE(is_refused(m.pair, two, m.truth, m.name)) << m.name << ", witness " << k;
      (void)is_refused(m.pair, one, m.truth, m.name);  // it may have had that much room
    }
  }
}

/// A leaf's letter: of those that need a witness or a region the counts no longer agree, and of the others the claim is false.
TEST(Proof, NoLeafMayChangeItsLetter) {
  int refused = 0, true_all_the_same = 0;
  for (const Made& m : all_made()) {
    if (m.proof.kind != ProofKind::cover) continue;
    for (const Leaf from : {Leaf::split, Leaf::excluded, Leaf::open, Leaf::bounded, Leaf::convex})
      for (const Leaf to : {Leaf::split, Leaf::excluded, Leaf::open, Leaf::bounded, Leaf::convex}) {
        if (from == to) continue;
        const std::vector<std::size_t> places = leaves_of(m.proof, from);
        for (const std::size_t k : places.empty() ? std::vector<std::size_t>{} : some_of(places.size(), 3)) {
          Proof changed = m.proof;
          changed.cover.tree[places[k]] = to;
          const bool is_none = is_refused(m.pair, changed, m.truth, m.name);
          // An excluded leaf may as well be an open one: its witness bounds it.
          const bool may_be_so =
              (from == Leaf::excluded && to == Leaf::open) || (from == Leaf::open && to == Leaf::excluded);
          if (!may_be_so) {
            EXPECT_TRUE(is_none) << m.name << ": " << static_cast<int>(from) << " to " << static_cast<int>(to);
          }
          (is_none ? refused : true_all_the_same) += 1;
        }
      }
  }
  EXPECT_GT(refused, 50);
  EXPECT_GT(true_all_the_same, 0);
}

/// Numbers of a proof changed at random, a little or much: refused, or true.
TEST(Proof, NoChangeMakesItProveWhatIsFalse) {
  int refused = 0, held = 0;
  Stream stream("tampering", 1, 0);
  const auto shake = [&](double& x) {
    x = stream.chance(0.5) ? x * (1 + stream.signed_log_uniform(1e-12, 1)) : x + stream.signed_log_uniform(1e-9, 1);
  };
  for (const Made& m : all_made())
    for (int draw = 0; draw < 8; ++draw) {
      Proof p = m.proof;
      const auto any = [&](std::size_t count) { return stream.below(count); };
      switch (draw) {
        case 0: shake(p.level); break;
        case 1: shake(p.cover.frame(static_cast<int>(any(3)), static_cast<int>(any(3)))); break;
        case 2: shake(p.direction.high[static_cast<int>(any(3))]); break;
        case 3:
          for (Witness& w : p.cover.witnesses) w.point1 *= 1 - stream.uniform() * 1e-3;
          break;
        case 4:
          if (!p.cover.regions.empty()) shake(p.cover.regions[any(p.cover.regions.size())].half);
          break;
        case 5:
          if (!p.solutions.empty()) shake(p.solutions[any(p.solutions.size())].high[static_cast<int>(any(3))]);
          break;
        case 6:
          if (!p.meridian.places.empty()) shake(p.meridian.places[any(p.meridian.places.size())]);
          for (Valley& valley : p.meridian.valleys) shake(valley.last);
          break;
        default:
          shake(p.apart.point1[static_cast<int>(any(3))]);
          if (!p.cover.regions.empty()) shake(p.cover.regions[any(p.cover.regions.size())].u);
      }
      (is_refused(m.pair, p, m.truth, m.name + ", draw " + std::to_string(draw)) ? refused : held) += 1;
    }
  EXPECT_GT(refused, 15);
  EXPECT_GT(held, 30);  // the bounds were put to the test
}

/// A proof of one pair proves of another only what is true of that.
TEST(Proof, OfAnotherPairItIsNoneOrTrue) {
  int refused = 0;
  for (const Made& m : all_made())
    for (const double by : {1e-9, 1e-3, 0.1}) {
      Pair other = m.pair;
      other.body2.position[0] += by * size_of(m.pair);
      other.body1.shape.semi_axes[1] *= 1 - by / 4;
      refused += is_refused(other, m.proof, find_reference(other, Effort::bounds).overlap, m.name) ? 1 : 0;
    }
  EXPECT_GT(refused, 10);
}

TEST(Proof, AChangedMeridianIsRefused) {
  expect_refused(ProofKind::meridian, of_any_kind);
  expect_refused(ProofKind::meridian,
                 {{"a first place", [](Proof& p) { p.meridian.places.front() = 0.001; }},
                  {"a last place", [](Proof& p) { p.meridian.places.back() = 3.999; }},
                  {"a place missing", [](Proof& p) { p.meridian.places.erase(p.meridian.places.begin() + 1); }},
                  {"a witness outside", [](Proof& p) { p.meridian.witnesses.front().point1 *= 1.01; }},
                  {"a witness missing", [](Proof& p) { p.meridian.witnesses.pop_back(); }},
                  {"no arcs", [](Proof& p) { p.meridian = {}; }}});
}

TEST(Proof, AChangedProofOfADistanceIsRefused) {
  expect_refused(ProofKind::apart, of_any_kind);
  expect_refused(ProofKind::apart,
                 {{"the opposite direction",
                   [](Proof& p) { p.direction.high = -p.direction.high, p.direction.low = -p.direction.low; }},
                  {"a point outside its body", [](Proof& p) { p.apart.point1 *= 1.5; }},
                  {"the other's point outside", [](Proof& p) { p.apart.point2 *= 1.5; }},
                  {"a point that is no number", [](Proof& p) { p.apart.point2[0] = nan; }},
                  {"a tree", [](Proof& p) { p.cover.tree.push_back(Leaf::convex); }}});
}

TEST(Proof, AChangedProofOfSpheresIsRefused) {
  expect_refused(ProofKind::spheres, of_any_kind);
  for (const Made& m : all_made()) {
    if (m.proof.kind != ProofKind::spheres) continue;
    Pair other = m.pair;
    other.body1.shape.semi_axes[0] *= 0.999;
    EXPECT_EQ(verify_proof(other, m.proof).failure, "the bodies are no spheres");
  }
}

}  // namespace
}  // namespace plumb::reference::proof_tests
