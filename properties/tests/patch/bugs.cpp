// Each seeded bug of the patch (fuzz/bugs/patch) is found by a law, and without a bug none finds anything.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include "properties/generators/families.hpp"
#include "properties/laws/laws_patch.hpp"
#include "properties/tests/patch/special_pairs.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

/// The library that holds them.
struct SeededPatch {
  using Solve = void(int, const Pair*, const Contact<double>*, double, Patch*);
  Solve* solve;
  int (*bugs)();
  const char* (*name)(int);

  [[nodiscard]] static SeededPatch load() {
    void* library = dlopen(PLUMB_SEEDED_PATCH, RTLD_NOW | RTLD_LOCAL);
    EXPECT_NE(library, nullptr) << dlerror();
    return {reinterpret_cast<Solve*>(dlsym(library, "seeded_patch")),
            reinterpret_cast<int (*)()>(dlsym(library, "seeded_count")),
            reinterpret_cast<const char* (*)(int)>(dlsym(library, "seeded_name"))};
  }
};

constexpr double asked = 1e-3;

std::vector<Pair> judged_pairs(std::uint64_t of_a_family) {
  std::vector<Pair> out;
  for (const auto& [name, pair] : special_pairs()) out.push_back(pair);
  for (std::uint64_t i = 0; i < of_a_family; ++i)
    for (const char* family : {"ellipsoid", "superquadric", "spheroid"}) out.push_back(generate(family, 34, i).pair);
  return out;
}

/// A bug's patch; -1: without one.
Patch patch_by(const SeededPatch& library, int bug, const Pair& pair, double tolerance) {
  const Contact<double> contact = find_method("auto")->solve(pair, {}, nullptr);
  Patch out;
  if (contact.verdict == Verdict::overlapping) library.solve(bug, &pair, &contact, tolerance, &out);
  return out;
}

/// The first finding of a bug in pairs of all families, or that it does not reach a tolerance that is reached without it; "" for none.
std::string killer_of(const SeededPatch& library, int bug, const std::vector<Pair>& pairs) {
  const auto solve = [&](const Pair& pair, double tolerance) { return patch_by(library, bug, pair, tolerance); };
  for (const Pair& pair : pairs) {
    const Contact<double> contact = find_method("auto")->solve(pair, {}, nullptr);
    if (contact.status != Status::converged || contact.verdict != Verdict::overlapping) continue;
    const Patch patch = solve(pair, asked);
    const Finding found = judge_patch({pair, patch, asked, solve});
    if (found.kind != FindingKind::none) return found.law + ": " + found.detail;
    if (patch.error > asked && patch_by(library, -1, pair, asked).error <= asked) return "the tolerance is not reached";
  }
  return "";
}

TEST(SeededPatchBugs, AreAllKilledByTheLaws) {
  const SeededPatch library = SeededPatch::load();
  ASSERT_TRUE(library.solve && library.bugs && library.name);
  const std::vector<Pair> pairs = judged_pairs(10);
  EXPECT_EQ(killer_of(library, -1, pairs), "");
  for (int bug = 0; bug < library.bugs(); ++bug) {
    const std::string killer = killer_of(library, bug, pairs);
    EXPECT_NE(killer, "") << library.name(bug);
    if (!killer.empty()) RecordProperty(library.name(bug), killer);
  }
}

}  // namespace
}  // namespace plumb
