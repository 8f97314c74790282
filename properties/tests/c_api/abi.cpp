// The binary interface of plumb.h on this machine's kind: what a program that was built against an earlier header relies on. A change
// here needs a new soname (solver/CMakeLists.txt), but for a new function and for fields at the end of a struct with `size`.
#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <sstream>
#include <string>

#include "properties/tests/corpus/programs.hpp"
#include "solver/plumb.h"

namespace plumb {
namespace {

#if defined(__x86_64__)
static_assert(sizeof(plumb_body) == 96 && offsetof(plumb_body, exponents) == 24 &&
              offsetof(plumb_body, position) == 40 && offsetof(plumb_body, quaternion_wxyz) == 64);
static_assert(sizeof(plumb_pair) == 192);
static_assert(sizeof(plumb_contact) == 120 && offsetof(plumb_contact, verdict) == 4 &&
              offsetof(plumb_contact, overlap) == 8 && offsetof(plumb_contact, normal) == 16 &&
              offsetof(plumb_contact, points) == 40 && offsetof(plumb_contact, contact_point) == 88 &&
              offsetof(plumb_contact, iterations) == 112 && offsetof(plumb_contact, evaluations) == 116);
static_assert(sizeof(plumb_abilities) >= 72 && offsetof(plumb_abilities, shapes) == 4 &&
              offsetof(plumb_abilities, exponents) == 8 && offsetof(plumb_abilities, apart) == 24 &&
              offsetof(plumb_abilities, points) == 28 && offsetof(plumb_abilities, normal) == 32 &&
              offsetof(plumb_abilities, problem) == 36 && offsetof(plumb_abilities, tolerance) == 40 &&
              offsetof(plumb_abilities, name) == 48 && offsetof(plumb_abilities, version) == 56 &&
              offsetof(plumb_abilities, licence) == 64);
static_assert(sizeof(plumb_context) == 128);
static_assert(sizeof(plumb_witnesses) == 384);
static_assert(sizeof(plumb_body_arrays) == 96 && offsetof(plumb_body_arrays, exponents) == 24 &&
              offsetof(plumb_body_arrays, position) == 40 && offsetof(plumb_body_arrays, quaternion_wxyz) == 64);
static_assert(sizeof(plumb_contact_arrays) == 136 && offsetof(plumb_contact_arrays, verdict) == 8 &&
              offsetof(plumb_contact_arrays, overlap) == 16 && offsetof(plumb_contact_arrays, normal) == 24 &&
              offsetof(plumb_contact_arrays, points) == 48 && offsetof(plumb_contact_arrays, contact_point) == 96 &&
              offsetof(plumb_contact_arrays, iterations) == 120 && offsetof(plumb_contact_arrays, evaluations) == 128);
static_assert(sizeof(plumb_shape) == 112 && offsetof(plumb_shape, hull) == 8 && offsetof(plumb_shape, foreign) == 8 &&
              offsetof(plumb_shape, parameters) == 16);
static_assert(sizeof(plumb_foreign) >= 56 && offsetof(plumb_foreign, data) == 8 &&
              offsetof(plumb_foreign, support) == 16 && offsetof(plumb_foreign, hessian) == 24 &&
              offsetof(plumb_foreign, enclose) == 32 && offsetof(plumb_foreign, bounding_radius) == 40 &&
              offsetof(plumb_foreign, inscribed_radius) == 48);
static_assert(sizeof(plumb_convex_body) == 176 && offsetof(plumb_convex_body, swept_radius) == 112 &&
              offsetof(plumb_convex_body, position) == 120 && offsetof(plumb_convex_body, quaternion_wxyz) == 144);
static_assert(sizeof(plumb_convex_pair) == 352);
// These may grow; what they have does not move.
static_assert(sizeof(plumb_options) >= 64 && offsetof(plumb_options, patch_tolerance) == 56 &&
              offsetof(plumb_options, witnesses) == 64 && offsetof(plumb_options, method) == 8 &&
              offsetof(plumb_options, want) == 16 && offsetof(plumb_options, iteration_limit) == 20 &&
              offsetof(plumb_options, tolerance) == 24 && offsetof(plumb_options, motion) == 32);
static_assert(sizeof(plumb_details) >= 816 && offsetof(plumb_details, patch) == 528 &&
              offsetof(plumb_details, method) == 8 && offsetof(plumb_details, radii) == 16 &&
              offsetof(plumb_details, directions) == 48 && offsetof(plumb_details, overlap_by_shift) == 144 &&
              offsetof(plumb_details, overlap_by_turn) == 192 && offsetof(plumb_details, normal_by_shift) == 240 &&
              offsetof(plumb_details, normal_by_turn) == 384);
static_assert(sizeof(plumb_patch) >= 288 && offsetof(plumb_patch, area) == 8 && offsetof(plumb_patch, normal) == 16 &&
              offsetof(plumb_patch, centre) == 40 && offsetof(plumb_patch, area_moment) == 64 &&
              offsetof(plumb_patch, second_moments) == 88 && offsetof(plumb_patch, axes) == 112 &&
              offsetof(plumb_patch, points) == 184 && offsetof(plumb_patch, error) == 280);
static_assert(sizeof(plumb_certificate) >= 152 && offsetof(plumb_certificate, verdict) == 8 &&
              offsetof(plumb_certificate, global) == 12 && offsetof(plumb_certificate, unique) == 16 &&
              offsetof(plumb_certificate, overlap_lower) == 24 && offsetof(plumb_certificate, overlap_upper) == 32 &&
              offsetof(plumb_certificate, normal) == 40 && offsetof(plumb_certificate, normal_radius) == 64 &&
              offsetof(plumb_certificate, points) == 72 && offsetof(plumb_certificate, points_radius) == 120 &&
              offsetof(plumb_certificate, condition_overlap) == 128 &&
              offsetof(plumb_certificate, condition_normal) == 136 &&
              offsetof(plumb_certificate, condition_points) == 144 && offsetof(plumb_certificate, open) == 152);
#endif

template <class Function, class Type>
constexpr bool is = std::is_same_v<Function, Type>;
static_assert(is<decltype(plumb_version), const char*(void)> && is<decltype(plumb_error_text), const char*(int)> &&
              is<decltype(plumb_status_name), const char*(int)> && is<decltype(plumb_verdict_name), const char*(int)> &&
              is<decltype(plumb_method_name), const char*(size_t)> &&
              is<decltype(plumb_describe_input), int(const plumb_pair*, char*, size_t)>);
static_assert(is<decltype(plumb_solve),
                 int(const plumb_pair*, const plumb_options*, plumb_context*, plumb_contact*, plumb_details*)> &&
              is<decltype(plumb_solve_batch),
                 int(size_t, const plumb_body_arrays*, const plumb_options*, const plumb_contact_arrays*)> &&
              is<decltype(plumb_solve_batch_warm), int(size_t, const plumb_body_arrays*, const plumb_options*,
                                                       plumb_context*, const plumb_contact_arrays*)> &&
              is<decltype(plumb_certify), int(const plumb_pair*, plumb_certificate*)> &&
              is<decltype(plumb_certify_convex), int(const plumb_convex_pair*, const double*, plumb_certificate*)>);
static_assert(is<decltype(plumb_hull_create), plumb_hull*(const double*, size_t, int*)> &&
              is<decltype(plumb_hull_destroy), void(plumb_hull*)> &&
              is<decltype(plumb_describe_convex_input), int(const plumb_convex_pair*, char*, size_t)> &&
              is<decltype(plumb_solve_convex),
                 int(const plumb_convex_pair*, const plumb_options*, plumb_context*, plumb_contact*)> &&
              is<decltype(plumb_solve_convex_details),
                 int(const plumb_convex_pair*, const plumb_options*, plumb_context*, plumb_contact*, plumb_details*)>);
static_assert(is<decltype(plumb_solver_version), int(void)> &&
              is<decltype(plumb_solver_solve), int(const plumb_pair*, plumb_contact*)> &&
              is<decltype(plumb_solver_abilities), void(plumb_abilities*)> &&
              is<decltype(plumb_solver_solve_warm), int(const plumb_pair*, const plumb_contact*, plumb_contact*)>);

static_assert(PLUMB_OK == 0 && PLUMB_ERROR_ARGUMENT == 1 && PLUMB_ERROR_METHOD == 2 && PLUMB_ERROR_MEMORY == 3 &&
              PLUMB_ERROR_INTERNAL == 4);
static_assert(PLUMB_WANT_OVERLAP == 1 && PLUMB_WANT_NORMAL == 2 && PLUMB_WANT_POINTS == 4 &&
              PLUMB_WANT_CURVATURE == 8 && PLUMB_WANT_DERIVATIVES == 16 && PLUMB_WANT_PATCH == 32 &&
              PLUMB_WANT_CONTACT == 7);
static_assert(PLUMB_OPEN == 0 && PLUMB_PROVED == 1 && PLUMB_DISPROVED == 2);
static_assert(PLUMB_CONVERGED == 0 && PLUMB_ITERATION_LIMIT == 1 && PLUMB_STALLED == 2 && PLUMB_SINGULAR == 3 &&
              PLUMB_NOT_FINITE == 4 && PLUMB_INVALID_INPUT == 5);
static_assert(PLUMB_SUPERELLIPSOIDS == 0 && PLUMB_ELLIPSOIDS == 1 && PLUMB_SPHERES == 2);
static_assert(PLUMB_SHAPE_SUPERELLIPSOID == 0 && PLUMB_SHAPE_CAPSULE == 1 && PLUMB_SHAPE_CYLINDER == 2 &&
              PLUMB_SHAPE_CONE == 3 && PLUMB_SHAPE_FRUSTUM == 4 && PLUMB_SHAPE_BOX == 5 &&
              PLUMB_SHAPE_POLYHEDRON == 6 && PLUMB_SHAPE_POLY_SUPERELLIPSOID == 7 && PLUMB_SHAPE_HALF_SPACE == 8 &&
              PLUMB_SHAPE_TABLET == 9 && PLUMB_SHAPE_FOREIGN == 10);
static_assert(PLUMB_APART_DISTANCE == 0 && PLUMB_APART_VERDICT == 1 && PLUMB_APART_NONE == 2);
static_assert(PLUMB_POINTS_TWO == 0 && PLUMB_POINTS_MIDWAY == 1 && PLUMB_POINTS_NONE == 2);
static_assert(PLUMB_COMMON_NORMAL == 0 && PLUMB_DEEPEST_POINTS == 1 && PLUMB_MIDWAY == 2);
static_assert(PLUMB_UNDECIDED == 0 && PLUMB_OVERLAPPING == 1 && PLUMB_SEPARATED == 2);

/// The names that a library shows.
std::set<std::string> shown_by(const std::string& library) {
  const std::string listed = run("nm -D --defined-only --format=just-symbols " + library).out;
  std::set<std::string> out;
  std::istringstream lines(listed);
  for (std::string name; lines >> name;) out.insert(name);
  return out;
}

TEST(CAbi, TheLibrariesShowTheFunctionsOfTheHeaderAndNothingElse) {
  EXPECT_EQ(shown_by(PLUMB_C_LIBRARY),
            (std::set<std::string>{
                "plumb_describe_convex_input", "plumb_describe_input", "plumb_error_text", "plumb_hull_create",
                "plumb_hull_destroy", "plumb_method_name", "plumb_solve", "plumb_solve_batch", "plumb_solve_batch_warm",
                "plumb_solve_convex", "plumb_solve_convex_details", "plumb_solver_solve", "plumb_solver_solve_warm",
                "plumb_solver_version", "plumb_status_name", "plumb_verdict_name", "plumb_version"}));
  EXPECT_EQ(shown_by(PLUMB_CERTIFY_LIBRARY), (std::set<std::string>{"plumb_certify", "plumb_certify_convex"}));
}

TEST(CAbi, TheSonameIsThatOfVersionZero) {
  for (const std::string library : {PLUMB_C_LIBRARY, PLUMB_CERTIFY_LIBRARY}) {
    const std::string read = run("readelf -d " + library).out;
    const std::string name = library == PLUMB_C_LIBRARY ? "libplumb.so.0" : "libplumb_certify.so.0";
    EXPECT_NE(read.find("Library soname: [" + name + "]"), std::string::npos) << read;
  }
}

// The installed library is a solver behind its own door: the harness judges it as it judges anybody's.
TEST_F(Commands, TheInstalledLibraryIsAForeignSolverWithoutAFinding) {
  const Ran ran =
      plumb(std::string("campaign --family all --cases 50 --seed 3 --out out --solver ") + PLUMB_C_LIBRARY + " 2>&1");
  EXPECT_EQ(ran.code, 0) << ran.out;
  const Json findings = json("out/summary.json").at("methods").begin().value().at("findings");
  EXPECT_EQ(findings, Json({{"none", 200}}));
}

}  // namespace
}  // namespace plumb
