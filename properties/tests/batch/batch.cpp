// The batch: the answers of `auto`, whatever the instruction set, the number of pairs and the neighbours.
#include "solver/batch/batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>

#include "properties/doors/columns.hpp"
#include "properties/generators/families.hpp"
#include "properties/laws/laws.hpp"
#include "properties/tests/allocations.hpp"
#include "solver/method/methods.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

std::vector<Pair> pairs_of(std::string_view family, std::size_t count) {
  std::vector<Pair> out;
  for (std::uint64_t i = 0; i < count; ++i) out.push_back(generate(family, 21, i).pair);
  return out;
}

/// The report is checked to be without error.
ContactColumns solved(const std::vector<Pair>& pairs, InstructionSet set, const Want& want = {}) {
  ContactColumns out(pairs.size());
  const PairColumns columns(pairs);
  EXPECT_EQ(solve_batch(columns.arrays(), want, out.arrays(), set).error, BatchError::none);
  return out;
}

Contact<double> solved_alone(const Pair& pair) {
  return find_method("auto")->solve(pair, {}, nullptr);
}

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}
bool same(const Vec3<double>& a, const Vec3<double>& b) {
  return same(a[0], b[0]) && same(a[1], b[1]) && same(a[2], b[2]);
}
bool same(const Contact<double>& a, const Contact<double>& b) {
  return a.status == b.status && a.verdict == b.verdict && same(a.overlap, b.overlap) && same(a.normal, b.normal) &&
         same(a.point1, b.point1) && same(a.point2, b.point2) && same(a.contact_point, b.contact_point) &&
         a.iterations == b.iterations && a.evaluations == b.evaluations;
}

bool are_ellipsoids(const Pair& pair) {
  const Superellipsoid<double>&s1 = pair.body1.shape, &s2 = pair.body2.shape;
  return s1.n1 == 2 && s1.n2 == 2 && s2.n1 == 2 && s2.n2 == 2;
}

TEST(Batch, EllipsoidsHaveTheBitsOfAuto) {
  for (const std::string_view family : {"spheroid", "ellipsoid"}) {
    const std::vector<Pair> pairs = pairs_of(family, 1000);
    for (const InstructionSet set : available_instruction_sets()) {
      const ContactColumns batch = solved(pairs, set);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        ASSERT_TRUE(same(batch.at(i), solved_alone(pairs[i]))) << family << ' ' << i << ' ' << name(set);
    }
  }
}

/// Exponents: whole ones of one pair are products, those of many powers; the rest is rounded alike.
TEST(Batch, OtherExponentsHaveTheOverlapOfAutoToRounding) {
  const std::vector<Pair> pairs = pairs_of("superquadric", 1000);
  for (const InstructionSet set : available_instruction_sets()) {
    const ContactColumns batch = solved(pairs, set);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Contact<double> alone = solved_alone(pairs[i]);
      ASSERT_EQ(batch.status[i], alone.status) << i;
      if (alone.status != Status::converged) continue;
      const double reach = std::max(size_of(pairs[i]), (pairs[i].body2.position - pairs[i].body1.position).norm());
      EXPECT_NEAR(batch.overlap[i], alone.overlap, 8 * std::numeric_limits<double>::epsilon() * reach) << i;
    }
  }
}

TEST(Batch, EveryInstructionSetHasTheSameBits) {
  if (!is_available(InstructionSet::avx2)) GTEST_SKIP() << "this machine has one";
  for (const std::string_view family : {"ellipsoid", "superquadric", "hard"}) {
    const std::vector<Pair> pairs = pairs_of(family, 500);
    const ContactColumns narrow = solved(pairs, InstructionSet::baseline), wide = solved(pairs, InstructionSet::avx2);
    for (std::size_t i = 0; i < pairs.size(); ++i) ASSERT_TRUE(same(narrow.at(i), wide.at(i))) << family << ' ' << i;
  }
}

TEST(Batch, AnyNumberOfPairs) {
  const std::vector<Pair> all = pairs_of("ellipsoid", 67);
  for (const InstructionSet set : available_instruction_sets()) {
    const auto width = static_cast<std::size_t>(lanes(set));
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, width - 1, width, width + 1, std::size_t{63},
                                    std::size_t{64}, std::size_t{65}, std::size_t{67}}) {
      const std::vector<Pair> pairs(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
      const ContactColumns batch = solved(pairs, set);
      for (std::size_t i = 0; i < count; ++i)
        ASSERT_TRUE(same(batch.at(i), solved_alone(pairs[i]))) << count << ' ' << i << ' ' << name(set);
    }
  }
}

/// Exponents below 2: bodies apart are settled side by side, and the others are for the search.
TEST(Batch, ExponentsBelowTwoThatAreApartAreSettled) {
  std::vector<Pair> pairs = pairs_of("superquadric", 1000);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i].body1.shape.n1 = 1.2 + 0.7 * static_cast<double>(i) / 1000;
    pairs[i].body2.position += 2 * (pairs[i].body2.position - pairs[i].body1.position);
  }
  for (const InstructionSet set : available_instruction_sets()) {
    ContactColumns out(pairs.size());
    const PairColumns columns(pairs);
    EXPECT_LT(solve_batch(columns.arrays(), {}, out.arrays(), set).alone, 100U) << name(set);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Contact<double> alone = solved_alone(pairs[i]);
      ASSERT_EQ(out.verdict[i], alone.verdict) << i;
      const double reach = std::max(size_of(pairs[i]), (pairs[i].body2.position - pairs[i].body1.position).norm());
      ASSERT_NEAR(out.overlap[i], alone.overlap, 8 * std::numeric_limits<double>::epsilon() * reach) << i;
    }
  }
}

/// Pairs of all families, with some that no solver may take.
std::vector<Pair> mixed_pairs() {
  std::vector<Pair> out;
  for (std::uint64_t i = 0; i < 100; ++i) {
    for (const std::string_view family : {"ellipsoid", "superquadric", "spheroid", "hard"})
      out.push_back(generate(family, 22, i).pair);
    if (i % 3 != 0) continue;
    Pair invalid = out.back();
    switch (i % 5) {
      case 0: invalid.body1.shape.semi_axes[1] = std::numeric_limits<double>::quiet_NaN(); break;
      case 1: invalid.body2.quaternion = {0, 0, 0, 0}; break;
      case 2: invalid.body2.position[0] = std::numeric_limits<double>::infinity(); break;
      case 3: invalid.body1.shape.n1 = i % 2 == 0 ? 1 : std::numeric_limits<double>::infinity(); break;
      default: invalid.body2.shape.semi_axes[2] = -1;
    }
    out.push_back(invalid);
  }
  return out;
}

TEST(Batch, NoPairTouchesAnother) {
  const std::vector<Pair> pairs = mixed_pairs();
  for (const InstructionSet set : available_instruction_sets()) {
    const ContactColumns batch = solved(pairs, set);
    std::vector<Pair> turned = pairs;
    std::reverse(turned.begin(), turned.end());
    const ContactColumns reversed = solved(turned, set);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Contact<double> alone = solved({pairs[i]}, set).at(0);
      ASSERT_TRUE(same(batch.at(i), alone)) << i << ' ' << name(set);
      ASSERT_TRUE(same(reversed.at(pairs.size() - 1 - i), alone)) << i << ' ' << name(set);
    }
  }
}

TEST(Batch, MixedPairsHaveTheStatusOfAuto) {
  const std::vector<Pair> pairs = mixed_pairs();
  for (const InstructionSet set : available_instruction_sets()) {
    const ContactColumns batch = solved(pairs, set);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Contact<double> alone = solved_alone(pairs[i]);
      EXPECT_EQ(batch.status[i], alone.status) << i;
      EXPECT_EQ(batch.verdict[i], alone.verdict) << i;
      if (are_ellipsoids(pairs[i])) {
        EXPECT_TRUE(same(batch.at(i), alone)) << i;
      }
    }
  }
}

TEST(Batch, TheLimitsOfWantHold) {
  const std::vector<Pair> pairs = pairs_of("ellipsoid", 50);
  for (const Want want :
       {Want{.iteration_limit = 2}, Want{.iteration_limit = 0}, Want{.tolerance = 1e-3}, Want{.tolerance = 1e-17}})
    for (const InstructionSet set : available_instruction_sets()) {
      const ContactColumns batch = solved(pairs, set, want);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        ASSERT_TRUE(same(batch.at(i), find_method("auto")->solve(pairs[i], want, nullptr)))
            << i << ' ' << name(set) << ' ' << want.iteration_limit << ' ' << want.tolerance;
    }
}

TEST(Batch, ExponentsMayBeLeftOut) {
  const std::vector<Pair> pairs = pairs_of("ellipsoid", 9);
  const PairColumns columns(pairs);
  PairArrays arrays = columns.arrays();
  for (BodyArrays* body : {&arrays.body1, &arrays.body2}) body->n1 = body->n2 = {};
  ContactColumns out(pairs.size());
  EXPECT_EQ(solve_batch(arrays, {}, out.arrays()).error, BatchError::none);
  for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_TRUE(same(out.at(i), solved_alone(pairs[i]))) << i;
}

TEST(Batch, WhatIsNotWantedIsNotWritten) {
  const std::vector<Pair> pairs = pairs_of("spheroid", 7);
  const PairColumns columns(pairs);
  ContactColumns all = solved(pairs, InstructionSet::best), overlap(pairs.size());
  EXPECT_EQ(solve_batch(columns.arrays(), {}, {.overlap = overlap.overlap}).error, BatchError::none);
  EXPECT_EQ(overlap.overlap, all.overlap);
}

/// Pulled apart by a little and by much.
TEST(Batch, SeparatedBodiesAreApartAlongTheirDirection) {
  const auto gap_along = [](const Pair& pair, const Vec3<double>& direction) {
    const PlacedPair<double> placed = place<double>(pair);
    const auto height = [](const PlacedBody<double>& body, const Vec3<double>& d) {
      return support<double>(body.shape, body.to_body_direction(d));
    };
    return direction.dot(placed.body2.centre - placed.body1.centre) - height(placed.body1, direction) -
           height(placed.body2, -direction);
  };
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"}) {
    std::vector<Pair> pairs = pairs_of(family, 90);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Contact<double> at = solved_alone(pairs[i]);
      pairs[i].body2.position += (at.overlap + (i % 3 == 0 ? 1 : 1e-3)) * at.normal;
    }
    const PairColumns columns(pairs);
    for (const InstructionSet set : available_instruction_sets()) {
      ContactColumns out(pairs.size());
      const ContactArrays all = out.arrays();
      const ContactArrays to{.status = all.status, .verdict = all.verdict, .separating = all.normal};
      EXPECT_EQ(solve_batch(columns.arrays(), {}, to, set).error, BatchError::none);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        EXPECT_EQ(out.verdict[i], Verdict::separated) << family << ' ' << i;
        EXPECT_GT(gap_along(pairs[i], out.at(i).normal), 0) << family << ' ' << i << ' ' << name(set);
      }
    }
  }
}

TEST(Batch, UnequalLengthsAreAnError) {
  const std::vector<Pair> pairs = pairs_of("spheroid", 5);
  const PairColumns columns(pairs);
  ContactColumns out(pairs.size());
  PairArrays arrays = columns.arrays();
  arrays.body2.position[1] = arrays.body2.position[1].first(4);
  EXPECT_EQ(solve_batch(arrays, {}, out.arrays()).error, BatchError::input_lengths);
  ContactArrays contacts = out.arrays();
  contacts.normal[2] = contacts.normal[2].first(4);
  EXPECT_EQ(solve_batch(columns.arrays(), {}, contacts).error, BatchError::output_lengths);
  EXPECT_EQ(out.overlap, std::vector<double>(pairs.size(), 0));
}

TEST(Batch, NoFindingByTheLaws) {
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric", "hard"}) {
    const std::vector<Pair> pairs = pairs_of(family, 24);
    const ContactColumns batch = solved(pairs, InstructionSet::best);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      Judge judge(pairs[i]);
      const auto solve = [](const Pair& pair) { return solved({pair}, InstructionSet::best).at(0); };
      const Judgement judgement = judge.judge(Problem::common_normal, batch.at(i), solve, true);
      EXPECT_EQ(judgement.finding.kind, FindingKind::none)
          << family << ' ' << i << ": " << judgement.finding.law << ": " << judgement.finding.detail;
    }
  }
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(Batch, NoHeap) {
  const std::vector<Pair> pairs = mixed_pairs();
  const PairColumns columns(pairs);
  ContactColumns out(pairs.size());
  for (const InstructionSet set : available_instruction_sets()) {
    const long before = allocations;
    const BatchReport report = solve_batch(columns.arrays(), {}, out.arrays(), set);
    ASSERT_EQ(allocations, before);
    EXPECT_EQ(report.error, BatchError::none);
  }
}

/// Symbols of the libraries' members that the linker may take from any of them, by nm: of the file of that name, or of all the others.
std::set<std::string> weak_symbols(const std::string& file, bool of_others) {
  const std::string command = "cd " PLUMB_BINARY_DIR "/solver && nm -A libplumb_solver.a libplumb_batch.a 2>/dev/null";
  const std::unique_ptr<FILE, int (*)(FILE*)> nm(popen(command.c_str(), "r"), pclose);
  std::set<std::string> out;
  std::array<char, 1U << 16U> line{};
  while (fgets(line.data(), line.size(), nm.get()) != nullptr) {
    const std::string text(line.data());
    const std::size_t at = text.find_first_of("WVu", text.find(' '));
    if (at == std::string::npos || text[at - 1] != ' ' || text[at + 1] != ' ') continue;
    if ((text.find(file) == std::string::npos) == of_others) out.insert(text.substr(at + 2));
  }
  return out;
}

/// One of two functions of the same name goes into the program: it must not be one that a machine without AVX cannot run.
TEST(Batch, NoFunctionIsSharedBetweenInstructionSets) {
  struct Names {
    std::string file, register_type, solver;
  };
  for (const Names& of : {Names{"chunk_avx2", "_VecBuiltinILi32", "ChunkSolverILi4"},
                          Names{"chunk_avx512", "_VecBltnBtmskILi64", "ChunkSolverILi8"},
                          Names{"kernel_avx2", "_VecBuiltinILi32", "_VecBuiltinILi32"},
                          Names{"kernel_avx512", "_VecBltnBtmskILi64", "_VecBltnBtmskILi64"}}) {
    const std::set<std::string> own = weak_symbols(of.file, false), others = weak_symbols(of.file, true);
    ASSERT_FALSE(own.empty());
    ASSERT_FALSE(others.empty());
    for (const std::string& symbol : own) {
      if (symbol.starts_with("DW.ref.")) continue;
      EXPECT_TRUE(symbol.find(of.register_type) != std::string::npos || symbol.find(of.solver) != std::string::npos)
          << symbol;
      EXPECT_FALSE(others.contains(symbol)) << symbol;
    }
  }
}
#endif

}  // namespace
}  // namespace plumb
