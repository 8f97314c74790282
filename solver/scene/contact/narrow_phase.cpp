#include "solver/scene/contact/narrow_phase.hpp"

#include <Eigen/Geometry>

#include "solver/method/automatic.hpp"
#include "solver/scene/contact/relative_curvature.hpp"
#include "solver/shape/curvature.hpp"

namespace plumb::scene {
namespace {

using Index = std::uint32_t;

/// What the solver takes of its last answer.
Contact<double> last_answer(const Contacts& contacts, std::size_t c) {
  Contact<double> last;
  const auto chart = contacts.chart->entry(c);
  last.chart1 = Vec3<double>::Map(chart.data());
  last.chart2 = Vec3<double>::Map(chart.data() + 3);
  last.last_chart1 = Vec3<double>::Map(chart.data() + 6);
  last.last_chart2 = Vec3<double>::Map(chart.data() + 9);
  return last;
}

void keep_charts(Contacts& contacts, std::size_t c, const Contact<double>& answer) {
  const auto chart = contacts.chart->entry(c);
  Vec3<double>::Map(chart.data()) = answer.chart1;
  Vec3<double>::Map(chart.data() + 3) = answer.chart2;
  Vec3<double>::Map(chart.data() + 6) = answer.last_chart1;
  Vec3<double>::Map(chart.data() + 9) = answer.last_chart2;
}

/// arm = (point - centre) x normal, which is 0 for a sphere whatever rounding says.
Vec3<double> arm_of(const World& world, Index i, const Vec3<double>& point, const Vec3<double>& normal) {
  if (world.bodies.is_sphere[i]) return Vec3<double>::Zero();
  return (point - world.state.position->vector(i)).cross(normal);
}

/// The inverse inertia, world axes, times an arm.
Vec3<double> yield_of(const World& world, Index i, const Vec3<double>& arm) {
  const Eigen::Quaterniond q = world.state.orientation_of(i);
  return q * Vec3<double>((q.conjugate() * arm).cwiseProduct(world.bodies.inverse_inertia[i]));
}

/// The arms of the normal, and the mass that it feels: 1 / mass and what turning adds to it, of both bodies.
void keep_arms(World& world, std::size_t c, const Contact<double>& answer) {
  Contacts& contacts = world.contacts;
  const auto [i, j] = contacts.pairs[c];
  const bool is_wall = world.bodies.is_wall(j);
  double inverse_mass = world.bodies.inverse_mass[i] + world.bodies.inverse_mass[j];
  if (contacts.arm1 != nullptr) {
    const Vec3<double> arm1 = arm_of(world, i, answer.contact_point, answer.normal);
    const Vec3<double> arm2 = is_wall ? Vec3<double>::Zero() : arm_of(world, j, answer.contact_point, answer.normal);
    contacts.arm1->vector(c) = arm1;
    contacts.arm2->vector(c) = arm2;
    if (contacts.yield1 != nullptr) {
      const Vec3<double> yield1 = yield_of(world, i, arm1);
      const Vec3<double> yield2 = is_wall ? Vec3<double>::Zero() : yield_of(world, j, arm2);
      contacts.yield1->vector(c) = yield1;
      contacts.yield2->vector(c) = yield2;
      inverse_mass += arm1.dot(yield1) + arm2.dot(yield2);
    }
  }
  if (contacts.inverse_mass != nullptr) (*contacts.inverse_mass)[c] = inverse_mass;
}

double radius_at(const World& world, std::size_t c, const Vec3<double>& point) {
  const auto [i, j] = world.contacts.pairs[c];
  const double inverse = 1 / (point - world.state.position->vector(i)).norm();
  return 1 / (world.bodies.is_wall(j) ? inverse : inverse + 1 / (point - world.state.position->vector(j)).norm());
}

/// One contact's columns, from what was wanted.
void keep_contact(World& world, std::size_t c, const Contact<double>& answer) {
  Contacts& contacts = world.contacts;
  if (contacts.overlap != nullptr) (*contacts.overlap)[c] = answer.overlap;
  if (contacts.normal != nullptr) contacts.normal->vector(c) = answer.normal;
  if (contacts.point != nullptr) contacts.point->vector(c) = answer.contact_point;
  if (contacts.radius != nullptr) (*contacts.radius)[c] = radius_at(world, c, answer.contact_point);
  keep_arms(world, c, answer);
}

void keep_curvature(World& world, std::size_t c, const Curvatures& first, const Curvatures& second) {
  std::ranges::copy(relative_curvature(first, second), world.contacts.curvature->entry(c).begin());
}

/// The point on the normal through a ball's centre, and two balls' normal through both: there they are up to the solver's tolerance, but
/// a ball's arm is zero by its shape, and what is left of it would be angular momentum made from nothing.
void straighten(const World& world, Index i, Index j, Contact<double>& answer) {
  const bool is_ball1 = world.bodies.is_sphere[i] != 0, is_ball2 = world.bodies.is_sphere[j] != 0;
  if (!is_ball1 && !is_ball2) return;
  const Vec3<double> x1 = world.state.position->vector(i), x2 = world.state.position->vector(j);
  if (is_ball1 && is_ball2 && x1 != x2) answer.normal = (x2 - x1).normalized();
  const Vec3<double>& centre = is_ball1 ? x1 : x2;
  answer.contact_point = centre + answer.normal.dot(answer.contact_point - centre) * answer.normal;
}

Curvatures curvatures_of(const World& world, Index i, const PrincipalCurvature<double>& at) {
  return Curvatures::of(at, world.bodies.shape[i].semi_axes.maxCoeff());
}

/// The deepest point of a body in a wall: the support point, in closed form. Whether they touch.
bool meet_wall(World& world, std::size_t c) {
  Contacts& contacts = world.contacts;
  const auto [i, j] = contacts.pairs[c];
  const Vec3<double> into = -world.bodies.wall_normal[j - world.bodies.count];
  const double distance = into.dot(world.state.position->vector(j) - world.state.position->vector(i));
  if (distance >= world.bodies.radius[i] + contacts.range) return false;
  const Superellipsoid<double>& shape = world.bodies.shape[i];
  const Eigen::Quaterniond q =
      world.bodies.is_sphere[i] ? Eigen::Quaterniond::Identity() : world.state.orientation_of(i);
  const NormValue<double> at = support_point<double>(shape, q.conjugate() * into);
  Contact<double> answer;
  answer.overlap = at.value - distance;
  if (answer.overlap <= -contacts.range) return false;
  answer.normal = into;
  answer.contact_point = world.state.position->vector(i) + q * at.gradient - answer.overlap / 2 * into;
  keep_contact(world, c, answer);
  if (contacts.curvature == nullptr) return true;
  PrincipalCurvature<double> curvature = principal_curvature<double>(shape, at.gradient);
  curvature.direction1 = q * curvature.direction1;
  keep_curvature(world, c, curvatures_of(world, i, curvature), {});
  return true;
}

Contact<double> count(Contact<double> answer, Round& round) {
  ++round.solves;
  round.evaluations += answer.evaluations;
  return answer;
}

/// A yes or no, from the last answer.
Contact<double> ask(World& world, std::size_t c, const Pair& pair, const Want& want, Round& round) {
  Want yes_or_no = want;
  yes_or_no.overlap = yes_or_no.normal = yes_or_no.points = yes_or_no.curvature = false;
  const Contact<double> last = last_answer(world.contacts, c);
  const Contact<double> answer = count(automatic<double>(pair, yes_or_no, &last), round);
  keep_charts(world.contacts, c, answer);
  return answer;
}

/// Warm, and cold where that fails: a contact is never dropped because a start was bad.
Contact<double> solve(const World& world, std::size_t c, const Pair& pair, const Want& want, Round& round) {
  const Contact<double> last = last_answer(world.contacts, c);
  const Contact<double> warm = count(automatic<double>(pair, want, &last), round);
  if (warm.status == Status::converged) return warm;
  ++round.failed_warm;
  const Contact<double> cold = count(automatic<double>(pair, want, nullptr), round);
  if (cold.status != Status::converged) ++round.failed;
  return cold;
}

/// Whether two bodies touch. Where no solve gave a finite answer they do what they did before, with the columns of then.
bool meet_body(World& world, std::size_t c, const Want& want, Round& round, SolveNote* note) {
  Contacts& contacts = world.contacts;
  const auto [i, j] = contacts.pairs[c];
  const Bodies& bodies = world.bodies;
  const double reach = bodies.radius[i] + bodies.radius[j] + contacts.range;
  if ((world.state.position->vector(j) - world.state.position->vector(i)).squaredNorm() > reach * reach) return false;
  const bool touched = (*contacts.is_pressing)[c] != 0;
  const Pair pair{solver_body(world, i), solver_body(world, j)};
  if (want.is_yes_or_no() || (!touched && contacts.range == 0)) {
    const Contact<double> asked = ask(world, c, pair, want, round);
    const bool is_answered = asked.status == Status::converged;
    if (is_answered && asked.verdict == Verdict::separated) return false;
    if (want.is_yes_or_no()) {
      if (!is_answered) ++round.failed;
      return !is_answered || asked.verdict == Verdict::overlapping;
    }
  }
  Contact<double> answer = solve(world, c, pair, want, round);
  const bool is_answered = std::isfinite(answer.overlap);
  const bool touches = is_answered ? answer.overlap > -contacts.range : touched;
  if (note != nullptr)
    *note = {.contact = static_cast<Index>(c),
             .status = answer.status,
             .iterations = answer.iterations,
             .evaluations = static_cast<int>(round.evaluations),
             .touched = touched,
             .touches = touches,
             .failed_warm = round.failed_warm > 0};
  if (!is_answered) return touches;
  keep_charts(contacts, c, answer);
  if (!touches) return false;
  straighten(world, i, j, answer);
  keep_contact(world, c, answer);
  if (contacts.curvature != nullptr)
    keep_curvature(world, c, curvatures_of(world, i, answer.curvature[0]),
                   curvatures_of(world, j, answer.curvature[1]));
  return true;
}

/// Below so many pairs, waking threads takes longer than they spare.
[[maybe_unused]] constexpr std::int64_t few = 128;

/// Which pairs touch, which of them overlap, and which did and no longer do.
void sort_out(Contacts& contacts, const std::vector<char>& touches) {
  contacts.touching.clear();
  contacts.pressing.clear();
  contacts.parted.clear();
  for (std::size_t c = 0; c < touches.size(); ++c) {
    double& flag = (*contacts.is_pressing)[c];
    const bool presses = touches[c] != 0 && (contacts.overlap == nullptr || (*contacts.overlap)[c] > 0);
    if (touches[c] != 0) contacts.touching.push_back(static_cast<Index>(c));
    if (presses) contacts.pressing.push_back(static_cast<Index>(c));
    if (!presses && flag != 0) contacts.parted.push_back(static_cast<Index>(c));
    flag = presses ? 1 : 0;
  }
}

}  // namespace

Body solver_body(const World& world, std::uint32_t i) {
  Body body{world.bodies.shape[i], world.state.position->vector(i), {1, 0, 0, 0}};
  if (world.bodies.is_sphere[i] == 0) std::ranges::copy(world.state.orientation->entry(i), body.quaternion.begin());
  return body;
}

Round solve_contacts(World& world, const Want& want, [[maybe_unused]] int threads, std::vector<SolveNote>* notes) {
  Contacts& contacts = world.contacts;
  const auto pairs = static_cast<std::int64_t>(contacts.pairs.size());
  std::vector<SolveNote> all(notes == nullptr ? 0 : contacts.pairs.size());
  std::vector<char> touches(contacts.pairs.size());
  std::int64_t solves = 0, evaluations = 0, failed = 0, failed_warm = 0;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 32) if (threads > 1 && pairs >= few) \
    reduction(+ : solves, evaluations, failed, failed_warm)
  for (std::int64_t k = 0; k < pairs; ++k) {
    const auto c = static_cast<std::size_t>(k);
    Round round;
    const bool is_wall = world.bodies.is_wall(contacts.pairs[c][1]);
    SolveNote* note = all.empty() ? nullptr : &all[c];
    touches[c] = (is_wall ? meet_wall(world, c) : meet_body(world, c, want, round, note)) ? 1 : 0;
    solves += round.solves;
    evaluations += round.evaluations;
    failed += round.failed;
    failed_warm += round.failed_warm;
  }
  sort_out(contacts, touches);
  if (notes != nullptr)
    std::ranges::copy_if(all, std::back_inserter(*notes), [](const SolveNote& note) { return note.evaluations > 0; });
  return {solves, evaluations, failed, failed_warm};
}

}  // namespace plumb::scene
