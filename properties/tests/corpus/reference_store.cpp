// A stored reference is the computed one, bit for bit; whatever else lies in its place is a miss.
#include "corpus/certificate/reference_store.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <fstream>
#include <latch>
#include <set>
#include <thread>

#include "corpus/certificate/reference_json.hpp"
#include "properties/generators/families.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

// Comparisons of bits: 0 is not -0, and one NaN is like another.
bool same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(const Real50& a, const Real50& b) {
  if (isnan(a) && isnan(b)) return true;
  return a == b && signbit(a) == signbit(b);
}

template <class S>
bool same(const Vec3<S>& a, const Vec3<S>& b) {
  return same(a[0], b[0]) && same(a[1], b[1]) && same(a[2], b[2]);
}

bool same(const Bounds& a, const Bounds& b) {
  return same(a.lower, b.lower) && same(a.upper, b.upper);
}

bool same(const Condition& a, const Condition& b) {
  return same(a.overlap, b.overlap) && same(a.normal, b.normal) && same(a.points, b.points);
}

bool same(const Solution& a, const Solution& b) {
  return a.solved == b.solved && a.proved == b.proved && a.reason == b.reason && same(a.overlap, b.overlap) &&
         same(a.normal, b.normal) && same(a.point1, b.point1) && same(a.point2, b.point2) &&
         same(a.residual, b.residual) && same(a.condition, b.condition) && same(a.bounds, b.bounds) &&
         same(a.normal_radius, b.normal_radius) && same(a.points_radius, b.points_radius);
}

template <class Item>
bool same(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Item& x, const Item& y) { return same(x, y); });
}

/// But for the proof, which is not stored.
bool same(const Reference& a, const Reference& b) {
  return a.effort == b.effort && a.verdict == b.verdict && same(a.overlap, b.overlap) &&
         same(a.common_normal, b.common_normal) && same(a.tied, b.tied) && same(a.close, b.close) &&
         a.global == b.global && a.unique == b.unique && a.reason == b.reason && same(a.open, b.open) &&
         same(a.direction, b.direction) && a.cells == b.cells;
}

Pair pair_of(std::string_view family, std::uint64_t index) {
  return generate(family, 11, index).pair;
}

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void overwrite(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

class Store : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(dir_); }
  void TearDown() override { fs::remove_all(dir_); }

  [[nodiscard]] std::size_t files() const {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(dir_)) count += entry.is_regular_file() ? 1 : 0;
    return count;
  }
  /// What lies in the entry's place is taken for a miss, and the right answer is put there again.
  void expect_miss(const std::string& what) const {
    const ReferenceStore store(dir_);
    EXPECT_TRUE(same(store.find(pair_, Effort::bounds), found_)) << what;
    EXPECT_EQ(store.counts().misses, 1U) << what;
    EXPECT_TRUE(same(store.find(pair_, Effort::bounds), found_)) << what;
    EXPECT_EQ(store.counts().hits, 1U) << what;
  }

  fs::path dir_ = fs::temp_directory_path() / ("plumb-store-" + std::to_string(::getpid()));
  Pair pair_ = pair_of("ellipsoid", 0);
  Reference found_ = find_reference(pair_, Effort::bounds);
};

TEST_F(Store, EveryFieldComesBackBitForBit) {
  for (const Family& family : families())
    for (std::uint64_t index = 0; index < 15; ++index)
      for (const Effort effort : efforts) {
        const ReferenceStore first(dir_), second(dir_);
        const Pair pair = pair_of(family.name, index);
        const Reference computed = find_reference(pair, effort);
        ASSERT_TRUE(same(first.find(pair, effort), computed)) << family.name << ' ' << index << ' ' << name(effort);
        ASSERT_TRUE(same(second.find(pair, effort), computed)) << family.name << ' ' << index << ' ' << name(effort);
        EXPECT_EQ(first.counts().misses, 1U);
        EXPECT_EQ(first.counts().unstored, 0U);
        EXPECT_EQ(second.counts().hits, 1U);
      }
  EXPECT_EQ(files(), families().size() * 15 * efforts.size());
}

TEST_F(Store, PotentialsComeBackBitForBit) {
  for (const Problem problem : {Problem::deepest_points, Problem::midway}) {
    const ReferenceStore first(dir_), second(dir_);
    const Solution computed = find_problem_reference(pair_, problem);
    ASSERT_TRUE(same(first.find_other(pair_, problem), computed)) << name(problem);
    ASSERT_TRUE(same(second.find_other(pair_, problem), computed)) << name(problem);
    EXPECT_EQ(first.counts().misses, 1U);
    EXPECT_EQ(second.counts().hits, 1U);
  }
  EXPECT_EQ(files(), 2U);
}

TEST_F(Store, NumbersThatNoCaseGives) {
  Reference odd = found_;
  odd.common_normal.overlap = ldexp(Real50(1) / 3, -1000000);
  odd.common_normal.residual = -Real50(0);
  odd.common_normal.normal_radius = 5e-324;
  odd.overlap.lower = -std::numeric_limits<Real50>::infinity();
  odd.tied = {Solution{}, odd.common_normal};
  odd.close = {odd.common_normal};
  odd.open = {{-0.0, 1e22, 1.0 / 3}, not_valid<double>(), {1, 2, -std::numeric_limits<double>::infinity()}};
  odd.direction = {Real50(1) / 3, -Real50(0), Real50(1)};
  odd.reason = "a \"quoted\"\nline";
  odd.unique = Claim::disproved;
  const Json json = read_json(write_json(reference_json(odd)));
  EXPECT_TRUE(same(read_reference(Field(json)), odd));
}

TEST_F(Store, TheProofIsNotGivenWhetherStoredOrNot) {
  const ReferenceStore store(dir_);
  Pair apart = pair_;
  apart.body2.position[0] += 100;
  ASSERT_FALSE(find_reference(pair_, Effort::bounds).cover.tree.empty());
  ASSERT_TRUE(find_reference(apart, Effort::bounds).nearest);
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(store.find(pair_, Effort::bounds).cover.tree.empty());
    EXPECT_FALSE(store.find(apart, Effort::bounds).nearest);
  }
}

TEST_F(Store, WhatIsDamagedIsAMiss) {
  const ReferenceStore store(dir_);
  (void)store.find(pair_, Effort::bounds);
  const fs::path file = store.file_of(pair_, Effort::bounds);
  const std::string whole = read(file);
  for (std::size_t size = 0; size + 1 < whole.size(); size += 97) {
    overwrite(file, whole.substr(0, size));
    expect_miss("truncated to " + std::to_string(size));
  }
  // One digit, letter or sign for another leaves JSON that can be read, more often than not.
  for (std::size_t at = 0; at + 1 < whole.size(); at += 41) {
    std::string text = whole;
    text[at] = text[at] == '1' ? '2' : '1';
    overwrite(file, text);
    expect_miss("damaged at " + std::to_string(at));
  }
}

TEST_F(Store, WhatIsForeignIsAMiss) {
  const ReferenceStore store(dir_);
  const fs::path file = store.file_of(pair_, Effort::bounds);
  fs::create_directories(file.parent_path());
  for (const std::string& text : {std::string("{}"), std::string("[1, 2]"), std::string("null"), sample_case(),
                                  std::string(100000, '['), std::string(3, '\0'), std::string("\xff\xfe")}) {
    overwrite(file, text);
    expect_miss(text.substr(0, 20));
  }
}

TEST_F(Store, AnotherPairOrEffortUnderTheSameNameIsAMiss) {
  const ReferenceStore store(dir_);
  const fs::path file = store.file_of(pair_, Effort::bounds);
  Pair next = pair_;
  next.body2.position[0] = std::nextafter(next.body2.position[0], 1e300);
  (void)store.find(next, Effort::bounds);
  (void)store.find(pair_, Effort::proof);
  fs::create_directories(file.parent_path());
  for (const fs::path& other : {store.file_of(next, Effort::bounds), store.file_of(pair_, Effort::proof)}) {
    fs::copy_file(other, file, fs::copy_options::overwrite_existing);
    expect_miss(other.string());
  }
}

TEST_F(Store, EachBitOfThePairAndTheEffortNameAnotherFile) {
  const ReferenceStore store(dir_);
  Pair zero = pair_, minus = pair_;
  zero.body1.position[1] = 0.0;
  minus.body1.position[1] = -0.0;
  std::set<fs::path> names;
  for (const Pair& pair : {pair_, swapped(pair_), zero, minus})
    for (const Effort effort : efforts) names.insert(store.file_of(pair, effort));
  EXPECT_EQ(names.size(), 12U);
}

TEST_F(Store, AFolderThatCannotBeWrittenToStillAnswers) {
  // A file in the folder's place: root, who may write anywhere, cannot write there either.
  overwrite(dir_, "");
  const ReferenceStore store(dir_);
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(same(store.find(pair_, Effort::bounds), found_));
  EXPECT_EQ(store.counts().misses, 2U);
  EXPECT_EQ(store.counts().unstored, 2U);
  EXPECT_THROW(store.prepare(), InputFailure);
  EXPECT_THROW((void)open_store((dir_ / "below").string()), InputFailure);
}

TEST_F(Store, NothingIsLeftBesideAnEntryThatCannotBePutInItsPlace) {
  const ReferenceStore store(dir_);
  fs::create_directories(store.file_of(pair_, Effort::bounds) / "full");
  EXPECT_TRUE(same(store.find(pair_, Effort::bounds), found_));
  EXPECT_EQ(store.counts().unstored, 1U);
  EXPECT_EQ(files(), 0U);
}

TEST_F(Store, ThreadsMayAskForTheSameAtOnce) {
  const auto store = open_store(dir_.string());
  const auto references = references_of(store);
  std::latch start(4);
  std::array<bool, 4> right{};
  {
    std::vector<std::jthread> threads;
    for (bool& mine : right)
      threads.emplace_back([&] {
        start.arrive_and_wait();
        mine = true;
        for (int i = 0; i < 20; ++i)
          mine = mine && same(references.common_normal(pair_, Effort::bounds, nullptr), found_);
      });
  }
  EXPECT_EQ(right, (std::array{true, true, true, true}));
  EXPECT_EQ(store->counts().hits + store->counts().misses, 80U);
  EXPECT_EQ(store->counts().unstored, 0U);
  EXPECT_EQ(files(), 1U);
}

TEST_F(Store, WithoutAFolderReferencesAreComputed) {
  EXPECT_EQ(open_store(""), nullptr);
  EXPECT_TRUE(same(references_of(nullptr).common_normal(pair_, Effort::bounds, nullptr), found_));
  EXPECT_FALSE(fs::exists(dir_));
}

}  // namespace
}  // namespace plumb
