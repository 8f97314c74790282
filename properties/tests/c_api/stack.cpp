// What plumb.h says that its functions take of a thread's stack. The figures are those of a release build (tests.cmake): others, and
// sanitizers, have larger frames.
#include <gtest/gtest.h>

#include "corpus/case/case.hpp"
#include "properties/doors/columns.hpp"
#include "properties/generators/families.hpp"
#include "properties/tests/c_api/convex_pairs.hpp"
#include "properties/tests/c_api/painted.hpp"
#include "solver/c/door.hpp"
#include "solver/method/methods.hpp"
#include "solver/plumb.h"

namespace plumb {
namespace {

#if defined(PLUMB_HAS_STACK_FIGURES)
constexpr bool has_the_figures = true;
#else
constexpr bool has_the_figures = false;
#endif

constexpr std::size_t kib = 1024, ample = 1024 * kib;
constexpr unsigned all_wants = 32;  // sets of enum plumb_want

using Pairs = std::vector<Pair>;

Pairs family(const std::string& name, std::uint64_t cases) {
  Pairs out;
  for (std::uint64_t i = 0; i < cases; ++i) out.push_back(generate(name, 21, i).pair);
  return out;
}

/// Every pair of superellipsoids that is kept: among them those whose searches take the most.
Pairs kept() {
  Pairs out;
  for (const auto& file : find_case_files({PLUMB_SOURCE_DIR "/corpus/cases"})) {
    CaseReader reader(file.string(), CaseShapes::every);
    while (const auto c = reader.next())
      if (!c->convex) out.push_back(c->pair);
  }
  return out;
}

/// Cold, and warm from there with body 2 a little further on.
int solve_twice(Pair pair, const char* method, unsigned want) {
  plumb_options options = PLUMB_OPTIONS;
  options.method = method;
  options.want = want;
  options.motion[0] = 1;
  plumb_context context{};
  plumb_contact contact{};
  plumb_details details{};
  details.size = sizeof details;
  const plumb_pair cold = door::c_pair(pair);
  EXPECT_EQ(plumb_solve(&cold, &options, &context, &contact, &details), PLUMB_OK);
  const int evaluations = contact.evaluations;
  pair.body2.position += Vec3<double>(1e-3, -2e-3, 1e-3) * size_of(pair);
  const plumb_pair warm = door::c_pair(pair);
  EXPECT_EQ(plumb_solve(&warm, &options, &context, &contact, &details), PLUMB_OK);
  return evaluations;
}

/// By `auto`: the evaluations of the longest search.
int solve_by_all_wants(const Pairs& pairs) {
  int most = 0;
  for (const Pair& pair : pairs)
    for (unsigned want = 0; want < all_wants; ++want) most = std::max(most, solve_twice(pair, nullptr, want));
  return most;
}

plumb_body_arrays arrays_of(const BodyArrays& b) {
  return {{b.semi_axes[0].data(), b.semi_axes[1].data(), b.semi_axes[2].data()},
          {b.n1.data(), b.n2.data()},
          {b.position[0].data(), b.position[1].data(), b.position[2].data()},
          {b.quaternion[0].data(), b.quaternion[1].data(), b.quaternion[2].data(), b.quaternion[3].data()}};
}

void solve_as_batch(const Pairs& pairs) {
  const PairColumns columns(pairs);
  const PairArrays from = columns.arrays();
  ContactColumns found(pairs.size());
  const ContactArrays to = found.arrays();
  std::vector<int> status(pairs.size());
  plumb_contact_arrays contacts{};
  contacts.status = status.data();
  contacts.overlap = to.overlap.data();
  for (std::size_t k = 0; k < 3; ++k) contacts.normal[k] = to.normal[k].data();
  for (std::size_t k = 0; k < 3; ++k) contacts.contact_point[k] = to.contact_point[k].data();
  const plumb_body_arrays bodies[2] = {arrays_of(from.body1), arrays_of(from.body2)};
  EXPECT_EQ(plumb_solve_batch(pairs.size(), bodies, nullptr, &contacts), PLUMB_OK);
  std::vector<plumb_context> contexts(pairs.size());
  for (int step = 0; step < 2; ++step)
    EXPECT_EQ(plumb_solve_batch_warm(pairs.size(), bodies, nullptr, contexts.data(), &contacts), PLUMB_OK);
}

void solve_convex_in_c(const std::vector<BothPairs>& pairs) {
  for (const BothPairs& both : pairs) {
    plumb_contact contact{};
    plumb_options options = PLUMB_OPTIONS;
    options.want = PLUMB_WANT_CONTACT | PLUMB_WANT_CURVATURE | PLUMB_WANT_DERIVATIVES;
    plumb_details details{};
    details.size = sizeof details;
    EXPECT_EQ(plumb_solve_convex_details(&both.c_pair, &options, nullptr, &contact, &details), PLUMB_OK);
  }
}

void certify(const Pairs& pairs) {
  for (const Pair& pair : pairs) {
    const plumb_pair c = door::c_pair(pair);
    plumb_certificate out{};
    out.size = sizeof out;
    EXPECT_EQ(plumb_certify(&c, &out), PLUMB_OK);
  }
}

class CStack : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_the_figures)
      GTEST_SKIP() << "the figures are those of a release build by g++ for x86-64, without sanitizers";
  }
};

class CStackOfFamily : public CStack, public testing::WithParamInterface<const char*> {
 protected:
  [[nodiscard]] static Pairs pairs(std::uint64_t cases) { return family(GetParam(), cases); }
};

TEST_P(CStackOfFamily, SolvesTakeWhatTheHeaderSays) {
  PaintedThread thread(ample);
  const Pairs few = pairs(300);
  EXPECT_LE(thread.run([&] { solve_by_all_wants(few); }).by_work, PLUMB_STACK_SOLVE);
}

TEST_P(CStackOfFamily, BatchesTakeWhatTheHeaderSays) {
  PaintedThread thread(ample);
  const Pairs many = pairs(2000);
  EXPECT_LE(thread.run([&] { solve_as_batch(many); }).by_work, PLUMB_STACK_SOLVE);
  const PairColumns columns(many);
  ContactColumns found(many.size());
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2}) {
    if (!is_available(set)) continue;
    const auto solve = [&] {
      EXPECT_EQ(solve_batch(columns.arrays(), {}, found.arrays(), set).error, BatchError::none);
    };
    EXPECT_LE(thread.run(solve).by_work, PLUMB_STACK_SOLVE) << name(set);
  }
}

TEST_P(CStackOfFamily, EveryMethodTakesWhatTheHeaderSays) {
  PaintedThread thread(ample);
  const Pairs few = pairs(40);
  for (const Method& method : methods()) {
    const auto solve = [&] {
      for (const Pair& pair : few) solve_twice(pair, method.name.data(), PLUMB_WANT_CONTACT);
    };
    EXPECT_LE(thread.run(solve).by_work, PLUMB_STACK_SOLVE) << method.name;
  }
}

TEST_P(CStackOfFamily, CertificatesTakeWhatTheHeaderSays) {
  PaintedThread thread(ample);
  const Pairs few = pairs(25);
  EXPECT_LE(thread.run([&] { certify(few); }).by_work, PLUMB_STACK_CERTIFY);
}

INSTANTIATE_TEST_SUITE_P(Families, CStackOfFamily, testing::Values("spheroid", "ellipsoid", "superquadric", "hard"),
                         [](const auto& family) { return std::string(family.param); });

TEST_F(CStack, TheLongestSearchesTakeWhatTheHeaderSays) {
  PaintedThread thread(ample);
  const Pairs pairs = kept();
  int most = 0;
  EXPECT_LE(thread.run([&] { most = solve_by_all_wants(pairs); }).by_work, PLUMB_STACK_SOLVE);
  EXPECT_LE(thread.run([&] { solve_as_batch(pairs); }).by_work, PLUMB_STACK_SOLVE);
  EXPECT_GE(most, 1650);  // the limit of a search: nothing takes more
}

TEST_F(CStack, ShapesTakeWhatTheHeaderSays) {
  PaintedThread thread(ample);
  std::vector<BothPairs> pairs;
  for_c_pairs(40, [&](BothPairs both) { pairs.push_back(std::move(both)); });
  EXPECT_LE(thread.run([&] { solve_convex_in_c(pairs); }).by_work, PLUMB_STACK_CONVEX);
}

// In all, with what the C library has of it; one that takes more ends the program.
TEST_F(CStack, AThreadOf64KibSolvesEllipsoidsAndExponentsTo8) {
  PaintedThread thread(64 * kib);
  for (const char* name : {"spheroid", "ellipsoid", "superquadric"}) {
    const Pairs pairs = family(name, 300);
    (void)thread.run([&] { solve_by_all_wants(pairs); });
    (void)thread.run([&] { solve_as_batch(pairs); });
  }
}

TEST_F(CStack, AThreadOf128KibSolvesEverything) {
  PaintedThread thread(128 * kib);
  for (const Pairs& pairs : {family("hard", 500), kept()}) {
    (void)thread.run([&] { solve_by_all_wants(pairs); });
    (void)thread.run([&] { solve_as_batch(pairs); });
  }
}

TEST_F(CStack, AThreadOf256KibCertifies) {
  PaintedThread thread(256 * kib);
  const Pairs pairs = family("hard", 10);
  (void)thread.run([&] { certify(pairs); });
}

// What the figures are measured by.
TEST_F(CStack, ThePaintShowsWhatWasUsed) {
  PaintedThread thread(ample);
  constexpr std::size_t used = 100 * kib;
  const StackUse use = thread.run([] {
    volatile char bytes[used];
    std::fill(bytes, bytes + used, '\1');
    EXPECT_EQ(bytes[used / 2], '\1');
  });
  EXPECT_GE(use.by_work, used);
  EXPECT_LE(use.by_work, used + kib);
  EXPECT_GT(use.in_all, use.by_work);
}

}  // namespace
}  // namespace plumb
