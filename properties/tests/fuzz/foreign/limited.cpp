// Foreign solvers of limited ability, each right in what it claims and useless in the rest: PLUMB_LIMIT names the ability,
// PLUMB_LIE=1 makes one answer in four wrong within what is claimed.
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string_view>

#include "solver/c/door.hpp"
#include "solver/method/methods.hpp"

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Vector = double[3];

void forget(Vector& v) {
  v[0] = v[1] = v[2] = nan;
}

void forget_points(plumb_contact& c) {
  for (auto& point : c.points) forget(point);
}

bool is_ellipsoid(const plumb_body& body) {
  return body.exponents[0] == 2 && body.exponents[1] == 2;
}

bool is_sphere(const plumb_body& body) {
  return is_ellipsoid(body) && body.semi_axes[0] == body.semi_axes[1] && body.semi_axes[1] == body.semi_axes[2];
}

bool is_round(const plumb_body& body) {
  return std::fmax(body.exponents[0], body.exponents[1]) <= 4 && std::fmin(body.exponents[0], body.exponents[1]) >= 2;
}

bool takes_all(const plumb_body& /*body*/) {
  return true;
}

void leave(plumb_contact& /*c*/) {}

/// Apart it knows nothing but that they are.
void only_say_apart(plumb_contact& c) {
  if (c.verdict != PLUMB_SEPARATED) return;
  c.status = PLUMB_STALLED;
  c.overlap = nan;
  forget(c.normal);
  forget(c.contact_point);
  forget_points(c);
}

void say_nothing_apart(plumb_contact& c) {
  only_say_apart(c);
  if (c.verdict == PLUMB_SEPARATED) c.verdict = PLUMB_OVERLAPPING;  // it was never asked
}

void forget_all_points(plumb_contact& c) {
  forget_points(c);
  forget(c.contact_point);
}

void forget_normal(plumb_contact& c) {
  forget(c.normal);
}

/// As one that stops at 1e-8 of the size does.
void be_coarse(plumb_contact& c) {
  constexpr double off = 1e-8;
  const double tilt = off * (c.normal[0] > 0.5 ? -1 : 1);
  Vector turned{c.normal[0] - tilt * c.normal[1], c.normal[1] + tilt * c.normal[0], c.normal[2]};
  std::memcpy(c.normal, turned, sizeof turned);
}

void deepen(plumb_contact& c) {
  c.overlap *= 1.01;
}

void tilt(plumb_contact& c) {
  const Vector turned{c.normal[1], c.normal[2], c.normal[0]};
  std::memcpy(c.normal, turned, sizeof turned);
}

void exchange_verdict(plumb_contact& c) {
  c.verdict = c.verdict == PLUMB_SEPARATED ? PLUMB_OVERLAPPING : PLUMB_SEPARATED;
}

void shift_contact(plumb_contact& c) {
  for (double& x : c.contact_point) x += c.overlap + 0.1 * std::abs(c.points[0][0] - c.points[1][1]) + 0.01;
}

struct Limit {
  std::string_view name;
  plumb_abilities claims;
  std::string_view method = "auto";
  bool (*takes)(const plumb_body&) = takes_all;
  void (*strip)(plumb_contact&) = leave;
  void (*lie)(plumb_contact&) = tilt;
};

plumb_abilities abilities() {
  plumb_abilities out{};
  out.exponents[0] = 1;
  out.exponents[1] = HUGE_VAL;
  out.normal = 1;
  return out;
}

template <class Change>
plumb_abilities with(const Change& change) {
  plumb_abilities out = abilities();
  change(out);
  return out;
}

const auto& limits() {
  static const std::array all{
      Limit{"spheres", with([](auto& a) { a.shapes = PLUMB_SPHERES; }), "auto", is_sphere},
      Limit{"ellipsoids", with([](auto& a) { a.shapes = PLUMB_ELLIPSOIDS; }), "auto", is_ellipsoid},
      Limit{"exponents", with([](auto& a) { a.exponents[0] = 2, a.exponents[1] = 4; }), "auto", is_round},
      Limit{"verdict", with([](auto& a) { a.apart = PLUMB_APART_VERDICT; }), "auto", takes_all, only_say_apart,
            exchange_verdict},
      Limit{"overlapping", with([](auto& a) { a.apart = PLUMB_APART_NONE; }), "auto", takes_all, say_nothing_apart},
      Limit{"midway", with([](auto& a) { a.points = PLUMB_POINTS_MIDWAY; }), "auto", takes_all, forget_points,
            shift_contact},
      Limit{"no_points", with([](auto& a) { a.points = PLUMB_POINTS_NONE; }), "auto", takes_all, forget_all_points,
            deepen},
      Limit{"no_normal", with([](auto& a) { a.normal = 0; }), "auto", takes_all, forget_normal, deepen},
      Limit{"bare", with([](auto& a) { a.normal = 0, a.points = PLUMB_POINTS_NONE; }), "auto", takes_all,
            [](plumb_contact& c) { forget_normal(c), forget_all_points(c); }, deepen},
      Limit{"deepest_points", with([](auto& a) { a.problem = PLUMB_DEEPEST_POINTS; }), "geometric_potential"},
      Limit{"midway_problem", with([](auto& a) { a.problem = PLUMB_MIDWAY; }), "geometric_potential_midway"},
      Limit{"coarse", with([](auto& a) { a.tolerance = 1e-8; }), "auto", takes_all, be_coarse},
  };
  return all;
}

const Limit& limit() {
  const char* const asked = std::getenv("PLUMB_LIMIT");
  for (const Limit& one : limits())
    if (asked != nullptr && one.name == asked) return one;
  return limits()[1];
}

bool lies_about(const plumb_pair& pair) {
  const char* const lies = std::getenv("PLUMB_LIE");
  const plumb_body *one = &pair.bodies[0], *two = &pair.bodies[1];
  return lies != nullptr && *lies == '1' && two->position[0] > one->position[0] && two->position[1] > one->position[1];
}

}  // namespace

extern "C" int plumb_solver_version() {
  return PLUMB_SOLVER_VERSION;
}

extern "C" void plumb_solver_abilities(plumb_abilities* out) {
  const unsigned size = out->size;
  *out = limit().claims;
  out->size = size;
  out->name = limit().name.data();
  out->version = "1.0";
  out->licence = "BSD-3-Clause";
}

extern "C" int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  const Limit& mine = limit();
  if (!mine.takes(pair->bodies[0]) || !mine.takes(pair->bodies[1])) return 1;
  *contact = plumb::door::c_contact(plumb::find_method(mine.method)->solve(plumb::door::pair_of(*pair), {}, nullptr));
  if (contact->status != PLUMB_CONVERGED) return 0;
  if (lies_about(*pair)) mine.lie(*contact);
  mine.strip(*contact);
  return 0;
}
