// A foreign solver that is right but for the mistakes that the environment variable PLUMB_MISTAKE names, joined by '+', and that
// claims no more than PLUMB_CLAIMS says. The mistakes are made as an adapter makes them, and not as the doctor describes them.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>

#include "solver/c/door.hpp"
#include "solver/method/methods.hpp"

namespace {

using Vector = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;

using plumb::Body;
using plumb::Pair;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = 0.017453292519943295;

/// Three numbers of the answer as a vector.
Eigen::Map<Vector> at(double* numbers) {
  return Eigen::Map<Vector>(numbers);
}

std::string_view from_environment(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? "" : text;
}

bool makes(std::string_view mistake) {
  return ("+" + std::string(from_environment("PLUMB_MISTAKE")) + "+").find("+" + std::string(mistake) + "+") !=
         std::string::npos;
}

bool claims(std::string_view words) {
  return from_environment("PLUMB_CLAIMS") == words;
}

Quaternion rotation_of(const Body& body) {
  const auto [w, x, y, z] = body.quaternion;
  return Quaternion(w, x, y, z).normalized();
}

void set_rotation(Body& body, const Quaternion& q) {
  body.quaternion = {q.w(), q.x(), q.y(), q.z()};
}

double length_of(const Body& body) {
  const auto [w, x, y, z] = body.quaternion;
  return std::sqrt(w * w + x * x + y * y + z * z);
}

/// Roll, pitch and yaw by the textbook, each times a factor.
Quaternion by_angles(const Quaternion& q, double factor) {
  const Eigen::Matrix3d r = q.toRotationMatrix();
  const double yaw = std::atan2(r(1, 0), r(0, 0)), pitch = std::asin(-r(2, 0)), roll = std::atan2(r(2, 1), r(2, 2));
  return Eigen::AngleAxisd(factor * yaw, Vector::UnitZ()) * Eigen::AngleAxisd(factor * pitch, Vector::UnitY()) *
         Eigen::AngleAxisd(factor * roll, Vector::UnitX());
}

/// Precession, nutation and spin (z, x, z), each times a factor.
Quaternion by_precession(const Quaternion& q, double factor) {
  const Eigen::Matrix3d r = q.toRotationMatrix();
  const double precession = std::atan2(r(0, 2), -r(1, 2)), nutation = std::acos(r(2, 2)),
               spin = std::atan2(r(2, 0), r(2, 1));
  return Eigen::AngleAxisd(factor * precession, Vector::UnitZ()) *
         Eigen::AngleAxisd(factor * nutation, Vector::UnitX()) * Eigen::AngleAxisd(factor * spin, Vector::UnitZ());
}

Quaternion by_vector(const Quaternion& q, double factor) {
  Eigen::AngleAxisd turn(q);
  turn.angle() *= factor;
  return Quaternion(turn);
}

double coarse(double x, double step) {
  return step * std::round(x / step);
}

/// What each mistake makes of a body that is handed on.
const std::map<std::string_view, std::function<void(Body&)>> kBodyMistakes{
    {"quaternion_xyzw",
     [](Body& b) { std::rotate(b.quaternion.begin(), b.quaternion.begin() + 1, b.quaternion.end()); }},
    {"quaternion_wxyz",
     [](Body& b) { std::rotate(b.quaternion.begin(), b.quaternion.begin() + 3, b.quaternion.end()); }},
    {"rotation_inverted", [](Body& b) { b.quaternion[0] = -b.quaternion[0]; }},
    {"rotation_ignored", [](Body& b) { b.quaternion = {1, 0, 0, 0}; }},
    {"degrees_rpy", [](Body& b) { set_rotation(b, by_angles(rotation_of(b), 1 / kDegree)); }},
    {"degrees_zxz", [](Body& b) { set_rotation(b, by_precession(rotation_of(b), 1 / kDegree)); }},
    {"degrees_vector", [](Body& b) { set_rotation(b, by_vector(rotation_of(b), 1 / kDegree)); }},
    {"radians_rpy", [](Body& b) { set_rotation(b, by_angles(rotation_of(b), kDegree)); }},
    {"twice_as_large", [](Body& b) { b.shape.semi_axes *= 2; }},
    {"half_as_large", [](Body& b) { b.shape.semi_axes /= 2; }},
    {"axes_sorted_away", [](Body& b) { std::swap(b.shape.semi_axes[0], b.shape.semi_axes[2]); }},
    {"exponents_exchanged", [](Body& b) { std::swap(b.shape.n1, b.shape.n2); }},
    {"exponents_inverted",
     [](Body& b) {
       b.shape.n1 = 2 / b.shape.n1;
       b.shape.n2 = 2 / b.shape.n2;
     }},
    {"exponents_ignored", [](Body& b) { b.shape.n1 = b.shape.n2 = 2; }},
    {"quaternion_length", [](Body& b) { b.shape.semi_axes *= length_of(b) * length_of(b); }},
    {"far_from_origin",
     [](Body& b) {
       if (b.position.norm() < 10) return;
       b.position = b.position.unaryExpr([](double x) { return coarse(x, 0.25); });
     }},
};

/// Of a pair.
const std::map<std::string_view, std::function<void(Pair&)>> kPairMistakes{
    {"bodies_exchanged", [](Pair& p) { std::swap(p.body1, p.body2); }},
    {"shape_twice", [](Pair& p) { p.body2.shape = p.body1.shape; }},
    {"rotation_twice", [](Pair& p) { p.body2.quaternion = p.body1.quaternion; }},
    {"position1_ignored", [](Pair& p) { p.body1.position.setZero(); }},
    {"position2_from_body1", [](Pair& p) { p.body2.position += p.body1.position; }},
};

using Answer = plumb_contact;

/// World coordinates in a body's axes.
void into_axes(const Body& body, double* point) {
  at(point) = rotation_of(body).conjugate() * (at(point) - body.position);
}

void scale(Answer& a, double factor) {
  a.overlap *= factor;
  for (double* x : {a.points[0], a.points[1], a.contact_point}) at(x) *= factor;
}

int verdict_by_sign(double overlap) {
  return overlap > 0 ? PLUMB_OVERLAPPING : PLUMB_SEPARATED;
}

/// Of an answer that is handed back.
const std::map<std::string_view, std::function<void(Answer&, const Pair&)>> kAnswerMistakes{
    {"normal_reversed", [](Answer& a, const Pair&) { at(a.normal) *= -1; }},
    {"normal_in_body1",
     [](Answer& a, const Pair& p) { at(a.normal) = rotation_of(p.body1).conjugate() * Vector(at(a.normal)); }},
    {"normal_in_body2",
     [](Answer& a, const Pair& p) { at(a.normal) = rotation_of(p.body2).conjugate() * Vector(at(a.normal)); }},
    {"normal_long", [](Answer& a, const Pair&) { at(a.normal) *= a.overlap > 0 ? a.overlap : -a.overlap; }},
    {"normal_of_length_3", [](Answer& a, const Pair&) { at(a.normal) *= 3; }},
    {"normal_along_centres",
     [](Answer& a, const Pair& p) { at(a.normal) = (p.body2.position - p.body1.position).normalized(); }},
    {"depth_negative", [](Answer& a, const Pair&) { a.overlap = -a.overlap; }},
    {"depth_negative_and_verdict", [](Answer& a, const Pair&) { a.verdict = verdict_by_sign(a.overlap = -a.overlap); }},
    {"distance_positive", [](Answer& a, const Pair&) { a.overlap = std::abs(a.overlap); }},
    {"distance_positive_once",
     [](Answer& a, const Pair& p) {
       if (p.body1.shape.semi_axes[0] < p.body2.shape.semi_axes[0]) a.overlap = std::abs(a.overlap);
     }},
    {"overlap_half", [](Answer& a, const Pair&) { a.overlap /= 2; }},
    {"overlap_in_millimetres", [](Answer& a, const Pair&) { a.overlap *= 1000; }},
    {"all_in_millimetres", [](Answer& a, const Pair&) { scale(a, 1000); }},
    {"all_over_size",
     [](Answer& a, const Pair& p) {
       scale(a, 1 / std::max(p.body1.shape.semi_axes.maxCoeff(), p.body2.shape.semi_axes.maxCoeff()));
     }},
    {"always_overlapping", [](Answer& a, const Pair&) { a.verdict = PLUMB_OVERLAPPING; }},
    {"verdict_reversed", [](Answer& a, const Pair&) { a.verdict = PLUMB_OVERLAPPING + PLUMB_SEPARATED - a.verdict; }},
    {"verdict_missing", [](Answer& a, const Pair&) { a.verdict = PLUMB_UNDECIDED; }},
    {"points_exchanged", [](Answer& a, const Pair&) { std::swap(a.points[0], a.points[1]); }},
    {"points_from_body1",
     [](Answer& a, const Pair& p) {
       for (double* x : {a.points[0], a.points[1], a.contact_point}) at(x) -= p.body1.position;
     }},
    {"points_in_body1",
     [](Answer& a, const Pair& p) {
       for (double* x : {a.points[0], a.points[1], a.contact_point}) into_axes(p.body1, x);
     }},
    {"points_in_bodies",
     [](Answer& a, const Pair& p) {
       into_axes(p.body1, a.points[0]);
       into_axes(p.body2, a.points[1]);
     }},
    {"all_in_body1",
     [](Answer& a, const Pair& p) {
       for (double* x : {a.points[0], a.points[1], a.contact_point}) into_axes(p.body1, x);
       at(a.normal) = rotation_of(p.body1).conjugate() * Vector(at(a.normal));
     }},
    {"one_point", [](Answer& a, const Pair&) { std::copy_n(a.points[0], 3, a.points[1]); }},
    {"contact_point_at_centre", [](Answer& a, const Pair& p) { at(a.contact_point) = p.body2.position; }},
    {"absolute_tolerance", [](Answer& a, const Pair&) { a.overlap += 4e-4; }},
    {"nan_points", [](Answer& a, const Pair&) { a.points[1][2] = kNan; }},
    {"status_missing", [](Answer& a, const Pair&) { a.status = PLUMB_STALLED; }},
    {"refuses_all", [](Answer& a, const Pair&) { a.status = PLUMB_INVALID_INPUT, a.overlap = kNan; }},
    {"refuses_exponents",
     [](Answer& a, const Pair& p) {
       if (p.body1.shape.n1 != 2) a.status = PLUMB_INVALID_INPUT;
     }},
    {"refuses_ellipsoids",
     [](Answer& a, const Pair& p) {
       if (p.body1.shape.semi_axes.minCoeff() < p.body1.shape.semi_axes.maxCoeff()) a.status = PLUMB_INVALID_INPUT;
     }},
    {"refuses_apart",
     [](Answer& a, const Pair&) {
       if (a.overlap < 0) a.status = PLUMB_ITERATION_LIMIT;
     }},
    {"two_answers",
     [](Answer& a, const Pair&) {
       static int calls = 0;
       a.overlap *= 1 + 1e-9 * ++calls;
     }},
    {"crash_apart",
     [](Answer& a, const Pair&) {
       if (a.overlap < 0) std::abort();
     }},
    {"hang_apart",
     [](Answer& a, const Pair&) {
       for (volatile bool forever = a.overlap < 0; forever;) continue;
     }},
    // No mistake: as good as a solver of that accuracy is.
    {"noise",
     [](Answer& a, const Pair& p) {
       const double unit = p.body1.shape.semi_axes.maxCoeff();
       for (double* x : {a.points[0], a.points[1]}) at(x) += 1e-4 * unit * Vector(at(a.normal)).reverse();
       a.overlap += 1e-4 * unit;
       at(a.normal) = (Vector(at(a.normal)) + Vector(1e-4, -1e-4, 0)).normalized();
     }},
    {"coarse", [](Answer& a, const Pair& p) { a.overlap += 0.004 * p.body1.shape.semi_axes.maxCoeff(); }},
};

/// The pair in body 1's axes, but for the line between the centres; its answer in the world again.
Answer solve_in_axes_of_body1(const Pair& pair, const std::function<Answer(const Pair&)>& solve) {
  const Quaternion turn = rotation_of(pair.body1);
  Pair local = pair;
  local.body1.position.setZero();
  local.body2.position = pair.body2.position - pair.body1.position;
  set_rotation(local.body2, turn.conjugate() * rotation_of(pair.body2));
  set_rotation(local.body1, Quaternion::Identity());
  Answer out = solve(local);
  for (double* x : {out.points[0], out.points[1], out.contact_point})
    at(x) = turn * Vector(at(x)) + pair.body1.position;
  at(out.normal) = turn * Vector(at(out.normal));
  return out;
}

/// What a solver that says PLUMB_CLAIMS of itself leaves out.
void leave_out(Answer& a, bool apart) {
  if (claims("midway")) at(a.contact_point) = 0.3 * at(a.points[0]) + 0.7 * at(a.points[1]);
  if (claims("midway") || claims("no_points")) at(a.points[0]).setConstant(kNan);
  if (claims("no_points")) at(a.contact_point).setConstant(kNan);
  if (claims("no_normal")) at(a.normal).setConstant(kNan);
  if (apart && claims("apart_verdict")) {
    a.status = PLUMB_STALLED;
    a.overlap = kNan;
  }
}

bool is_refused(const Pair& pair, bool apart) {
  const auto is_round = [](const Body& b) { return b.shape.semi_axes.minCoeff() == b.shape.semi_axes.maxCoeff(); };
  const auto is_smooth = [](const Body& b) { return b.shape.n1 == 2 && b.shape.n2 == 2; };
  if (claims("spheres")) return !(is_round(pair.body1) && is_round(pair.body2) && is_smooth(pair.body1));
  if (claims("ellipsoids")) return !(is_smooth(pair.body1) && is_smooth(pair.body2));
  return claims("apart_none") && apart;
}

Answer solve(const Pair& pair) {
  const char* method = claims("deepest_points")   ? "geometric_potential"
                       : claims("midway_problem") ? "geometric_potential_midway"
                                                  : "auto";
  return plumb::door::c_contact(plumb::find_method(method)->solve(pair, {}, nullptr));
}

}  // namespace

extern "C" int plumb_solver_version() {
  return PLUMB_SOLVER_VERSION;
}

extern "C" void plumb_solver_abilities(plumb_abilities* abilities) {
  abilities->name = "mistaken";
  if (claims("spheres")) abilities->shapes = PLUMB_SPHERES;
  if (claims("ellipsoids")) abilities->shapes = PLUMB_ELLIPSOIDS;
  if (claims("apart_none")) abilities->apart = PLUMB_APART_NONE;
  if (claims("apart_verdict")) abilities->apart = PLUMB_APART_VERDICT;
  if (claims("midway")) abilities->points = PLUMB_POINTS_MIDWAY;
  if (claims("no_points")) abilities->points = PLUMB_POINTS_NONE;
  if (claims("no_normal")) abilities->normal = 0;
  if (claims("deepest_points")) abilities->problem = PLUMB_DEEPEST_POINTS;
  if (claims("midway_problem")) abilities->problem = PLUMB_MIDWAY;
  if (claims("tolerance")) abilities->tolerance = 1e-2;
}

extern "C" int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  const Pair asked = plumb::door::pair_of(*pair);
  Pair read = asked;
  for (const auto& [name, mistake] : kBodyMistakes)
    if (makes(name)) mistake(read.body1), mistake(read.body2);
  for (const auto& [name, mistake] : kPairMistakes)
    if (makes(name)) mistake(read);
  *contact = makes("line_not_turned") ? solve_in_axes_of_body1(read, solve) : solve(read);
  const bool apart = contact->overlap < 0;
  for (const auto& [name, mistake] : kAnswerMistakes)
    if (makes(name)) mistake(*contact, asked);
  if (is_refused(asked, apart)) return 1;
  leave_out(*contact, apart);
  return 0;
}
